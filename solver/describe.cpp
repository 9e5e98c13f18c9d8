// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run.hpp"

#include "engine/instruction_set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace plenum {

namespace {

std::string densityLine(const SolverSettings& s) {
  std::string text = s.sumsDensity() ? "density          sum over neighbours (2.2)"
                                     : "density          continuity (5.23)";
  if (s.densityDiffusion)
    text += fmt::format(", delta-SPH diffusion {:g}", s.densityDiffusion->delta);
  return text + "\n";
}

std::string smoothingLine(const SolverSettings& s) {
  if (!s.lengthsFollow()) return "";
  if (s.hasForm("grad_h"))
    return fmt::format("smoothing        h = {:g} (m/rho)^(1/d), grad-h terms, to {:g}\n",
                       s.smoothingLength, s.adaptive->tolerance);
  return fmt::format("smoothing        h = {:g} (m/rho_mean)^(1/d){}\n", s.smoothingLength,
                     s.adaptive->changeLimit
                         ? fmt::format(", at most {:g} % a step", 100 * *s.adaptive->changeLimit)
                         : "");
}

std::string gasLine(const Material& material, const SolverSettings& s) {
  if (!s.isIdealGas())
    return fmt::format("fluid            {}: isothermal gas with c = {:g} m/s\n", material.name,
                       material.soundSpeed.value_or(s.soundSpeed));
  return fmt::format("fluid            {}: ideal gas with gamma = {:g}\n", material.name,
                     s.adiabaticIndex);
}

std::string phaseLines(const Phases& phases, const std::vector<Material>& materials,
                       const SolverSettings& s) {
  std::string text;
  for (std::size_t k = 0; k < phases.size(); ++k) {
    if (s.equationOfState != "tait") {
      text += gasLine(materials[k], s);
      continue;
    }
    const Tait& state = phases[k].state;
    text += fmt::format(
        "fluid            {}: rho0 = {:g}, Tait with c = {:g} m/s, gamma = {:g}, "
        "p0 = {:g}",
        materials[k].name, state.referenceDensity, state.soundSpeed, state.exponent,
        state.backgroundPressure);
    if (std::isfinite(state.cavitationPressure))
      text += fmt::format(", p >= {:g}", state.cavitationPressure);
    if (s.laminar()) text += fmt::format(", mu = {:g}", phases[k].dynamicViscosity);
    text += "\n";
  }
  return text;
}

std::string forceLines(const SolverSettings& s) {
  const char* form = s.hasForm("grad_h")                    ? "p/(Omega rho^2) form (Price 2012)"
                     : momentumForm(s) == "density_squared" ? "p/rho^2 form (2.3)"
                                                            : "(p + p)/(rho rho) form (5.24)";
  std::string text = fmt::format("pressure force   {}\n", form);
  if (s.monaghan())
    text += fmt::format("viscosity        Monaghan: alpha = {:g}, beta = {:g}\n",
                        s.monaghan()->alpha, s.monaghan()->beta);
  if (s.usesBalsara()) text += "viscosity        with Balsara's limiter\n";
  if (s.tensor())
    text += fmt::format("viscosity        tensor: alpha_1 = {:g}, alpha_2 = {:g}, beta = {:g}\n",
                        s.tensor()->alpha1, s.tensor()->alpha2, s.tensor()->beta);
  if (s.bulk()) text += fmt::format("viscosity        bulk: alpha = {:g}\n", s.bulk()->alpha);
  if (s.neumannRichtmyer())
    text += fmt::format("viscosity        von Neumann-Richtmyer: alpha = {:g}\n",
                        s.neumannRichtmyer()->alpha);
  if (s.conductivity)
    text += fmt::format("conductivity     alpha = {:g} (Price 2008)\n", s.conductivity->alpha);
  if (s.laminar()) text += "viscosity        laminar (Morris et al. 1997), walls without slip\n";
  if (s.collisions)
    text += fmt::format("collisions       {} pairs closer than {:g} d_ref, restitution {:g}\n",
                        s.collisions->pairs == "all" ? "all" : s.collisions->pairs,
                        s.collisions->range, s.collisions->restitution);
  if (s.shifting)
    text += fmt::format("shifting         A = {:g}{}\n", s.shifting->coefficient,
                        s.shifting->freeSurface ? ", not at free surfaces" : "");
  return text;
}

std::string streamLines(const SolverSettings& s) {
  std::string text;
  const auto add = [&](const char* label, const std::vector<StreamSettings>& streams) {
    for (const StreamSettings& stream : streams)
      text += fmt::format("{:<16} {} end of {}: plane at {:g} m, gas held for {:g} m beyond it\n",
                          label, stream.side, stream.axis, stream.at, stream.length);
  };
  add("inflow", s.inflows);
  add("outflow", s.outflows);
  return text;
}

std::string wallLine(std::size_t nWalls, const std::string& model) {
  const char* what = model == "zero"                ? "zero"
                     : model == "initial"           ? "as at the start"
                     : model == "equation_of_state" ? "from the equation of state"
                                                    : "extrapolated from the fluid";
  return fmt::format("walls            {}, pressure {}\n", nWalls, what);
}

template <int Dim>
std::string leftOut(const Simulation<Dim>& simulation) {
  const SolverSettings& s = simulation.settings();
  std::vector<std::string> absent;
  if (!s.isIdealGas()) absent.push_back("energy equation");
  if (s.hasOwnLengths() && !s.lengthsFollow()) absent.push_back("adaptive smoothing lengths");
  if (!s.viscosity) absent.push_back("viscosity");
  if (s.isIdealGas() && !s.conductivity) absent.push_back("conductivity");
  if (!s.collisions) absent.push_back("collisions");
  if (s.gravity.empty()) absent.push_back("gravity");
  if (s.equationOfState != "tait" && !s.hasStreams()) absent.push_back("inflow and outflow");
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
      "kernel           {}, h = {:g} {}, {}support {:g} m\n",
      particles.nFluid(), particles.nWalls(), Dim, simulation.info().spacing, s.kernel,
      s.smoothingLength, s.lengthsFollow() ? "(m/rho)^(1/d)" : "d_ref",
      s.lengthsFollow() ? "largest " : "", simulation.engine().support());
  text += smoothingLine(s);
  text += phaseLines(simulation.phases(), simulation.info().materials, s);
  text += densityLine(s) + forceLines(s);
  if (!s.gravity.empty())
    text += fmt::format("gravity          ({:g}) m/s^2\n", fmt::join(s.gravity, ", "));
  if (particles.nWalls() > 0) text += wallLine(simulation.info().walls.size(), s.wallPressure);
  text += streamLines(s);
  text += fmt::format(
      "time step        {}, {}\n", s.kicksTwice() ? "kick-drift-kick" : "symplectic Euler",
      s.timeStep ? fmt::format("{:g} s, fixed", *s.timeStep) : fmt::format("cfl {:g}", s.cfl));
  text +=
      fmt::format("pairs            {}, with {} instructions\n",
                  simulation.engine().precision() == Precision::mixed ? "in float, state in double"
                                                                      : "in double",
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
