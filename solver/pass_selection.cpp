// SPDX-License-Identifier: GPL-3.0-or-later
//
// Run-time choices become template arguments here and nowhere else. Every `Selected` below is one
// instantiation of the pair loop; the budget of the project is 150.
#include "engine/pair_loop.hpp"
#include "solver/pair_pass.hpp"
#include "solver/terms.hpp"

namespace plenum {

namespace {

template <int Dim, class Profile, class... Terms>
class Selected final : public PairPass<Dim> {
 public:
  explicit Selected(const Pass<Profile, Terms...>& pass) : pass_(pass) {}
  void run(const Engine<Dim>& engine, ParticleSet<Dim>& particles) const override {
    runPass(pass_, engine, particles);
  }
  FieldSet reads() const override { return pass_.reads; }
  FieldSet writes() const override { return pass_.writes; }

 private:
  Pass<Profile, Terms...> pass_;
};

template <int Dim>
using PassPtr = std::unique_ptr<PairPass<Dim>>;

template <int Dim>
class Selector {
 public:
  Selector(const SolverSettings& settings, double spacing, bool hasWalls)
      : settings_(settings), spacing_(spacing), hasWalls_(hasWalls) {}

  template <class Profile>
  StepPasses<Dim> passes(const Profile& profile) const {
    return {densityPass(profile), forcePass(profile), nullptr};
  }

  /// Collisions need no kernel: one loop for all.
  PassPtr<Dim> collisionPass() const {
    if (!settings_.collisions) return nullptr;
    const CollisionSettings& c = *settings_.collisions;
    const Group sources = c.pairs == "fluid"  ? Group::fluids
                          : c.pairs == "wall" ? Group::walls
                                              : Group::all;
    return make(noKernel(), Group::fluids, sources,
                term::Collision{c.restitution, c.range * spacing_});
  }

 private:
  static kernel::Any noKernel() { return kernel::Any{KernelId(0)}; }

  template <class Profile, class... Terms>
  PassPtr<Dim> make(const Profile& profile, Group receivers, Group sources,
                    const Terms&... terms) const {
    Pass<Profile, Terms...> pass{
        profile, settings_.smoothingLength * spacing_, {terms...}, receivers, sources};
    return std::make_unique<Selected<Dim, Profile, Terms...>>(pass);
  }

  template <class Profile>
  PassPtr<Dim> densityPass(const Profile& profile) const {
    const Group receivers = hasWalls_ && settings_.wallsEvolve() ? Group::all : Group::fluids;
    if (settings_.density == "summation")
      return make(profile, receivers, Group::all, term::DensitySum{});
    return make(profile, receivers, Group::all, term::Continuity{});
  }

  template <class Profile>
  PassPtr<Dim> forcePass(const Profile& profile) const {
    if (momentumForm(settings_) == "density_squared")
      return forcePass(profile, term::PressureDensitySquared{});
    return forcePass(profile, term::PressureDensityProduct{});
  }

  template <class Profile, class Pressure>
  PassPtr<Dim> forcePass(const Profile& profile, const Pressure& pressure) const {
    if (!settings_.viscosity || !settings_.viscosity->monaghan)
      return make(profile, Group::fluids, Group::all, pressure);
    const MonaghanSettings& monaghan = *settings_.viscosity->monaghan;
    const term::MonaghanViscosity viscosity{monaghan.alpha, monaghan.beta, settings_.soundSpeed};
    return make(profile, Group::fluids, Group::all, pressure, viscosity);
  }

  const SolverSettings& settings_;
  double spacing_;
  bool hasWalls_;
};

/// The kernels that scenes name: each has its own loops in 2-D and 3-D.
template <class Visit>
bool withTunedProfile(KernelId id, Visit&& visit) {
  bool found = false;
  const auto tryProfile = [&](auto profile) {
    if (kernel::indexOf<decltype(profile)>() != id.index()) return;
    visit(profile);
    found = true;
  };
  tryProfile(kernel::CubicSpline{});
  tryProfile(kernel::WendlandC2{});
  tryProfile(kernel::WendlandC2OneD{});
  tryProfile(kernel::WendlandQuadratic{});
  tryProfile(kernel::Convex{});
  return found;
}

}  // namespace

std::string momentumForm(const SolverSettings& settings) {
  if (settings.momentum != "matching") return settings.momentum;
  return settings.density == "summation" ? "density_squared" : "density_product";
}

template <int Dim>
StepPasses<Dim> selectPasses(const SolverSettings& settings, double spacing, bool hasWalls) {
  const Selector<Dim> selector(settings, spacing, hasWalls);
  const KernelId id = KernelId::named(settings.kernel);
  StepPasses<Dim> passes;
  bool tuned = false;
  if constexpr (Dim > 1)
    tuned = withTunedProfile(id, [&](auto profile) { passes = selector.passes(profile); });
  if (!tuned) passes = selector.passes(kernel::Any{id});
  passes.collisions = selector.collisionPass();
  return passes;
}

template StepPasses<1> selectPasses<1>(const SolverSettings&, double, bool);
template StepPasses<2> selectPasses<2>(const SolverSettings&, double, bool);
template StepPasses<3> selectPasses<3>(const SolverSettings&, double, bool);

}  // namespace plenum
