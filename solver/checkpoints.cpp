// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/checkpoints.hpp"

#include "particles/errors.hpp"
#include "particles/particle_file.hpp"
#include "particles/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>

namespace plenum {

namespace fs = std::filesystem;

namespace {

const std::regex checkpointName(R"((.+)_checkpoint_(\d+)\.hdf)");

/// Checkpoints in a folder with the step in front, of one run or (name "") of all.
std::vector<std::pair<long, fs::path>> found(const fs::path& folder, const std::string& name) {
  std::vector<std::pair<long, fs::path>> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string file = entry.path().filename().string();
    std::smatch match;
    if (!std::regex_match(file, match, checkpointName)) continue;
    if (name.empty() || match[1] == name)
      files.emplace_back(std::stol(match[2].str()), entry.path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

template <int Dim>
fs::path Checkpoints::write(Simulation<Dim>& simulation) const {
  simulation.notePause();
  simulation.describeState(fmt::format("plenum-sph {}", version), {});
  const fs::path path =
      folder_ / fmt::format("{}_checkpoint_{:09}.hdf", name_, simulation.nSteps());
  writeParticleFile(path, simulation.scene());
  simulation.forgetPause();
  for (const char* last : {"_end.hdf", "_failed.hdf"})  // what the run went on from
    fs::remove(folder_ / (name_ + last));
  const std::vector<fs::path> files = all();
  const std::size_t nOld = files.size() - std::min(files.size(), static_cast<std::size_t>(nKept_));
  for (std::size_t k = 0; k < nOld; ++k)
    if (files[k] != path) fs::remove(files[k]);
  return path;
}

std::vector<fs::path> Checkpoints::all() const {
  std::vector<fs::path> paths;
  for (const auto& [step, path] : found(folder_, name_)) paths.push_back(path);
  return paths;
}

std::string Checkpoints::runNameOf(const fs::path& file) {
  static const std::regex suffix(R"(_(checkpoint_\d+|end|failed)$)");
  return std::regex_replace(file.stem().string(), suffix, "");
}

fs::path Checkpoints::newestIn(const fs::path& folder) {
  const auto files = found(folder, "");
  std::set<std::string> names;
  for (const auto& [step, path] : files) names.insert(runNameOf(path));
  if (names.empty())
    throw InputError(
        fmt::format("{}: holds no checkpoint (*_checkpoint_*.hdf); output.checkpoint_every and "
                    "output.checkpoint_wall_clock say when a run writes them",
                    folder.string()));
  if (names.size() > 1)
    throw InputError(
        fmt::format("{}: holds checkpoints of several runs; name the file", folder.string()));
  return files.back().second;
}

template fs::path Checkpoints::write(Simulation<1>&) const;
template fs::path Checkpoints::write(Simulation<2>&) const;
template fs::path Checkpoints::write(Simulation<3>&) const;

}  // namespace plenum
