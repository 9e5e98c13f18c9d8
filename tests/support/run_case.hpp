// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/generate.hpp"
#include "particles/case_node.hpp"
#include "particles/case_settings.hpp"
#include "solver/simulation.hpp"
#include "solver/state_row.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace plenum::test {

using Changes = std::vector<std::pair<std::string, std::string>>;

/// Makes the particles of a shipped case, changed by key and value, as plenum-ic does.
template <int Dim>
std::pair<Scene<Dim>, CaseSettings> sceneOf(const std::string& caseFile, const Changes& changes) {
  const std::string path = std::string(PLENUM_SOURCE_DIR) + "/cases/" + caseFile;
  CaseNode root = CaseNode::load(path);
  for (const auto& [key, value] : changes) root.set(key, value);
  const CaseSettings settings = readCase(root);
  return {generate<Dim>(root, settings, path, [](const std::string&) {}).scene, settings};
}

/// Runs a shipped case to its end time and returns the figures of the last state.
template <int Dim>
std::vector<Figure> runCase(const std::string& caseFile, const Changes& changes) {
  auto [scene, settings] = sceneOf<Dim>(caseFile, changes);
  Simulation<Dim> simulation(std::move(scene), settings.solverOrDefaults());
  simulation.advanceTo(settings.solverOrDefaults().endTime, [] {});
  return measureState(simulation, settings.measuresOrDefaults());
}

}  // namespace plenum::test
