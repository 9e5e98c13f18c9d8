// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_file.hpp"
#include "solver/simulation.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plenum::test {

/// The run that goes on from a file which `simulation` writes where it may pause, `nSteps` steps
/// from now or later.
template <int Dim>
Simulation<Dim> resumedAfter(int nSteps, Simulation<Dim>& simulation,
                             const SolverSettings& settings) {
  for (int k = 0; k < nSteps || !simulation.mayPause(); ++k)
    simulation.step(simulation.maxTimeStep());
  simulation.notePause();
  const TemporaryFolder folder;
  writeParticleFile(folder / "pause.hdf", simulation.scene());
  return Simulation<Dim>(readParticleFile<Dim>(folder / "pause.hdf"), settings);
}

}  // namespace plenum::test
