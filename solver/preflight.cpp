// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/preflight.hpp"

#include "engine/engine.hpp"
#include "particles/errors.hpp"
#include "solver/phases.hpp"
#include "solver/preflight_gas.hpp"
#include "solver/preflight_streams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

template <int Dim>
void checkFields(const ParticleSet<Dim>& particles) {
  FieldSet needed{field::position, field::velocity, field::mass, field::density, field::id};
  if (particles.nWalls() > 0) needed |= {field::wall, field::normal};
  for (const FieldInfo& info : fieldTable)
    if (needed.has(info.id) && !particles.has(info.id))
      throw InputError(fmt::format("the particle file has no {} ({}); generate it with plenum-ic",
                                   info.name, info.fileName));
}

template <int Dim>
void checkValues(const ParticleSet<Dim>& particles, double support) {
  const auto ids = particles[field::id];
  const auto refuse = [&](std::size_t i, const char* what, double value) {
    throw InputError(fmt::format("particle {}: {} = {:g}; generate the particle file anew", ids[i],
                                 what, value));
  };
  for (std::size_t i = 0; i < particles.size(); ++i) {
    for (int a = 0; a < Dim; ++a) {
      const double x = particles[field::position][i][a], v = particles[field::velocity][i][a];
      if (!std::isfinite(x)) refuse(i, "position", x);
      if (!std::isfinite(v)) refuse(i, "velocity", v);
      if (!(std::abs(x) < 0.5 * mostSupportsAway * support))
        throw InputError(fmt::format(
            "particle {}: position = {:g} m is further away than {:g} times the kernel's support "
            "{:g} m, and could not be told from those beside it; generate the particle file anew",
            ids[i], x, 0.5 * mostSupportsAway, support));
    }
    const double mass = particles[field::mass][i], density = particles[field::density][i];
    if (!(mass > 0 && std::isfinite(mass))) refuse(i, "mass", mass);
    if (!(density > 0 && std::isfinite(density))) refuse(i, "density", density);
  }
}

/// Pairs are summed with one kernel for all.
template <int Dim>
void checkSmoothingLengths(const ParticleSet<Dim>& particles) {
  if (!particles.has(field::smoothingLength)) return;
  const auto lengths = particles[field::smoothingLength].first(particles.nFluid());
  const auto [least, most] = std::ranges::minmax(lengths);
  constexpr double roundOff = 1e-6;  // floats of files made by others
  if (most - least <= roundOff * most) return;
  throw InputError(fmt::format(
      "the particles' smoothing lengths reach from {:g} to {:g} m, because their spacing varies, "
      "and this run has one for all of them; set solver.adaptive, or make the set without "
      "[[refine]], equal_mass_with and particles = \"equal_mass\"",
      least, most));
}

/// Fluid may touch the surface, so a wall must be as thick as the support of the kernel.
template <int Dim>
void checkCoverage(const SceneInfo<Dim>& info, const SolverSettings& settings) {
  const double support = 2 * settings.smoothingLength * info.spacing;
  // Where walls sum their density, those that fluid can feel need a full neighbourhood behind them.
  const bool wallsSum = settings.wallsEvolve() && settings.density == "summation";
  const double needed = wallsSum ? 2 * support : support;
  std::string thin;
  for (const Wall& wall : info.walls) {
    const int missing =
        static_cast<int>(std::ceil((needed - wall.thickness) / info.spacing - 1e-6));
    if (missing <= 0) continue;
    thin += fmt::format("{}wall \"{}\" is {:g} m thick, {} layer{} of {:g} m short",
                        thin.empty() ? "" : "; ", wall.name, wall.thickness, missing,
                        missing == 1 ? "" : "s", info.spacing);
  }
  if (!thin.empty())
    throw InputError(fmt::format(
        "{}: the kernel's support is 2 x {:g} d_ref = {:g} m{}. Give these walls more layers "
        "in the case (or a thicker solid), or run with a smaller solver.smoothing_length{}",
        thin, settings.smoothingLength, support,
        wallsSum ? ", and walls whose density is summed need it twice" : "",
        wallsSum ? ", with density = \"continuity\" or with wall_pressure = \"zero\"" : ""));
}

/// Physics that do not go together.
template <int Dim>
void checkPhysics(const SceneInfo<Dim>& info, const SolverSettings& settings) {
  const std::vector<Material>& materials = info.materials;
  const bool manyDensities = std::ranges::any_of(materials, [&](const Material& material) {
    return material.density != materials.front().density;
  });
  if (manyDensities && settings.equationOfState == "tait")
    for (const Material& material : materials)
      if (!material.soundSpeed)
        throw InputError(fmt::format(
            "fluids of different densities and one equation of state: fluid \"{}\" has no "
            "sound_speed of its own; give each [[fluid]] its sound_speed [m/s] in the case (and, "
            "where they differ, tait_exponent, background_pressure, dynamic_viscosity) and run "
            "plenum-ic generate again",
            material.name));
  if (settings.wallsExtrapolate() && !info.walls.empty()) {
    const Phases phases(materials, settings);
    for (std::size_t k = 0; k < phases.size(); ++k)
      if (std::isnan(phases[k].state.density(0)))
        throw InputError(fmt::format(
            "solver.wall_pressure = \"extrapolated\": walls do not pull, and fluid \"{}\" has no "
            "density "
            "at pressure 0 (its background_pressure is {:g}, rho0 c^2/gamma = {:g}); lower "
            "background_pressure, or use wall_pressure = \"equation_of_state\"",
            materials[k].name, phases[k].state.backgroundPressure,
            phases[k].state.referenceDensity * phases[k].state.soundSpeed *
                phases[k].state.soundSpeed / phases[k].state.exponent));
  }
  for (const Material& material : materials) {
    const double p0 = material.backgroundPressure.value_or(settings.backgroundPressure);
    const auto least =
        material.cavitationPressure ? material.cavitationPressure : settings.cavitationPressure;
    if (least && *least > p0)
      throw InputError(
          fmt::format("fluid \"{}\": cavitation_pressure = {:g} is above its background_pressure = "
                      "{:g}: it would "
                      "not stand still at its reference density; lower the one or raise the other",
                      material.name, *least, p0));
  }
  if (!settings.densityDiffusion) return;
  const auto refuse = [](const char* why, const char* remedy) {
    throw InputError(fmt::format("solver.density_diffusion {}; {}, or leave density_diffusion out",
                                 why, remedy));
  };
  if (settings.sumsDensity())
    refuse("is a part of the continuity equation, and solver.density = \"summation\"",
           "set solver.density = \"continuity\"");
  if (manyDensities)
    refuse("would mix the densities of the fluids", "use solver.collisions or solver.shifting");
}

/// A fixed step may be too long for sound or viscosity. Measured: a tank with alpha = 1 is stable
/// up to 1.6 h/c.
template <int Dim>
void checkTimeStep(const SceneInfo<Dim>& info, const SolverSettings& settings) {
  if (!settings.timeStep) return;
  if (settings.isIdealGas()) return;  // its speed of sound changes
  const Phases phases(info.materials, settings);
  const double h = settings.smoothingLength * info.spacing;
  const double nu = phases.largestKinematicViscosity();
  double limit = 2 * h / phases.largestSoundSpeed();
  if (nu > 0) limit = std::min(limit, h * h / nu);
  if (*settings.timeStep > limit)
    throw InputError(fmt::format(
        "solver.time_step = {:g} s is longer than its limit {:.3g} s, the smaller one of 2 h/c and "
        "h^2/nu: no run is stable with it; use about {:.2g}, or leave time_step out",
        *settings.timeStep, limit, 0.1 * limit));
}

}  // namespace

template <int Dim>
void checkBeforeRun(const SceneInfo<Dim>& info, const ParticleSet<Dim>& particles,
                    const SolverSettings& settings) {
  if (particles.nFluid() == 0) throw InputError("the particle file has no fluid particle");
  checkFields(particles);
  checkValues(particles, 2 * settings.smoothingLength * info.spacing);
  if (!settings.adaptive) checkSmoothingLengths(particles);
  checkGas(info, particles, settings);
  checkStreams(info, particles, settings);
  checkCoverage(info, settings);
  checkPhysics(info, settings);
  checkTimeStep(info, settings);
  if (settings.collisions && settings.collisions->range > 2 * settings.smoothingLength)
    throw InputError(fmt::format(
        "solver.collisions.range = {:g} d_ref: must not exceed the kernel's support, {:g} d_ref",
        settings.collisions->range, 2 * settings.smoothingLength));
}

template void checkBeforeRun<1>(const SceneInfo<1>&, const ParticleSet<1>&, const SolverSettings&);
template void checkBeforeRun<2>(const SceneInfo<2>&, const ParticleSet<2>&, const SolverSettings&);
template void checkBeforeRun<3>(const SceneInfo<3>&, const ParticleSet<3>&, const SolverSettings&);

}  // namespace plenum
