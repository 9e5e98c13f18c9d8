// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-make-cad SOURCE_FOLDER OUTPUT_FOLDER: writes from the .geo scripts of cases/cad the same
// geometry in every other format that Plenum reads.
// plenum-make-cad --step SCRIPT.geo OUTPUT.step, --stl SCRIPT.geo OUTPUT.stl: one script, one
// format.
#include "geometry/cad_file.hpp"
#include "geometry/gmsh_session.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

using namespace plenum;
namespace fs = std::filesystem;

/// Everything that gmsh itself can write.
void convert(const fs::path& script, const fs::path& folder, int dimension, double perCircle) {
  GmshSession session;
  session.open(script);
  session.guarded(script.string(), [&] {
    const std::string target = (folder / script.stem()).string();
    gmsh::write(target + ".step");
    gmsh::write(target + ".brep");
    gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", perCircle);
    gmsh::option::setNumber("Mesh.MeshSizeMax", 1e22);
    gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
    gmsh::model::mesh::generate(dimension);
    gmsh::write(target + ".msh");
  });
}

void writeWkt(const fs::path& script, const fs::path& target, double tolerance) {
  const CadLoops cad = readCadLoops(script, tolerance, 0);
  std::ofstream out(target);
  for (const PolygonLoops& polygon : nestedLoops(cad.loops, script.string())) {
    std::vector<Loop> rings = polygon.holes;
    rings.insert(rings.begin(), polygon.outer);
    out << "POLYGON (";
    for (std::size_t r = 0; r < rings.size(); ++r) {
      out << (r > 0 ? ",\n(" : "(");
      for (const Vec<2>& x : rings[r]) out << fmt::format("{} {}, ", x[0], x[1]);
      out << fmt::format("{} {})", rings[r][0][0], rings[r][0][1]);
    }
    out << ")\n";
  }
}

void writeStl(const fs::path& script, const fs::path& target, double tolerance) {
  const CadSurface cad = readCadSurface(script, tolerance, 0);
  std::ofstream out(target);
  out << "solid " << target.stem().string() << "\n";
  for (std::size_t t = 0; t < cad.soup.triangles.size(); ++t) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec<3> x = cad.soup.corner(t, k);
      out << fmt::format("vertex {:.9g} {:.9g} {:.9g}\n", x[0], x[1], x[2]);
    }
    out << "endloop\nendfacet\n";
  }
  out << "endsolid\n";
}

constexpr double fine = 1e-4;    // how far triangles may be from curved faces [m]
constexpr double coarse = 5e-4;  // in files that are kept

int makeAll(const fs::path& scripts, const fs::path& folder) {
  fs::create_directories(folder);
  for (const std::string name : {"annulus", "dam_water", "dam_room"}) {
    convert(scripts / (name + ".geo"), folder, 2, 256);
    writeWkt(scripts / (name + ".geo"), folder / (name + ".wkt"), fine);
  }
  for (const std::string name : {"box_minus_cylinder", "tank_water", "tank_walls", "blob"}) {
    convert(scripts / (name + ".geo"), folder, 3, 64);
    writeStl(scripts / (name + ".geo"), folder / (name + ".stl"), fine);
  }
  return exitOk;
}

int makeStep(const fs::path& script, const fs::path& target) {
  GmshSession session;
  session.open(script);
  session.guarded(script.string(), [&] { gmsh::write(target.string()); });
  return exitOk;
}

int makeStl(const fs::path& script, const fs::path& target) {
  writeStl(script, target, coarse);
  return exitOk;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 4 && std::string(argv[1]) == "--step")
    return plenum::runProgram("plenum-make-cad", [&] { return makeStep(argv[2], argv[3]); });
  if (argc == 4 && std::string(argv[1]) == "--stl")
    return plenum::runProgram("plenum-make-cad", [&] { return makeStl(argv[2], argv[3]); });
  if (argc != 3) {
    std::cerr << "usage: plenum-make-cad SOURCE_FOLDER OUTPUT_FOLDER\n"
                 "       plenum-make-cad --step SCRIPT.geo OUTPUT.step\n"
                 "       plenum-make-cad --stl SCRIPT.geo OUTPUT.stl\n";
    return plenum::exitInputAtFault;
  }
  return plenum::runProgram("plenum-make-cad", [&] { return makeAll(argv[1], argv[2]); });
}
