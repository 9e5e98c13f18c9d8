// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "studies/accuracy.hpp"

namespace CLI {
class App;
}

namespace plenum::study {

/// What the studies of one case take from the command line: the case, what is varied, what is
/// measured, where all of it goes.
void addCaseOptions(CLI::App& command, AccuracyOptions& options);

/// A check for CLI11: a number above zero. Its own message prints the largest double.
std::string notPositive(const std::string& text);

}  // namespace plenum::study
