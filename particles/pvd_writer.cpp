// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/pvd_writer.hpp"

#include "particles/atomic_file.hpp"

#include <fmt/format.h>

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

}  // namespace

void PvdSeries::add(double time, const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::absolute(path_).lexically_normal().parent_path();
  const fs::path relative = fs::absolute(file).lexically_normal().lexically_relative(folder);
  entries_.emplace_back(time, relative.generic_string());
  std::string xml =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const auto& [t, name] : entries_)
    xml += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", t, xmlEscaped(name));
  writeTextFile(path_, xml + "</Collection>\n</VTKFile>\n");
}

}  // namespace plenum
