// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/instruction_set.hpp"
#include "solver/pair_pass.hpp"
#include "solver/pass_choice.hpp"

namespace plenum {

namespace {

template <int Dim, class... Terms>
PairPass<Dim> makePass(PassChoice choice, TermList<Terms...> list, const Units& units,
                       Group receivers, Group sources) {
  choice.smoothingLength /= units.length;
  ((static_cast<Terms&>(choice.terms) = inUnits(static_cast<const Terms&>(choice.terms), units)),
   ...);
  choice.termList = indexOf<TermList<Terms...>>();
  PairPass<Dim> pass;
  pass.reads = list.reads;
  pass.writes = list.writes;
  pass.receivers = receivers;
  pass.sources = sources;
  withInstructionSet(instructionSet(), [&](auto isa) {
    pass.inFloat = tileFunction<decltype(isa), float, Dim>(choice);
    pass.inDouble = tileFunction<decltype(isa), double, Dim>(choice);
  });
  pass.parameters = std::make_shared<const PassChoice>(choice);
  return pass;
}

template <int Dim>
PairPass<Dim> forcePass(const PassChoice& choice, const SolverSettings& settings,
                        const Units& units) {
  using namespace term;
  const bool viscous = settings.viscosity && settings.viscosity->monaghan;
  const auto make = [&](auto list) {
    return makePass<Dim>(choice, list, units, Group::fluids, Group::all);
  };
  if (momentumForm(settings) == "density_squared")
    return viscous ? make(TermList<PressureDensitySquared, MonaghanViscosity>{})
                   : make(TermList<PressureDensitySquared>{});
  return viscous ? make(TermList<PressureDensityProduct, MonaghanViscosity>{})
                 : make(TermList<PressureDensityProduct>{});
}

}  // namespace

std::string momentumForm(const SolverSettings& settings) {
  if (settings.momentum != "matching") return settings.momentum;
  return settings.density == "summation" ? "density_squared" : "density_product";
}

template <int Dim>
StepPasses<Dim> selectPasses(const SolverSettings& settings, double spacing, bool hasWalls,
                             const Units& units) {
  PassChoice choice;
  choice.kernel = KernelId::named(settings.kernel).index();
  choice.smoothingLength = settings.smoothingLength * spacing;
  if (settings.viscosity && settings.viscosity->monaghan) {
    const MonaghanSettings& monaghan = *settings.viscosity->monaghan;
    static_cast<term::MonaghanViscosity&>(choice.terms) = {monaghan.alpha, monaghan.beta,
                                                           settings.soundSpeed};
  }
  if (settings.collisions)
    static_cast<term::Collision&>(choice.terms) = {settings.collisions->restitution,
                                                   settings.collisions->range * spacing};
  StepPasses<Dim> passes;
  const Group receivers = hasWalls && settings.wallsEvolve() ? Group::all : Group::fluids;
  passes.density =
      settings.density == "summation"
          ? makePass<Dim>(choice, TermList<term::DensitySum>{}, units, receivers, Group::all)
          : makePass<Dim>(choice, TermList<term::Continuity>{}, units, receivers, Group::all);
  passes.forces = forcePass<Dim>(choice, settings, units);
  if (settings.collisions) {
    const std::string& pairs = settings.collisions->pairs;
    const Group sources = pairs == "fluid"  ? Group::fluids
                          : pairs == "wall" ? Group::walls
                                            : Group::all;
    passes.collisions =
        makePass<Dim>(choice, TermList<term::Collision>{}, units, Group::fluids, sources);
  }
  return passes;
}

template StepPasses<1> selectPasses<1>(const SolverSettings&, double, bool, const Units&);
template StepPasses<2> selectPasses<2>(const SolverSettings&, double, bool, const Units&);
template StepPasses<3> selectPasses<3>(const SolverSettings&, double, bool, const Units&);

}  // namespace plenum
