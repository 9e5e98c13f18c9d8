// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene_setup.hpp"

#include "engine/derived_fields.hpp"

namespace plenum {

template <int Dim>
typename Engine<Dim>::Options engineOptions(const Scene<Dim>& scene, const SolverSettings& s,
                                            double soundSpeed, bool measuresLoads) {
  const SceneInfo<Dim>& info = scene.info;
  typename Engine<Dim>::Options options;
  options.support = 2 * s.smoothingLength * info.spacing;
  options.wallsReceive =
      scene.particles.nWalls() > 0 && (s.wallsEvolve() || s.wallsExtrapolate() || s.laminar() ||
                                       s.densityDiffusion || measuresLoads);
  options.adaptive = s.hasOwnLengths();
  // What Newton's method corrects in a smooth flow, after a prediction.
  if (s.hasForm("grad_h")) options.lengthSkin = 0.01;
  options.precision =
      s.precision == "double" || !hasLoops<Dim, float> ? Precision::doubled : Precision::mixed;
  options.units =
      Units::near(s.smoothingLength * info.spacing, scene.particles[field::mass][0], soundSpeed);
  return options;
}

template <int Dim>
Vec<Dim> gravityOf(const SolverSettings& settings) {
  Vec<Dim> gravity;
  for (std::size_t a = 0; a < settings.gravity.size(); ++a)
    gravity[static_cast<int>(a)] = settings.gravity[a];
  return gravity;
}

template <int Dim>
FieldSet fieldsOf(const Scene<Dim>& scene, const SolverSettings& settings,
                  const StepPasses<Dim>& passes, bool wallsMove) {
  FieldSet needed{field::position, field::velocity, field::mass,
                  field::density,  field::pressure, field::id};
  if (scene.particles.nWalls() > 0) needed |= {field::wall, field::normal, field::wallDistance};
  if (wallsMove) needed |= {field::referencePosition, field::referenceNormal};
  if (scene.info.materials.size() > 1) needed |= {field::material};
  if (settings.kicksTwice()) needed |= {field::acceleration};
  if (settings.laminar() && scene.particles.nWalls() > 0) needed |= {field::slipVelocity};
  if (settings.hasOwnLengths())
    needed |=
        {field::smoothingLength, field::omegaDensity, field::velocityDivergence, field::soundSpeed};
  if (settings.isIdealGas()) needed |= {field::internalEnergy, field::internalEnergyRate};
  if (settings.bulk() || settings.neumannRichtmyer()) needed |= {field::viscousPressure};
  for (const PairPass<Dim>* pass : passes.all())
    if (*pass) needed |= storedFor(pass->reads);
  return needed;
}

template <int Dim>
void setConstants(Scene<Dim>& scene, const SolverSettings& settings, const Phases& phases) {
  ParticleSet<Dim>& particles = scene.particles;
  const std::size_t nFluid = particles.nFluid();
  const bool many = particles.has(field::material);
  const auto phaseOf = [&](std::size_t i) -> const Phase& {
    return phases[many ? static_cast<std::size_t>(particles[field::material][i]) : 0];
  };
  if (particles.has(field::soundSpeed)) {
    const MaterialTable ofWalls = phases.statesOf(scene.info.walls, settings);
    for (std::size_t i = 0; i < particles.size(); ++i)
      particles[field::soundSpeed][i] =
          i < nFluid ? phaseOf(i).state.soundSpeed
                     : ofWalls.of(particles[field::wall], i - nFluid).soundSpeed;
  }
  if (particles.has(field::dynamicViscosity))
    for (std::size_t i = 0; i < particles.size(); ++i)
      particles[field::dynamicViscosity][i] = i < nFluid ? phaseOf(i).dynamicViscosity : 0;
}

template <int Dim>
void keepFields(Scene<Dim>& scene, FieldSet fields) {
  scene.particles.add(fields);
  scene.particles.remove(scene.particles.fields().without(fields));
}

#define PLENUM_INSTANTIATE(Dim)                                                                  \
  template typename Engine<Dim>::Options engineOptions(const Scene<Dim>&, const SolverSettings&, \
                                                       double, bool);                            \
  template Vec<Dim> gravityOf(const SolverSettings&);                                            \
  template FieldSet fieldsOf(const Scene<Dim>&, const SolverSettings&, const StepPasses<Dim>&,   \
                             bool);                                                              \
  template void keepFields(Scene<Dim>&, FieldSet);                                               \
  template void setConstants(Scene<Dim>&, const SolverSettings&, const Phases&);
PLENUM_INSTANTIATE(1)
PLENUM_INSTANTIATE(2)
PLENUM_INSTANTIATE(3)
#undef PLENUM_INSTANTIATE

}  // namespace plenum
