// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/maps/map_cases.hpp"

#include "particles/atomic_file.hpp"
#include "particles/case_settings.hpp"
#include "studies/maps/case_texts.hpp"

#include <stdexcept>

namespace plenum::study {

namespace fs = std::filesystem;

fs::path writeMapCase(const fs::path& folder, const std::string& name) {
  for (const CaseText& known : caseTexts) {
    if (known.name != name) continue;
    const fs::path file = folder / "cases" / (name + ".toml");
    fs::create_directories(file.parent_path());
    writeTextFile(file, known.text);
    return file;
  }
  throw std::logic_error("no case " + name + " in studies/maps/case_texts.cmake");
}

Scales scalesOf(const fs::path& caseFile, bool quick) {
  CaseNode root = CaseNode::load(caseFile);
  applyChanges(root, quick, {});
  const CaseSettings settings = readCase(root);
  const SolverSettings solver = settings.solverOrDefaults();
  return {solver.soundSpeed, solver.smoothingLength * settings.spacing};
}

}  // namespace plenum::study
