// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"
#include "particles/file_rows.hpp"
#include "particles/finite.hpp"
#include "particles/gadget_box.hpp"
#include "particles/particle_file.hpp"
#include "particles/scene_info_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <vector>

namespace plenum {

namespace {

using hdf5::Group;

void writeUnits(const Group& units) {
  units.setAttribute("Unit length in cgs (U_L)", 100.0);
  units.setAttribute("Unit mass in cgs (U_M)", 1000.0);
  units.setAttribute("Unit time in cgs (U_t)", 1.0);
  units.setAttribute("Unit current in cgs (U_I)", 1.0);
  units.setAttribute("Unit temperature in cgs (U_T)", 1.0);
}

void writeHeader(const Group& header, int dimension, std::size_t n, double time,
                 const GadgetBox& box) {
  const std::array<std::uint32_t, 6> low{static_cast<std::uint32_t>(n)};
  const std::array<std::uint32_t, 6> high{static_cast<std::uint32_t>(std::uint64_t{n} >> 32)};
  const std::array<std::int64_t, 6> here{static_cast<std::int64_t>(n)};
  const std::array<double, 6> noMasses{};
  header.setAttribute<std::int32_t>("Dimension", dimension);
  header.setAttributes<double>("BoxSize", box.size);
  header.setAttributes<std::uint32_t>("NumPart_Total", low);
  header.setAttributes<std::uint32_t>("NumPart_Total_HighWord", high);
  header.setAttributes<std::int64_t>("NumPart_ThisFile", here);
  header.setAttributes<double>("MassTable", noMasses);
  header.setAttribute<std::int32_t>("Flag_Entropy_ICs", 0);
  header.setAttribute<std::int32_t>("NumFilesPerSnapshot", 1);
  header.setAttribute("Time", time);
  header.setAttribute("Redshift", 0.0);
}

void describe(const Group& group, const FieldInfo& info) {
  const std::string name(info.fileName);
  group.setText("Unit", std::string(info.unit), name);
  group.setText("Description", std::string(info.description), name);
}

/// What GADGET's readers need although this set does not carry it.
template <int Dim>
void writeAbsent(const Group& group, const Scene<Dim>& scene) {
  const ParticleSet<Dim>& particles = scene.particles;
  const std::size_t n = particles.size();
  for (FieldId id : {FieldId::velocity, FieldId::mass, FieldId::density, FieldId::internalEnergy,
                     FieldId::smoothingLength, FieldId::id}) {
    if (particles.has(id)) continue;
    const FieldInfo& info = infoOf(id);
    const std::string name(info.fileName);
    if (id == FieldId::id) {
      const std::size_t nFluid = particles.nFluid();
      group.writePieces<std::uint64_t>(
          name, n, 1, [&](std::size_t first, std::span<std::uint64_t> ids) {
            for (std::uint64_t& number : ids) {
              number = first < nFluid ? particles.nWalls() + first + 1 : first - nFluid + 1;
              ++first;
            }
          });
    } else {
      const int columns = info.rank == Rank::vector ? 3 : 1;
      const double value = id == FieldId::smoothingLength ? scene.info.smoothingLength : 0.0;
      group.writePieces<double>(name, n, columns, [&](std::size_t, std::span<double> rows) {
        std::ranges::fill(rows, value);
      });
    }
    describe(group, info);
  }
}

/// Writes /PartType0 and returns the names of its datasets but Coordinates.
template <int Dim>
std::vector<std::string> writeParticles(const Group& group, const Scene<Dim>& scene,
                                        const GadgetBox& box) {
  const ParticleSet<Dim>& particles = scene.particles;
  const std::span<const Vec<Dim>> positions = particles[field::position];
  std::vector<std::string> names{"Velocities",     "Masses",          "Density",
                                 "InternalEnergy", "SmoothingLength", "ParticleIDs"};
  group.writePieces<double>("Coordinates", positions.size(), 3,
                            [&](std::size_t first, std::span<double> rows) {
                              gadgetCoordinates(positions, box, first, rows);
                            });
  describe(group, infoOf(FieldId::position));
  particles.forEachField([&](const FieldInfo& info, auto values) {
    if (!info.isState || info.id == FieldId::position) return;
    const auto rows = rowsOf(particles, info, values);
    const std::string name(info.fileName);
    group.write(name, rows.values, rows.components);
    describe(group, info);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  });
  writeAbsent(group, scene);
  group.writePieces<std::uint8_t>("ParticleTypes", particles.size(), 1,
                                  [&](std::size_t first, std::span<std::uint8_t> types) {
                                    for (std::uint8_t& type : types)
                                      type = first++ < particles.nFluid() ? 0 : 1;
                                  });
  group.setText("Description", "0 fluid, 1 wall", "ParticleTypes");
  names.push_back("ParticleTypes");
  group.setText("KernelName", scene.info.kernel, "SmoothingLength");
  group.setAttribute("SupportOverH", supportOverH, "SmoothingLength");
  return names;
}

/// One vertex cell a particle, arrays shared with /PartType0.
template <int Dim>
void writeVtk(const Group& vtk, const Group& partType0, const ParticleSet<Dim>& particles,
              const std::vector<std::string>& names, bool ownPoints) {
  const auto n = static_cast<std::int64_t>(particles.size());
  vtk.setAttributes<std::int64_t>("Version", std::array<std::int64_t, 2>{1, 0});
  vtk.setAsciiText("Type", "UnstructuredGrid");
  for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
    vtk.write<std::int64_t>(name, std::array<std::int64_t, 1>{n});
  const auto count = [](std::size_t first, std::span<std::int64_t> numbers) {
    std::iota(numbers.begin(), numbers.end(), static_cast<std::int64_t>(first));
  };
  vtk.writePieces<std::int64_t>("Offsets", particles.size() + 1, 1, count);
  vtk.writePieces<std::int64_t>("Connectivity", particles.size(), 1, count);
  vtk.writePieces<std::uint8_t>("Types", particles.size(), 1,
                                [](std::size_t, std::span<std::uint8_t> types) {
                                  std::ranges::fill(types, std::uint8_t{1});
                                });
  if (ownPoints) {
    const auto rows = rowsOf(particles, infoOf(FieldId::position), particles[field::position]);
    vtk.write("Points", rows.values, 3);
    vtk.setText("Unit", "m", "Points");
  } else {
    vtk.link("Points", partType0, "Coordinates");
  }
  const Group pointData = vtk.create("PointData");
  for (const std::string& name : names) pointData.link(name, partType0, name);
}

template <int Dim>
void writePlenum(const Group& plenum, const Scene<Dim>& scene, const GadgetBox& box) {
  const ParticleSet<Dim>& particles = scene.particles;
  std::vector<std::string> fields;
  particles.forEachField([&](const FieldInfo& info, const auto&) {
    if (info.isState) fields.emplace_back(info.name);
  });
  plenum.setAttribute<std::int32_t>("SchemaVersion", particleFileSchema);
  plenum.setAttribute<std::int32_t>("Dimension", Dim);
  plenum.setAttribute<std::uint64_t>("NumberOfFluids", particles.nFluid());
  plenum.setAttribute<std::uint64_t>("NumberOfWalls", particles.nWalls());
  plenum.setTexts("Fields", fields);
  plenum.setAttributes<double>("Shift", box.shift);
  writeSceneInfo(plenum, scene.info);
}

/// No file is larger than this.
template <int Dim>
std::uintmax_t mostBytes(const Scene<Dim>& scene) {
  std::uintmax_t perParticle = 24 + 3 * 8;  // /VTKHDF: own points, connectivity, offsets and types
  for (const FieldInfo& info : fieldTable)
    if (info.isState) perParticle += info.rank == Rank::vector ? 24 : 8;
  const SceneInfo<Dim>& info = scene.info;
  std::uintmax_t texts = info.caseText.size() + info.caseName.size() + info.title.size();
  std::uintmax_t tables = 0;  // five numbers a row
  for (const Wall& wall : info.walls) tables += 5 * sizeof(double) * wall.motion.table.times.size();
  return scene.particles.size() * perParticle + texts + tables + info.container.counts.size() +
         1024 * (256 + info.walls.size() + info.materials.size() + info.quality.size());
}

template <int Dim>
void checkWritable(const std::filesystem::path& path, const Scene<Dim>& scene) {
  const ParticleSet<Dim>& particles = scene.particles;
  if (particles.size() == 0 || !particles.has(FieldId::position))
    throw InputError(path.string() +
                     ": not written: there are no particles; a smaller spacing "
                     "or a larger region makes some");
  if (const auto found = firstNotFinite(particles, {FieldId::position}))
    throw RunError(fmt::format("{}: not written: {} of {} is not finite", path.string(),
                               found->field, found->particle));
  for (int a = 0; a < Dim; ++a)
    if (scene.info.domain.isPeriodic(a) && !(scene.info.domain.extent()[a] > 0))
      throw InputError(fmt::format("{}: not written: the periodic axis {} has no length",
                                   path.string(), "xyz"[a]));
}

}  // namespace

template <int Dim>
void writeParticleFile(const std::filesystem::path& path, const Scene<Dim>& scene) {
  checkWritable(path, scene);
  AtomicFile file(path);
  const GadgetBox box = gadgetBox(scene);
  // Before HDF5 opens the file, because HDF5 does not recover from a full disk; and again, because
  // opening empties the file.
  file.reserve(mostBytes(scene));
  auto hdf = hdf5::File::create(file.temporaryPath(), path);
  file.reserve(mostBytes(scene));
  {
    const Group& root = hdf.root();
    writeHeader(root.create("Header"), Dim, scene.particles.size(), scene.info.time, box);
    writeUnits(root.create("Units"));
    const Group partType0 = root.create("PartType0");
    const auto names = writeParticles(partType0, scene, box);
    const bool ownPoints = changesCoordinates<Dim>(scene.particles[field::position], box);
    writeVtk(root.create("VTKHDF"), partType0, scene.particles, names, ownPoints);
    writePlenum(root.create("Plenum"), scene, box);
  }
  file.trim(hdf.close());
  file.commit();
}

template void writeParticleFile(const std::filesystem::path&, const Scene<1>&);
template void writeParticleFile(const std::filesystem::path&, const Scene<2>&);
template void writeParticleFile(const std::filesystem::path&, const Scene<3>&);

}  // namespace plenum
