// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace plenum {

/// A gas at one place.
struct GasState {
  double density = 0;   ///< [kg/m^d]
  double velocity = 0;  ///< [m/s]
  double pressure = 0;  ///< [Pa m^(3-d)]
};

/// Exact solution of the Riemann problem of an ideal gas: two uniform states meet at x = 0, t = 0
/// (Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed. 2009, chapter 4, doi
/// 10.1007/b79761). An isothermal gas is the limit gamma = 1 with p = c^2 rho on both sides: the
/// relations across shocks hold as they stand, the powers of rarefactions become exponentials.
class RiemannProblem {
 public:
  /// Throws InputError for densities, pressures and gamma that cannot be, and for states that part
  /// so fast that there is vacuum between them (Toro eq. 4.40), which no particles can show.
  RiemannProblem(const GasState& left, const GasState& right, double gamma);

  /// One of the two waves that run into the gas. Speeds are coordinates x/t [m/s].
  struct Wave {
    GasState behind;  ///< between this wave and the contact
    bool isShock = false;
    double head = 0;  ///< where undisturbed gas begins
    double tail = 0;  ///< where `behind` begins; at a shock the same as head
  };

  const Wave& left() const { return left_.wave; }
  const Wave& right() const { return right_.wave; }
  double starPressure() const { return left_.wave.behind.pressure; }  ///< p* [Pa m^(3-d)]
  double starVelocity() const { return left_.wave.behind.velocity; }  ///< u* [m/s], the contact's

  /// The gas at x/t [m/s]; +-infinity for t = 0.
  GasState at(double speed) const;

 private:
  /// The gas on one side, as it would be seen with that side on the left.
  struct Side {
    GasState ahead;  // velocity towards the other side
    double soundSpeed = 0;
    Wave wave = {};
  };
  double velocityChange(const Side& side, double pressure) const;
  double solveForPressure() const;
  void makeWave(Side& side, double pressure, double velocity) const;
  GasState insideFan(const Side& side, double speed) const;
  GasState onSide(const Side& side, double speed) const;

  double gamma_;
  Side left_, right_;
};

}  // namespace plenum
