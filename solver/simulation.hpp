// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_settings.hpp"
#include "particles/scene.hpp"
#include "solver/equation_of_state.hpp"
#include "solver/pair_pass.hpp"
#include "solver/wall_motion.hpp"

namespace plenum {

/// A scene in motion. Holds the fields that the chosen physics needs, and no others.
template <int Dim>
class Simulation {
 public:
  /// Throws InputError if the particle set does not fit the settings (preflight.hpp).
  Simulation(Scene<Dim> scene, const SolverSettings& settings);

  /// One step of symplectic Euler, as the sources have it: density, pressure and forces at the old
  /// positions, then the velocities, then the positions. dt [s] <= maxTimeStep() unless the case
  /// fixes it. Throws RunError, before anything moves, if a force is not finite.
  void step(double dt);

  /// Steps until `target` [s] is met exactly, in steps of equal length where the step is fixed.
  /// Calls `afterStep()` after every step.
  template <class AfterStep>
  void advanceTo(double target, AfterStep&& afterStep);

  /// cfl min(h/(c + |v|), sqrt(h/|a|)) over all fluid particles, or the fixed step of the case [s].
  double maxTimeStep() const;

  double time() const { return info_.time; }
  long nSteps() const { return nSteps_; }
  const SceneInfo<Dim>& info() const { return info_; }
  const ParticleSet<Dim>& particles() const { return particles_; }
  const Engine<Dim>& engine() const { return engine_; }
  const SolverSettings& settings() const { return settings_; }
  const MaterialTable& materials() const { return materials_; }
  Vec<Dim> gravity() const { return gravity_; }
  double smoothingLength() const { return settings_.smoothingLength * info_.spacing; }

  /// The scene as it is now, for files.
  Scene<Dim> scene() const { return {info_, particles_}; }

  double bytesPerParticle() const;

 private:
  FieldSet neededFields() const;
  void updateDensity(double dt);
  void updatePressure();
  void kick(double dt);
  void collide();
  void drift(double dt);
  void refuseNonFiniteForces() const;
  std::size_t nDensityReceivers() const;

  SolverSettings settings_;
  SceneInfo<Dim> info_;
  ParticleSet<Dim> particles_;
  Engine<Dim> engine_;
  StepPasses<Dim> passes_;
  MaterialTable materials_;  // of the fluids
  MaterialTable wallMaterials_;
  WallMotion<Dim> wallMotion_;
  Vec<Dim> gravity_{};
  long nSteps_ = 0;
};

template <int Dim>
template <class AfterStep>
void Simulation<Dim>::advanceTo(double target, AfterStep&& afterStep) {
  while (time() < target) {
    // The remaining time in equal steps: the last one is never a tiny rest.
    const double steps = std::ceil((target - time()) / maxTimeStep() - 1e-9);
    if (steps <= 1) {
      step(target - time());
      info_.time = target;
    } else {
      step((target - time()) / steps);
    }
    afterStep();
  }
}

extern template class Simulation<1>;
extern template class Simulation<2>;
extern template class Simulation<3>;

}  // namespace plenum
