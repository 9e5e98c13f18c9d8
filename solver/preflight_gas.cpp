// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/preflight_gas.hpp"

#include "particles/errors.hpp"
#include "particles/solver_conflicts.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plenum {

namespace {

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
  if (const auto conflict = conflictOf(settings, Dim))
    throw InputError(fmt::format("solver.{}{} {}; {}", conflict->key,
                                 conflict->value.empty() ? "" : " = " + conflict->value,
                                 conflict->why, conflict->remedy));
  if (settings.isIdealGas()) checkEnergies(info, particles);
}

template void checkGas<1>(const SceneInfo<1>&, const ParticleSet<1>&, const SolverSettings&);
template void checkGas<2>(const SceneInfo<2>&, const ParticleSet<2>&, const SolverSettings&);
template void checkGas<3>(const SceneInfo<3>&, const ParticleSet<3>&, const SolverSettings&);

}  // namespace plenum
