// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/export_file.hpp"

#include "geometry/text_reader.hpp"
#include "particles/csv_writer.hpp"
#include "particles/errors.hpp"
#include "particles/particle_file.hpp"
#include "particles/vtu_writer.hpp"

#include <fmt/format.h>

namespace plenum {

std::size_t exportFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  const std::string ending = extensionOf(to);
  if (ending != ".vtu" && ending != ".csv")
    throw InputError(
        fmt::format("{}: must end in .vtu or .csv, which say what is written", to.string()));
  return withParticleFile(from, [&](const auto& scene) {
    if (ending == ".vtu")
      writeVtu(to, scene.particles, {.time = scene.info.time});
    else
      writeCsv(to, scene.particles);
    return scene.particles.size();
  });
}

}  // namespace plenum
