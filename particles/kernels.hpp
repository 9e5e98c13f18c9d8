// SPDX-License-Identifier: GPL-3.0-or-later
//
// Smoothing kernels W(r) = sigma_d h^-d f(R), R = r/h, support 2h.
//
// Sources: [N] hand-written note on kernels; [C] Kruisbrink et al. 2018, doi
// 10.4236/jamp.2018.69158; Dehnen & Aly 2012, doi 10.1111/j.1365-2966.2012.21439.x; Price 2012,
// doi 10.1016/j.jcp.2010.12.011; Read et al. 2010, doi 10.1111/j.1365-2966.2010.16577.x.
//
// Each profile is written without branches, with truncated powers t = max(0, a - R), so that `Real`
// may be a pack of numbers as well as a double. A profile gives f(R) and g(R) = f'(R)/R; the
// gradient is grad_i W = sigma_d h^-(d+2) g(R) r_ij. Where f'(0) != 0, g is evaluated at
// max(R, tiny), so that coincident particles (r_ij = 0) give a zero gradient and no NaN.
#pragma once

#include "particles/number.hpp"

#include <array>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace plenum {

namespace kernel {

inline constexpr double pi = std::numbers::pi;

/// Smallest R used in a division by R.
inline constexpr double tinyR = 1e-9;

struct CubicSpline {
  static constexpr std::string_view name = "cubic_spline";
  static constexpr std::array sigma{2.0 / 3, 10 / (7 * pi), 1 / pi};
  template <class Real>
  static constexpr Real f(Real R) {
    const Real s = positivePart(Real(2) - R), t = positivePart(Real(1) - R);
    return Real(0.25) * s * s * s - t * t * t;
  }
  template <class Real>
  static constexpr Real g(Real R) {
    const Real s = positivePart(Real(2) - R), t = positivePart(Real(1) - R);
    return (Real(3) * t * t - Real(0.75) * s * s) / max(R, Real(tinyR));
  }
};

/// Quartic of Liu, figure 2 of [C].
struct QuarticLiu {
  static constexpr std::string_view name = "quartic_liu";
  static constexpr std::array sigma{1.0, 15 / (7 * pi), 315 / (208 * pi)};
  template <class Real>
  static constexpr Real f(Real R) {
    const Real t = positivePart(Real(2) - R);
    return t * t * (Real(1.0 / 6) + R * (Real(1.0 / 6) - Real(5.0 / 32) * R));
  }
  template <class Real>
  static constexpr Real g(Real R) {
    return positivePart(Real(2) - R) * (Real(0.625) * R - Real(1.125));
  }
};

/// M5 B-spline, rescaled to support 2h: q = 5R/4.
struct QuarticSpline {
  static constexpr std::string_view name = "quartic_spline";
  static constexpr std::array sigma{1.25 / 24, 1.25 * 1.25 * 96 / (1199 * pi),
                                    1.25 * 1.25 * 1.25 / (20 * pi)};
  template <class Real>
  static constexpr Real f(Real R) {
    const Real q = Real(1.25) * R;
    return power<4>(positivePart(Real(2.5) - q)) - Real(5) * power<4>(positivePart(Real(1.5) - q)) +
           Real(10) * power<4>(positivePart(Real(0.5) - q));
  }
  template <class Real>
  static constexpr Real g(Real R) {
    const Real q = Real(1.25) * R;
    return Real(-5) *
           (power<3>(positivePart(Real(2.5) - q)) -
            Real(5) * power<3>(positivePart(Real(1.5) - q)) +
            Real(10) * power<3>(positivePart(Real(0.5) - q))) /
           max(R, Real(tinyR));
  }
};

/// M6 B-spline, rescaled to support 2h: q = 3R/2.
struct QuinticSpline {
  static constexpr std::string_view name = "quintic_spline";
  static constexpr std::array sigma{1.5 / 120, 1.5 * 1.5 * 7 / (478 * pi),
                                    1.5 * 1.5 * 1.5 / (120 * pi)};
  template <class Real>
  static constexpr Real f(Real R) {
    const Real q = Real(1.5) * R;
    return power<5>(positivePart(Real(3) - q)) - Real(6) * power<5>(positivePart(Real(2) - q)) +
           Real(15) * power<5>(positivePart(Real(1) - q));
  }
  template <class Real>
  static constexpr Real g(Real R) {
    const Real q = Real(1.5) * R;
    return Real(-7.5) *
           (power<4>(positivePart(Real(3) - q)) - Real(6) * power<4>(positivePart(Real(2) - q)) +
            Real(15) * power<4>(positivePart(Real(1) - q))) /
           max(R, Real(tinyR));
  }
};

/// The "quintic" of [N]: the true Wendland C2 function of two and three dimensions.
struct WendlandC2 {
  static constexpr std::string_view name = "wendland_c2";
  static constexpr std::array sigma{3.0 / 4, 7 / (4 * pi), 21 / (16 * pi)};
  template <class Real>
  static constexpr Real f(Real R) {
    return power<4>(positivePart(Real(1) - Real(0.5) * R)) * (Real(1) + Real(2) * R);
  }
  template <class Real>
  static constexpr Real g(Real R) {
    return Real(-5) * power<3>(positivePart(Real(1) - Real(0.5) * R));
  }
};

struct WendlandC4 {
  static constexpr std::string_view name = "wendland_c4";
  static constexpr std::array sigma{27.0 / 32, 9 / (4 * pi), 495 / (256 * pi)};
  template <class Real>
  static constexpr Real f(Real R) {
    return power<6>(positivePart(Real(1) - Real(0.5) * R)) *
           (Real(1) + R * (Real(3) + Real(35.0 / 12) * R));
  }
  template <class Real>
  static constexpr Real g(Real R) {
    return Real(-7.0 / 3) * power<5>(positivePart(Real(1) - Real(0.5) * R)) *
           (Real(2) + Real(5) * R);
  }
};

struct WendlandC6 {
  static constexpr std::string_view name = "wendland_c6";
  static constexpr std::array sigma{15.0 / 16, 39 / (14 * pi), 1365 / (512 * pi)};
  template <class Real>
  static constexpr Real f(Real R) {
    return power<8>(positivePart(Real(1) - Real(0.5) * R)) *
           (Real(1) + R * (Real(4) + R * (Real(6.25) + Real(4) * R)));
  }
  template <class Real>
  static constexpr Real g(Real R) {
    return Real(-5.5) * power<7>(positivePart(Real(1) - Real(0.5) * R)) *
           (Real(1) + R * (Real(3.5) + Real(4) * R));
  }
};

/// The "Wendland kernel" (1.1) of [C]: positive definite in one dimension only.
struct WendlandC2OneD {
  static constexpr std::string_view name = "wendland_c2_1d";
  static constexpr std::array sigma{5.0 / 64, 5 / (32 * pi), 105 / (1024 * pi)};
  template <class Real>
  static constexpr Real f(Real R) {
    return power<3>(positivePart(Real(2) - R)) * (Real(1) + Real(1.5) * R);
  }
  template <class Real>
  static constexpr Real g(Real R) {
    const Real t = positivePart(Real(2) - R);
    return Real(-6) * t * t;
  }
};

/// (3.7) of [C].
struct WendlandQuadratic {
  static constexpr std::string_view name = "wendland_quadratic";
  static constexpr std::array sigma{1.0 / 8, 5 / (24 * pi), 15 / (128 * pi)};
  template <class Real>
  static constexpr Real f(Real R) {
    const Real t = positivePart(Real(2) - R);
    return t * t * (Real(1) + R);
  }
  template <class Real>
  static constexpr Real g(Real R) {
    return Real(-3) * positivePart(Real(2) - R);
  }
};

/// The convex kernel (3.9) of [C].
struct Convex {
  static constexpr std::string_view name = "convex";
  static constexpr std::array sigma{5.0 / 48, 15 / (64 * pi), 21 / (128 * pi)};
  template <class Real>
  static constexpr Real f(Real R) {
    return power<3>(positivePart(Real(2) - R)) * (Real(1) + Real(0.5) * R);
  }
  template <class Real>
  static constexpr Real g(Real R) {
    const Real t = positivePart(Real(2) - R);
    return Real(-2) * t * t * (Real(1) + R) / max(R, Real(tinyR));
  }
};

/// Schuessler & Schmitt, (3.5) of [C]; its slope is infinite at R = 0 and jumps at R = 2.
struct SchuesslerSchmitt {
  static constexpr std::string_view name = "schuessler_schmitt";
  static constexpr std::array sigma{3 / (4 * std::numbers::sqrt2),
                                    5 / (4 * std::numbers::sqrt2 * pi),
                                    21 / (32 * std::numbers::sqrt2 * pi)};
  template <class Real>
  static constexpr Real f(Real R) {
    return positivePart(Real(std::numbers::sqrt2) - squareRoot(R));
  }
  template <class Real>
  static constexpr Real g(Real R) {
    const Real r = max(R, Real(tinyR));
    return select(R < Real(2), Real(-0.5) / (r * squareRoot(r)), Real(0));
  }
};

/// Johnson & Beissel, (3.6) of [C].
struct JohnsonBeissel {
  static constexpr std::string_view name = "johnson_beissel";
  static constexpr std::array sigma{3.0 / 4, 3 / (2 * pi), 15 / (16 * pi)};
  template <class Real>
  static constexpr Real f(Real R) {
    const Real t = positivePart(Real(1) - Real(0.5) * R);
    return t * t;
  }
  template <class Real>
  static constexpr Real g(Real R) {
    return -positivePart(Real(1) - Real(0.5) * R) / max(R, Real(tinyR));
  }
};

/// Core-triangle of Read et al. 2010: the cubic spline with a constant slope below R = 2/3.
struct CoreTriangle {
  static constexpr std::string_view name = "core_triangle";
  static constexpr std::array sigma{54.0 / 85, 162 / (115 * pi), 3645 / (3661 * pi)};
  template <class Real>
  static constexpr Real f(Real R) {
    const Real x = Real(0.5) * R;
    return Real(2) * power<3>(positivePart(Real(1) - x)) -
           Real(8) * power<3>(positivePart(Real(0.5) - x)) +
           Real(6) * power<3>(positivePart(Real(1.0 / 3) - x));
  }
  template <class Real>
  static constexpr Real g(Real R) {
    const Real x = Real(0.5) * R;
    const Real s = positivePart(Real(1) - x), t = positivePart(Real(0.5) - x),
               u = positivePart(Real(1.0 / 3) - x);
    return (Real(12) * t * t - Real(3) * s * s - Real(9) * u * u) / max(R, Real(tinyR));
  }
};

template <class... Profiles>
struct ProfileList {};

/// All profiles, in the order of `KernelId`.
using AllProfiles = ProfileList<CubicSpline, QuarticLiu, QuarticSpline, QuinticSpline, WendlandC2,
                                WendlandC4, WendlandC6, WendlandC2OneD, WendlandQuadratic, Convex,
                                SchuesslerSchmitt, JohnsonBeissel, CoreTriangle>;

template <class Visit>
constexpr void forEachProfile(Visit&& visit) {
  [&]<class... Profiles>(ProfileList<Profiles...>) { (visit(Profiles{}), ...); }(AllProfiles{});
}

}  // namespace kernel

/// A profile as a kernel in `Dim` dimensions. `r` [m] and `h` [m] give W [m^-d] and F [m^-(d+2)],
/// where grad_i W = F r_ij.
template <int Dim, class Profile>
struct Kernel {
  static_assert(Dim >= 1 && Dim <= 3);
  static constexpr double sigma = Profile::sigma[Dim - 1];

  static double W(double r, double h) { return sigma * power<Dim>(1 / h) * Profile::f(r / h); }
  static double F(double r, double h) { return sigma * power<Dim + 2>(1 / h) * Profile::g(r / h); }
};

/// Names one of the profiles above at run time.
class KernelId {
 public:
  KernelId() = default;
  constexpr explicit KernelId(int index) : index_(index) {}

  /// Throws InputError that lists the known names.
  static KernelId named(const std::string& name);
  static const std::vector<std::string>& names();

  constexpr int index() const { return index_; }
  const std::string& name() const { return names()[static_cast<std::size_t>(index_)]; }
  constexpr bool operator==(const KernelId&) const = default;

 private:
  int index_ = 0;
};

namespace kernel {

/// Place of a profile in `forEachProfile`.
template <class Profile>
consteval int indexOf() {
  int index = -1, k = 0;
  forEachProfile([&](auto profile) {
    if (profile.name == Profile::name) index = k;
    ++k;
  });
  return index;
}

/// Calls `visit(profile)` with the profile that `id` names. One chain of comparisons, which
/// compilers make a jump of: pair loops ask for each pack of pairs.
template <class Visit>
[[gnu::always_inline]] constexpr void withProfile(KernelId id, Visit&& visit) {
  [&]<class... Profiles>(ProfileList<Profiles...>) {
    int k = 0;
    ((k++ == id.index() && (visit(Profiles{}), true)) || ...);
  }(AllProfiles{});
}

/// The profile chosen at run time: one pair loop for all kernels that no scene made fast.
struct Any {
  KernelId id;
  double sigma(int dim) const;

  template <class Real>
  constexpr Real f(Real R) const {
    Real value(0);
    withProfile(id, [&](auto profile) { value = profile.f(R); });
    return value;
  }
  template <class Real>
  constexpr Real g(Real R) const {
    Real value(0);
    withProfile(id, [&](auto profile) { value = profile.g(R); });
    return value;
  }
};

}  // namespace kernel
}  // namespace plenum
