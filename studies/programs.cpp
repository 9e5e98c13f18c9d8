// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/programs.hpp"

#include "particles/errors.hpp"
#include "particles/version.hpp"
#include "studies/key.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <vector>

namespace plenum::study {

namespace {

namespace fs = std::filesystem;

fs::path thisProgram() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error);
}

/// The program `name`, which CMake builds in its folder `part`.
fs::path findOne(const fs::path& folder, const char* name, const char* part) {
  std::vector<fs::path> places;
  if (!folder.empty()) {
    places = {folder / name, folder / part / name};
  } else {
    const fs::path here = thisProgram().parent_path();
    places = {here / name, here.parent_path() / part / name};
  }
  for (const fs::path& place : places)
    if (access(place.c_str(), X_OK) == 0) return fs::canonical(place);
  throw InputError(
      fmt::format("{} is needed and neither at {} nor at {}; build or install it, or "
                  "name its folder with --programs",
                  name, places[0].string(), places[1].string()));
}

}  // namespace

bool Programs::haveChanged() const {
  std::error_code gone;
  return fs::last_write_time(ic, gone) != icTime_ || fs::last_write_time(sph, gone) != sphTime_;
}

Programs Programs::find(const fs::path& folder) {
  Programs found;
  found.ic = findOne(folder, "plenum-ic", "ictools");
  found.sph = findOne(folder, "plenum-sph", "solver");
  found.icTime_ = fs::last_write_time(found.ic);
  found.sphTime_ = fs::last_write_time(found.sph);
  Key key;
  key.add(version);
  key.addFile(found.ic);
  key.addFile(found.sph);
  found.fingerprint = key.text();
  return found;
}

}  // namespace plenum::study
