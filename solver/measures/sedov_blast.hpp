// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/measures/riemann_problem.hpp"

#include <vector>

namespace plenum {

/// Point explosion in a cold ideal gas of uniform density (Sedov, Similarity and Dimensional
/// Methods in Mechanics, 1959; Kamm & Timmes 2007, LA-UR-07-2849). With lambda = r/R, D = dR/dt the
/// flow is u = D f(lambda), rho = rho0 g(lambda), p = rho0 D^2 q(lambda), and R = (E t^2/(alpha
/// rho0))^(1/(d + 2)). The ordinary equations of f/lambda, ln g and ln q over ln lambda are smooth
/// down to the centre, for every gamma of the standard case, and are integrated inwards from the
/// strong shock once; closed forms divide by zero at some gamma.
class SedovBlast {
 public:
  /// `dim` 1, 2 or 3; in 1-D the energy is that of both sides. Throws InputError for a gamma at
  /// which the gas leaves a vacuum in the middle: from 7 on in 3-D.
  SedovBlast(int dim, double gamma);

  double alpha() const { return alpha_; }  ///< E t^2/(rho0 R^(d + 2))

  /// R [m] after `time` [s] of an explosion with `energy` [J m^(d-3)] in `density` [kg/m^d].
  double shockRadius(double time, double energy, double density) const;

  /// g, f and q as density, velocity and pressure of a gas with rho0 = 1 and D = 1; lambda >= 0.
  GasState at(double lambda) const;

 private:
  struct Point {  // and the slopes of all three over s = ln lambda
    double phi, lnG, lnQ;
    Point operator+(const Point& b) const { return {phi + b.phi, lnG + b.lnG, lnQ + b.lnQ}; }
    Point operator*(double a) const { return {a * phi, a * lnG, a * lnQ}; }
  };
  Point slope(double s, const Point& y) const;
  double phiWithoutEnergyFlux(double s, const Point& y) const;
  void integrate();
  double energyIntegral() const;
  Point interpolated(double s) const;

  int dim_;
  double gamma_, step_;        // of s, going down from 0
  std::vector<Point> points_;  // at s = -k step
  double alpha_ = 0;
};

}  // namespace plenum
