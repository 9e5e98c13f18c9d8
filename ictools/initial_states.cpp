// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/initial_states.hpp"

#include "ictools/formula.hpp"
#include "ictools/gas_states.hpp"
#include "ictools/state.hpp"
#include "particles/parallel.hpp"

#include <algorithm>

namespace plenum {

namespace {

constexpr std::size_t batchLength = 4096;

/// A liquid: density and pressure belong to each other.
template <int Dim>
class LiquidStates : public InitialStates<Dim> {
 public:
  LiquidStates(const FluidFill<Dim>& fluid, const SolverSettings& solver)
      : settings_(fluid.settings),
        profile_(fluid.profile),
        state_(settings_.ownSolver(solver), settings_.density, settings_.pressure,
               settings_.hydrostatic, settings_.node) {}

  void at(std::span<const Vec<Dim>> points, const StateArrays& states) const override {
    const std::vector<double> given = givenAt(points);
    if (given.empty() && state_.isUniform()) {
      const FluidState everywhere = state_(Vec<Dim>{});
      std::ranges::fill(states.density, everywhere.density);
      std::ranges::fill(states.pressure, everywhere.pressure);
      return;
    }
    parallelFor((points.size() + batchLength - 1) / batchLength, [&](std::size_t b) {
      const std::size_t end = std::min(points.size(), (b + 1) * batchLength);
      for (std::size_t k = b * batchLength; k < end; ++k) {
        const FluidState here = given.empty() ? state_(points[k])
                                : profile_    ? state_.withDensity(given[k])
                                              : state_.withPressure(given[k]);
        states.density[k] = here.density;
        states.pressure[k] = here.pressure;
      }
    });
  }

 private:
  /// What formula or profile say at the points; empty where there is neither.
  std::vector<double> givenAt(std::span<const Vec<Dim>> points) const {
    if (profile_) return densitiesAt<Dim>(*profile_, points, plenum::at(settings_.node, "profile"));
    if (settings_.pressureFormula.empty()) return {};
    const CaseNode& node = plenum::at(settings_.node, "pressure_formula");
    return finiteValuesAt(Formula<Dim>(settings_.pressureFormula, node), points, node);
  }

  FluidSettings settings_;
  DensityProfilePtr<Dim> profile_;
  InitialState state_;
};

/// A wall beside a liquid.
template <int Dim>
class LiquidWallStates : public InitialStates<Dim> {
 public:
  LiquidWallStates(const WallFill<Dim>& wall, const SolverSettings& solver)
      : density_(wall.density),
        isHydrostatic_(wall.settings.hydrostatic.has_value()),
        isPassive_(solver.wallPressure == "zero" && !wall.settings.pressure && !isHydrostatic_),
        state_(solver, wall.density, wall.settings.pressure, wall.settings.hydrostatic,
               wall.settings.node) {}

  void at(std::span<const Vec<Dim>> points, const StateArrays& states) const override {
    for (std::size_t k = 0; k < points.size(); ++k) {
      FluidState here = isPassive_ ? FluidState{0, density_} : state_(points[k]);
      // A wall above the surface of a liquid at rest does not pull.
      if (isHydrostatic_ && here.pressure < 0) here = state_.withPressure(0);
      states.density[k] = here.density;
      states.pressure[k] = here.pressure;
    }
  }

 private:
  double density_;
  bool isHydrostatic_, isPassive_;
  InitialState state_;
};

}  // namespace

template <int Dim>
InitialStatesPtr<Dim> initialStates(const FluidFill<Dim>& fluid, const SolverSettings& solver) {
  if (solver.equationOfState == "tait")
    return std::make_unique<const LiquidStates<Dim>>(fluid, solver);
  return gasStates(fluid, solver);
}

template <int Dim>
InitialStatesPtr<Dim> initialStates(const WallFill<Dim>& wall,
                                    const std::vector<FluidFill<Dim>>& fluids,
                                    const SolverSettings& solver) {
  const auto like = std::ranges::find(
      fluids, wall.density, [](const FluidFill<Dim>& fluid) { return fluid.settings.density; });
  if (solver.equationOfState == "tait")
    return std::make_unique<const LiquidWallStates<Dim>>(
        wall, like == fluids.end() ? solver : like->settings.ownSolver(solver));
  return gasStates(wall, (like == fluids.end() ? fluids.front() : *like).settings, solver);
}

#define PLENUM_INSTANTIATE(Dim)                                                               \
  template InitialStatesPtr<Dim> initialStates(const FluidFill<Dim>&, const SolverSettings&); \
  template InitialStatesPtr<Dim> initialStates(                                               \
      const WallFill<Dim>&, const std::vector<FluidFill<Dim>>&, const SolverSettings&);
PLENUM_INSTANTIATE(1)
PLENUM_INSTANTIATE(2)
PLENUM_INSTANTIATE(3)
#undef PLENUM_INSTANTIATE

}  // namespace plenum
