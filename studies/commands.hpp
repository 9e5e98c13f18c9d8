// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

namespace CLI {
class App;
}

namespace plenum::study {

/// A subcommand that has been declared: where it was parsed, `run` does it and returns the exit
/// code.
struct Command {
  CLI::App* app = nullptr;
  std::function<int()> run;
};

/// `plenum-study accuracy`: a case over a grid of settings.
Command addAccuracy(CLI::App& app);

/// `plenum-study minimal`: the cheapest setting that meets an error.
Command addMinimal(CLI::App& app);

/// Subcommands of `plenum-study stability` that compute, or run the solver on one lattice:
/// transforms of kernels, waves of lattices, their growth.
std::vector<Command> addLatticeCommands(CLI::App& stability);

/// Those that run cases: maps of pairing, tension, time steps, collisions, interfaces.
std::vector<Command> addMapCommands(CLI::App& stability);

}  // namespace plenum::study
