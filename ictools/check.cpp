// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/check.hpp"

#include "ictools/assemble.hpp"
#include "ictools/container.hpp"
#include "ictools/prepare_fluid.hpp"
#include "ictools/thin_parts.hpp"
#include "ictools/wall_thickness.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace plenum {

namespace {

/// A case on its way from settings to particles, as far as it is sound.
template <int Dim>
struct Draft {
  SceneFrame<Dim> frame;
  std::vector<FluidFill<Dim>> fluids;
  std::vector<WallFill<Dim>> walls;
  Box<Dim> container = Box<Dim>::nothing();
};

/// Where a fluid's region is too narrow for the kernel; below one spacing `checkThinParts` speaks.
template <int Dim>
void checkGap(const FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame, Findings& findings) {
  const auto gap = thinnestPlace(fluid, frame, frame.support());
  if (!gap || gap->thickness < frame.spacing) return;
  const double ratio =
      fluid.resolution ? ratiosAt<Dim>(*fluid.resolution, std::span(&gap->point, 1))[0] : 1;
  if (gap->thickness >= ratio * frame.support()) return;
  findings.add(
      {Severity::warning,
       fmt::format("{}: fluid \"{}\": its narrowest gap is {:.4g} m or {:.3g} d_ref wide, at "
                   "({:.4g}); the kernel's support needs {:g} d_ref",
                   at(fluid.settings.node, "region").where(), fluid.settings.name, gap->thickness,
                   gap->thickness / frame.spacing, fmt::join(gap->point.components, ", "),
                   frame.support() / frame.spacing),
       fmt::format("refine the spacing to {:.3g} m or less",
                   gap->thickness / (2 * frame.solver.smoothingLength)),
       {gap->point.components.begin(), gap->point.components.end()}});
}

/// False if some fluid is at fault: what is built upon all of them is not looked at then.
template <int Dim>
bool draftFluids(const CaseSettings& settings, const Regions<Dim>& regions,
                 const std::filesystem::path& folder, Draft<Dim>& draft, Findings& findings) {
  std::vector<FluidSettings> all;
  bool isSound = findings.attempt([&] { all = readFluids(settings); });
  for (const FluidSettings& fluid : all)
    isSound &= findings.attempt([&] {
      draft.fluids.push_back(
          prepareFluid(fluid, settings, regions, folder, draft.frame, findings.warner()));
    });
  return isSound && findings.attempt([&] {
    prepareTogether(draft.fluids, settings, regions, draft.frame, findings.warner());
  }) && findings.attempt([&] { checkMemory(draft.fluids, draft.frame); });
}

template <int Dim>
bool draftWalls(const CaseSettings& settings, const Regions<Dim>& regions,
                const std::filesystem::path& folder, bool fluidsAreSound, Draft<Dim>& draft,
                Findings& findings) {
  std::vector<WallSettings> all;
  bool isSound = findings.attempt([&] { all = readWalls(settings); });
  for (const WallSettings& wall : all)
    isSound &= findings.attempt([&] {
      const GeometryPtr<Dim> solid = regions.find(at(wall.node, wall.regionKey()));
      if (!fluidsAreSound) return;
      draft.walls.push_back(
          prepareWall(wall, solid, draft.fluids, draft.frame, folder, findings.warner()));
    });
  return isSound && fluidsAreSound;
}

/// Puts particles into the draft and makes all checks that `generate` makes.
template <int Dim>
bool fillDraft(Draft<Dim>& draft, Findings& findings) {
  if (!findings.attempt([&] { fillFluids(draft.fluids, draft.frame); })) return false;
  for (const auto& fluid : draft.fluids)
    if (fluid.nCovered > 0)
      findings.add({Severity::note,
                    fmt::format("{}: overlaps an earlier fluid, which has the place: {} places of "
                                "fluid \"{}\" are left to it",
                                at(fluid.settings.node, "region").where(), fluid.nCovered,
                                fluid.settings.name),
                    "make its region a difference, or change the order of the fluids, if that is "
                    "not meant",
                    {}});
  findings.attempt([&] { checkThinParts(draft.fluids, draft.frame, findings.warner()); });
  if (!findings.attempt([&] { checkFluidOutsideWalls(draft.fluids, draft.walls, draft.frame); }))
    return false;  // walls would miss the places of that fluid
  const bool isFilled =
      findings.attempt([&] { fillWalls(draft.walls, draft.fluids, draft.container, draft.frame); });
  if (!isFilled) return false;
  findings.attempt([&] { measureThickness(draft.walls, draft.frame, findings.warner()); });
  findings.attempt([&] { assemble(draft.fluids, draft.walls, draft.frame); });
  return true;
}

template <int Dim>
void estimateDraft(Draft<Dim>& draft, CheckReport& report) {
  double nFluid = expectedFluid(draft.fluids);
  double nWalls = 0;
  if (!draft.walls.empty())
    nWalls = expectedWalls(draft.walls,
                           wallBox(draft.walls, draft.fluids, draft.container, draft.frame));
  bool isCounted = false;
  if (nFluid + nWalls <= maxCounted) {
    isCounted = fillDraft(draft, report.findings);
  } else {
    report.findings.add(
        {Severity::note,
         fmt::format("{}: about {:.3g} particles are more than the {:.0e} up to which they are "
                     "made to look at gaps, thin walls and overlaps",
                     report.caseName, nFluid + nWalls, maxCounted),
         "check with a larger --set spacing=... as well",
         {}});
  }
  if (isCounted) {
    nFluid = nWalls = 0;
    for (const auto& fluid : draft.fluids)  // `assemble` has taken the points, if it came so far
      nFluid += static_cast<double>(std::max(fluid.nParticles, fluid.points.size()));
    for (const auto& wall : draft.walls) nWalls += static_cast<double>(wall.points.size());
  }
  report.estimate = estimateOf(nFluid, nWalls, isCounted, draft.fluids.front(), draft.frame);
  report.estimate->generateMemory = memoryToGenerate(draft.fluids, nWalls);
}

template <int Dim>
void check(const CaseNode& root, const CaseSettings& settings, const std::filesystem::path& folder,
           CheckReport& report) {
  Findings& findings = report.findings;
  Draft<Dim> draft;
  if (!findings.attempt([&] { draft.frame = sceneFrame<Dim>(root, settings); })) return;
  const Regions<Dim> regions(settings, folder, findings);
  report.parts = checkParts(settings, regions, draft.frame, findings);
  const bool fluidsAreSound = draftFluids(settings, regions, folder, draft, findings);
  if (expectedFluid(draft.fluids) <= maxCounted)  // whatever is wrong elsewhere
    for (const auto& fluid : draft.fluids) checkGap(fluid, draft.frame, findings);
  bool isSound = draftWalls(settings, regions, folder, fluidsAreSound, draft, findings);
  isSound &= findings.attempt([&] {
    for (const auto& region : containerRegions(root, settings, regions, draft.fluids, draft.frame))
      draft.container.extend(region->bounds());
  });
  isSound &= findings.attempt([&] { readRelax(settings); });
  if (isSound) estimateDraft(draft, report);
}

}  // namespace

CheckReport checkCase(const std::filesystem::path& path, const std::vector<std::string>& settings,
                      bool quick) {
  CheckReport report;
  report.caseName = path.string();
  CaseNode root;
  CaseSettings read;
  const bool isCase = report.findings.attempt([&] {
    root = CaseNode::load(path);
    applyChanges(root, quick, settings);
    read = readCase(root);
  });
  if (!isCase) return report;
  const std::filesystem::path folder = path.parent_path();
  if (read.dimension == 1) check<1>(root, read, folder, report);
  if (read.dimension == 2) check<2>(root, read, folder, report);
  if (read.dimension == 3) check<3>(root, read, folder, report);
  return report;
}

}  // namespace plenum
