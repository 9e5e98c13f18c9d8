// SPDX-License-Identifier: GPL-3.0-or-later
//
// Table 1 of Kruisbrink et al. 2018, doi 10.4236/jamp.2018.69158, and the closed form of what it
// shows: the error of the pressure gradient of water at rest on a hexagonal lattice.
#include "particles/kernels.hpp"
#include "tests/support/run_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <optional>

namespace plenum {
namespace {

/// In per cent, means over 0 to 1 s by the trapezoidal rule, a value every 2 ms.
struct Errors {
  double absolute = 0;  ///< of |error|, what the source prints
  double withSign = 0;  ///< about this value the column sways
};

/// With the case's own step and duration. Longer steps are unstable for the narrower kernels. Means
/// over the first .5 s are up to .07 away.
Errors measureTank(const test::Changes& changes) {
  auto [scene, settings] = test::sceneOf<2>("hydrostatic_tank.toml", changes);
  settings.measures->order = false;
  Simulation<2> simulation(std::move(scene), settings.solverOrDefaults());
  constexpr int nIntervals = 500;
  Errors mean;
  for (int k = 0; k <= nIntervals; ++k) {
    simulation.advanceTo(1.0 * k / nIntervals, [] {});
    const double error =
        valueOf(measureState(simulation, *settings.measures), "pressure_gradient_error");
    const double weight = (k == 0 || k == nIntervals ? 0.5 : 1.0) / nIntervals;
    mean.withSign += weight * error;
    mean.absolute += weight * std::abs(error);
  }
  return mean;
}

/// (1/M)(1 + g H/(2 c^2)) - 1 in per cent, M = -sum_j V x_j^2 W'(r_j)/r_j over a hexagonal lattice
/// of spacing 1.
double closedForm(const std::string& kernel, double h) {
  const double row = std::sqrt(3.0) / 2;
  double moment = 0;
  kernel::withProfile(KernelId::named(kernel), [&](auto profile) {
    for (int j = -10; j <= 10; ++j)
      for (int i = -10; i <= 10; ++i) {
        const double x = i + 0.5 * std::abs(j % 2), y = j * row;
        if (i != 0 || j != 0)
          moment -= row * y * y * Kernel<2, decltype(profile)>::F(std::hypot(x, y), h);
      }
  });
  const double g = 9.81, height = 1, c = 30;
  return 100 * ((1 + g * height / (2 * c * c)) / moment - 1);
}

struct Row {
  const char* kernel;
  double h;                         ///< [d_ref]
  std::optional<double> asPrinted;  ///< in the source's table
  const char* precision = "mixed";
};

/// The hexagonal lattice is unstable for cubic_spline at 1.5 d_ref: it leaves its place as rounding
/// grows. With pairs in float that happens before 1 s (mean to .8 s 2.00 %, to 1 s 1.91 to 1.96 %
/// as the order of sums will have it), with pairs in double after it (1.98 %).
constexpr Row unstableLattice{"cubic_spline", 1.5, {}, "double"};

class HydrostaticTank : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(Table1, HydrostaticTank,
                         testing::Values(Row{"wendland_c2_1d", 1.5, 1.32},
                                         Row{"wendland_c2_1d", 2, {}}, Row{"wendland_c2", 1.5, {}},
                                         Row{"wendland_c2", 2, {}}, Row{"convex", 1.5, 2.76},
                                         Row{"convex", 2, 1.20}, unstableLattice,
                                         Row{"cubic_spline", 2, {}}, Row{"wendland_c4", 1.5, {}},
                                         Row{"wendland_c4", 2, {}}, Row{"quintic_spline", 1.5, {}},
                                         Row{"quintic_spline", 2, {}}),
                         [](const auto& row) {
                           return fmt::format("{}_{:.0f}", row.param.kernel, 10 * row.param.h);
                         });

TEST_P(HydrostaticTank, HasTheErrorOfItsKernel) {
  const Row& row = GetParam();
  const Errors here = measureTank({{"solver.kernel", row.kernel},
                                   {"solver.smoothing_length", fmt::format("{:.1f}", row.h)},
                                   {"solver.precision", row.precision}});
  const double expected = closedForm(row.kernel, row.h);
  std::cout << fmt::format("  {:15} {:.1f}: closed form {:.3f} %, here {:.3f} %, |.| {:.3f} %{}\n",
                           row.kernel, row.h, expected, here.withSign, here.absolute,
                           row.asPrinted ? fmt::format(", source {:.2f} %", *row.asPrinted) : "");
  // The sway, up to 1 %, does not end with a whole period.
  EXPECT_NEAR(here.withSign, expected, 0.05);
  if (row.asPrinted) {
    EXPECT_NEAR(here.absolute, *row.asPrinted, 0.05);
  }
}

/// No pair ever comes closer than .99 d_ref.
TEST(HydrostaticTankCollisions, ChangeNoDigit) {
  const Errors without = measureTank({});
  const Errors with = measureTank({{"solver.collisions", "{ restitution = 0.01, range = 0.85 }"}});
  EXPECT_EQ(with.absolute, without.absolute);
  EXPECT_EQ(with.withSign, without.withSign);
}

/// Walls that keep their first pressure do as well.
TEST(HydrostaticTankWalls, MayKeepTheirPressure) {
  const Errors kept = measureTank({{"solver.wall_pressure", "initial"}});
  EXPECT_NEAR(kept.absolute, 1.32, 0.05);
}

}  // namespace
}  // namespace plenum
