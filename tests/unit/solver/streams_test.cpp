// SPDX-License-Identifier: GPL-3.0-or-later
//
// Gas that comes in at one end of a scene and leaves at the other.
#include "particles/errors.hpp"
#include "particles/particle_file.hpp"
#include "solver/conserved.hpp"
#include "solver/measures/riemann_problem.hpp"
#include "solver/simulation.hpp"
#include "solver/state_row.hpp"
#include "tests/support/random_particles.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/threads.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <set>

namespace plenum {
namespace {

constexpr double gammaOfGas = 1.4;

/// Ends at x = 1 and x = 3 of a tunnel whose gas reaches from 0 to 4.
SolverSettings tunnelSettings() {
  SolverSettings settings;
  settings.equationOfState = "ideal_gas";
  settings.adiabaticIndex = gammaOfGas;
  settings.integrator = "kick_drift_kick";
  settings.precision = "double";
  settings.adaptive = AdaptiveSettings{};
  settings.viscosity = ViscositySettings{.monaghan = MonaghanSettings{1, 2, true}};
  settings.inflows = {{"x", 1, "lower", 1}};
  settings.outflows = {{"x", 3, "upper", 1}};
  return settings;
}

/// A lattice of 16 a metre in a tunnel of .5 m width whose rows stand an eighth of a spacing
/// further each, so that 8 of them close over the period; sound speed 1 and a wind of `mach`.
/// Masses are powers of two.
template <int Dim>
Scene<Dim> tunnel(double mach) {
  Scene<Dim> scene;
  scene.info.title = "tunnel";
  scene.info.caseName = "tunnel.toml";
  const double a = scene.info.spacing = 1.0 / 16;
  scene.info.domain.upper = Vec<Dim>::filled(0.5);
  scene.info.domain.upper[0] = 4;
  scene.info.domain.periodic.fill(true);
  scene.info.domain.periodic[0] = false;
  scene.info.materials = {{"gas", 1.0}};
  const std::size_t nRows = Dim == 1 ? 1 : Dim == 2 ? 8 : 64, n = 64 * nRows;
  ParticleSet<Dim>& p = scene.particles;
  p = ParticleSet<Dim>({field::position, field::velocity, field::mass, field::density, field::id,
                        field::internalEnergy},
                       n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const auto column = static_cast<double>(i / nRows), row = static_cast<double>(i % nRows);
    p[field::position][i][0] = a * (column + std::fmod(0.3 + 0.125 * row, 1));
    if constexpr (Dim > 1) p[field::position][i][1] = a * (std::fmod(row, 8) + 0.5);
    if constexpr (Dim > 2) p[field::position][i][2] = a * (std::floor(row / 8) + 0.5);
    p[field::velocity][i][0] = mach;
    p[field::mass][i] = std::pow(a, Dim);
    p[field::density][i] = 1;
    p[field::internalEnergy][i] = 1 / (gammaOfGas * (gammaOfGas - 1));
    p[field::id][i] = 1 + i;
  }
  return scene;
}

/// Gas with a hump of pressure in the middle, which waves run away from.
Scene<2> hump(double mach) {
  Scene<2> scene = tunnel<2>(mach);
  ParticleSet<2>& p = scene.particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    p[field::internalEnergy][i] *=
        1 + std::exp(-60 * normSquared(p[field::position][i] - Vec<2>{{2, 0.25}}));
  return scene;
}

template <int Dim>
void advance(Simulation<Dim>& simulation, double target) {
  simulation.advanceTo(target, [] {});
}

/// How far a wind has come from the one that it began as: the largest differences, over their
/// values.
struct Unevenness {
  double velocity = 0, energy = 0, density = 0;
};

template <int Dim>
Unevenness unevennessOf(const ParticleSet<Dim>& p, double mach) {
  Unevenness found;
  double least = 1e9, most = 0;
  for (std::size_t i = 0; i < p.nFluid(); ++i) {
    Vec<Dim> wind;
    wind[0] = mach;
    found.velocity = std::max(found.velocity, norm(p[field::velocity][i] - wind) / mach);
    if (p.has(field::internalEnergy)) {
      const double energy = p[field::internalEnergy][i] * gammaOfGas * (gammaOfGas - 1);
      found.energy = std::max(found.energy, std::abs(energy - 1));
    }
    const double x = p[field::position][i][0];
    if (x < 1 || x > 3) continue;
    least = std::min(least, p[field::density][i]);
    most = std::max(most, p[field::density][i]);
  }
  found.density = most / least - 1;
  return found;
}

TEST(Streams, AUniformWindStaysUniform) {
  for (const double mach : {0.5, 2.7})
    for (const char* state : {"ideal_gas", "isothermal"})
      for (const char* form : {"grad_h", "mean_density", ""}) {
        SolverSettings settings = tunnelSettings();
        settings.equationOfState = state;
        settings.soundSpeed = 1;
        // Lengths at the start are as alike as the iterations make them.
        settings.adaptive->tolerance = 1e-13;
        if (*form == 0)
          settings.adaptive.reset();
        else
          settings.adaptive->form = form;
        settings.viscosity->monaghan->balsara = *form != 0;
        Simulation<2> simulation(tunnel<2>(mach), settings);
        advance(simulation, 6 / mach);  // three times the scene
        const Unevenness found = unevennessOf(simulation.particles(), mach);
        // Forces of a lattice cancel to rounding, which adds up over some hundred steps.
        EXPECT_LT(found.velocity, 1e-11) << mach << state << form;
        EXPECT_LT(found.energy, 1e-11) << mach << state << form;
        EXPECT_LT(found.density, 1e-11) << mach << state << form;
        EXPECT_EQ(simulation.particles().nFluid(), 512u) << mach << state << form;
      }
}

TEST(Streams, SoItDoesInThreeDimensions) {
  SolverSettings settings = tunnelSettings();
  settings.adaptive->tolerance = 1e-13;
  Simulation<3> simulation(tunnel<3>(2.7), settings);
  advance(simulation, 1 / 2.7);  // the gas that was held at the start has come in
  const Unevenness found = unevennessOf(simulation.particles(), 2.7);
  EXPECT_LT(std::max({found.velocity, found.energy, found.density}), 1e-11) << "to rounding";
  EXPECT_EQ(simulation.particles().nFluid(), 4096u);
  EXPECT_NEAR(simulation.streamBalance()->massIn, 0.25, 1.0 / 64) << "to a column of the lattice";
}

TEST(Streams, WhatCameInLessWhatLeftIsTheChangeOfMass) {
  Simulation<2> simulation(hump(1.5), tunnelSettings());
  const Conserved before = measureConserved(simulation);
  advance(simulation, 2.0);
  const StreamBalance<2>& balance = *simulation.streamBalance();
  EXPECT_GT(balance.massIn, 1);
  EXPECT_GT(balance.massOut, 1);
  // Masses are powers of two: these sums are exact.
  EXPECT_EQ(measureConserved(simulation).mass - before.mass, balance.massIn - balance.massOut);
  const auto ids = simulation.particles()[field::id];
  EXPECT_EQ(std::set<std::uint64_t>(ids.begin(), ids.end()).size(), ids.size());
}

/// The change that is left of energy and of momentum along x, after waves have gone through the
/// planes: those of the inflow, too, where the wind is slower than they are.
std::pair<double, double> imbalance(double mach, const SolverSettings& settings, int nSteps) {
  Simulation<2> simulation(hump(mach), settings);
  const Conserved before = measureConserved(simulation);
  for (int k = 0; k < nSteps; ++k) simulation.step(1.0 / nSteps);
  const Conserved after = measureConserved(simulation);
  const StreamBalance<2>& balance = *simulation.streamBalance();
  return {after.energy() - before.energy() - balance.energyIn,
          after.momentum[0] - before.momentum[0] - balance.momentumIn[0]};
}

SolverSettings exactLengths() {
  SolverSettings settings = tunnelSettings();
  settings.adaptive->tolerance = 1e-12;
  return settings;
}

TEST(Streams, EnergyBalancesToSecondOrderAndMomentumToRounding) {
  struct Flow {
    double mach;
    bool isViscous;
    const char* form;
  };
  for (const Flow flow :
       {Flow{0.5, true, "grad_h"}, Flow{1.5, false, "grad_h"}, Flow{0.5, false, "mean_density"}}) {
    SolverSettings settings = exactLengths();
    settings.adaptive->form = flow.form;
    if (!flow.isViscous) settings.viscosity.reset();
    const auto [coarse, momentum] = imbalance(flow.mach, settings, 640);
    const auto [fine, sameMomentum] = imbalance(flow.mach, settings, 1280);
    // Of some 4 J. As for the same gas in a periodic box, the order is 2 for short steps only:
    // terms of higher order have the other sign.
    EXPECT_LT(std::abs(coarse), 1e-6) << flow.mach << flow.form;
    EXPECT_GT(std::log2(coarse / fine), 1.6) << flow.mach << flow.form;
    // Of 1 kg m/s and more, in a thousand steps.
    EXPECT_LT(std::abs(momentum), 1e-13) << flow.mach << flow.form;
    EXPECT_LT(std::abs(sameMomentum), 1e-13) << flow.mach << flow.form;
  }
}

TEST(Streams, SoDoesTheEnergyOfGasThatFalls) {
  SolverSettings settings = exactLengths();
  settings.viscosity.reset();
  settings.gravity = {0.3, 0};
  const double coarse = imbalance(1.5, settings, 640).first;
  const double fine = imbalance(1.5, settings, 1280).first;
  EXPECT_LT(std::abs(coarse), 1e-6) << "of some 4 J";
  EXPECT_GT(std::log2(coarse / fine), 1.6);
}

TEST(Streams, AnIsothermalGasBalancesToFirstOrder) {
  SolverSettings settings = exactLengths();
  settings.viscosity.reset();
  settings.equationOfState = "isothermal";
  settings.soundSpeed = 1;
  const auto left = [&](int nSteps) {
    Scene<2> scene = tunnel<2>(1.5);
    for (std::size_t i = 0; i < scene.particles.size(); ++i) {
      const Vec<2> r = scene.particles[field::position][i] - Vec<2>{{2, 0.25}};
      scene.particles[field::velocity][i] += 2 * std::exp(-60 * normSquared(r)) * r;
    }
    Simulation<2> simulation(std::move(scene), settings);
    const double before = measureConserved(simulation).energy();
    for (int k = 0; k < nSteps; ++k) simulation.step(1.0 / nSteps);
    return measureConserved(simulation).energy() - before - simulation.streamBalance()->energyIn;
  };
  // Where particles come to keep their density, they do so somewhere in a step.
  const double coarse = left(160), fine = left(320);
  EXPECT_LT(std::abs(coarse), 1e-4) << "of some 2 J";
  EXPECT_GT(std::log2(coarse / fine), 0.8);
}

/// Isothermal gas that comes in at both ends at Mach 2 and meets in the middle.
TEST(Streams, CollidingStreamsMakeTheExactShocks) {
  constexpr double u = 2, a = 1.0 / 16;
  Scene<1> scene;
  scene.info.caseName = "streams.toml";
  scene.info.spacing = a;
  scene.info.domain.lower[0] = -6;
  scene.info.domain.upper[0] = 6;
  scene.info.materials = {{"gas", 1.0}};
  ParticleSet<1>& p = scene.particles;
  p = ParticleSet<1>({field::position, field::velocity, field::mass, field::density, field::id},
                     192, 0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = -6 + a * (static_cast<double>(i) + 0.5);
    p[field::position][i][0] = x;
    p[field::velocity][i][0] = x < 0 ? u : -u;
    p[field::mass][i] = a;
    p[field::density][i] = 1;
    p[field::id][i] = 1 + i;
  }
  SolverSettings settings;
  settings.equationOfState = "isothermal";
  settings.soundSpeed = 1;
  settings.kernel = "cubic_spline";
  settings.smoothingLength = 2;
  settings.adaptive = AdaptiveSettings{.form = "mean_density"};
  settings.integrator = "kick_drift_kick";
  settings.viscosity = ViscositySettings{.tensor = TensorSettings{0.8, 0.5, 0.1}};
  settings.inflows = {{"x", -5, "lower", 1}, {"x", 5, "upper", 1}};
  Simulation<1> simulation(std::move(scene), settings);
  advance(simulation, 8.0);  // all that was between the planes is inside the shocks by t = 2.5
  const RiemannProblem exact({1, u, 1}, {1, -u, 1}, 1);
  double error = 0, n = 0;
  for (std::size_t i = 0; i < simulation.particles().nFluid(); ++i) {
    const double x = simulation.particles()[field::position][i][0];
    if (std::abs(x) > 4.5) continue;
    error += std::abs(simulation.particles()[field::density][i] - exact.at(x / 8).density);
    ++n;
  }
  const double relative = error / n / exact.left().behind.density;
  EXPECT_NEAR(exact.left().behind.density, 5.828, 1e-3);
  // The shocks are some ten spacings of the gas behind them wide, and there are two of them among
  // some 650 particles: .0041; with free ends the same streams give .0037 at t = 5
  // (cases/colliding_streams.toml).
  EXPECT_LT(relative, 0.006);
}

/// What a pulse of sound that goes out with the wind leaves between the planes, over what it was.
double reflected(double mach) {
  Scene<1> scene = tunnel<1>(mach);
  ParticleSet<1>& p = scene.particles;
  constexpr double amplitude = 0.01;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p[field::position][i][0] - 2;
    const double v = amplitude * std::exp(-20 * x * x);
    p[field::velocity][i][0] += v;
    p[field::internalEnergy][i] *= 1 + (gammaOfGas - 1) * v;  // a simple wave, and where the gas is
    p[field::position][i][0] -=
        amplitude * std::sqrt(std::acos(-1) / 80) * std::erf(std::sqrt(20.0) * x);  // denser by v/c
  }
  SolverSettings settings = tunnelSettings();
  settings.viscosity.reset();
  Simulation<1> simulation(std::move(scene), settings);
  advance(simulation, 1.9);  // at Mach .5 the outflow's reflection is half a metre on its way back
  double most = 0;
  for (std::size_t i = 0; i < simulation.particles().nFluid(); ++i) {
    const double x = simulation.particles()[field::position][i][0];
    if (x < 1 || x > 3) continue;
    most = std::max(most, std::abs(simulation.particles()[field::velocity][i][0] - mach));
  }
  return most / amplitude;
}

TEST(Streams, SoundIsReflectedWhereTheWindIsSlowerOnly) {
  EXPECT_LT(reflected(1.5), 0.02) << "what the start was no simple wave by";
  // .21 with six times as many particles (docs/gas.md). Here a pulse is some seven particles wide.
  EXPECT_NEAR(reflected(0.5), 0.21, 0.06);
}

TEST(Streams, ARunThatStopsGoesOnWithTheSameBits) {
  for (const char* form : {"grad_h", "mean_density"}) {
    SolverSettings settings = tunnelSettings();
    settings.precision = "mixed";
    settings.adaptive->form = form;
    Simulation<2> simulation(hump(1.5), settings);
    for (int k = 0; k < 70 || !simulation.mayPause(); ++k)
      simulation.step(simulation.maxTimeStep());
    simulation.notePause();
    const test::TemporaryFolder folder;
    writeParticleFile(folder / "pause.hdf", simulation.scene());
    Simulation<2> resumed(readParticleFile<2>(folder / "pause.hdf"), settings);
    EXPECT_TRUE(resumed.isContinued());
    for (int k = 0; k < 80; ++k)
      for (Simulation<2>* run : {&simulation, &resumed}) run->step(run->maxTimeStep());
    EXPECT_EQ(simulation.time(), resumed.time()) << form;
    const auto compare = [&](auto f) {
      const auto a = simulation.particles()[f], b = resumed.particles()[f];
      ASSERT_EQ(a.size(), b.size()) << form;
      EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0) << form;
    };
    compare(field::position);
    compare(field::internalEnergy);
    compare(field::id);
    EXPECT_EQ(simulation.streamBalance()->massIn, resumed.streamBalance()->massIn);
    EXPECT_EQ(simulation.streamBalance()->energyIn, resumed.streamBalance()->energyIn);
    EXPECT_EQ(simulation.streamBalance()->momentumIn, resumed.streamBalance()->momentumIn);
  }
}

TEST(Streams, ANewRunMayBeginFromAStateThatRan) {
  Simulation<2> simulation(hump(0.5), tunnelSettings());
  advance(simulation, 1.5);  // waves have come to both planes
  Simulation<2> another(simulation.scene(), tunnelSettings());
  EXPECT_FALSE(another.isContinued());
  EXPECT_EQ(another.streamBalance()->massIn, 0);
  advance(another, 2.0);
  EXPECT_GT(another.streamBalance()->massIn, 0);
}

TEST(Streams, BitsDoNotDependOnThreads) {
  const auto states = test::forThreads([] {
    Simulation<2> simulation(hump(1.5), tunnelSettings());
    advance(simulation, 1.0);
    const auto e = simulation.particles()[field::internalEnergy];
    std::vector<double> state(e.begin(), e.end());
    state.push_back(simulation.streamBalance()->energyIn);
    return state;
  });
  EXPECT_EQ(states[0], states[1]);
  EXPECT_EQ(states[0], states[2]);
}

TEST(Streams, TheHistoryHasTheBalance) {
  Simulation<2> simulation(tunnel<2>(1), tunnelSettings());
  advance(simulation, 0.5);
  const std::vector<Figure> row = measureState(simulation);
  EXPECT_DOUBLE_EQ(valueOf(row, "mass"), 2);
  EXPECT_NEAR(valueOf(row, "mass_in"), 0.25, 8.0 / 256) << "to a column of the lattice";
  EXPECT_NEAR(valueOf(row, "mass_out"), 0.25, 8.0 / 256);
  EXPECT_DOUBLE_EQ(valueOf(row, "mass_balance"), 2) << "as at the start";
  EXPECT_DOUBLE_EQ(valueOf(row, "energy_balance"),
                   valueOf(row, "energy_total") - valueOf(row, "energy_in"));
  EXPECT_NEAR(valueOf(row, "momentum_balance_x"), 2, 1e-12)
      << "to rounding: what came in is what left";
  SolverSettings closed = tunnelSettings();
  closed.inflows.clear();
  closed.outflows.clear();
  const std::vector<Figure> other = measureState(Simulation<2>(tunnel<2>(1), closed));
  EXPECT_THROW(valueOf(other, "mass_in"), std::out_of_range) << "nothing comes in";
}

using Change = std::function<void(Scene<2>&, SolverSettings&)>;

std::string refusal(const Change& change) {
  Scene<2> scene = tunnel<2>(1);
  SolverSettings settings = tunnelSettings();
  change(scene, settings);
  try {
    const Simulation<2> simulation(std::move(scene), settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expectRefused(const Change& change, std::initializer_list<const char*> parts) {
  const std::string text = refusal(change);
  for (const char* part : parts) EXPECT_NE(text.find(part), std::string::npos) << text;
}

/// A row of wall particles across the tunnel.
void addWall(Scene<2>& scene, double x) {
  ParticleSet<2> with(
      scene.particles.fields() | FieldSet{field::wall, field::normal, field::wallDistance},
      scene.particles.size(), 8);
  for (std::size_t i = 0; i < with.size(); ++i) {
    const std::size_t from = i % scene.particles.size();
    for (const auto f : {field::position, field::velocity}) with[f][i] = scene.particles[f][from];
    for (const auto f : {field::mass, field::density, field::internalEnergy})
      with[f][i] = scene.particles[f][from];
    with[field::id][i] = i + 1;
    if (i >= with.nFluid()) {
      with[field::position][i] = {{x, (static_cast<double>(from) + 0.5) / 16}};
      with[field::velocity][i] = {};
    }
  }
  scene.info.walls = {{"grid", "lattice", 4, 1, 1.0, {}}};
  scene.particles = std::move(with);
}

TEST(Streams, AnInflowThatMeetsAWallIsRefused) {
  for (const double x : {0.5, 0.99, 1.2})
    expectRefused(
        [&](Scene<2>& scene, SolverSettings&) { addWall(scene, x); },
        {"tunnel.toml", "[[solver.inflow]]", "at = 1", "meets wall \"grid\"", "keep walls"});
  expectRefused([](Scene<2>& scene, SolverSettings&) { addWall(scene, 1.2); },
                {"0.2 m from the plane", "0.375 m"});
  expectRefused([](Scene<2>& scene, SolverSettings&) { addWall(scene, 2.9); },
                {"[[solver.outflow]]", "meets wall \"grid\""});
  EXPECT_EQ(refusal([](Scene<2>& scene, SolverSettings&) { addWall(scene, 2); }), "");
}

TEST(Streams, WhatCannotBeIsRefused) {
  expectRefused([](Scene<2>&, SolverSettings& s) { s.equationOfState = "tait"; },
                {"solver.inflow", "gases", "isothermal"});
  expectRefused([](Scene<2>&, SolverSettings& s) { s.integrator = "symplectic_euler"; },
                {"solver.inflow", "kick_drift_kick"});
  expectRefused([](Scene<2>& scene, SolverSettings&) { scene.info.domain.periodic[0] = true; },
                {"tunnel.toml", "periodic axis x", "domain.periodic"});
  expectRefused([](Scene<2>&, SolverSettings& s) { s.inflows[0].at = -1; },
                {"[[solver.inflow]]", "outside of the fluid", "move the plane"});
  expectRefused([](Scene<2>&, SolverSettings& s) { s.outflows[0].at = 5; },
                {"[[solver.outflow]]", "outside of the fluid"});
  expectRefused([](Scene<2>&, SolverSettings& s) { s.inflows[0].length = 0.25; },
                {"[[solver.inflow]]", "less than twice the kernel's support", "0.375"});
  expectRefused([](Scene<2>&, SolverSettings& s) { s.inflows[0].length = 0.75; },
                {"beyond the plane", "make length as long"});
  expectRefused([](Scene<2>&, SolverSettings& s) { s.outflows[0].length = 2; },
                {"[[solver.outflow]]", "fluid reaches only"});
  expectRefused([](Scene<2>&, SolverSettings& s) { s.inflows[0].length = 1.03; },
                {"whole periods", "set length = 1 "});
  expectRefused(
      [](Scene<2>&, SolverSettings& s) {
        s.inflows.push_back({"y", 0.1, "lower", 1});
      },
      {"[[solver.inflow]]", "periodic axis y"});
  expectRefused([](Scene<2>&, SolverSettings& s) { s.outflows[0].side = "lower"; },
                {"[[solver.outflow]]", "one at the lower and one at the upper"});
}

TEST(Streams, FluidMustComeInAndLeave) {
  const Change turn = [](Scene<2>& scene, SolverSettings&) {
    for (Vec<2>& v : scene.particles[field::velocity]) v = -v;
  };
  expectRefused(turn, {"[[solver.inflow]]", "does not come in", "particle ", "-1 m/s"});
  expectRefused(
      [](Scene<2>& scene, SolverSettings&) {
        for (std::size_t i = 0; i < scene.particles.size(); ++i)
          if (scene.particles[field::position][i][0] > 3) scene.particles[field::velocity][i] = {};
      },
      {"[[solver.outflow]]", "leave", "0 m/s"});
}

/// What stops a run whose gas between x = `from` and `to` moves at `speed`.
std::string failure(double from, double to, double speed) {
  Scene<2> scene = tunnel<2>(0.5);
  ParticleSet<2>& p = scene.particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p[field::position][i][0] > from && p[field::position][i][0] < to)
      p[field::velocity][i][0] = speed;
  Simulation<2> simulation(std::move(scene), tunnelSettings());
  try {
    advance(simulation, 1.0);
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

TEST(Streams, GasThatFlowsBackStopsTheRun) {
  const std::string out = failure(1, 1.5, -3), in = failure(2.5, 3, -3);
  for (const char* part : {"particle ", "flows back out through the inflow", "x = 1 m", "t = "})
    EXPECT_NE(out.find(part), std::string::npos) << out;
  for (const char* part : {"particle ", "flows back in through the outflow", "x = 3 m", "t = "})
    EXPECT_NE(in.find(part), std::string::npos) << in;
}

}  // namespace
}  // namespace plenum
