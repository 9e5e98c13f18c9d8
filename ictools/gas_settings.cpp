// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/gas_settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace plenum {

namespace {

/// What an ideal gas may be given instead of its energy; one of them.
const std::vector<std::string>& energyKeys() {
  static const std::vector<std::string> keys = {"pressure", "pressure_formula", "internal_energy",
                                                "internal_energy_formula", "temperature"};
  return keys;
}

std::vector<std::string> givenOf(const CaseNode& table, const std::vector<std::string>& keys) {
  std::vector<std::string> given;
  for (const std::string& key : keys)
    if (table.find(key) != nullptr) given.push_back(key);
  return given;
}

void refuse(const CaseNode& table, const std::vector<std::string>& keys, const std::string& why) {
  for (const std::string& key : givenOf(table, keys)) at(table, key).fail(why);
}

/// Keys of an ideal gas where there is none.
void refuseEnergies(const CaseNode& table, const SolverSettings& solver) {
  refuse(table, {"internal_energy", "internal_energy_formula", "temperature", "energy_deposit"},
         fmt::format("is of an ideal gas, and solver.equation_of_state = \"{}\" has no energy; "
                     "leave it out, or set equation_of_state = \"ideal_gas\"",
                     solver.equationOfState));
}

void refuseLiquids(const CaseNode& table, const SolverSettings& solver) {
  refuse(table, {"tait_exponent", "background_pressure", "cavitation_pressure"},
         fmt::format("is of a liquid, and solver.equation_of_state = \"{}\"; leave it out, or set "
                     "equation_of_state = \"tait\"",
                     solver.equationOfState));
  refuse(table, {"hydrostatic"},
         "is of a liquid; give a gas the density that balances gravity instead, e.g. profile = { "
         "formula = \"exp(-9.81*z/c^2)\" } with its numbers");
}

void checkIsothermal(const CaseNode& table, const SolverSettings& solver) {
  refuseEnergies(table, solver);
  refuseLiquids(table, solver);
  refuse(table, {"pressure", "pressure_formula"},
         "follows from the density in an isothermal gas, p = c^2 rho; give density or profile "
         "instead");
}

void checkIdealGas(const CaseNode& table, const SolverSettings& solver) {
  refuseLiquids(table, solver);
  refuse(table, {"sound_speed"},
         "follows from the energy in an ideal gas, c^2 = gamma (gamma - 1) e; leave it out and "
         "give pressure, internal_energy or temperature");
  const std::vector<std::string> given = givenOf(table, energyKeys());
  if (given.size() > 1)
    at(table, given[1]).fail(fmt::format("excludes {}; give one of them", given[0]));
  for (const std::string& key : given) {
    if (key.ends_with("formula")) continue;
    const CaseNode& node = at(table, key);
    if (!(node.asNumber() > 0))
      node.fail("must be > 0 in an ideal gas; nearly cold gas has a small one, as 1e-6");
  }
}

}  // namespace

const Section<EnergyDepositSettings>& energyDepositSection() {
  using S = EnergyDepositSettings;
  static const Section<S> section = [] {
    Section<S> made("energy put into the particles around a point, weighted by the case's kernel");
    made.vector("point", &S::point, "m", "where").required();
    made.number("energy", &S::energy, "J", Range::positive(), "the sum of m e that is added")
        .required();
    made.number("radius", &S::radius, "m", Range::positive(), "how far the kernel reaches: 2h")
        .required();
    return made;
  }();
  return section;
}

void checkGasKeys(const FluidSettings& fluid, const SolverSettings& solver) {
  if (solver.equationOfState == "tait") return refuseEnergies(fluid.node, solver);
  if (solver.equationOfState == "isothermal") return checkIsothermal(fluid.node, solver);
  checkIdealGas(fluid.node, solver);
  if (givenOf(fluid.node, energyKeys()).empty())
    fluid.node.fail(fmt::format(
        "fluid \"{}\" is an ideal gas and says nothing of its energy; give it one of {}",
        fluid.name, fmt::join(energyKeys(), ", ")));
}

void checkGasKeys(const WallSettings& wall, const SolverSettings& solver) {
  if (solver.equationOfState == "tait") return refuseEnergies(wall.node, solver);
  if (solver.equationOfState == "isothermal") return checkIsothermal(wall.node, solver);
  checkIdealGas(wall.node, solver);
}

}  // namespace plenum
