// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/gas_states.hpp"

#include "ictools/formula.hpp"
#include "particles/ideal_gas.hpp"
#include "particles/parallel.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace plenum {

namespace {

/// What says how hot an ideal gas is; see gas_settings.hpp.
struct Heat {
  std::optional<double> pressure, internalEnergy, temperature;
  std::string pressureFormula, internalEnergyFormula;
  CaseNode node;  ///< the table
};

Heat heatOf(const FluidSettings& fluid) {
  return {fluid.pressure,        fluid.internalEnergy,        fluid.temperature,
          fluid.pressureFormula, fluid.internalEnergyFormula, fluid.node};
}

/// The densities of a gas: one, or a profile.
template <int Dim>
struct GasDensity {
  double density;
  DensityProfilePtr<Dim> profile;
  CaseNode table;

  void at(std::span<const Vec<Dim>> points, std::span<double> densities) const {
    if (!profile) return std::fill(densities.begin(), densities.end(), density);
    std::ranges::copy(densitiesAt<Dim>(*profile, points, plenum::at(table, "profile")),
                      densities.begin());
  }
};

/// p = c^2 rho, whatever the fluid's density.
template <int Dim>
class IsothermalStates : public InitialStates<Dim> {
 public:
  IsothermalStates(GasDensity<Dim> density, double soundSpeed, bool isPassive)
      : density_(std::move(density)), soundSpeedSquared_(isPassive ? 0 : soundSpeed * soundSpeed) {}

  void at(std::span<const Vec<Dim>> points, const StateArrays& states) const override {
    density_.at(points, states.density);
    forEachIndex(points.size(), [&](std::size_t k) {
      states.pressure[k] = soundSpeedSquared_ * states.density[k];
    });
  }

 private:
  GasDensity<Dim> density_;
  double soundSpeedSquared_;
};

/// p = (gamma - 1) rho e.
template <int Dim>
class IdealGasStates : public InitialStates<Dim> {
 public:
  IdealGasStates(GasDensity<Dim> density, Heat heat, const SolverSettings& solver, bool isPassive)
      : density_(std::move(density)),
        heat_(std::move(heat)),
        gamma_(solver.adiabaticIndex),
        molecularWeight_(solver.molecularWeight),
        isPassive_(isPassive) {}

  void at(std::span<const Vec<Dim>> points, const StateArrays& states) const override {
    density_.at(points, states.density);
    setEnergies(points, states);
    forEachIndex(points.size(), [&](std::size_t k) {
      states.pressure[k] =
          isPassive_ ? 0 : pressureOfEnergy(states.internalEnergy[k], states.density[k], gamma_);
    });
  }

 private:
  void setEnergies(std::span<const Vec<Dim>> points, const StateArrays& states) const {
    const auto energy = states.internalEnergy;
    if (heat_.internalEnergy) return std::fill(energy.begin(), energy.end(), *heat_.internalEnergy);
    if (heat_.temperature)
      return std::fill(energy.begin(), energy.end(),
                       energyOfTemperature(*heat_.temperature, molecularWeight_, gamma_));
    if (!heat_.internalEnergyFormula.empty()) {
      std::ranges::copy(
          positiveValues("internal_energy_formula", heat_.internalEnergyFormula, points),
          energy.begin());
      return;
    }
    std::vector<double> pressure;
    if (!heat_.pressureFormula.empty())
      pressure = positiveValues("pressure_formula", heat_.pressureFormula, points);
    forEachIndex(points.size(), [&](std::size_t k) {
      energy[k] = energyOfPressure(pressure.empty() ? *heat_.pressure : pressure[k],
                                   states.density[k], gamma_);
    });
  }

  std::vector<double> positiveValues(const std::string& key, const std::string& formula,
                                     std::span<const Vec<Dim>> points) const {
    const CaseNode& node = plenum::at(heat_.node, key);
    std::vector<double> values = finiteValuesAt(Formula<Dim>(formula, node), points, node);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (!(values[k] > 0))
        node.fail(fmt::format("gives {:g} at ({:g}); in an ideal gas it must be > 0 everywhere",
                              values[k], fmt::join(points[k].components, ", ")));
    return values;
  }

  GasDensity<Dim> density_;
  Heat heat_;
  double gamma_, molecularWeight_;
  bool isPassive_;
};

template <int Dim>
InitialStatesPtr<Dim> statesOf(GasDensity<Dim> density, const FluidSettings& fluid, Heat heat,
                               const SolverSettings& solver, bool isPassive) {
  if (solver.isIdealGas())
    return std::make_unique<const IdealGasStates<Dim>>(std::move(density), std::move(heat), solver,
                                                       isPassive);
  return std::make_unique<const IsothermalStates<Dim>>(
      std::move(density), fluid.ownSolver(solver).soundSpeed, isPassive);
}

}  // namespace

template <int Dim>
InitialStatesPtr<Dim> gasStates(const FluidFill<Dim>& fluid, const SolverSettings& solver) {
  const FluidSettings& settings = fluid.settings;
  return statesOf<Dim>({settings.density, fluid.profile, settings.node}, settings, heatOf(settings),
                       solver, false);
}

template <int Dim>
InitialStatesPtr<Dim> gasStates(const WallFill<Dim>& wall, const FluidSettings& like,
                                const SolverSettings& solver) {
  const WallSettings& settings = wall.settings;
  Heat heat = heatOf(like);
  if (settings.pressure || settings.internalEnergy)
    heat = {settings.pressure, settings.internalEnergy, {}, "", "", settings.node};
  const bool isPassive = solver.wallPressure == "zero" && !settings.pressure;
  return statesOf<Dim>({wall.density, nullptr, settings.node}, like, std::move(heat), solver,
                       isPassive);
}

template InitialStatesPtr<1> gasStates(const FluidFill<1>&, const SolverSettings&);
template InitialStatesPtr<2> gasStates(const FluidFill<2>&, const SolverSettings&);
template InitialStatesPtr<3> gasStates(const FluidFill<3>&, const SolverSettings&);
template InitialStatesPtr<1> gasStates(const WallFill<1>&, const FluidSettings&,
                                       const SolverSettings&);
template InitialStatesPtr<2> gasStates(const WallFill<2>&, const FluidSettings&,
                                       const SolverSettings&);
template InitialStatesPtr<3> gasStates(const WallFill<3>&, const FluidSettings&,
                                       const SolverSettings&);

}  // namespace plenum
