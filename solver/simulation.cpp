// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/simulation.hpp"

#include "particles/errors.hpp"
#include "particles/parallel.hpp"
#include "solver/density_gradient.hpp"
#include "solver/integrate.hpp"
#include "solver/preflight.hpp"
#include "solver/scene_setup.hpp"
#include "solver/shifting.hpp"
#include "solver/time_step.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

/// A RunError that says when.
class TimedError : public RunError {
 public:
  using RunError::RunError;
};

/// The scene itself, after the checks that everything else relies on. Its domain reaches as far as
/// gas is held beyond planes.
template <int Dim>
Scene<Dim>& checked(Scene<Dim>& scene, const SolverSettings& settings) {
  checkBeforeRun(scene.info, scene.particles, settings);
  scene.info.domain = StreamPlanes<Dim>(settings).covering(scene.info.domain);
  return scene;
}

}  // namespace

template <int Dim>
Simulation<Dim>::Simulation(Scene<Dim> scene, const SolverSettings& settings, bool measuresLoads)
    : settings_(settings),
      measuresLoads_(measuresLoads && scene.particles.nWalls() > 0),
      scene_(std::move(checked(scene, settings))),
      phases_(scene_.info.materials, settings),
      gas_(settings.hasOwnLengths() ? std::optional<Gas<Dim>>(settings) : std::nullopt),
      engine_(scene_.info.domain, engineOptions(scene_, settings,
                                                largestSignalSpeed(scene_.particles, settings,
                                                                   phases_.largestSoundSpeed()),
                                                measuresLoads_)),
      passes_(selectPasses<Dim>(
          settings, phases_, {scene_.info.spacing, scene_.particles.nWalls() > 0, measuresLoads_},
          engine_.units())),
      states_(phases_.states()),
      gravity_(gravityOf<Dim>(settings)),
      streams_(settings.hasStreams()
                   ? std::optional<Streams<Dim>>(std::in_place, settings, smoothingLength(),
                                                 states_, gravity_)
                   : std::nullopt),
      wallState_(settings, phases_.statesOf(scene_.info.walls, settings), gravity_),
      wallMotion_(scene_),
      wallLoads_(scene_.info.walls.size()) {
  scene_.info.kernel = settings_.kernel;
  scene_.info.smoothingLength = smoothingLength();
  isContinued_ = !scene_.info.progress.empty();
  const bool hasAcceleration =
      scene_.particles.has(field::acceleration) &&
      (!settings_.isIdealGas() || scene_.particles.has(field::internalEnergyRate));
  keepFields(scene_, fieldsOf(scene_, settings_, passes_, wallMotion_.anyMoves()));
  setConstants(scene_, settings_, phases_);
  if (gas_) gas_->setWallConstants(scene_.particles);
  if (isContinued_ && (hasAcceleration || !settings_.kicksTwice()))
    goOn();
  else
    begin();
}

/// The state before the first step.
template <int Dim>
void Simulation<Dim>::begin() {
  isContinued_ = false;
  scene_.info.progress.clear();
  if (gas_) gas_->setLengths(scene_.particles, smoothingLength());
  if (streams_) beginStreams();
  record_.runStart = time();
  record_.largestAcceleration = norm(gravity_);
  record_.fastest = largestFluidSpeed();
  engine_.update(scene_.particles);
  if (gas_) gas_->lengths().begin(engine_, passes_, scene_.particles);
  if (settings_.sumsDensity()) updateDensity(0);  // the first state shown is the run's own
  updatePressure(time());
  if (!settings_.kicksTwice() && !gas_) return;
  sumForces(time());
  if (settings_.kicksTwice()) storeAcceleration();
}

template <int Dim>
void Simulation<Dim>::beginStreams() {
  streams_->begin(scene_.particles);
  if (!gas_) return;
  const double soundSpeed =
      largestSignalSpeed(scene_.particles, settings_, phases_.largestSoundSpeed());
  streams_->settleBuffers(settings_, engineOptions(scene_, settings_, soundSpeed, measuresLoads_),
                          passes_, scene_);
}

/// The state in which a run stopped.
template <int Dim>
void Simulation<Dim>::goOn() {
  record_.restore(scene_.info.progress);
  wallLoads_.restore(scene_.info.progress);
  if (streams_) streams_->restore(scene_.info.progress);
}

template <int Dim>
bool Simulation<Dim>::mayPause() const {
  constexpr long stepsBetween = 64;
  return record_.nSteps % stepsBetween == 0 || engine_.isOld();
}

template <int Dim>
void Simulation<Dim>::notePause() {
  scene_.info.progress = record_.progress();
  std::ranges::copy(wallLoads_.progress(), std::back_inserter(scene_.info.progress));
  if (streams_) std::ranges::copy(streams_->progress(), std::back_inserter(scene_.info.progress));
}

template <int Dim>
void Simulation<Dim>::step(double dt) {
  const auto failNow = [&](const std::exception& error) {
    throw TimedError(
        fmt::format("at t = {:.6g} s, step {}: {}", time(), record_.nSteps, error.what()));
  };
  try {
    take(dt);
  } catch (const TimedError&) {
    throw;
  } catch (const RunError& error) {
    failNow(error);
  } catch (const InputError& error) {  // what was true of the first state no longer is
    failNow(error);
  }
}

template <int Dim>
void Simulation<Dim>::take(double dt) {
  if (record_.nSteps > 0 && mayPause()) engine_.forget();
  if (settings_.kicksTwice())
    stepKickDriftKick(dt);
  else
    stepEuler(dt);
  wallLoads_.elapse(dt);
  scene_.info.time += dt;
  ++record_.nSteps;
}

template <int Dim>
void Simulation<Dim>::stepEuler(double dt) {
  engine_.update(scene_.particles);
  updateDensity(dt);
  updatePressure(time());
  sumForces(time());
  kickByForces(dt);
  collide(time());
  shiftParticles(dt);
  driftParticles(dt);
  moveWalls(time() + dt);
}

template <int Dim>
void Simulation<Dim>::stepKickDriftKick(double dt) {
  kickByAcceleration(dt / 2);
  if (settings_.sumsDensity()) {
    driftParticles(dt);
  } else {
    driftParticles(dt / 2);
    moveWalls(time() + dt / 2);
    engine_.update(scene_.particles);
    updateDensity(dt);
    driftParticles(dt / 2);
  }
  moveWalls(time() + dt);
  if (gas_) predictByAcceleration(dt / 2);
  engine_.update(scene_.particles);
  if (settings_.sumsDensity()) updateDensity(dt);
  updatePressure(time() + dt);
  sumForces(time() + dt);
  if (gas_) predictByAcceleration(-dt / 2);
  storeAcceleration();
  kickByAcceleration(dt / 2);
  collide(time() + dt);
  shiftParticles(dt);
}

template <int Dim>
void Simulation<Dim>::updateDensity(double dt) {
  ParticleSet<Dim>& particles = scene_.particles;
  if (gas_) {
    nDensitySums_ = gas_->lengths().update(engine_, passes_, particles);
    return;
  }
  if (passes_.densityGradient) updateDensityGradient(engine_, passes_.densityGradient, particles);
  const auto advance = [&] {
    const auto [change, bad] = advanceDensities(engine_, particles, dt, settings_.wallsEvolve());
    if (bad) fail("the density is no longer positive and finite", *bad);
  };
  engine_.run(passes_.density, particles);
  if (settings_.sumsDensity())
    return takeSummedDensities(engine_, particles, settings_.wallsEvolve());
  advance();
  if (!passes_.densityAtWalls) return;
  engine_.run(passes_.densityAtWalls, particles);
  advance();
}

template <int Dim>
void Simulation<Dim>::updatePressure(double now) {
  ParticleSet<Dim>& particles = scene_.particles;
  if (settings_.isIdealGas()) {
    gas_->updatePressure(particles);
    return gas_->updateViscosity(engine_, passes_, particles);
  }
  {
    const auto integrating = engine_.stopwatch().lap(Part::integrate);
    const std::size_t nFluid = particles.nFluid();
    std::span<const std::int32_t> materialOf;
    if (particles.has(field::material)) materialOf = particles[field::material];
    states_.pressures(std::as_const(particles)[field::density].first(nFluid), materialOf,
                      particles[field::pressure].first(nFluid));
  }
  if (settings_.wallsExtrapolate() && wallMotion_.anyMoves()) {
    wallAccelerations_.resize(particles.nWalls());
    wallMotion_.accelerations(now, particles, wallAccelerations_);
  }
  if (settings_.laminar() && wallMotion_.anyMoves()) {
    towardsSurface_.resize(particles.nWalls());
    wallMotion_.towardsSurface(now, particles, towardsSurface_);
  }
  wallState_.update(engine_, passes_.atWalls, particles, {wallAccelerations_, towardsSurface_});
  if (gas_) gas_->updateViscosity(engine_, passes_, particles);
}

/// Sums the forces at the present positions, those of the time `now` [s]. Walls that fluid sticks
/// to show it the velocity behind their surface.
template <int Dim>
void Simulation<Dim>::sumForces(double now) {
  ParticleSet<Dim>& particles = scene_.particles;
  const auto swapSlip = [&] {
    if (particles.has(field::slipVelocity))
      std::ranges::swap_ranges(particles[field::velocity].subspan(particles.nFluid()),
                               particles[field::slipVelocity]);
  };
  swapSlip();
  engine_.run(passes_.forces, particles);
  swapSlip();
  if (gas_) record_.largestRate = gas_->takeRates(engine_, particles);
  if (measuresLoads_) wallLoads_.setForces(engine_, particles, wallMotion_.centers(now));
}

template <int Dim>
void Simulation<Dim>::fail(const std::string& what, std::size_t i) const {
  const ParticleSet<Dim>& particles = scene_.particles;
  const std::string shorter = settings_.timeStep
                                  ? fmt::format("time_step={:.2g}", 0.25 * *settings_.timeStep)
                                  : fmt::format("cfl={:.2g}", 0.25 * settings_.cfl);
  throw TimedError(fmt::format(
      "particle {} at ({:.4g}): {} at t = {:.6g} s, step {}: likely a time step that is too large, "
      "particles that overlap or a wall that is missing; try --set solver.{}",
      particles[field::id][i], fmt::join(particles[field::position][i].components, ", "), what,
      time(), record_.nSteps, shorter));
}

template <int Dim>
void Simulation<Dim>::kickByForces(double dt) {
  const auto [change, bad] = kick(engine_, scene_.particles, gravity_, dt);
  if (bad) fail("the force is not finite", *bad);
  record_.largestAcceleration = change / dt;
  wallLoads_.act(dt);
  if (!settings_.isIdealGas()) return;
  gas_->takeHeating(engine_, scene_.particles);
  requireEnergy(heat(engine_, scene_.particles, dt));
}

template <int Dim>
void Simulation<Dim>::requireEnergy(const Advanced& heated) const {
  if (heated.bad) fail("its internal energy is no longer positive and finite", *heated.bad);
}

template <int Dim>
void Simulation<Dim>::storeAcceleration() {
  const auto [change, bad] = storeAccelerations(engine_, scene_.particles, gravity_);
  if (bad) fail("the force is not finite", *bad);
  if (settings_.isIdealGas()) gas_->takeHeating(engine_, scene_.particles);
  if (streams_) streams_->hold(scene_.particles);
  record_.largestAcceleration =
      largestNorm<Dim>(std::as_const(scene_.particles)[field::acceleration]);
}

template <int Dim>
void Simulation<Dim>::kickByAcceleration(double dt) {
  predictByAcceleration(dt);
  wallLoads_.act(dt);
  if (streams_) streams_->act(dt);
}

/// Velocities and energies after dt by the stored rates, as they would be for now.
template <int Dim>
void Simulation<Dim>::predictByAcceleration(double dt) {
  kickByAccelerations(engine_, scene_.particles, dt);
  if (settings_.isIdealGas()) requireEnergy(heat(engine_, scene_.particles, dt));
}

template <int Dim>
void Simulation<Dim>::collide(double now) {
  if (!passes_.collisions) return;
  engine_.run(passes_.collisions, scene_.particles);
  if (measuresLoads_) wallLoads_.addImpulses(engine_, scene_.particles, wallMotion_.centers(now));
  const auto [change, bad] = takeImpulses(engine_, scene_.particles);
  if (bad) fail("the change of velocity by collisions is not finite", *bad);
}

template <int Dim>
void Simulation<Dim>::driftParticles(double dt) {
  record_.fastest = largestFluidSpeed();
  requireSpeedLimit();
  if (streams_) streams_->beforeMove(scene_.particles);
  drift(engine_, scene_.info.domain, scene_.particles, dt, record_.fastest);
  if (streams_) streams_->afterMove(engine_, scene_.particles, dt);
  if (gas_) gas_->lengths().predict(engine_, scene_.particles, dt);
}

template <int Dim>
double Simulation<Dim>::largestFluidSpeed() const {
  return largestNorm<Dim>(scene_.particles[field::velocity].first(scene_.particles.nFluid()));
}

template <int Dim>
void Simulation<Dim>::moveWalls(double time) {
  engine_.moved(wallMotion_.moveTo(time, scene_.particles));
}

template <int Dim>
void Simulation<Dim>::shiftParticles(double dt) {
  if (!passes_.concentration) return;
  engine_.run(passes_.concentration, scene_.particles);
  const auto integrating = engine_.stopwatch().lap(Part::integrate);
  engine_.moved(shift(*settings_.shifting, smoothingLength(), dt, engine_, scene_.particles));
  wrapPositions(scene_.info.domain, scene_.particles);
}

template <int Dim>
double Simulation<Dim>::maxTimeStep() const {
  const double h = smoothingLength(), step = longestTimeStep(settings_, phases_, h, record_);
  if (!settings_.timeStep && isSenseless(step, settings_, phases_, h))
    fail(fmt::format(
             "speeds up to {:g} m/s (its own) and accelerations up to {:g} m/s^2 make the cfl "
             "time step fall below {}",
             record_.fastest, record_.largestAcceleration,
             settings_.hasOwnLengths() ? "1e-10 of end_time" : "a millionth of h/c"),
         fastestParticle());
  return step;
}

template <int Dim>
std::size_t Simulation<Dim>::fastestParticle() const {
  const auto velocity = scene_.particles[field::velocity].first(scene_.particles.nFluid());
  const auto fastest =
      std::ranges::max_element(velocity, {}, [](const Vec<Dim>& v) { return normSquared(v); });
  return static_cast<std::size_t>(fastest - velocity.begin());
}

template <int Dim>
void Simulation<Dim>::requireSpeedLimit() const {
  if (settings_.isIdealGas() && !settings_.speedLimit) return;
  const double limit = settings_.speedLimit.value_or(5) * largestSoundSpeed();
  if (record_.fastest <= limit) return;
  fail(fmt::format("its speed {:g} m/s is above solver.speed_limit = {:g} c", record_.fastest,
                   settings_.speedLimit.value_or(5)),
       fastestParticle());
}

template <int Dim>
double Simulation<Dim>::largestSoundSpeed() const {
  if (!settings_.isIdealGas()) return phases_.largestSoundSpeed();
  return std::ranges::max(scene_.particles[field::soundSpeed].first(scene_.particles.nFluid()));
}

template <int Dim>
double Simulation<Dim>::bytesPerParticle() const {
  return scene_.particles.bytesPerParticle() +
         static_cast<double>(engine_.bytes()) / static_cast<double>(scene_.particles.size());
}

template class Simulation<1>;
template class Simulation<2>;
template class Simulation<3>;

}  // namespace plenum
