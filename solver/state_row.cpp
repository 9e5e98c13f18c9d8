// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/state_row.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

template <int Dim>
double maxSpeed(const ParticleSet<Dim>& particles) {
  double squared = 0;
  for (const Vec<Dim>& v : particles[field::velocity].first(particles.nFluid()))
    squared = std::max(squared, normSquared(v));
  return std::sqrt(squared);
}

}  // namespace

template <int Dim>
std::vector<Figure> measureState(const Simulation<Dim>& simulation, bool freeSurface,
                                 double wallClock) {
  const ParticleSet<Dim>& particles = simulation.particles();
  const SceneInfo<Dim>& info = simulation.info();
  const Conserved c = measureConserved(simulation);
  const SpacingMeasures s = measureSpacing(particles, info.domain, info.spacing);

  std::vector<Figure> row{
      {"time", "s", simulation.time()},
      {"step", "", static_cast<double>(simulation.nSteps())},
      {"wall_clock", "s", wallClock},
      {"max_speed", "m/s", maxSpeed(particles)},
      {"energy_kinetic", "J", c.kineticEnergy},
      {"energy_potential", "J", c.potentialEnergy},
      {"energy_compression", "J", c.compressionEnergy},
      {"energy_total", "J", c.energy()},
  };
  for (std::size_t a = 0; a < Dim; ++a)
    row.push_back({std::string("momentum_") + "xyz"[a], "kg m/s", c.momentum[a]});
  for (std::size_t a = 0; a < 3; ++a)
    if (Dim == 3 || (Dim == 2 && a == 2))
      row.push_back(
          {std::string("angular_momentum_") + "xyz"[a], "kg m^2/s", c.angularMomentum[a]});
  row.push_back({"nn_min", "d_ref", s.minNearest});
  row.push_back({"nn_mean", "d_ref", s.meanNearest});
  row.push_back({"f.1", "", s.below01});
  row.push_back({"f.5", "", s.below05});
  row.push_back({"f.85", "", s.below085});
  if (Dim == 2) row.push_back({"psi6", "", s.psi6});
  row.push_back({"void1", "", measureVoids(particles, info, freeSurface)});
  row.push_back({"left", "", static_cast<double>(countLeft(particles, info))});
  return row;
}

template std::vector<Figure> measureState<1>(const Simulation<1>&, bool, double);
template std::vector<Figure> measureState<2>(const Simulation<2>&, bool, double);
template std::vector<Figure> measureState<3>(const Simulation<3>&, bool, double);

}  // namespace plenum
