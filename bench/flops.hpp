// SPDX-License-Identifier: GPL-3.0-or-later
//
// Floating-point operations of a step, counted from the formulas (solver/terms.hpp) for a pair of
// particles and both its sides, as a loop needs them that computes what the sides share once. An
// addition, a product, a maximum, a comparison, a division and a root count 1 each; constants of
// the run count nothing. What the machine computes besides (lanes without a neighbour,
// sums over lanes) is no use, so it is not counted.
#pragma once

namespace plenum::bench {

/// r_ij (d), r^2 (2d - 1), root, R = r/h.
constexpr int distance(int d) { return d + (2 * d - 1) + 2; }
/// wendland_c2: t = max(0, 1 - R/2) (3), t^3 (2), factors -5 and sigma (2).
constexpr int gradient = 7;
/// t (3), t^4 (2), (1 + 2R) (2), the product and sigma (2).
constexpr int kernel = 9;
/// v_i - v_j (d), times r_ij (2d - 1).
constexpr int approach(int d) { return d + (2 * d - 1); }
/// F (v.r); a side: V_j times the former, added.
constexpr int continuity = 1 + 2 * 2;
/// A side: m_j W, added.
constexpr int densitySum = 2 * 2;
/// V_i V_j (p_i + p_j), or m_i m_j (p_i/rho_i^2 + p_j/rho_j^2).
constexpr int pressure = 3;
/// r^2 + .01 h^2 (1), 1/rho_i + 1/rho_j (1), h min(v.r, 0) over their product (4), mu (1), the
/// bracket (2) times the former (1), V_i V_j (1, or one more where the pressure does not have it).
constexpr int monaghanViscosity = 11;
/// Sum of the two factors (1), times F (1), times r_ij (d), added to i and taken from j (2d).
constexpr int force(int d) { return 2 + 3 * d; }

/// Of one interaction, which is one side of a pair, in both passes.
struct Flops {
  double density, forces;
};

/// Continuity; pressure and viscosity: 32.5 in 2-D, 40 in 3-D.
constexpr Flops damBreakFlops(int d) {
  const int shared = distance(d) + gradient + approach(d);
  return {0.5 * (shared + continuity), 0.5 * (shared + pressure + monaghanViscosity + force(d))};
}

/// Summation; pressure and viscosity.
constexpr Flops quietGasFlops(int d) {
  return {
      0.5 * (distance(d) + kernel + densitySum),
      0.5 * (distance(d) + gradient + approach(d) + pressure + monaghanViscosity + 1 + force(d))};
}

/// Kernels and gradients of both smoothing lengths, each with R = r/h of its own (1). Density and
/// Omega rho: a side m_j W (2) and m_j F r^2 (3). Forces: P_i F_i + P_j F_j, times m_i m_j (4);
/// viscosity with beta (2), the mean of the two F (2), half its work a side (1 + 2); rate of the
/// density: a side m_j F v.r (3).
constexpr Flops idealGasFlops(int d) {
  const int shared = distance(d) - 1 + 2 * (1 + gradient);
  return {0.5 * (shared + 2 * kernel + 2 * (2 + 3)),
          0.5 * (shared + approach(d) + 4 + monaghanViscosity + 1 + 2 + 2 + (1 + 2) + 2 * 3 +
                 force(d))};
}

}  // namespace plenum::bench
