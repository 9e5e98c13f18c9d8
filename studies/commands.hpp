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

/// `plenum-study stability ...`: one command for each map.
std::vector<Command> addStability(CLI::App& app);

}  // namespace plenum::study
