// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/sedov_blast.hpp"

#include "particles/errors.hpp"
#include "solver/measures/gas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

constexpr double lowestS = -7;         // lambda = 1e-3: from there on everything is a power
constexpr double lowestDensity = -60;  // ln g: 1e-26 of the density around has no mass

}  // namespace

SedovBlast::SedovBlast(int dim, double gamma)
    : dim_(dim), gamma_(gamma), step_(2e-3 * std::min(1.0, gamma - 1)) {
  if (!(gamma > 1) || (dim == 3 && gamma >= 7))
    throw InputError(fmt::format(
        "gamma = {:g}: must be above 1{}", gamma,
        dim == 3 ? " and below 7, from where on the explosion leaves a vacuum in the middle" : ""));
  integrate();
  const double delta = 2.0 / (dim + 2);  // R grows as t^delta, so D = delta R/t
  alpha_ = unitSphereSurface(dim) * delta * delta * energyIntegral();
}

/// Euler's equations of a similar flow whose shock slows as R d^2R/dt^2 = -d/2 D^2. With
/// phi = f/lambda, M = g lambda^2/q, A = df/dlambda, k = A + (d - 1) phi, the divergence of f:
/// A (gamma - M (phi - 1)^2) = d - gamma (d - 1) phi - d/2 M phi (phi - 1),
/// dphi/ds = A - phi, dlnG/ds = -k/(phi - 1), dlnQ/ds = (d - gamma k)/(phi - 1).
SedovBlast::Point SedovBlast::slope(double s, const Point& y) const {
  const double d = dim_, inwards = y.phi - 1;
  const double M = std::exp(y.lnG - y.lnQ + 2 * s);
  const double A = (d - gamma_ * (d - 1) * y.phi - 0.5 * d * M * y.phi * inwards) /
                   (gamma_ - M * inwards * inwards);
  const double k = A + (d - 1) * y.phi;
  return {A - y.phi, -k / inwards, (d - gamma_ * k) / inwards};
}

/// The energy inside r/R = const stays the same (Landau & Lifshitz, Fluid Mechanics, section 106):
/// (phi - 1)(M phi^2/2 + 1/(gamma - 1)) + phi = 0. Newton's iteration from y.phi, which is near.
double SedovBlast::phiWithoutEnergyFlux(double s, const Point& y) const {
  const double M = std::exp(y.lnG - y.lnQ + 2 * s);
  double phi = y.phi;
  for (int k = 0; k < 3; ++k) {
    const double energy = 0.5 * M * phi * phi + 1 / (gamma_ - 1);
    phi -= ((phi - 1) * energy + phi) / (energy + (phi - 1) * M * phi + 1);
  }
  return phi;
}

/// Runge-Kutta of fourth order, from the strong shock down. Errors of phi would grow as lambda^-d
/// on the way in, so each step ends where no energy flows.
void SedovBlast::integrate() {
  const double behind = 2 / (gamma_ + 1);
  Point y{behind, std::log((gamma_ + 1) / (gamma_ - 1)), std::log(behind)};
  points_ = {y};
  const double h = -step_;
  for (double s = 0; s > lowestS && y.lnG > lowestDensity;) {
    const Point k1 = slope(s, y), k2 = slope(s + h / 2, y + k1 * (h / 2));
    const Point k3 = slope(s + h / 2, y + k2 * (h / 2)), k4 = slope(s + h, y + k3 * h);
    y = y + (k1 + (k2 + k3) * 2 + k4) * (h / 6);
    s = -step_ * static_cast<double>(points_.size());
    y.phi = phiWithoutEnergyFlux(s, y);
    points_.push_back(y);
  }
  if (points_.size() % 2 == 0) points_.pop_back();  // Simpson's rule takes pairs of steps
}

/// Integral of (g f^2/2 + q/(gamma - 1)) lambda^(d-1) over lambda, by Simpson's rule over ln
/// lambda.
double SedovBlast::energyIntegral() const {
  const std::size_t last = points_.size() - 1;
  double sum = 0;
  for (std::size_t k = 0; k <= last; ++k) {
    const double s = -step_ * static_cast<double>(k);
    const Point& y = points_[k];
    const double f = y.phi * std::exp(s);
    const double density = 0.5 * std::exp(y.lnG) * f * f + std::exp(y.lnQ) / (gamma_ - 1);
    const double weight = k == 0 || k == last ? 1 : (k % 2 == 1 ? 4 : 2);
    sum += weight * density * std::exp(dim_ * s);
  }
  // In the middle there is pressure and hardly any mass.
  const double innermost = -step_ * static_cast<double>(last);
  const double middle = std::exp(points_.back().lnQ + dim_ * innermost) / ((gamma_ - 1) * dim_);
  return sum * step_ / 3 + middle;
}

double SedovBlast::shockRadius(double time, double energy, double density) const {
  return std::pow(energy * time * time / (alpha_ * density), 1.0 / (dim_ + 2));
}

/// Cubic Hermite between the points.
SedovBlast::Point SedovBlast::interpolated(double s) const {
  const double place = -s / step_;
  const auto k = static_cast<std::size_t>(place);
  const double x = place - static_cast<double>(k), y = 1 - x;
  const Point& a = points_[k];
  const Point& b = points_[k + 1];
  const double sa = -step_ * static_cast<double>(k);
  const Point da = slope(sa, a) * -step_, db = slope(sa - step_, b) * -step_;
  return a * (y * y * (1 + 2 * x)) + b * (x * x * (1 + 2 * y)) + da * (x * y * y) +
         db * (-x * x * y);
}

GasState SedovBlast::at(double lambda) const {
  if (lambda > 1) return {1, 0, 0};
  const double innermost = -step_ * static_cast<double>(points_.size() - 1);
  if (std::log(lambda) > innermost) {
    const Point y = interpolated(std::log(lambda));
    return {std::exp(y.lnG), y.phi * lambda, std::exp(y.lnQ)};
  }
  // phi = 1/gamma, q = const, g as lambda^(d/(gamma - 1)).
  const Point& y = points_.back();
  const double ratio = lambda * std::exp(-innermost);
  return {std::exp(y.lnG) * std::pow(ratio, dim_ / (gamma_ - 1)), y.phi * lambda, std::exp(y.lnQ)};
}

}  // namespace plenum
