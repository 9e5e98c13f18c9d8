// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/engine.hpp"
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
  /// fixes it. Throws RunError, before anything moves, if a force or velocity is not finite or a
  /// density not positive: positions and time are those before the step then, densities (and, if
  /// collisions failed, velocities) may be the new ones.
  void step(double dt);

  /// Steps until `target` [s] is met exactly, in steps of equal length where the step is fixed.
  /// Calls `afterStep()` after every step.
  template <class AfterStep>
  void advanceTo(double target, AfterStep&& afterStep);

  /// cfl min(h/(c + |v|), sqrt(h/|a|)) over all fluid particles, or the fixed step of the case [s].
  /// Throws RunError if it has become senselessly small.
  double maxTimeStep() const;

  double time() const { return scene_.info.time; }
  long nSteps() const { return nSteps_; }
  const SceneInfo<Dim>& info() const { return scene_.info; }
  const ParticleSet<Dim>& particles() const { return scene_.particles; }
  const Engine<Dim>& engine() const { return engine_; }
  Engine<Dim>& engine() { return engine_; }
  const SolverSettings& settings() const { return settings_; }
  const MaterialTable& materials() const { return materials_; }
  Vec<Dim> gravity() const { return gravity_; }
  double smoothingLength() const { return settings_.smoothingLength * scene_.info.spacing; }

  /// The scene as it is now, for files. Positions and velocities are those at time(); density and
  /// pressure those that moved them there, of the positions one step before.
  const Scene<Dim>& scene() const { return scene_; }

  double bytesPerParticle() const;

  /// Notes who made the present state and its figures, for the files written from now on.
  void describeState(const std::string& generator,
                     std::vector<std::pair<std::string, double>> quality) {
    scene_.info.generator = generator;
    scene_.info.quality = std::move(quality);
  }

 private:
  FieldSet neededFields() const;
  void updateDensity(double dt);
  void updatePressure();
  void kick(double dt);
  void collide();
  void drift(double dt);

  template <class Value, class Sums, class Next, class Previous, class IsSound>
  double advance(std::span<Value> values, const Sums& sums, bool wallsToo, const char* what,
                 Next&& next, Previous&& previous, IsSound&& isSound);
  [[noreturn]] void fail(const char* what, std::size_t particle) const;

  SolverSettings settings_;
  Scene<Dim> scene_;
  Engine<Dim> engine_;
  StepPasses<Dim> passes_;
  MaterialTable materials_;  // of the fluids
  MaterialTable wallMaterials_;
  WallMotion<Dim> wallMotion_;
  Vec<Dim> gravity_{};
  double largestAcceleration_ = 0;  // of a fluid particle in the last step [m/s^2]
  double fastest_ = 0;              // its speed [m/s]
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
      scene_.info.time = target;
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
