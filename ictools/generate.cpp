// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/generate.hpp"

#include "ictools/assemble.hpp"
#include "ictools/container.hpp"
#include "ictools/estimate.hpp"
#include "ictools/places_of_set.hpp"
#include "ictools/prepare_fluid.hpp"
#include "ictools/regions.hpp"
#include "ictools/thin_parts.hpp"
#include "ictools/wall_thickness.hpp"
#include "particles/errors.hpp"
#include "particles/version.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

namespace plenum {

namespace {

/// Reads all regions; says what was mended and throws what is wrong.
template <int Dim>
Regions<Dim> readRegions(const CaseSettings& settings, const std::filesystem::path& folder,
                         const Warn& warn) {
  Findings findings;
  Regions<Dim> regions(settings, folder, findings);
  for (const Finding& finding : findings.all())
    if (finding.severity != Severity::error) warn(finding.text());
  findings.throwErrors();
  return regions;
}

template <int Dim>
std::vector<FluidFill<Dim>> prepareFluids(const CaseSettings& settings, const Regions<Dim>& regions,
                                          const std::filesystem::path& folder,
                                          const SceneFrame<Dim>& frame, const Warn& warn) {
  std::vector<FluidFill<Dim>> fluids;
  for (const FluidSettings& fluid : readFluids(settings))
    fluids.push_back(prepareFluid(fluid, settings, regions, folder, frame, warn));
  prepareTogether(fluids, settings, regions, frame, warn);
  return fluids;
}

template <int Dim>
std::vector<WallFill<Dim>> prepareWalls(const CaseSettings& settings, const Regions<Dim>& regions,
                                        const std::filesystem::path& folder,
                                        const std::vector<FluidFill<Dim>>& fluids,
                                        const SceneFrame<Dim>& frame, const Warn& warn) {
  std::vector<WallFill<Dim>> walls;
  for (const WallSettings& wall : readWalls(settings)) {
    const GeometryPtr<Dim> geometry = regions.find(at(wall.node, wall.regionKey()));
    walls.push_back(prepareWall(wall, geometry, fluids, frame, folder, warn));
  }
  return walls;
}

/// The case as the solver must read it: the file's own text, or, if something was set on the
/// command line, the values with which this set was made.
std::string caseText(const CaseNode& root, const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream file;
  file << in.rdbuf();
  if (in && CaseNode::parse(file.str(), path.string()).printed() == root.printed())
    return file.str();
  return root.printedFile(path.string() + " with values set on the command line");
}

template <int Dim>
Box<Dim> domainOf(const SceneFrame<Dim>& frame, const ParticleSet<Dim>& particles) {
  Box<Dim> box = Box<Dim>::nothing();
  for (const Vec<Dim>& x : particles[field::position]) box.extend(x);
  return frame.clipped(box);
}

template <int Dim>
SceneInfo<Dim> sceneInfo(const CaseNode& root, const CaseSettings& settings,
                         const std::filesystem::path& casePath, const SceneFrame<Dim>& frame,
                         const std::vector<FluidFill<Dim>>& fluids,
                         const std::vector<WallFill<Dim>>& walls) {
  SceneInfo<Dim> info;
  info.title = settings.title;
  info.caseName = casePath.string();
  info.caseText = caseText(root, casePath);
  info.generator = fmt::format("plenum-ic {}", version);
  info.spacing = frame.spacing;
  info.kernel = frame.solver.kernel;
  info.smoothingLength = frame.smoothingLength();
  for (const auto& fluid : fluids)
    info.materials.push_back({fluid.settings.name, fluid.settings.density,
                              fluid.settings.soundSpeed, fluid.settings.taitExponent,
                              fluid.settings.backgroundPressure, fluid.settings.dynamicViscosity,
                              fluid.settings.cavitationPressure});
  for (const auto& wall : walls)
    info.walls.push_back({wall.settings.name, wall.settings.method, wall.layers, wall.thickness,
                          wall.density, wall.motion});
  return info;
}

template <int Dim>
void addFigures(const RelaxationResult& relaxed, SceneInfo<Dim>& info) {
  info.quality.emplace_back("relaxation: iterations", relaxed.history.back().iteration);
  info.quality.emplace_back("relaxation: iterations of the best state", relaxed.best.iteration);
  info.quality.emplace_back("relaxation: scatter of the kernel sum", relaxed.best.scatter);
  info.quality.emplace_back("relaxation: largest deviation of the kernel sum", relaxed.best.worst);
}

}  // namespace

template <int Dim>
Generated<Dim> generate(const CaseNode& root, const CaseSettings& settings,
                        const std::filesystem::path& casePath, const Warn& warn,
                        const GenerateOptions<Dim>& options) {
  const SceneFrame<Dim> frame = sceneFrame<Dim>(root, settings);
  const Regions<Dim> regions = readRegions<Dim>(settings, casePath.parent_path(), warn);
  auto fluids = prepareFluids(settings, regions, casePath.parent_path(), frame, warn);
  auto walls = prepareWalls(settings, regions, casePath.parent_path(), fluids, frame, warn);
  const auto container = containerRegions(root, settings, regions, fluids, frame);

  checkMemory(fluids, frame);
  if (options.placesOf != nullptr) takePlaces(fluids, *options.placesOf, frame);
  fillFluids(fluids, frame);
  checkFluidOutsideWalls(fluids, walls, frame);
  checkThinParts(fluids, frame, warn);
  Box<Dim> containerBox = Box<Dim>::nothing();
  for (const auto& region : container) containerBox.extend(region->bounds());
  fillWalls(walls, fluids, containerBox, frame);
  std::optional<RelaxationResult> relaxed;
  if (const auto relaxation = readRelax(settings))
    relaxed = relax(fluids, walls, frame, *relaxation, options.watch);
  measureThickness(walls, frame, warn);

  Scene<Dim> scene{sceneInfo(root, settings, casePath, frame, fluids, walls),
                   assemble(fluids, walls, frame)};
  scene.info.domain = domainOf(frame, scene.particles);
  scene.info.quality =
      qualityFigures(fluids, walls, scene.particles, scene.info.domain, frame.spacing);
  scene.info.container = containerMap(container, frame);
  if (relaxed) addFigures(*relaxed, scene.info);
  std::vector<DensityProfilePtr<Dim>> profiles;
  for (const auto& fluid : fluids) profiles.push_back(fluid.profile);
  return {std::move(scene), std::move(profiles), std::move(relaxed)};
}

template Generated<1> generate(const CaseNode&, const CaseSettings&, const std::filesystem::path&,
                               const Warn&, const GenerateOptions<1>&);
template Generated<2> generate(const CaseNode&, const CaseSettings&, const std::filesystem::path&,
                               const Warn&, const GenerateOptions<2>&);
template Generated<3> generate(const CaseNode&, const CaseSettings&, const std::filesystem::path&,
                               const Warn&, const GenerateOptions<3>&);

}  // namespace plenum
