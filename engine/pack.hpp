// SPDX-License-Identifier: GPL-3.0-or-later
//
// Several numbers that a formula treats as one. `Isa` names the instruction set that the source is
// compiled for: the same formula for two instruction sets has two types, so that the linker never
// mixes their code.
#pragma once

#include "particles/number.hpp"

#include <type_traits>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace plenum {

/// N numbers of type T (float or double), in one register where the processor has one that wide.
template <class T, int N, class Isa>
struct Pack {
  using Scalar = T;
  using Integer = std::conditional_t<sizeof(T) == 4, int, long long>;
  typedef T Raw __attribute__((vector_size(N * sizeof(T))));
  typedef Integer Mask __attribute__((vector_size(N * sizeof(T))));
  /// Lanes in an array of T: aligned to a number only.
  typedef T Memory __attribute__((vector_size(N * sizeof(T)), aligned(alignof(T))));
  static constexpr int size = N;

  Raw raw;

  [[gnu::always_inline]] Pack() : raw{} {}
  template <class Number>
  requires std::is_arithmetic_v<Number>
  [[gnu::always_inline]] explicit Pack(Number s) : raw(static_cast<T>(s) - Raw{}) {}
  [[gnu::always_inline]] static Pack of(Raw raw) {
    Pack p;
    p.raw = raw;
    return p;
  }
  [[gnu::always_inline]] static Pack load(const T* from) {
    return of(*reinterpret_cast<const Memory*>(from));
  }
  [[gnu::always_inline]] void store(T* to) const { *reinterpret_cast<Memory*>(to) = raw; }

  [[gnu::always_inline]] Pack& operator+=(Pack b) { return raw += b.raw, *this; }
  [[gnu::always_inline]] Pack& operator-=(Pack b) { return raw -= b.raw, *this; }
  [[gnu::always_inline]] Pack& operator*=(Pack b) { return raw *= b.raw, *this; }
  [[gnu::always_inline]] friend Pack operator+(Pack a, Pack b) { return of(a.raw + b.raw); }
  [[gnu::always_inline]] friend Pack operator-(Pack a, Pack b) { return of(a.raw - b.raw); }
  [[gnu::always_inline]] friend Pack operator*(Pack a, Pack b) { return of(a.raw * b.raw); }
  [[gnu::always_inline]] friend Pack operator/(Pack a, Pack b) { return of(a.raw / b.raw); }
  [[gnu::always_inline]] friend Pack operator-(Pack a) { return of(-a.raw); }
  [[gnu::always_inline]] friend Mask operator<(Pack a, Pack b) { return a.raw < b.raw; }

  [[gnu::always_inline]] friend Pack max(Pack a, Pack b) { return of(larger(a.raw, b.raw)); }
  [[gnu::always_inline]] friend Pack min(Pack a, Pack b) { return of(smaller(a.raw, b.raw)); }
  [[gnu::always_inline]] friend Pack select(Mask condition, Pack yes, Pack no) {
    return of(condition ? yes.raw : no.raw);
  }
  [[gnu::always_inline]] friend Pack positivePart(Pack a) { return max(a, Pack(0)); }
  [[gnu::always_inline]] friend Pack negativePart(Pack a) { return min(a, Pack(0)); }
  [[gnu::always_inline]] friend Pack squareRoot(Pack a) { return of(root(a.raw)); }

 private:
  // The compiler does not find these instructions by itself as long as it must honour NaN.
  [[gnu::always_inline]] static Raw larger(Raw a, Raw b) {
#if defined(__AVX__)
    if constexpr (std::is_same_v<T, float> && N == 8) return _mm256_max_ps(a, b);
    if constexpr (std::is_same_v<T, double> && N == 4) return _mm256_max_pd(a, b);
#endif
#if defined(__SSE2__)
    if constexpr (std::is_same_v<T, float> && N == 4) return _mm_max_ps(a, b);
    if constexpr (std::is_same_v<T, double> && N == 2) return _mm_max_pd(a, b);
#endif
    return a > b ? a : b;
  }
  [[gnu::always_inline]] static Raw smaller(Raw a, Raw b) {
#if defined(__AVX__)
    if constexpr (std::is_same_v<T, float> && N == 8) return _mm256_min_ps(a, b);
    if constexpr (std::is_same_v<T, double> && N == 4) return _mm256_min_pd(a, b);
#endif
#if defined(__SSE2__)
    if constexpr (std::is_same_v<T, float> && N == 4) return _mm_min_ps(a, b);
    if constexpr (std::is_same_v<T, double> && N == 2) return _mm_min_pd(a, b);
#endif
    return a < b ? a : b;
  }

  [[gnu::always_inline]] static Raw root(Raw a) {
#if defined(__AVX512F__)
    if constexpr (std::is_same_v<T, double> && N == 8) return _mm512_maskz_sqrt_pd(0xff, a);
    if constexpr (std::is_same_v<T, float> && N == 16) return _mm512_maskz_sqrt_ps(0xffff, a);
#endif
#if defined(__AVX__)
    if constexpr (std::is_same_v<T, double> && N == 4) return _mm256_sqrt_pd(a);
    if constexpr (std::is_same_v<T, float> && N == 8) return _mm256_sqrt_ps(a);
#endif
#if defined(__SSE2__)
    if constexpr (std::is_same_v<T, double> && N == 2) return _mm_sqrt_pd(a);
    if constexpr (std::is_same_v<T, float> && N == 4) return _mm_sqrt_ps(a);
#endif
    Raw result;
    for (int k = 0; k < N; ++k) result[k] = squareRoot(a[k]);
    return result;
  }
};

/// The sum of all lanes, always added up in the same order.
template <class T, int N, class Isa>
[[gnu::always_inline]] inline T sumOfLanes(const Pack<T, N, Isa>& a) {
  if constexpr (N == 1) {
    return a.raw[0];
  } else {
    Pack<T, N / 2, Isa> low, high;
    for (int k = 0; k < N / 2; ++k) {
      low.raw[k] = a.raw[k];
      high.raw[k] = a.raw[k + N / 2];
    }
    return sumOfLanes(low + high);
  }
}

/// Bit k says whether lane k is smaller than `limit`.
template <class T, int N, class Isa>
[[gnu::always_inline]] inline unsigned lanesBelow(const Pack<T, N, Isa>& a, T limit) {
  const auto below = a < Pack<T, N, Isa>(limit);
#if defined(__AVX512F__)
  if constexpr (sizeof(below) == 64 && sizeof(T) == 8)
    return _mm512_cmplt_pd_mask(a.raw, Pack<T, N, Isa>(limit).raw);
#endif
#if defined(__AVX__)
  if constexpr (sizeof(below) == 32 && sizeof(T) == 4)
    return static_cast<unsigned>(_mm256_movemask_ps((__m256)below));
  if constexpr (sizeof(below) == 32 && sizeof(T) == 8)
    return static_cast<unsigned>(_mm256_movemask_pd((__m256d)below));
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(below) == 16 && sizeof(T) == 4)
    return static_cast<unsigned>(_mm_movemask_ps((__m128)below));
  if constexpr (sizeof(below) == 16 && sizeof(T) == 8)
    return static_cast<unsigned>(_mm_movemask_pd((__m128d)below));
#endif
  unsigned bits = 0;
  for (int k = 0; k < N; ++k) bits |= static_cast<unsigned>(below[k] != 0) << k;
  return bits;
}

}  // namespace plenum
