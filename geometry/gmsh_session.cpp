// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/gmsh_session.hpp"

#include "geometry/text_reader.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>
#include <gmsh.h>

namespace plenum {

namespace {

std::mutex& gmshMutex() {
  static std::mutex mutex;
  return mutex;
}

/// The line of OpenCASCADE's output that says what is wrong, without its decoration.
std::string complaint(const std::string& printed) {
  const std::size_t begin = printed.find("ERR ");
  if (begin == std::string::npos) return "";
  std::string line = printed.substr(begin + 4, printed.find('\n', begin) - begin - 4);
  line.erase(std::min(line.find(" *"), line.size()));
  line.erase(line.find_last_not_of(" *") + 1);
  return " (" + line + ")";
}

}  // namespace

GmshSession::GmshSession() : lock_(gmshMutex()) {
  gmsh::initialize(0, nullptr, false);  // no configuration files: the same on every machine
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setString("Geometry.OCCTargetUnit", "M");
}

GmshSession::~GmshSession() {
  try {
    gmsh::finalize();
  } catch (...) {  // nothing more can be done
  }
}

void GmshSession::guarded(const std::string& source, const std::function<void()>& work) {
  std::string what;
  try {
    work();
    return;
  } catch (const InputError&) {
    throw;
  } catch (const std::string& message) {  // what gmsh 4.8 throws
    what = message;
  } catch (const std::exception& error) {
    what = error.what();
  }
  throw InputError(
      fmt::format("{}: gmsh cannot use it: {}{}; truncated, or a file of another kind? "
                  "export it again",
                  source, what, complaint(printed_.str())));
}

void GmshSession::open(const std::filesystem::path& path) {
  const std::string source = path.string();
  openFile(path);  // gmsh says nothing of files that are missing or empty
  gmsh::vectorpair entities;
  guarded(source, [&] {
    gmsh::open(source);
    gmsh::model::getEntities(entities);
  });
  if (entities.empty())
    throw InputError(source +
                     ": gmsh finds no geometry in it; truncated, or a file of another kind? "
                     "export it again");
}

}  // namespace plenum
