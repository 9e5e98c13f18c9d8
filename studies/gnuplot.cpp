// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/gnuplot.hpp"

#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"
#include "studies/process.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace plenum::study {

namespace {

namespace fs = std::filesystem;

/// Where the shell would find it.
fs::path gnuplotProgram() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/usr/bin:/bin" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const fs::path program = fs::path(folder) / "gnuplot"; access(program.c_str(), X_OK) == 0)
      return program;
  throw RunError("charts need gnuplot, which is not on PATH; install Debian's gnuplot-nox");
}

/// A folder of its own, gone with this.
class Workplace {
 public:
  Workplace() {
    std::string name = (fs::temp_directory_path() / "plenum_chart_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw RunError(name + ": cannot be made");
    folder_ = name;
  }
  ~Workplace() {
    std::error_code ignored;  // nothing depends on it
    fs::remove_all(folder_, ignored);
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  fs::path operator/(const char* name) const { return folder_ / name; }

 private:
  fs::path folder_;
};

}  // namespace

std::string gnuplot(const std::string& script) {
  const Workplace workplace;
  const fs::path out = workplace / "out", file = workplace / "script.gp";
  writeTextFile(file, fmt::format("set output {}\n{}", quotedForGnuplot(out.string()), script));
  const ProcessEnd end = runProcess({gnuplotProgram(), file});
  if (!end.isDone())
    throw RunError(
        fmt::format("gnuplot refused a chart (exit code {}): {}", end.exitCode, end.errors));
  std::ifstream in(out, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (!in || bytes.str().empty()) throw RunError("gnuplot drew nothing: " + end.errors);
  return bytes.str();
}

std::string quotedForGnuplot(const std::string& text) {
  std::string quoted = "'";  // in which nothing but the mark itself means more than it is
  for (const char c : text)
    quoted += c == '\'' ? std::string("''") : std::string(1, c == '\n' ? ' ' : c);
  return quoted + "'";
}

}  // namespace plenum::study
