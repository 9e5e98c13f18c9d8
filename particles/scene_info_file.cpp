// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/scene_info_file.hpp"

#include "particles/motion_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <span>

namespace plenum {

namespace {

/// One member of every element, as a column.
template <class Row, class T>
std::vector<T> column(const std::vector<Row>& rows, T Row::*member) {
  std::vector<T> values;
  for (const Row& row : rows) values.push_back(row.*member);
  return values;
}

std::vector<double> flattened(const std::vector<Wall>& walls,
                              std::array<double, 3> RigidMotion::*member) {
  std::vector<double> values;
  for (const Wall& wall : walls)
    for (double value : wall.motion.*member) values.push_back(value);
  return values;
}

template <class T>
void writeColumn(const hdf5::Group& group, const std::string& name, const std::vector<T>& values,
                 int columns = 1) {
  group.write(name, std::span<const T>(values), columns);
}

/// What a material may have of its own, by the name of its column; NaN where it has not.
constexpr std::array<std::pair<const char*, std::optional<double> Material::*>, 5> ownValues{{
    {"SoundSpeed", &Material::soundSpeed},
    {"TaitExponent", &Material::taitExponent},
    {"BackgroundPressure", &Material::backgroundPressure},
    {"DynamicViscosity", &Material::dynamicViscosity},
    {"CavitationPressure", &Material::cavitationPressure},
}};

void writeMaterials(const hdf5::Group& group, const std::vector<Material>& materials) {
  group.writeTexts("Name", column(materials, &Material::name));
  writeColumn(group, "Density", column(materials, &Material::density));
  group.setText("Unit", "kg/m^d", "Density");
  for (const auto& [name, member] : ownValues) {
    std::vector<double> values;
    for (const Material& material : materials) values.push_back((material.*member).value_or(NAN));
    writeColumn(group, name, values);
  }
}

void writeWalls(const hdf5::Group& group, const std::vector<Wall>& walls) {
  group.writeTexts("Name", column(walls, &Wall::name));
  group.writeTexts("Method", column(walls, &Wall::method));
  writeColumn(group, "Layers", column(walls, &Wall::layers));
  writeColumn(group, "Thickness", column(walls, &Wall::thickness));
  writeColumn(group, "Density", column(walls, &Wall::density));
  writeColumn(group, "Velocity", flattened(walls, &RigidMotion::velocity), 3);
  writeColumn(group, "AngularVelocity", flattened(walls, &RigidMotion::angularVelocity), 3);
  writeColumn(group, "Center", flattened(walls, &RigidMotion::center), 3);
  group.setText("Unit", "m", "Thickness");
  group.setText("Unit", "kg/m^d", "Density");
  group.setText("Unit", "m/s", "Velocity");
  group.setText("Unit", "rad/s", "AngularVelocity");
  group.setText("Unit", "m", "Center");
  writeMotions(group, walls);
}

std::vector<Material> readMaterials(const hdf5::Group& group) {
  const std::vector<std::string> names = group.readTexts("Name");
  const auto densities = group.read<double>("Density", names.size());
  std::vector<Material> materials;
  for (std::size_t k = 0; k < names.size(); ++k) materials.push_back({names[k], densities[k]});
  for (const auto& [name, member] : ownValues) {
    if (!group.has(name)) continue;  // a file of an earlier version
    const auto values = group.read<double>(name, names.size());
    for (std::size_t k = 0; k < names.size(); ++k)
      if (!std::isnan(values[k])) materials[k].*member = values[k];
  }
  return materials;
}

std::vector<Wall> readWalls(const hdf5::Group& group) {
  std::vector<Wall> walls;
  for (const std::string& name : group.readTexts("Name")) walls.emplace_back().name = name;
  const std::size_t n = walls.size();
  const std::vector<std::string> methods = group.readTexts("Method");
  if (methods.size() != n)
    group.fail("Method", fmt::format("has {} rows, Name has {}", methods.size(), n));
  const auto layers = group.read<std::int32_t>("Layers", n);
  const auto thicknesses = group.read<double>("Thickness", n);
  const auto densities = group.read<double>("Density", n);
  const auto velocities = group.read<double>("Velocity", n, 3);
  const auto angularVelocities = group.read<double>("AngularVelocity", n, 3);
  const auto centers = group.read<double>("Center", n, 3);
  for (std::size_t k = 0; k < n; ++k) {
    Wall& wall = walls[k];
    wall.method = methods[k];
    wall.layers = layers[k];
    wall.thickness = thicknesses[k];
    wall.density = densities[k];
    for (std::size_t a = 0; a < 3; ++a) {
      wall.motion.velocity[a] = velocities[3 * k + a];
      wall.motion.angularVelocity[a] = angularVelocities[3 * k + a];
      wall.motion.center[a] = centers[3 * k + a];
    }
  }
  readMotions(group, walls);
  return walls;
}

template <class T, std::size_t N>
std::array<T, N> arrayAttribute(const hdf5::Group& group, const std::string& name) {
  const std::vector<T> values = group.attributes<T>(name, N);
  std::array<T, N> array{};
  std::copy(values.begin(), values.end(), array.begin());
  return array;
}

template <int Dim>
void writeDomain(const hdf5::Group& group, const Box<Dim>& domain) {
  std::vector<std::int32_t> periodic(domain.periodic.begin(), domain.periodic.end());
  group.setAttributes<double>("Lower", domain.lower.components);
  group.setAttributes<double>("Upper", domain.upper.components);
  group.setAttributes<std::int32_t>("Periodic", periodic);
}

template <int Dim>
Box<Dim> readDomain(const hdf5::Group& group) {
  Box<Dim> domain;
  domain.lower.components = arrayAttribute<double, Dim>(group, "Lower");
  domain.upper.components = arrayAttribute<double, Dim>(group, "Upper");
  const auto periodic = group.attributes<std::int32_t>("Periodic", Dim);
  for (std::size_t a = 0; a < Dim; ++a) {
    domain.periodic[a] = periodic[a] != 0;
    const double length = domain.upper.components[a] - domain.lower.components[a];
    if (domain.periodic[a] && !(length > 0 && std::isfinite(length)))
      group.fail(".", fmt::format("has a periodic axis {} of length {}", "xyz"[a], length));
  }
  return domain;
}

template <int Dim>
void writeContainer(const hdf5::Group& group, const ContainerMap<Dim>& map) {
  group.setAttributes<double>("Lower", map.lower.components);
  group.setAttribute("Spacing", map.spacing);
  group.setAttribute("Step", map.step);
  group.setAttributes<std::int32_t>("Shape", map.shape);
  group.writeCompressed<std::int8_t>("Counts", map.counts);
}

template <int Dim>
ContainerMap<Dim> readContainer(const hdf5::Group& group) {
  ContainerMap<Dim> map;
  map.lower.components = arrayAttribute<double, Dim>(group, "Lower");
  map.spacing = group.attribute<double>("Spacing");
  map.step = group.attribute<double>("Step");
  map.shape = arrayAttribute<std::int32_t, Dim>(group, "Shape");
  const std::vector<hsize_t> shape = group.shape("Counts");
  if (shape.size() != 1) group.fail("Counts", "is not a list");
  map.counts = group.read<std::int8_t>("Counts", shape[0]);
  double cells = 1;
  for (int n : map.shape) cells *= n >= 0 ? n : NAN;
  if (!map.empty() && (cells != static_cast<double>(map.counts.size()) || !(map.spacing > 0)))
    group.fail("Counts", fmt::format("has {} cells, its Shape says {}", map.counts.size(), cells));
  return map;
}

void writeFigures(const hdf5::Group& group,
                  const std::vector<std::pair<std::string, double>>& figures) {
  using Figure = std::pair<std::string, double>;
  group.writeTexts("Name", column(figures, &Figure::first));
  writeColumn(group, "Value", column(figures, &Figure::second));
}

std::vector<std::pair<std::string, double>> readFigures(const hdf5::Group& group) {
  const std::vector<std::string> names = group.readTexts("Name");
  const auto values = group.read<double>("Value", names.size());
  std::vector<std::pair<std::string, double>> figures;
  for (std::size_t k = 0; k < names.size(); ++k) figures.emplace_back(names[k], values[k]);
  return figures;
}

}  // namespace

template <int Dim>
void writeSceneInfo(const hdf5::Group& plenum, const SceneInfo<Dim>& info) {
  plenum.setText("Title", info.title);
  plenum.setText("CaseName", info.caseName);
  plenum.setText("Generator", info.generator);
  plenum.setAttribute("Time", info.time);
  plenum.setAttribute("StartTime", info.startTime);
  plenum.setAttribute("Spacing", info.spacing);
  plenum.setText("KernelName", info.kernel);
  plenum.setAttribute("SmoothingLength", info.smoothingLength);
  plenum.setAttribute("SupportOverH", supportOverH);
  plenum.writeText("CaseText", info.caseText);
  writeDomain(plenum.create("Domain"), info.domain);
  writeMaterials(plenum.create("Materials"), info.materials);
  writeWalls(plenum.create("Walls"), info.walls);
  writeContainer(plenum.create("Container"), info.container);
  writeFigures(plenum.create("Quality"), info.quality);
  if (!info.progress.empty()) writeFigures(plenum.create("Progress"), info.progress);
}

template <int Dim>
SceneInfo<Dim> readSceneInfo(const hdf5::Group& plenum) {
  SceneInfo<Dim> info;
  info.title = plenum.text("Title");
  info.caseName = plenum.text("CaseName");
  info.caseText = plenum.readText("CaseText");
  info.generator = plenum.text("Generator");
  info.time = plenum.attribute<double>("Time");
  // Absent in a file of an earlier version.
  info.startTime =
      plenum.hasAttribute("StartTime") ? plenum.attribute<double>("StartTime") : info.time;
  info.spacing = plenum.attribute<double>("Spacing");
  info.kernel = plenum.text("KernelName");
  info.smoothingLength = plenum.attribute<double>("SmoothingLength");
  info.domain = readDomain<Dim>(plenum.open("Domain"));
  info.materials = readMaterials(plenum.open("Materials"));
  info.walls = readWalls(plenum.open("Walls"));
  info.container = readContainer<Dim>(plenum.open("Container"));
  info.quality = readFigures(plenum.open("Quality"));
  if (plenum.has("Progress")) info.progress = readFigures(plenum.open("Progress"));
  return info;
}

template void writeSceneInfo(const hdf5::Group&, const SceneInfo<1>&);
template void writeSceneInfo(const hdf5::Group&, const SceneInfo<2>&);
template void writeSceneInfo(const hdf5::Group&, const SceneInfo<3>&);
template SceneInfo<1> readSceneInfo(const hdf5::Group&);
template SceneInfo<2> readSceneInfo(const hdf5::Group&);
template SceneInfo<3> readSceneInfo(const hdf5::Group&);

}  // namespace plenum
