// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/pairing_forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace plenum {

namespace {

/// f.5, the share of particles with a neighbour nearer than half a spacing, after a gas at a random
/// start has come to rest.
struct Measured {
  const char* kernel;
  std::vector<double> share;
};

/// 2-D: 462 particles in a periodic unit box, three seeds; h/d_ref of a hexagonal lattice.
const std::vector<double> h2{1.2, 1.5, 2, 2.5, 3};
const std::vector<Measured> measured2{
    {"cubic_spline", {.80, .97, .995, 1, .99}}, {"quartic_liu", {0, .19, .99, .99, .99}},
    {"wendland_quadratic", {1, 1, 1, 1, 1}},    {"wendland_c2_1d", {0, .01, .21, .46, .69}},
    {"quintic_spline", {0, 0, .66, .83, .84}},  {"quartic_spline", {0, 0, .68, .98, .995}},
};

/// 3-D: 1728 particles in a periodic unit box; neighbours within the support.
const std::vector<double> neighbours3{32, 48, 64, 80, 100, 200, 400};
const std::vector<Measured> measured3{
    {"cubic_spline", {0, 0, .44, .81, .92, .96, .97}},
    {"wendland_c2_1d", {.37, .68, .80, .84, .87, .96, .96}},
    {"quintic_spline", {0, 0, 0, 0, 0, .09, .25}},
};

/// Between the measured places on a straight line; nothing outside of them, but for shares that
/// have reached their end there.
std::optional<double> interpolated(const std::vector<double>& x, const std::vector<double>& y,
                                   double at) {
  if (at < x.front()) return y.front() == 0 ? std::optional(0.0) : std::nullopt;
  if (at > x.back()) return y.back() > 0 ? std::optional(y.back()) : std::nullopt;
  const auto next = std::upper_bound(x.begin(), x.end() - 1, at);
  const auto k = static_cast<std::size_t>(next - x.begin());
  const double t = (at - x[k - 1]) / (x[k] - x[k - 1]);
  return y[k - 1] + t * (y[k] - y[k - 1]);
}

std::optional<double> measuredShare(KernelId kernel, int dimension, double hOverSpacing,
                                    double neighbours) {
  if (dimension == 1) return std::nullopt;
  for (const Measured& row : dimension == 2 ? measured2 : measured3)
    if (row.kernel == kernel.name())
      return dimension == 2 ? interpolated(h2, row.share, hOverSpacing)
                            : interpolated(neighbours3, row.share, neighbours);
  return std::nullopt;
}

std::string textOf(const PairingForecast& f, KernelId kernel, int dimension, double hOverSpacing) {
  const std::string here = fmt::format("{} at h/d {:.2f} ({:.0f} neighbours in {}-D)",
                                       kernel.name(), hOverSpacing, f.neighbours, dimension);
  using Verdict = PairingForecast::Verdict;
  switch (f.verdict) {
    case Verdict::safe:
      return here +
             " is not known to pair: its Fourier transform is nowhere negative, and no "
             "measured set paired";
    case Verdict::pairs:
      return fmt::format(
          "{} is known to pair: its Fourier transform turns negative at k h = {:.2f}, and of "
          "particles from a random start about {:.0f} % paired; choose wendland_c2, or fewer "
          "neighbours",
          here, f.transform.firstNegative, 100 * *f.measuredShare);
    case Verdict::unpaired:
      return fmt::format(
          "{} is not known to pair with so few neighbours, but its Fourier transform turns "
          "negative at k h = {:.2f}: with more it may",
          here, f.transform.firstNegative);
    case Verdict::unknown:
      break;
  }
  return fmt::format(
      "{} may pair: its Fourier transform turns negative at k h = {:.2f}, and this case was not "
      "measured; choose wendland_c2 to be sure",
      here, f.transform.firstNegative);
}

}  // namespace

PairingForecast forecastPairing(KernelId kernel, int dimension, double h, double volume) {
  constexpr double pi = kernel::pi;
  const double support = 2 * h;
  PairingForecast forecast;
  const double reach = dimension == 1   ? 2 * support
                       : dimension == 2 ? pi * support * support
                                        : 4 * pi / 3 * support * support * support;
  forecast.neighbours = reach / volume;
  // d_ref of the densest lattice with that volume a particle.
  const double spacing = dimension == 1   ? volume
                         : dimension == 2 ? std::sqrt(volume * 2 / std::sqrt(3.0))
                                          : std::cbrt(volume * std::sqrt(2.0));
  forecast.transform = transformSign(kernel, dimension);
  forecast.measuredShare = measuredShare(kernel, dimension, h / spacing, forecast.neighbours);
  using Verdict = PairingForecast::Verdict;
  if (!forecast.transform.isNegative)
    forecast.verdict = Verdict::safe;
  else if (!forecast.measuredShare)
    forecast.verdict = Verdict::unknown;
  else
    forecast.verdict = *forecast.measuredShare >= 0.005 ? Verdict::pairs : Verdict::unpaired;
  forecast.text = textOf(forecast, kernel, dimension, h / spacing);
  return forecast;
}

}  // namespace plenum
