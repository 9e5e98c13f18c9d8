// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/density_profile.hpp"
#include "ictools/equal_masses.hpp"
#include "ictools/fluids.hpp"
#include "ictools/number_density.hpp"
#include "ictools/periodic_support.hpp"
#include "ictools/positions.hpp"
#include "ictools/regions.hpp"

#include <fmt/format.h>

namespace plenum {

/// A fluid of a case, with its region and its density profile, ready to be filled, or filled
/// if the case gives positions. Files are relative to `folder`. Throws InputError as `prepareFluid`
/// of fluids.hpp and `placeFromFile` do.
template <int Dim>
FluidFill<Dim> prepareFluid(const FluidSettings& fluid, const CaseSettings& settings,
                            const Regions<Dim>& regions, const std::filesystem::path& folder,
                            const SceneFrame<Dim>& frame, const Warn& warn) {
  const GeometryPtr<Dim> region =
      fluid.region.empty() ? nullptr : regions.find(at(fluid.node, "region"));
  DensityProfilePtr<Dim> profile;
  if (fluid.profile) profile = makeProfile<Dim>(*fluid.profile, at(fluid.node, "profile"), folder);
  if (!fluid.profile && fluid.spacingFollowsDensity())
    profile = profileOf<Dim>(InitialState(fluid.ownSolver(frame.solver), fluid.density,
                                          fluid.pressure, fluid.hydrostatic, fluid.node));
  if (fluid.spacingFollowsDensity() && !settings.relax)
    warn(
        fmt::format("fluid \"{}\": particles of equal mass stand unevenly until a [relax] table "
                    "arranges them",
                    fluid.name));
  FluidFill<Dim> fill = prepareFluid(fluid, region, profile, frame, warn);
  if (fluid.positions) placeFromFile(fill, folder, frame, warn);
  return fill;
}

/// What the case says of all of its fluids together: equal masses, refinements; and estimates how
/// many particles they will have. Throws InputError for unknown regions and as `countExpected`
/// does.
template <int Dim>
void prepareTogether(std::vector<FluidFill<Dim>>& fluids, const CaseSettings& settings,
                     const Regions<Dim>& regions, const SceneFrame<Dim>& frame, const Warn& warn) {
  matchMasses(fluids, frame);
  checkSupports(fluids, frame);
  std::vector<Refinement<Dim>> refinements;
  for (const RefineSettings& refinement : readRefinements(settings))
    refinements.emplace_back(refinement, regions.find(at(refinement.node, refinement.regionKey())),
                             frame.spacing, frame.domain);
  if (!refinements.empty()) {
    const auto resolution =
        std::make_shared<const Resolution<Dim>>(std::move(refinements), frame.spacing);
    for (auto& fluid : fluids) fluid.resolution = resolution;
    if (!settings.relax)
      warn(
          "particles of refined fluids stand unevenly until they are arranged; add a [relax] "
          "table");
  }
  countExpected(fluids, frame, warn);
}

}  // namespace plenum
