// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/pvd_writer.hpp"

#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

namespace plenum {

namespace {

std::string xmlEscaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

constexpr std::string_view entryStart = "<DataSet timestep=\"", collectionEnd = "</Collection>";

}  // namespace

void PvdSeries::continueUntil(double time) {
  std::ifstream file(path_);
  if (!file) return;
  entries_.clear();
  std::string line;
  bool hasEnd = false;
  while (std::getline(file, line)) {
    hasEnd = hasEnd || line == collectionEnd;
    if (!line.starts_with(entryStart)) continue;
    if (std::strtod(line.c_str() + entryStart.size(), nullptr) <= time) entries_.push_back(line);
  }
  if (!hasEnd)
    throw InputError(fmt::format(
        "{}: is not a complete list of VTU files; go on in another folder with --output",
        path_.string()));
  write();
}

void PvdSeries::add(double time, const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::absolute(path_).lexically_normal().parent_path();
  const fs::path relative = fs::absolute(file).lexically_normal().lexically_relative(folder);
  entries_.push_back(fmt::format("{}{}\" part=\"0\" file=\"{}\"/>", entryStart, time,
                                 xmlEscaped(relative.generic_string())));
  write();
}

void PvdSeries::write() const {
  std::string xml =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const std::string& entry : entries_) xml += entry + "\n";
  writeTextFile(path_, fmt::format("{}{}\n</VTKFile>\n", xml, collectionEnd));
}

}  // namespace plenum
