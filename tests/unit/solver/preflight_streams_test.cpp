// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inflows and outflows that cannot be.
#include "particles/errors.hpp"
#include "tests/support/stream_tunnel.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <string>

namespace plenum {
namespace {

using test::advance;
using test::tunnel;
using test::tunnelSettings;

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

TEST(PreflightStreams, AnInflowThatMeetsAWallIsRefused) {
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

TEST(PreflightStreams, WhatCannotBeIsRefused) {
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

TEST(PreflightStreams, HalfAPeriodOfALatticeIsRefused) {
  // Every second place of the lattice, like the squares of one colour of a chessboard: rows repeat
  // after two columns.
  const auto chessboard = [](double length) {
    return [=](Scene<2>& scene, SolverSettings& s) {
      ParticleSet<2>& all = scene.particles;
      std::vector<std::uint32_t> kept;
      for (std::uint32_t i = 0; i < all.size(); ++i) {
        all[field::position][i][0] = (i / 8 + 0.5) / 16;
        if ((i / 8 + i % 8) % 2 == 0) kept.push_back(i);
      }
      all = all.fluidsOf(kept);
      for (double& mass : all[field::mass]) mass *= 2;
      s.inflows[0].at = s.inflows[0].length = length;
      s.smoothingLength = 1.2;  // a support of half the tunnel's width at most
    };
  };
  expectRefused(chessboard(0.9375), {"[[solver.inflow]]", "length = 0.9375 m", "follow each other",
                                     "0.0625 m apart", "along x"});
  EXPECT_EQ(refusal(chessboard(1)), "");
}

TEST(PreflightStreams, FluidMustComeInAndLeave) {
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

TEST(PreflightStreams, GasThatFlowsBackStopsTheRun) {
  const std::string out = failure(1, 1.5, -3), in = failure(2.5, 3, -3);
  for (const char* part : {"particle ", "flows back out through the inflow", "x = 1 m", "t = "})
    EXPECT_NE(out.find(part), std::string::npos) << out;
  for (const char* part : {"particle ", "flows back from the outflow", "x = 3 m", "t = "})
    EXPECT_NE(in.find(part), std::string::npos) << in;
}

}  // namespace
}  // namespace plenum
