// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/gadget_reader.hpp"

#include "particles/errors.hpp"
#include "particles/hdf5.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plenum {

namespace {

using hdf5::Group;

constexpr double metresACentimetre = 0.01;

/// Metres a unit of length of the file.
double lengthUnit(const Group& root) {
  constexpr std::pair<const char*, const char*> places[] = {{"Units", "Unit length in cgs (U_L)"},
                                                            {"Parameters", "UnitLength_in_cm"}};
  for (const auto& [name, attribute] : places) {
    if (!root.has(name)) continue;
    const Group group = root.open(name);
    if (!group.hasAttribute(attribute)) continue;
    const double centimetres = group.attribute<double>(attribute);
    if (!(centimetres > 0 && std::isfinite(centimetres)))
      group.fail(".", fmt::format("has the attribute {} = {:g}, must be positive", attribute,
                                  centimetres));
    // Exactly 1 for a file in metres, so that its coordinates keep their bits.
    return centimetres == 100 ? 1 : centimetres * metresACentimetre;
  }
  return 1;
}

void checkIsWhole(const Group& root) {
  if (!root.has("Header")) return;
  const Group header = root.open("Header");
  if (!header.hasAttribute("NumFilesPerSnapshot")) return;
  const auto nFiles = header.attribute<std::int32_t>("NumFilesPerSnapshot");
  if (nFiles > 1)
    header.fail(".", fmt::format("says that this is one of {} files of a snapshot, must be the "
                                 "only one; join them first",
                                 nFiles));
}

/// The number of points with three components. Throws InputError for another shape.
std::size_t countPoints(const Group& group, const std::string& name) {
  const std::vector<hsize_t> shape = group.shape(name);
  if (shape.size() != 2 || shape[1] != 3)
    group.fail(name, "is not a list of points with three coordinates");
  return shape[0];
}

/// The first `nFluid` rows; the others are walls.
FilePoints pointsOf(const Group& group, const std::string& name, double unit, std::size_t nFluid) {
  const std::size_t n = countPoints(group, name);
  const std::vector<double> x = group.read<double>(name, n, 3);
  FilePoints result;
  result.nWalls = n - nFluid;
  result.positions.reserve(nFluid);
  for (std::size_t k = 0; k < nFluid; ++k)
    result.positions.push_back({{unit * x[3 * k], unit * x[3 * k + 1], unit * x[3 * k + 2]}});
  return result;
}

}  // namespace

FilePoints readGadgetPoints(const std::filesystem::path& path) {
  const auto file = hdf5::File::open(path);
  const Group& root = file.root();
  if (root.has("Plenum") && root.has("VTKHDF")) {
    const Group vtk = root.open("VTKHDF");
    const auto nFluid = root.open("Plenum").attribute<std::uint64_t>("NumberOfFluids");
    const std::size_t n = countPoints(vtk, "Points");
    if (nFluid > n)
      vtk.fail("Points", fmt::format("has {} rows, /Plenum says {} fluid particles", n, nFluid));
    return pointsOf(vtk, "Points", 1, nFluid);
  }
  if (!root.has("PartType0"))
    throw InputError(
        path.string() +
        ": has no group /PartType0; give a file of GADGET or SWIFT with gas particles");
  checkIsWhole(root);
  const Group gas = root.open("PartType0");
  const std::size_t n = countPoints(gas, "Coordinates");
  return pointsOf(gas, "Coordinates", lengthUnit(root), n);
}

}  // namespace plenum
