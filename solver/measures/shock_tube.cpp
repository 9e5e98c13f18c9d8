// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/shock_tube.hpp"

#include "engine/ordered_sum.hpp"
#include "particles/errors.hpp"
#include "solver/measures/gas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

GasState sideOf(const RiemannSideSettings& side, const SolverSettings& solver,
                const std::string& key) {
  if (solver.isIdealGas() && !side.pressure)
    throw InputError(fmt::format("{}.pressure: is missing: an ideal gas needs one", key));
  if (!solver.isIdealGas() && side.pressure)
    throw InputError(fmt::format(
        "{}.pressure = {:g}: an isothermal gas has solver.sound_speed^2 x density; leave it out",
        key, *side.pressure));
  const double c = solver.soundSpeed;
  return {side.density, side.velocity, side.pressure.value_or(c * c * side.density)};
}

RiemannProblem problemOf(const RiemannSettings& settings, const SolverSettings& solver,
                         const std::string& key) {
  requireGas(solver, key);
  const GasState left = sideOf(*settings.left, solver, key + ".left");
  const GasState right = sideOf(*settings.right, solver, key + ".right");
  try {
    return RiemannProblem(left, right, solver.isIdealGas() ? solver.adiabaticIndex : 1);
  } catch (const InputError& error) {
    throw InputError(key + ": " + error.what());
  }
}

struct Errors {
  VolumeMean density, velocity, pressure, energy;

  Errors& operator+=(const Errors& b) {
    density += b.density;
    velocity += b.velocity;
    pressure += b.pressure;
    energy += b.energy;
    return *this;
  }
};

}  // namespace

template <int Dim>
ShockTube<Dim>::ShockTube(const RiemannSettings& settings, const Observed<Dim>& start,
                          const std::string& key)
    : settings_(settings),
      axis_(settings.axis[0] - 'x'),
      gamma_(start.settings.isIdealGas() ? start.settings.adiabaticIndex : 1),
      exact_(problemOf(settings, start.settings, key)) {}

/// The right shock, or the only one; with two rarefactions the right one.
template <int Dim>
const RiemannProblem::Wave& ShockTube<Dim>::shock() const {
  return !exact_.right().isShock && exact_.left().isShock ? exact_.left() : exact_.right();
}

template <int Dim>
typename ShockTube<Dim>::Plateau ShockTube<Dim>::plateau() const {
  const bool isRight = &shock() == &exact_.right();
  // The gas at the contact was at the jump when all began and still shows it. An isothermal tube
  // forgets it, two streams that collide do not.
  const bool ignoresContact = gamma_ == 1 && !(exact_.left().isShock && exact_.right().isShock);
  if (ignoresContact) return {exact_.left().tail, exact_.right().tail};
  return isRight ? Plateau{exact_.starVelocity(), exact_.right().tail}
                 : Plateau{exact_.left().tail, exact_.starVelocity()};
}

template <int Dim>
double ShockTube<Dim>::place(const Observed<Dim>& state, std::size_t i) const {
  return state.particles[field::position][i][axis_] - settings_.position;
}

template <int Dim>
double ShockTube<Dim>::speedAt(double place, double time) const {
  if (time > 0) return place / time;
  return place < 0 ? -infinity : infinity;
}

template <int Dim>
bool ShockTube<Dim>::isInWindow(const Observed<Dim>& state, std::size_t i) const {
  const double x = state.particles[field::position][i][axis_];
  return settings_.window.empty() || (x >= settings_.window[0] && x <= settings_.window[1]);
}

template <int Dim>
void ShockTube<Dim>::addErrors(std::vector<Figure>& row, const Observed<Dim>& state) const {
  const ParticleSet<Dim>& particles = state.particles;
  const bool hasEnergy = gamma_ > 1;
  const auto errors = orderedSum<Errors>(particles.nFluid(), [&](std::size_t i) -> Errors {
    if (!isInWindow(state, i)) return {};
    const GasState gas = exact_.at(speedAt(place(state, i), state.info.time));
    const double rho = particles[field::density][i], V = particles[field::mass][i] / rho;
    const auto error = [&](double is, double shouldBe) {
      return VolumeMean{V * std::abs(is - shouldBe), V};
    };
    Errors e{error(rho, gas.density),
             error(particles[field::velocity][i][axis_], gas.velocity),
             error(particles[field::pressure][i], gas.pressure),
             {}};
    if (hasEnergy)
      e.energy =
          error(particles[field::internalEnergy][i], gas.pressure / ((gamma_ - 1) * gas.density));
    return e;
  });
  const GasState& behind = shock().behind;
  row.push_back({"l1_density", "", errors.density.value() / behind.density});
  row.push_back({"l1_velocity", "m/s", errors.velocity.value()});
  row.push_back({"l1_pressure", "", errors.pressure.value() / behind.pressure});
  if (hasEnergy)
    row.push_back({"l1_internal_energy", "",
                   errors.energy.value() / behind.pressure * (gamma_ - 1) * behind.density});
}

template <int Dim>
double ShockTube<Dim>::velocityNoise(const Observed<Dim>& state) const {
  const Plateau inside = plateau();
  const double time = state.info.time;
  const auto squares =
      orderedSum<VolumeMean>(state.particles.nFluid(), [&](std::size_t i) -> VolumeMean {
        const double x = place(state, i), margin = settings_.margin * smoothingLengthOf(state, i);
        if (!(x > inside.lower * time + margin && x < inside.upper * time - margin)) return {};
        if (!isInWindow(state, i)) return {};
        const double dv = state.particles[field::velocity][i][axis_] - exact_.starVelocity();
        return {dv * dv, 1};  // every particle counts alike, as in the published figures
      });
  return std::sqrt(squares.value());
}

template <int Dim>
double ShockTube<Dim>::shockWidth(const Observed<Dim>& state) const {
  const double time = state.info.time;
  if (!hasShock() || !(time > 0)) return std::numeric_limits<double>::quiet_NaN();
  const bool isRight = &shock() == &exact_.right();
  const double outwards = isRight ? 1 : -1;
  const double ahead = exact_.at(outwards * infinity).density;
  const double jump = shock().behind.density - ahead;
  // Half of the way to the contact: there the gas is behind the shock and nothing else.
  const double reach = 0.5 * std::abs(shock().head - exact_.starVelocity()) * time;
  double first = infinity, last = -infinity;  // of the low and of the high densities
  VolumeMean h;
  for (std::size_t i = 0; i < state.particles.nFluid(); ++i) {
    const double x = outwards * (place(state, i) - shock().head * time);
    if (std::abs(x) > reach || !isInWindow(state, i)) continue;
    const double share = (state.particles[field::density][i] - ahead) / jump;
    if (share < 0.1) first = std::min(first, x);
    if (share > 0.9) {
      last = std::max(last, x);
      h += {smoothingLengthOf(state, i), 1};
    }
  }
  const double width = (first - last) / h.value();
  return std::isfinite(width) ? width : std::numeric_limits<double>::quiet_NaN();
}

template <int Dim>
void ShockTube<Dim>::addTo(std::vector<Figure>& row, const Observed<Dim>& state) const {
  addErrors(row, state);
  row.push_back({"velocity_noise", "m/s", velocityNoise(state)});
  row.push_back({"shock_width", "h", shockWidth(state)});
}

template class ShockTube<1>;
template class ShockTube<2>;
template class ShockTube<3>;

}  // namespace plenum
