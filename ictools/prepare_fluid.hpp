// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/density_profile.hpp"
#include "ictools/equal_masses.hpp"
#include "ictools/fluids.hpp"
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
  if (fluid.spacingFollowsDensity() && !settings.relax)
    warn(
        fmt::format("fluid \"{}\": particles of equal mass stand at random until a [relax] table "
                    "arranges them",
                    fluid.name));
  FluidFill<Dim> fill = prepareFluid(fluid, region, profile, frame, warn);
  if (fluid.positions) placeFromFile(fill, folder, frame, warn);
  return fill;
}

}  // namespace plenum
