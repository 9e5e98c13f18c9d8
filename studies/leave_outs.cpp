// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/leave_outs.hpp"

#include "studies/flatten.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace plenum::study {

namespace {

/// Parts of [solver] without which a run goes on, the costliest first.
constexpr std::array<std::pair<const char*, const char*>, 7> optionalTerms{
    {{"shifting", "shifting"},
     {"adaptive", "smoothing lengths that follow the density"},
     {"conductivity", "artificial conductivity"},
     {"density_diffusion", "diffusion of the density"},
     {"collisions", "collisions"},
     {"viscosity", "viscosity"},
     {"self_term_correction", "the correction of self-terms"}}};

std::string nameOfFluid(const CaseNode& fluid, std::size_t k) {
  for (const char* key : {"name", "region"})
    if (const CaseNode* name = fluid.find(key); name != nullptr && name->isString())
      return name->asString();
  return fmt::format("fluid[{}]", k);
}

/// Measures of a fluid that is no longer there.
void removeMeasuresOf(const std::string& fluid, CaseNode& root) {
  const CaseNode* measures = root.find("measures");
  if (measures == nullptr || !measures->isTable()) return;
  const auto isOfFluid = [&](const CaseNode& table) {
    const CaseNode* material = table.isTable() ? table.find("material") : nullptr;
    return material != nullptr && material->isString() && material->asString() == fluid;
  };
  std::vector<std::string> keys;
  for (const auto& [name, node] : measures->asTable()) {
    if (isOfFluid(node)) keys.push_back("measures." + name);
    if (!node.isArray()) continue;
    for (std::size_t k = node.asArray().size(); k-- > 0;)  // the last first: numbers stay right
      if (isOfFluid(node.asArray()[k])) keys.push_back(fmt::format("measures.{}[{}]", name, k));
  }
  for (const std::string& key : keys) root.remove(key);
}

/// A single fluid has no field that tells fluids apart, for pictures.
void removePictureOfMaterials(CaseNode& root) {
  const CaseNode *output = root.find("output"), *fluids = root.find("fluid");
  if (output == nullptr || fluids->asArray().size() > 1) return;
  const CaseNode* picture = output->find("picture");
  if (picture != nullptr && picture->isString() && picture->asString() == "material")
    root.remove("output.picture");
}

}  // namespace

std::vector<LeaveOut> leaveOutsOf(const CaseNode& root) {
  std::vector<LeaveOut> all;
  if (auto flat = flattened(root)) all.push_back(std::move(*flat));
  const CaseNode* fluids = root.find("fluid");
  const std::size_t nFluids = fluids != nullptr && fluids->isArray() ? fluids->asArray().size() : 0;
  for (std::size_t k = nFluids; k-- > 1;) {
    const std::string name = nameOfFluid(fluids->asArray()[k], k);
    LeaveOut without{"the fluid " + name, root, true};
    without.root.remove(fmt::format("fluid[{}]", k));
    removeMeasuresOf(name, without.root);
    removePictureOfMaterials(without.root);
    all.push_back(std::move(without));
  }
  const CaseNode* solver = root.find("solver");
  for (const auto& [key, what] : optionalTerms) {
    if (solver == nullptr || solver->find(key) == nullptr) continue;
    LeaveOut without{what, root, false};
    without.root.remove(std::string("solver.") + key);
    all.push_back(std::move(without));
  }
  return all;
}

}  // namespace plenum::study
