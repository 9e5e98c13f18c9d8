// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/commands.hpp"

namespace plenum::study {

std::vector<Command> addLatticeCommands(CLI::App&) { return {}; }

}  // namespace plenum::study
