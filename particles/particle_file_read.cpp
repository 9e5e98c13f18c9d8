// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/errors.hpp"
#include "particles/file_rows.hpp"
#include "particles/finite.hpp"
#include "particles/particle_file.hpp"
#include "particles/scene_info_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace plenum {

namespace {

using hdf5::Group;

/// /Plenum of a file that this program can read.
Group openPlenum(const hdf5::File& file) {
  const std::string& name = file.origin().file;
  if (!file.root().has("Plenum"))
    throw InputError(
        name + (file.root().has("PartType0")
                    ? ": a GADGET or SWIFT file without /Plenum, so walls, spacing and kernel are "
                      "unknown; generate a particle file with plenum-ic"
                    : ": an HDF5 file of another program; generate a particle file with "
                      "plenum-ic"));
  Group plenum = file.root().open("Plenum");
  const auto schema = plenum.attribute<std::int32_t>("SchemaVersion");
  if (schema != particleFileSchema)
    throw InputError(
        fmt::format("{}: has schema version {}, this program reads version {}; "
                    "generate the file again with this version of plenum-ic",
                    name, schema, particleFileSchema));
  return plenum;
}

int dimensionOf(const Group& plenum) {
  const auto dimension = plenum.attribute<std::int32_t>("Dimension");
  if (dimension < 1 || dimension > 3)
    plenum.fail(".", fmt::format("has the attribute Dimension = {}, must be 1, 2 or 3", dimension));
  return dimension;
}

FieldSet fieldsOf(const Group& plenum) {
  FieldSet fields;
  for (const std::string& name : plenum.texts("Fields")) {
    const auto id = fieldNamed(name);
    if (!id || !infoOf(*id).isState)
      plenum.fail(".", "names a field '" + name + "' that this program does not know");
    fields |= FieldSet{*id};
  }
  if (!fields.has(FieldId::position)) plenum.fail(".", "names no positions among its Fields");
  return fields;
}

/// An array of /PartType0 (or /VTKHDF/Points), cut to the particles that carry the field.
template <int Dim, class Value>
void readField(const Group& group, const std::string& name, const FieldInfo& info,
               ParticleSet<Dim>& particles, std::span<Value> values) {
  constexpr bool isVector = !std::is_arithmetic_v<Value>;
  const auto rows = group.read<FileNumber<Value>>(name, particles.size(), isVector ? 3 : 1);
  const std::size_t first = info.scope == Scope::walls ? particles.nFluid() : 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if constexpr (isVector)
      std::copy_n(rows.data() + 3 * (first + k), Dim, values[k].components.data());
    else
      values[k] = rows[first + k];
  }
}

template <int Dim>
ParticleSet<Dim> readParticles(const hdf5::File& file, const Group& plenum) {
  const auto nFluid = plenum.attribute<std::uint64_t>("NumberOfFluids");
  const auto nWalls = plenum.attribute<std::uint64_t>("NumberOfWalls");
  const Group partType0 = file.root().open("PartType0");
  const Group vtk = file.root().open("VTKHDF");
  // Lengths are compared before anything of that length is allocated.
  const std::vector<hsize_t> shape = vtk.shape("Points");
  if (shape.size() != 2 || shape[1] != 3)
    vtk.fail("Points", "is not a list of points with three coordinates");
  if (nFluid > shape[0] || nWalls != shape[0] - nFluid || shape[0] == 0)
    vtk.fail("Points", fmt::format("has {} rows, /Plenum says {} fluid and {} wall particles",
                                   shape[0], nFluid, nWalls));
  const FieldSet fields = fieldsOf(plenum);
  ParticleSet<Dim> particles(fields, nFluid, nWalls);
  particles.forEachField([&](const FieldInfo& info, auto values) {
    if (info.id == FieldId::position)
      readField(vtk, "Points", info, particles, values);
    else
      readField(partType0, std::string(info.fileName), info, particles, values);
  });
  if (partType0.read<std::uint8_t>("ParticleTypes", particles.size()) != particleTypes(particles))
    partType0.fail("ParticleTypes", "does not list fluids (0) first and walls (1) after them");
  return particles;
}

/// Labels must name rows of the tables of /Plenum.
template <int Dim>
void checkLabels(const std::string& name, const Scene<Dim>& scene) {
  const auto check = [&](Field<Rank::label> field, std::size_t nRows, const char* table) {
    if (!scene.particles.has(field)) return;
    for (const std::int32_t label : scene.particles[field])
      if (label < 0 || static_cast<std::size_t>(label) >= nRows)
        throw InputError(
            fmt::format("{}: /PartType0/{} has the value {}, {} has {} rows; generate "
                        "the particle file again",
                        name, infoOf(field).fileName, label, table, nRows));
  };
  check(field::material, scene.info.materials.size(), "/Plenum/Materials");
  check(field::wall, scene.info.walls.size(), "/Plenum/Walls");
}

}  // namespace

int particleFileDimension(const std::filesystem::path& path) {
  const auto file = hdf5::File::open(path);
  return dimensionOf(openPlenum(file));
}

template <int Dim>
Scene<Dim> readParticleFile(const std::filesystem::path& path) {
  const auto file = hdf5::File::open(path);
  const Group plenum = openPlenum(file);
  if (const int dimension = dimensionOf(plenum); dimension != Dim)
    throw InputError(fmt::format("{}: is {}-dimensional, must be {}-dimensional here",
                                 path.string(), dimension, Dim));
  Scene<Dim> scene{readSceneInfo<Dim>(plenum), readParticles<Dim>(file, plenum)};
  if (const auto found = firstNotFinite(scene.particles, scene.particles.fields()))
    throw InputError(
        fmt::format("{}: {} of {} is not finite; generate the particle file again or "
                    "resume from an earlier one",
                    path.string(), found->field, found->particle));
  checkLabels(path.string(), scene);
  return scene;
}

template Scene<1> readParticleFile(const std::filesystem::path&);
template Scene<2> readParticleFile(const std::filesystem::path&);
template Scene<3> readParticleFile(const std::filesystem::path&);

}  // namespace plenum
