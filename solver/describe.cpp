// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run.hpp"

#include "engine/instruction_set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace plenum {

namespace {

std::string densityLine(const SolverSettings& s) {
  return s.density == "summation" ? "density          sum over neighbours (2.2)\n"
                                  : "density          continuity (5.23)\n";
}

std::string forceLines(const SolverSettings& s) {
  std::string text = fmt::format("pressure force   {}\n", momentumForm(s) == "density_squared"
                                                              ? "p/rho^2 form (2.3)"
                                                              : "(p + p)/(rho rho) form (5.24)");
  text += fmt::format("equation of state  Tait: c = {:g} m/s, gamma = {:g}, p0 = {:g}\n",
                      s.soundSpeed, s.taitExponent, s.backgroundPressure);
  if (s.viscosity && s.viscosity->monaghan)
    text += fmt::format("viscosity        Monaghan: alpha = {:g}, beta = {:g}\n",
                        s.viscosity->monaghan->alpha, s.viscosity->monaghan->beta);
  if (s.collisions)
    text += fmt::format("collisions       {} pairs closer than {:g} d_ref, restitution {:g}\n",
                        s.collisions->pairs == "all" ? "all" : s.collisions->pairs,
                        s.collisions->range, s.collisions->restitution);
  return text;
}

template <int Dim>
std::string leftOut(const Simulation<Dim>& simulation) {
  const SolverSettings& s = simulation.settings();
  std::vector<std::string> absent{"energy equation"};
  if (!s.viscosity || !s.viscosity->monaghan) absent.push_back("viscosity");
  if (!s.collisions) absent.push_back("collisions");
  if (s.gravity.empty()) absent.push_back("gravity");
  if (simulation.particles().nWalls() == 0) absent.push_back("walls");
  if (simulation.info().materials.size() < 2) absent.push_back("material table");
  return fmt::format("not modelled     {}\n", fmt::join(absent, ", "));
}

}  // namespace

template <int Dim>
std::string describeModel(const Simulation<Dim>& simulation) {
  const SolverSettings& s = simulation.settings();
  const ParticleSet<Dim>& particles = simulation.particles();
  std::string text = fmt::format(
      "particles        {} fluid, {} wall, {}-D, d_ref = {:g} m\n"
      "kernel           {}, h = {:g} d_ref, support {:g} m\n",
      particles.nFluid(), particles.nWalls(), Dim, simulation.info().spacing, s.kernel,
      s.smoothingLength, simulation.engine().support());
  text += densityLine(s) + forceLines(s);
  if (!s.gravity.empty())
    text += fmt::format("gravity          ({:g}) m/s^2\n", fmt::join(s.gravity, ", "));
  if (particles.nWalls() > 0)
    text += fmt::format("walls            {}, pressure {}\n", simulation.info().walls.size(),
                        s.wallPressure == "zero" ? "zero" : "from the equation of state");
  text +=
      fmt::format("time step        {}\n", s.timeStep ? fmt::format("{:g} s, fixed", *s.timeStep)
                                                      : fmt::format("cfl {:g}", s.cfl));
  text += fmt::format("pairs            {}, with {} instructions\n",
                      s.precision == "mixed" ? "in float, state in double" : "in double",
                      nameOf(instructionSet()));
  text += leftOut(simulation);
  std::vector<std::string> names;
  particles.forEachField([&](const FieldInfo& info, auto) { names.emplace_back(info.name); });
  text += fmt::format("fields           {}\n", fmt::join(names, ", "));
  text += fmt::format("memory           {:.0f} bytes a particle, neighbour list included\n",
                      simulation.bytesPerParticle());
  return text;
}

template std::string describeModel<1>(const Simulation<1>&);
template std::string describeModel<2>(const Simulation<2>&);
template std::string describeModel<3>(const Simulation<3>&);

}  // namespace plenum
