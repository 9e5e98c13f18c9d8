// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/running_state.hpp"

#include "particles/errors.hpp"
#include "particles/particle_file.hpp"
#include "solver/simulation.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <chrono>
#include <cmath>
#include <cstdio>

namespace plenum::bench {

namespace {

/// Twice that of a run by default: the state, not its accuracy, matters here.
constexpr double cfl = 0.4;

/// What a state was made from; a file with other words is made anew.
template <int Dim>
std::string recipe(std::size_t n, const Setup<Dim>& start) {
  const Box<Dim>& tank = start.scene.info.domain;
  return fmt::format(
      "dam break {}: {} particles, h = {} d_ref, g = {:.9g}, cfl {}, tank {:.9g}, t = sqrt(H/g)",
      Dim, n, start.settings.smoothingLength, -start.settings.gravity.back(), cfl,
      tank.upper[0] - tank.lower[0]);
}

}  // namespace

template <int Dim>
Setup<Dim> damBreakRunning(std::size_t n, const std::filesystem::path& folder) {
  Setup<Dim> made = damBreakAtRest<Dim>(n);
  const std::string wanted = recipe<Dim>(n, made);
  const auto path = folder / fmt::format("dam_break_{}d_{}.hdf", Dim, n);
  if (std::filesystem::exists(path)) {
    try {
      Scene<Dim> kept = readParticleFile<Dim>(path);
      if (kept.info.caseText == wanted) {
        made.scene = std::move(kept);
        return made;
      }
    } catch (const InputError&) {  // of an older version: make it anew
    }
  }
  std::fprintf(stderr, "running the %d-D dam break of %zu particles until it has collapsed ...",
               Dim, n);
  std::fflush(stderr);
  const auto start = std::chrono::steady_clock::now();
  omp_set_num_threads(omp_get_num_procs());
  SolverSettings settings = made.settings;
  settings.cfl = cfl;
  Simulation<Dim> sim(std::move(made.scene), settings);
  sim.advanceTo(std::sqrt(made.height / -settings.gravity.back()), [] {});
  made.scene = sim.scene();
  made.scene.info.caseText = wanted;
  std::filesystem::create_directories(folder);
  writeParticleFile(path, made.scene);
  std::fprintf(stderr, " %.0f s, %ld steps; kept in %s\n",
               std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
               sim.nSteps(), path.c_str());
  return made;
}

template Setup<2> damBreakRunning<2>(std::size_t, const std::filesystem::path&);
template Setup<3> damBreakRunning<3>(std::size_t, const std::filesystem::path&);

}  // namespace plenum::bench
