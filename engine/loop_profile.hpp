// SPDX-License-Identifier: GPL-3.0-or-later
//
// The kernel of a pair loop: known to the compiler, or chosen at run time.
#pragma once

#include "particles/kernels.hpp"

#include <type_traits>

namespace plenum {

/// The profile of terms that use no kernel.
struct NoKernel {
  static constexpr std::array sigma{0.0, 0.0, 0.0};
  template <class Real>
  static constexpr Real f(Real) {
    return Real(0);
  }
  template <class Real>
  static constexpr Real g(Real) {
    return Real(0);
  }
};

/// `Profile` is a kernel, kernel::Any or one made of them (Adaptive).
template <class Profile>
constexpr Profile profileOf(int kernel) {
  if constexpr (std::is_same_v<Profile, kernel::Any>)
    return {KernelId(kernel)};
  else if constexpr (std::is_base_of_v<kernel::Any, Profile>)
    return {kernel::Any{KernelId(kernel)}};
  else
    return {};
}

/// Sanitizers make loops ten times as long to compile: then all kernels share the generic ones.
#if defined(PLENUM_GENERIC_LOOPS_ONLY)
inline constexpr bool genericLoopsOnly = true;
#else
inline constexpr bool genericLoopsOnly = false;
#endif

/// Calls `visit` with the profile of kernel `id` if it is one of `Tuned`, which have loops of their
/// own, else with kernel::Any.
template <class... Tuned, class Visit>
constexpr void withProfileAmong(int id, Visit&& visit) {
  bool found = false;
  const auto tryProfile = [&](auto profile) {
    if (kernel::indexOf<decltype(profile)>() != id) return;
    visit(profile);
    found = true;
  };
  if constexpr (!genericLoopsOnly) (tryProfile(Tuned{}), ...);
  if (!found) visit(kernel::Any{});
}

}  // namespace plenum
