// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/preflight_gas.hpp"

#include "particles/errors.hpp"
#include "solver/self_term.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plenum {

namespace {

[[noreturn]] void refuse(const std::string& key, const std::string& why,
                         const std::string& remedy) {
  throw InputError(fmt::format("solver.{} {}; {}", key, why, remedy));
}

/// What has smoothing lengths or energies of its own, for messages.
std::string reasonOf(const SolverSettings& s) {
  if (s.isIdealGas()) return "equation_of_state = \"ideal_gas\"";
  if (s.adaptive) return "adaptive";
  if (s.usesBalsara()) return "viscosity.monaghan.balsara";
  return s.bulk() ? "viscosity.bulk" : "viscosity.neumann_richtmyer";
}

void checkNumerics(const SolverSettings& s) {
  const std::string gas = reasonOf(s);
  if (!s.sumsDensity())
    refuse("density = \"continuity\"",
           "does not go with " + gas + ": smoothing lengths follow summed densities",
           "set density = \"summation\"");
  if (s.momentum == "density_product")
    refuse("momentum = \"density_product\"", "does not go with " + gas,
           "leave momentum out, or set \"density_squared\"");
  if (s.wallsEvolve() || s.wallsExtrapolate())
    refuse("wall_pressure = \"" + s.wallPressure + "\"",
           "is not known for particles with smoothing lengths of their own (" + gas + ")",
           "set wall_pressure = \"initial\" or \"zero\"");
  const std::pair<bool, const char*> liquids[] = {{s.laminar() != nullptr, "viscosity.laminar"},
                                                  {s.collisions.has_value(), "collisions"},
                                                  {s.shifting.has_value(), "shifting"}};
  for (const auto& [isAsked, key] : liquids)
    if (isAsked)
      refuse(key, "is for liquids and does not go with " + gas, "leave one of the two out");
}

void checkViscosities(const SolverSettings& s) {
  if (!s.viscosity) return;
  const bool hasPairs = s.monaghan() != nullptr || s.tensor() != nullptr;
  const bool hasPressure = s.bulk() != nullptr || s.neumannRichtmyer() != nullptr;
  if ((s.monaghan() != nullptr && s.tensor() != nullptr) || (hasPairs && hasPressure))
    refuse("viscosity", "has several artificial viscosities, each of which is meant to be enough",
           "keep monaghan, or tensor, or bulk and neumann_richtmyer");
}

template <int Dim>
void checkEnergies(const SceneInfo<Dim>& info, const ParticleSet<Dim>& particles) {
  if (!particles.has(field::internalEnergy))
    throw InputError(fmt::format(
        "the particle file has no internal_energy (InternalEnergy), which solver.equation_of_state "
        "= \"ideal_gas\" needs; give each [[fluid]] of {} its pressure, internal_energy or "
        "temperature and run plenum-ic generate again",
        info.caseName));
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double e = particles[field::internalEnergy][i];
    if (!(e > 0 && std::isfinite(e)))
      throw InputError(fmt::format(
          "particle {}: internal_energy = {:g} J/kg, must be above 0; generate the particle file "
          "anew with a positive pressure or energy",
          particles[field::id][i], e));
  }
}

}  // namespace

template <int Dim>
void checkGas(const SceneInfo<Dim>& info, const ParticleSet<Dim>& particles,
              const SolverSettings& settings) {
  checkViscosities(settings);
  if (settings.conductivity && !settings.isIdealGas())
    refuse("conductivity", "conducts internal energy, which only an ideal gas has",
           "set equation_of_state = \"ideal_gas\", or leave conductivity out");
  if (settings.selfTermCorrection && !hasSelfTermCorrection(settings.kernel, Dim))
    refuse("self_term_correction", fmt::format("is not known for {} in {}-D", settings.kernel, Dim),
           "it is for wendland_c2, wendland_c4 and wendland_c6 in 3-D");
  if (settings.selfTermCorrection && !settings.lengthsFollow())
    refuse("self_term_correction", "depends on the number of neighbours, which adaptive keeps",
           "set adaptive = {} beside it");
  if (!settings.hasOwnLengths()) return;
  checkNumerics(settings);
  if (settings.isIdealGas()) checkEnergies(info, particles);
}

template void checkGas<1>(const SceneInfo<1>&, const ParticleSet<1>&, const SolverSettings&);
template void checkGas<2>(const SceneInfo<2>&, const ParticleSet<2>&, const SolverSettings&);
template void checkGas<3>(const SceneInfo<3>&, const ParticleSet<3>&, const SolverSettings&);

}  // namespace plenum
