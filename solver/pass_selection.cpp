// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/instruction_set.hpp"
#include "solver/pair_pass.hpp"
#include "solver/pass_choice.hpp"

namespace plenum {

namespace {

template <int Dim, template <class...> class List, class... Terms>
PairPass<Dim> makePass(PassChoice choice, List<Terms...> list, const Units& units, Group receivers,
                       Group sources) {
  choice.smoothingLength /= units.length;
  ((std::get<Terms>(choice.terms) = inUnits(std::get<Terms>(choice.terms), units)), ...);
  choice.termList = indexOf<List<Terms...>>();
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

/// Makes the passes of one scene.
template <int Dim>
class PassMaker {
 public:
  PassMaker(const SolverSettings& settings, const Phases& phases, const PassOptions& options,
            const Units& units)
      : settings_(settings), phases_(phases), options_(options), units_(units) {
    choice_.kernel = KernelId::named(settings.kernel).index();
    choice_.smoothingLength = settings.smoothingLength * options.spacing;
    setTerms();
  }

  PairPass<Dim> density() const {
    if (settings_.hasOwnLengths())
      return make(OwnLengths<term::DensitySum, term::OmegaDensity>{}, Group::fluids);
    const Group receivers =
        options_.hasWalls && settings_.wallsEvolve() ? Group::all : Group::fluids;
    if (settings_.sumsDensity()) return make(TermList<term::DensitySum>{}, receivers);
    if (!settings_.densityDiffusion) return make(TermList<term::Continuity>{}, receivers);
    return make(TermList<term::Continuity, term::DensityDiffusion>{}, receivers, diffusing());
  }

  PairPass<Dim> densityAtWalls() const {
    return make(TermList<term::Continuity>{}, Group::fluids, Group::walls);
  }

  bool diffusionLeavesWallsOut() const {
    return settings_.densityDiffusion && options_.hasWalls && diffusing() == Group::fluids;
  }

  PairPass<Dim> densityGradient() const {
    return make(TermList<term::DensityGradient>{}, diffusing(), diffusing());
  }

  PairPass<Dim> densityMoment() const {
    return make(OwnLengths<term::DensityMoment>{}, Group::fluids);
  }

  PairPass<Dim> convergence() const {
    return make(OwnLengths<term::DensityRate, term::VelocityCurl>{}, Group::fluids);
  }

  PairPass<Dim> forces() const {
    if (settings_.hasOwnLengths()) return loaded(forcesInGas());
    return momentumForm(settings_) == "density_squared"
               ? forces(TermList<term::PressureDensitySquared>{})
               : forces(TermList<term::PressureDensityProduct>{});
  }

  PairPass<Dim> atWalls() const {
    using namespace term;
    return settings_.laminar()
               ? make(TermList<FluidAtWall, VelocityAtWall>{}, Group::walls, Group::fluids)
               : make(TermList<FluidAtWall>{}, Group::walls, Group::fluids);
  }

  PairPass<Dim> collisions() const {
    const std::string& pairs = settings_.collisions->pairs;
    return loaded(make(TermList<term::Collision>{}, Group::fluids,
                       pairs == "fluid"  ? Group::fluids
                       : pairs == "wall" ? Group::walls
                                         : Group::all));
  }

  PairPass<Dim> concentration() const {
    return make(TermList<term::Concentration>{}, Group::fluids);
  }

 private:
  /// Who exchanges density by diffusion: walls only where theirs evolves. A density that walls are
  /// given makes them a source without end: water at rest on extrapolated walls, which overestimate
  /// the pressure of loose water a little, grew by 2 % a second.
  Group diffusing() const {
    return options_.hasWalls && settings_.wallsEvolve() ? Group::all : Group::fluids;
  }

  void setTerms() {
    const double c = phases_.largestSoundSpeed();
    const term::MonaghanParameters monaghan = artificialViscosity();
    set<term::MonaghanViscosity>({monaghan, c});
    set<term::MonaghanViscosityOfPhases>({monaghan});
    set<term::HeatingViscosity>({{monaghan}});
    set<term::BalsaraViscosity>({{{monaghan}}});
    if (settings_.conductivity) set<term::Conductivity>({settings_.conductivity->alpha});
    if (settings_.laminar()) set<term::LaminarViscosity>({phases_[0].dynamicViscosity, Dim});
    if (settings_.densityDiffusion)
      set<term::DensityDiffusion>({settings_.densityDiffusion->delta, c});
    if (settings_.collisions)
      set<term::Collision>(
          {settings_.collisions->restitution, settings_.collisions->range * options_.spacing});
    set<term::Concentration>({kernelAt(options_.spacing), Dim});
  }

  term::MonaghanParameters artificialViscosity() const {
    if (const TensorSettings* t = settings_.tensor()) return {t->alpha1, t->alpha2, t->beta};
    if (const MonaghanSettings* m = settings_.monaghan()) return {m->alpha, m->beta};
    return {};
  }

  template <class Term>
  void set(const Term& term) {
    std::get<Term>(choice_.terms) = term;
  }

  double kernelAt(double distance) const {
    double value = 0;
    kernel::withProfile(KernelId(choice_.kernel), [&](auto profile) {
      value = Kernel<Dim, decltype(profile)>::W(distance, choice_.smoothingLength);
    });
    return value;
  }

  /// Whatever a gas models: what it does not has no weight. The lean list is the usual case.
  PairPass<Dim> forcesInGas() const {
    using namespace term;
    const auto pass = [&](auto list) { return make(list, Group::fluids); };
    const bool hasGradH = settings_.hasForm("grad_h"), hasBalsara = settings_.usesBalsara();
    if (!settings_.isIdealGas() && !hasBalsara)
      return hasGradH ? pass(OwnLengths<PressureGradH, MonaghanViscosityOfPhases, DensityRate>{})
                      : pass(OwnLengths<PressureDensitySquared, MonaghanViscosityOfPhases,
                                        DensityRate>{});
    if (!settings_.isIdealGas() && !hasGradH)
      return pass(OwnLengths<PressureDensitySquared, BalsaraViscosity, DensityRate>{});
    if (!hasGradH)
      return pass(OwnLengths<PressureDensitySquared, PressureWork, BalsaraViscosity, Conductivity,
                             DensityRate>{});
    if (settings_.conductivity)
      return pass(OwnLengths<PressureGradH, BalsaraViscosity, Conductivity, DensityRate>{});
    if (hasBalsara) return pass(OwnLengths<PressureGradH, BalsaraViscosity, DensityRate>{});
    return pass(OwnLengths<PressureGradH, HeatingViscosity, DensityRate>{});
  }

  template <class Pressure>
  PairPass<Dim> forces(TermList<Pressure>) const {
    using namespace term;
    const bool artificial = settings_.monaghan() != nullptr || settings_.tensor() != nullptr;
    const bool laminar = settings_.laminar() != nullptr;
    const auto pass = [&](auto list) { return loaded(make(list, Group::fluids)); };
    if (laminar && (artificial || phases_.differInViscosity()))
      return pass(TermList<Pressure, MonaghanViscosityOfPhases, LaminarViscosityOfPhases>{});
    if (laminar) return pass(TermList<Pressure, LaminarViscosity>{});
    if (artificial && phases_.differInSoundSpeed())
      return pass(TermList<Pressure, MonaghanViscosityOfPhases>{});
    if (artificial) return pass(TermList<Pressure, MonaghanViscosity>{});
    return pass(TermList<Pressure>{});
  }

  PairPass<Dim> loaded(PairPass<Dim> pass) const {
    pass.reactions = options_.measuresLoads;
    return pass;
  }

  template <class List>
  PairPass<Dim> make(List list, Group receivers, Group sources = Group::all) const {
    return makePass<Dim>(choice_, list, units_, receivers, sources);
  }

  const SolverSettings& settings_;
  const Phases& phases_;
  PassOptions options_;
  Units units_;
  PassChoice choice_;
};

}  // namespace

std::string momentumForm(const SolverSettings& settings) {
  if (settings.momentum != "matching") return settings.momentum;
  return settings.sumsDensity() ? "density_squared" : "density_product";
}

template <int Dim>
StepPasses<Dim> selectPasses(const SolverSettings& settings, const Phases& phases,
                             const PassOptions& options, const Units& units) {
  const PassMaker<Dim> make(settings, phases, options, units);
  StepPasses<Dim> passes;
  if (settings.densityDiffusion) passes.densityGradient = make.densityGradient();
  passes.density = make.density();
  if (make.diffusionLeavesWallsOut()) passes.densityAtWalls = make.densityAtWalls();
  if (options.hasWalls && (settings.wallsExtrapolate() || settings.laminar()))
    passes.atWalls = make.atWalls();
  if (settings.hasForm("mean_density")) passes.densityMoment = make.densityMoment();
  if (settings.usesBalsara() || settings.bulk() || settings.neumannRichtmyer())
    passes.convergence = make.convergence();
  passes.forces = make.forces();
  if (settings.collisions) passes.collisions = make.collisions();
  if (settings.shifting) passes.concentration = make.concentration();
  return passes;
}

template StepPasses<1> selectPasses<1>(const SolverSettings&, const Phases&, const PassOptions&,
                                       const Units&);
template StepPasses<2> selectPasses<2>(const SolverSettings&, const Phases&, const PassOptions&,
                                       const Units&);
template StepPasses<3> selectPasses<3>(const SolverSettings&, const Phases&, const PassOptions&,
                                       const Units&);

}  // namespace plenum
