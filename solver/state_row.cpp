// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/state_row.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

namespace {

template <int Dim>
double maxSpeed(const ParticleSet<Dim>& particles) {
  double squared = 0;
  for (const Vec<Dim>& v : particles[field::velocity].first(particles.nFluid()))
    squared = std::max(squared, normSquared(v));
  return std::sqrt(squared);
}

/// Mean loads of the walls; NaN before the first step.
template <int Dim>
void addLoads(std::vector<Figure>& row, const Simulation<Dim>& simulation) {
  std::vector<WallLoad> loads = simulation.wallLoads();
  if (simulation.time() == simulation.runStart())  // no time has passed to take a mean over
    for (WallLoad& load : loads) load = std::numeric_limits<double>::quiet_NaN() * load;
  for (std::size_t w = 0; w < loads.size(); ++w) {
    const std::string& wall = simulation.info().walls[w].name;
    for (std::size_t a = 0; a < Dim; ++a)
      row.push_back({wall + "_force_" + "xyz"[a], "N", loads[w].force[a]});
    for (std::size_t a = 0; a < 3; ++a)
      if (Dim == 3 || (Dim == 2 && a == 2))
        row.push_back({wall + "_torque_" + "xyz"[a], "N m", loads[w].torque[a]});
  }
}

/// What came in and went out, and sums without it: those stay the same where no wall acts.
template <int Dim>
void addStreams(std::vector<Figure>& row, const Simulation<Dim>& simulation, const Conserved& c) {
  const StreamBalance<Dim>* balance = simulation.streamBalance();
  if (balance == nullptr) return;
  row.push_back({"mass", "kg", c.mass});
  row.push_back({"mass_in", "kg", balance->massIn});
  row.push_back({"mass_out", "kg", balance->massOut});
  row.push_back({"mass_balance", "kg", c.mass - balance->massIn + balance->massOut});
  row.push_back({"energy_in", "J", balance->energyIn});
  row.push_back({"energy_balance", "J", c.energy() - balance->energyIn});
  for (int a = 0; a < Dim; ++a) {
    const double in = balance->momentumIn[a];
    row.push_back({std::string("momentum_in_") + "xyz"[a], "kg m/s", in});
    row.push_back({std::string("momentum_balance_") + "xyz"[a], "kg m/s",
                   c.momentum[static_cast<std::size_t>(a)] - in});
  }
}

}  // namespace

template <int Dim>
Observed<Dim> observed(const Simulation<Dim>& simulation) {
  const SolverSettings& settings = simulation.settings();
  return {
      simulation.particles(),       simulation.info(),   settings, KernelId::named(settings.kernel),
      simulation.smoothingLength(), simulation.gravity()};
}

template <int Dim>
std::vector<Figure> measureState(const Simulation<Dim>& simulation, const Observers<Dim>& observers,
                                 double wallClock) {
  const Conserved c = measureConserved(simulation);
  std::vector<Figure> row{
      {"time", "s", simulation.time()},
      {"step", "", static_cast<double>(simulation.nSteps())},
      {"wall_clock", "s", wallClock},
      {"max_speed", "m/s", maxSpeed(simulation.particles())},
      {"energy_kinetic", "J", c.kineticEnergy},
      {"energy_potential", "J", c.potentialEnergy},
  };
  if (simulation.settings().isIdealGas())
    row.push_back({"energy_internal", "J", c.internalEnergy});
  else
    row.push_back({"energy_compression", "J", c.compressionEnergy});
  row.push_back({"energy_total", "J", c.energy()});
  for (std::size_t a = 0; a < Dim; ++a)
    row.push_back({std::string("momentum_") + "xyz"[a], "kg m/s", c.momentum[a]});
  for (std::size_t a = 0; a < 3; ++a)
    if (Dim == 3 || (Dim == 2 && a == 2))
      row.push_back(
          {std::string("angular_momentum_") + "xyz"[a], "kg m^2/s", c.angularMomentum[a]});
  addStreams(row, simulation, c);
  addLoads(row, simulation);
  observers.addTo(row, observed(simulation));
  return row;
}

template <int Dim>
std::vector<Figure> measureState(const Simulation<Dim>& simulation,
                                 const MeasureSettings& measures) {
  return measureState(simulation, Observers<Dim>(measures, observed(simulation)), 0);
}

template Observed<1> observed<1>(const Simulation<1>&);
template std::vector<Figure> measureState<1>(const Simulation<1>&, const Observers<1>&, double);
template std::vector<Figure> measureState<1>(const Simulation<1>&, const MeasureSettings&);
template Observed<2> observed<2>(const Simulation<2>&);
template std::vector<Figure> measureState<2>(const Simulation<2>&, const Observers<2>&, double);
template std::vector<Figure> measureState<2>(const Simulation<2>&, const MeasureSettings&);
template Observed<3> observed<3>(const Simulation<3>&);
template std::vector<Figure> measureState<3>(const Simulation<3>&, const Observers<3>&, double);
template std::vector<Figure> measureState<3>(const Simulation<3>&, const MeasureSettings&);

}  // namespace plenum
