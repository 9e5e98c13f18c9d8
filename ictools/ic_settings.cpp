// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/ic_settings.hpp"

#include "geometry/geometry_set.hpp"
#include "ictools/gas_settings.hpp"
#include "ictools/table_names.hpp"

#include <fmt/format.h>

namespace plenum {

namespace {

/// [[refine]] chooses places and masses by itself.
void checkRefined(const FluidSettings& fluid) {
  if (fluid.spacingFollowsDensity())
    at(fluid.node, fluid.profile ? "profile" : "particles")
        .fail(
            "particles = \"equal_mass\" excludes [[refine]]: either the density chooses the "
            "spacing or the refinement does; set particles = \"equal_spacing\", so that masses "
            "follow the profile, or leave [[refine]] out");
  if (fluid.positions)
    at(fluid.node, "positions")
        .fail(
            "excludes [[refine]], which chooses places by itself; leave one of positions and "
            "[[refine]] out");
  if (fluid.jitter > 0)
    at(fluid.node, "jitter")
        .fail("goes with a lattice, which [[refine]] replaces; set lattice = \"random\" instead");
}

void checkWall(const WallSettings& wall, int dimension) {
  if (wall.region.empty() == wall.outside.empty())
    wall.node.fail(
        "needs either region = \"the solid\" or outside = \"the region that it encloses\"");
  if (wall.pressure && wall.hydrostatic)
    at(wall.node, "pressure").fail("excludes hydrostatic; give one of them");
  checkMotions(wall, dimension);
}

}  // namespace

const Section<HydrostaticSettings>& hydrostaticSection() {
  using S = HydrostaticSettings;
  static const Section<S> section =
      Section<S>("pressure p = p_surface + rho |g| depth, density from the equation of state")
          .number("surface", &S::surface, "m", Range::any(),
                  "height of the surface, against gravity")
          .required()
          .number("pressure_at_surface", &S::pressureAtSurface, "Pa m^(3-d)", Range::any(),
                  "p_surface; absent: solver.background_pressure");
  return section;
}

const CaseNode& at(const CaseNode& table, const std::string& key) {
  const CaseNode* node = table.find(key);
  return node != nullptr ? *node : table;
}

const Section<WallSettings>& wallSection() {
  using S = WallSettings;
  static const Section<S> section =
      Section<S>("layers of particles behind a surface; where two walls overlap, the first stands")
          .text("name", &S::name, "for messages and results; absent: the region's name")
          .text("region", &S::region, "the solid; or else:")
          .text("outside", &S::outside, "the solid is everything outside of this region")
          .integer("layers", &S::layers, Range::between(1, 1000),
                   "absent: as the kernel's support needs")
          .text("method", &S::method,
                "lattice: the fluid's lattice continued; conformal: layers at (k - 1/2) d_ref; "
                "both as "
                "fine as the finest of [[refine]] along the wall",
                {"lattice", "conformal"})
          .text("lattice_of", &S::latticeOf, "fluid whose lattice is continued; absent: the first")
          .number("density", &S::density, "kg/m^d", Range::positive(),
                  "absent: of the first fluid, or of lattice_of")
          .vector("velocity", &S::velocity, "m/s",
                  "constant; absent: zero. Translations add up; rotations do if they share centre "
                  "and axis, "
                  "and the centre moves along")
          .section("rotation", &S::rotation, wallRotationSection())
          .section("oscillation", &S::oscillation, oscillationSection())
          .section("rocking", &S::rocking, rockingSection())
          .section("motion", &S::motion, tableMotionSection())
          .number(
              "pressure", &S::pressure, "Pa m^(3-d)", Range::any(),
              "initial pressure, density follows; absent: the background pressure, or zero with "
              "solver.wall_pressure = \"zero\"; of an ideal gas as the fluid of that density")
          .number("internal_energy", &S::internalEnergy, "J/kg", Range::positive(),
                  "e of a wall beside an ideal gas; absent: as the fluid of that density")
          .section("hydrostatic", &S::hydrostatic, hydrostaticSection());
  return section;
}

const Section<RefineSettings>& refineSection() {
  using S = RefineSettings;
  static const Section<S> section =
      Section<S>("a place where particles stand closer; from there the spacing grows to d_ref")
          .text("near", &S::near, "a region: both sides of its surface; or else:")
          .text("inside", &S::inside, "a region: all of it")
          .number("spacing", &S::spacing, "d_ref", Range::above(0, 1), "the spacing there")
          .required()
          .number("distance", &S::distance, "m", Range::notNegative(),
                  "of near: how far from the surface the place reaches")
          .number("growth", &S::growth, "", Range::above(0, 0.3),
                  "metres that the spacing grows in each metre away from the place");
  return section;
}

std::vector<RefineSettings> readRefinements(const CaseSettings& settings) {
  std::vector<RefineSettings> refinements;
  if (!settings.refinements) return refinements;
  for (const CaseNode& node : settings.refinements->asArray()) {
    RefineSettings refinement = refineSection().read(node, settings.dimension);
    refinement.node = node;
    if (refinement.near.empty() == refinement.inside.empty())
      node.fail("needs either near = \"a region\" or inside = \"a region\"");
    if (refinement.near.empty() && node.find("distance") != nullptr)
      node.find("distance")->fail("goes with near only; leave it out");
    refinements.push_back(std::move(refinement));
  }
  if (refinements.empty()) return refinements;
  for (const FluidSettings& fluid : readFluids(settings)) checkRefined(fluid);
  return refinements;
}

const Section<RelaxSettings>& relaxSection() {
  using S = RelaxSettings;
  static const Section<S> section =
      Section<S>("moves particles until the kernel sums over their neighbours are even")
          .text(
              "method", &S::method,
              "packing: as a gas with friction; wvt: weighted Voronoi moves; lloyd: to the centres "
              "of Voronoi cells",
              {"packing", "wvt", "lloyd"})
          .number(
              "tolerance", &S::tolerance, "", Range::above(0, 1),
              "standard deviation of the kernel sum over its mean that must be reached; absent: "
              "as far as it falls")
          .integer("max_iterations", &S::maxIterations, Range::between(1, 1e6), "at most")
          .flag("may_fail", &S::mayFail, "a tolerance that is not reached is only a warning");
  return section;
}

std::optional<RelaxSettings> readRelax(const CaseSettings& settings) {
  if (!settings.relax) return std::nullopt;
  return relaxSection().read(*settings.relax, settings.dimension);
}

std::vector<WallSettings> readWalls(const CaseSettings& settings) {
  std::vector<WallSettings> walls;
  if (!settings.walls) return walls;
  const SolverSettings solver = settings.solverOrDefaults();
  for (const CaseNode& node : settings.walls->asArray()) {
    WallSettings wall = wallSection().read(node, settings.dimension);
    wall.node = node;
    checkWall(wall, settings.dimension);
    checkGasKeys(wall, solver);
    if ((wall.pressure || wall.hydrostatic) && !solver.wallsEvolve() &&
        solver.wallPressure != "initial")
      node.find(wall.pressure ? "pressure" : "hydrostatic")
          ->fail(fmt::format("has no effect while solver.wall_pressure = \"{}\"; leave it out, or "
                             "set wall_pressure = \"initial\" or \"equation_of_state\"",
                             solver.wallPressure));
    walls.push_back(std::move(wall));
  }
  nameAll(walls, "wall");
  return walls;
}

std::vector<SectionDoc> caseDocs() {
  std::vector<SectionDoc> docs{caseSection().doc("")};
  for (SectionDoc& doc : geometryDocs()) docs.push_back(std::move(doc));
  docs.push_back(fluidSection().doc("fluid"));
  docs.push_back(wallSection().doc("wall"));
  docs.push_back(refineSection().doc("refine"));
  docs.push_back(relaxSection().doc("relax"));
  return docs;
}

}  // namespace plenum
