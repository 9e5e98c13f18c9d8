// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/engine.hpp"
#include "particles/case_settings.hpp"
#include "particles/scene.hpp"
#include "solver/gas.hpp"
#include "solver/integrate.hpp"
#include "solver/pair_pass.hpp"
#include "solver/phases.hpp"
#include "solver/step_record.hpp"
#include "solver/streams.hpp"
#include "solver/wall_loads.hpp"
#include "solver/wall_motion.hpp"
#include "solver/wall_state.hpp"

#include <optional>

namespace plenum {

/// A scene in motion. Holds the fields that the chosen physics needs, and no others.
template <int Dim>
class Simulation {
 public:
  /// Begins a run, or goes on with one that stopped: a scene that holds its progress (as `pause`
  /// writes it) continues with the bits of a run that was never stopped. With `measuresLoads` the
  /// loads of the walls are added up. Throws InputError if the particle set does not fit the
  /// settings (preflight.hpp).
  Simulation(Scene<Dim> scene, const SolverSettings& settings, bool measuresLoads = false);

  /// One step. dt [s] <= maxTimeStep() unless the case fixes it.
  ///
  /// Symplectic Euler, as the sources have it: density, pressure and forces at the old positions,
  /// then the velocities, then the positions. Kick-drift-kick: half of the kick, the positions, the
  /// density (by continuity from the middle of the way, Adami et al. 2012,
  /// doi 10.1016/j.jcp.2012.05.005), pressure and forces at the new positions, the other half. The
  /// forces of a gas see velocities and energies as predicted for the end of the step (Springel
  /// 2005, doi 10.1111/j.1365-2966.2005.09655.x), without which heating by viscosity is of first
  /// order only.
  ///
  /// Throws RunError if a force or velocity is not finite, a density not positive, a particle
  /// faster than the limit or the step longer than its own: the values that it found so are not
  /// stored.
  void step(double dt);

  /// Steps until `target` [s] is met exactly, in steps of equal length where the step is fixed.
  /// Calls `afterStep()` after every step; if it returns false, that was the last one. Returns
  /// whether the target is met.
  template <class AfterStep>
  bool advanceTo(double target, AfterStep&& afterStep);

  /// As time_step.hpp has it [s]. Throws RunError if it has become senselessly small.
  double maxTimeStep() const;

  double time() const { return scene_.info.time; }
  long nSteps() const { return record_.nSteps; }
  const SceneInfo<Dim>& info() const { return scene_.info; }
  const ParticleSet<Dim>& particles() const { return scene_.particles; }
  const Engine<Dim>& engine() const { return engine_; }
  Engine<Dim>& engine() { return engine_; }
  const SolverSettings& settings() const { return settings_; }
  const MaterialTable& materials() const { return states_; }
  const Phases& phases() const { return phases_; }
  Vec<Dim> gravity() const { return gravity_; }
  double smoothingLength() const { return settings_.smoothingLength * scene_.info.spacing; }
  /// Largest speed of sound in the fluids, in an ideal gas that of now [m/s].
  double largestSoundSpeed() const;
  /// How often the last step summed densities to find smoothing lengths.
  int nDensitySums() const { return nDensitySums_; }

  /// The scene as it is now, for files. Positions and velocities are those at time(); with
  /// symplectic Euler, density and pressure those that moved them there, of the positions one step
  /// before.
  const Scene<Dim>& scene() const { return scene_; }

  /// What has come in and gone out; null where the case has no inflow and no outflow.
  const StreamBalance<Dim>* streamBalance() const {
    return streams_ ? &streams_->balance() : nullptr;
  }

  /// Whether a run may stop here: the next step will sort and search anew, as a run that goes on
  /// from a file must. So it is every 64 steps at the latest.
  bool mayPause() const;
  /// Lets the next step search anew, so that the run may stop here.
  void preparePause() { engine_.forget(); }
  /// Notes in the scene what a run needs to go on. To be called where it may pause.
  void notePause();
  /// Takes that note away: the scene goes on from there.
  void forgetPause() { scene_.info.progress.clear(); }
  /// The time at which the run began that this one goes on with, or now [s].
  double runStart() const { return record_.runStart; }
  bool isContinued() const { return isContinued_; }

  bool measuresLoads() const { return measuresLoads_; }
  /// Mean loads of the walls since `restartWallLoads` was called; empty if they are not measured.
  std::vector<WallLoad> wallLoads() const {
    return measuresLoads_ ? wallLoads_.means() : std::vector<WallLoad>{};
  }
  void restartWallLoads() { wallLoads_.restart(); }

  double bytesPerParticle() const;

  /// Notes who made the present state and its figures, for the files written from now on.
  void describeState(const std::string& generator,
                     std::vector<std::pair<std::string, double>> quality) {
    scene_.info.generator = generator;
    scene_.info.quality = std::move(quality);
  }

 private:
  void begin();
  void beginStreams();
  void goOn();

  void take(double dt);
  void stepEuler(double dt);
  void stepKickDriftKick(double dt);
  void updateDensity(double dt);
  void updatePressure(double now);
  void sumForces(double now);
  void kickByForces(double dt);
  void storeAcceleration();
  void kickByAcceleration(double dt);
  void predictByAcceleration(double dt);
  void requireEnergy(const Advanced& heated) const;
  void collide(double now);
  void driftParticles(double dt);
  void moveWalls(double time);
  void shiftParticles(double dt);
  double largestFluidSpeed() const;
  std::size_t fastestParticle() const;
  void requireSpeedLimit() const;
  [[noreturn]] void fail(const std::string& what, std::size_t particle) const;

  SolverSettings settings_;
  bool measuresLoads_;
  Scene<Dim> scene_;
  Phases phases_;
  std::optional<Gas<Dim>> gas_;  // absent where all have one smoothing length and no energy
  Engine<Dim> engine_;
  StepPasses<Dim> passes_;
  MaterialTable states_;  // of the fluids
  Vec<Dim> gravity_{};
  std::optional<Streams<Dim>> streams_;  // absent where nothing comes in or leaves
  WallState<Dim> wallState_;
  WallMotion<Dim> wallMotion_;
  std::vector<Vec<Dim>> wallAccelerations_;  // empty if no wall moves [m/s^2]
  std::vector<Vec<Dim>> towardsSurface_;     // empty if no wall moves [m/s]
  WallLoads<Dim> wallLoads_;
  StepRecord record_;
  int nDensitySums_ = 1;
  bool isContinued_ = false;
};

template <int Dim>
template <class AfterStep>
bool Simulation<Dim>::advanceTo(double target, AfterStep&& afterStep) {
  while (time() < target) {
    // The remaining time in equal steps: the last one is never a tiny rest.
    const double steps = std::ceil((target - time()) / maxTimeStep() - 1e-9);
    if (steps <= 1) {
      step(target - time());
      scene_.info.time = target;
    } else {
      step((target - time()) / steps);
    }
    if constexpr (std::is_same_v<decltype(afterStep()), bool>) {
      if (!afterStep()) return time() >= target;
    } else {
      afterStep();
    }
  }
  return true;
}

extern template class Simulation<1>;
extern template class Simulation<2>;
extern template class Simulation<3>;

}  // namespace plenum
