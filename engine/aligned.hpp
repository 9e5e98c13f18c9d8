// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <new>
#include <span>
#include <vector>

namespace plenum {

/// Memory that starts at a cache line.
template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};

  CacheLineAllocator() = default;
  template <class Other>
  CacheLineAllocator(const CacheLineAllocator<Other>&) {}

  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, alignment); }
  /// Numbers that are about to be overwritten need no zeros first.
  template <class U>
  void construct(U* p) {
    ::new (static_cast<void*>(p)) U;
  }
  template <class U, class... Args>
  void construct(U* p, Args&&... args) {
    ::new (static_cast<void*>(p)) U(static_cast<Args&&>(args)...);
  }
  friend bool operator==(CacheLineAllocator, CacheLineAllocator) { return true; }
};

/// A vector whose `resize` leaves new numbers unset.
template <class T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

/// Memory that several uses share one after the other: `begin`, then `take` as often as needed.
class Arena {
 public:
  /// Makes room for `bytes` in all, with a little to spare so that slow growth allocates seldom.
  void begin(std::size_t bytes) {
    used_ = 0;
    bytes += 8 * 64;  // what aligning the parts may cost
    if (bytes > bytes_.size()) {
      bytes_ = AlignedVector<std::byte>();  // before the larger one is there
      bytes_.resize(bytes + bytes / 64);
    }
  }

  /// Room for n values, unset; at most eight times.
  template <class T>
  std::span<T> take(std::size_t n) {
    T* first = reinterpret_cast<T*>(bytes_.data() + used_);
    used_ += (n * sizeof(T) + 63) / 64 * 64;
    return {first, n};
  }

  std::size_t bytes() const { return bytes_.size(); }

 private:
  AlignedVector<std::byte> bytes_;
  std::size_t used_ = 0;
};

}  // namespace plenum
