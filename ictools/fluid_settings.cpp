// SPDX-License-Identifier: GPL-3.0-or-later
//
// The [[fluid]] tables.
#include "ictools/gas_settings.hpp"
#include "ictools/ic_settings.hpp"
#include "ictools/lattice.hpp"
#include "ictools/table_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace plenum {

namespace {

Section<ProfileKeys> profileSection() {
  Section<LinearProfileKeys> linear("straight along a line, the same across it");
  linear.vector("from", &LinearProfileKeys::from, "m", "a place").required();
  linear.vector("to", &LinearProfileKeys::to, "m", "another").required();
  linear.numbers("density", &LinearProfileKeys::density, 2, "kg/m^d", "at these two").required();
  Section<PowerLawKeys> law("density (1 + r^2/core_radius^2)^exponent");
  law.vector("center", &PowerLawKeys::center, "m", "where r = 0; absent: the origin")
      .number("density", &PowerLawKeys::density, "kg/m^d", Range::positive(), "at the centre")
      .number("core_radius", &PowerLawKeys::coreRadius, "m", Range::positive(), "of the flat core")
      .required()
      .number("exponent", &PowerLawKeys::exponent, "", Range::any(), "of the fall outside");
  Section<RadialTableKeys> radial("a text file of radii [m] and densities, a line each");
  radial.text("file", &RadialTableKeys::file, "beside the case")
      .required()
      .vector("center", &RadialTableKeys::center, "m", "where r = 0; absent: the origin");
  Section<ImageProfileKeys> image("grey values of a PNG in x and y");
  image.text("file", &ImageProfileKeys::file, "beside the case").required();
  image.numbers("lower", &ImageProfileKeys::lower, 2, "m", "lower left corner of the image")
      .required();
  image.numbers("upper", &ImageProfileKeys::upper, 2, "m", "upper right corner").required();
  image.numbers("density", &ImageProfileKeys::density, 2, "kg/m^d", "of black and of white")
      .required();
  Section<ProfileKeys> section("a density that depends on the place: exactly one of these");
  section.section("linear", &ProfileKeys::linear, linear)
      .section("power_law", &ProfileKeys::powerLaw, law)
      .section("radial_table", &ProfileKeys::radialTable, radial)
      .section("image", &ProfileKeys::image, image)
      .text("formula", &ProfileKeys::formula,
            "of x, y, z [m], r and pi, as \"1 + 0.5*sin(2*pi*x)\"")
      .text("table", &ProfileKeys::table,
            "a text file with a line for each point of a regular grid: coordinates [m], density");
  return section;
}

Section<PositionsKeys> positionsSection() {
  using S = PositionsKeys;
  Section<S> section("where a file has particles, instead of a lattice; scaled, then translated");
  section
      .text("file", &S::file,
            "relative to the case file: .vtu, .csv (columns x, y, z or position_x ..., or "
            "numbers alone), .hdf5 or .hdf (/PartType0/Coordinates of GADGET and SWIFT in the "
            "file's unit of length, or a particle file)")
      .required()
      .number("scale", &S::scale, "", Range::positive(),
              "factor on lengths; 0.001 for a file in millimetres")
      .vector("translate", &S::translate, "m", "shift; absent: none");
  return section;
}

std::vector<std::string> allLattices() {
  std::vector<std::string> names;
  for (int dimension = 1; dimension <= 3; ++dimension)
    for (const std::string& name : latticeNames(dimension)) names.push_back(name);
  names.push_back("random");
  return names;
}

/// What a fluid starts with is said once.
void checkState(const FluidSettings& fluid, int dimension, const SolverSettings& solver) {
  checkGasKeys(fluid, solver);
  if (fluid.pressure && fluid.hydrostatic)
    at(fluid.node, "pressure").fail("excludes hydrostatic; give one of them");
  if (fluid.profile && fluid.hydrostatic)
    at(fluid.node, "profile").fail("excludes hydrostatic; give one of them");
  const bool densityFollows = solver.equationOfState == "tait";
  if (densityFollows && !fluid.pressureFormula.empty() &&
      (fluid.pressure || fluid.hydrostatic || fluid.profile))
    at(fluid.node, "pressure_formula")
        .fail("excludes pressure, hydrostatic and profile; give one of them");
  if (const CaseNode* node = fluid.node.find("velocity_formula")) {
    if (!fluid.velocity.empty()) node->fail("excludes velocity; give one of them");
    if (fluid.velocityFormula.size() != static_cast<std::size_t>(dimension))
      node->fail(fmt::format("needs {} formulas, one for each axis; has {}", dimension,
                             fluid.velocityFormula.size()));
  }
}

void checkFluid(const FluidSettings& fluid, int dimension, const SolverSettings& solver) {
  const std::vector<std::string>& known = latticeNames(dimension);
  if (fluid.lattice != "random" &&
      std::find(known.begin(), known.end(), fluid.lattice) == known.end())
    at(fluid.node, "lattice")
        .fail(fmt::format("does not exist in {} dimension{}; choose {} or random", dimension,
                          dimension == 1 ? "" : "s", fmt::join(known, ", ")));
  if (fluid.lattice == "random" && !fluid.latticeOrigin.empty())
    at(fluid.node, "lattice_origin").fail("a random set has no origin; leave it out");
  checkState(fluid, dimension, solver);
  if (!fluid.particles.empty() && !fluid.profile && !fluid.hydrostatic)
    at(fluid.node, "particles")
        .fail("goes with a profile or hydrostatic; leave it out, or give one of them");
  if (fluid.spacingFollowsDensity() && fluid.jitter > 0)
    at(fluid.node, "jitter")
        .fail("goes with a lattice, which equal masses replace; set lattice = \"random\" instead");
}

void checkEqualMasses(const FluidSettings& fluid, const std::vector<FluidSettings>& all) {
  if (fluid.equalMassWith.empty()) return;
  const CaseNode& node = at(fluid.node, "equal_mass_with");
  const auto other = std::ranges::find(all, fluid.equalMassWith, &FluidSettings::name);
  if (other == all.end()) {
    std::vector<std::string> names;
    for (const FluidSettings& one : all) names.push_back(one.name);
    node.fail(fmt::format("no such fluid; known: {}", fmt::join(names, ", ")));
  }
  if (!other->equalMassWith.empty())
    node.fail("that fluid takes its mass from another one itself; name that one");
  if (fluid.mass == "exact" || fluid.profile || !fluid.hasLattice())
    node.fail("goes with a lattice, one density and mass = \"cell\" only");
}

/// A file of positions stands for a lattice and all that a lattice has.
void checkPositions(const FluidSettings& fluid) {
  if (!fluid.positions) return;
  for (const char* key : {"lattice", "lattice_origin"})
    if (const CaseNode* node = fluid.node.find(key))
      node->fail("excludes positions; give one of them");
  if (fluid.spacingFollowsDensity())
    at(fluid.node, "positions")
        .fail(
            "excludes particles = \"equal_mass\", which chooses places by itself; set particles = "
            "\"equal_spacing\", or leave one of positions and profile out");
}

}  // namespace

const Section<FluidSettings>& fluidSection() {
  using S = FluidSettings;
  static const Section<S> section =
      Section<S>("a fluid that fills a region; where two fluids overlap, the first one stands")
          .text("name", &S::name, "for messages and results; absent: the region's name")
          .text("region", &S::region, "the region filled; absent: the whole periodic domain")
          .text("lattice", &S::lattice,
                "where particles stand; absent: uniform (1-D), hexagonal (2-D), hcp (3-D)",
                allLattices())
          .vector(
              "lattice_origin", &S::latticeOrigin, "m",
              "where a lattice point stands; absent: half a row spacing from the region's lower "
              "bounds")
          .section("positions", &S::positions, positionsSection())
          .integer("seed", &S::seed, Range::notNegative(), "of random positions and of jitter")
          .number("jitter", &S::jitter, "d_ref", Range::between(0, 0.5),
                  "noise: each coordinate is moved by up to this much")
          .number("density", &S::density, "kg/m^d", Range::positive(), "reference density rho_0")
          .number("sound_speed", &S::soundSpeed, "m/s", Range::positive(),
                  "c of this fluid; absent: solver.sound_speed")
          .number("tait_exponent", &S::taitExponent, "", Range::between(1, 20),
                  "gamma of this fluid; absent: solver.tait_exponent")
          .number("background_pressure", &S::backgroundPressure, "Pa m^(3-d)", Range::any(),
                  "p0 of this fluid; absent: solver.background_pressure")
          .number("dynamic_viscosity", &S::dynamicViscosity, "Pa s m^(3-d)", Range::positive(),
                  "mu of this fluid; absent: solver.viscosity.laminar.dynamic_viscosity")
          .number("cavitation_pressure", &S::cavitationPressure, "Pa m^(3-d)", Range::any(),
                  "below which the pressure of this fluid does not fall; absent: "
                  "solver.cavitation_pressure")
          .text("mass", &S::mass,
                "cell: density times the lattice's cell; exact: density times the region's exact "
                "volume over the number of particles; absent: cell, or exact with positions",
                {"cell", "exact"})
          .text(
              "equal_mass_with", &S::equalMassWith,
              "another fluid: this one's lattice becomes finer or coarser than d_ref, so that its "
              "particles have the mass of that one's")
          .vector("velocity", &S::velocity, "m/s", "initial velocity; absent: zero")
          .texts("velocity_formula", &S::velocityFormula,
                 "its components [m/s] by formulas of x, y, z [m], r and pi, instead, as "
                 "[\"sin(2*pi*y)\", \"0\"]")
          .number("pressure", &S::pressure, "Pa m^(3-d)", Range::any(),
                  "initial pressure; of a liquid density follows, absent: "
                  "solver.background_pressure; an ideal gas has this or one of the next four")
          .text("pressure_formula", &S::pressureFormula,
                "the initial pressure [Pa m^(3-d)] by a formula of x, y, z [m], r and pi, instead; "
                "of a liquid density follows")
          .number("internal_energy", &S::internalEnergy, "J/kg", Range::positive(),
                  "e of an ideal gas, specific, at first")
          .text("internal_energy_formula", &S::internalEnergyFormula,
                "e of an ideal gas [J/kg] by a formula of x, y, z [m], r and pi")
          .number("temperature", &S::temperature, "K", Range::positive(),
                  "of an ideal gas: e = k_B T/((gamma - 1) nu m_H)")
          .section("energy_deposit", &S::energyDeposit, energyDepositSection())
          .section("hydrostatic", &S::hydrostatic, hydrostaticSection())
          .section("profile", &S::profile, profileSection())
          .text(
              "particles", &S::particles,
              "of a profile or hydrostatic: equal_mass, so that their spacing follows the density, "
              "or equal_spacing, so that their mass does; absent: the first with a profile, the "
              "second with hydrostatic",
              {"equal_mass", "equal_spacing"});
  return section;
}

std::vector<FluidSettings> readFluids(const CaseSettings& settings) {
  const SolverSettings solver = settings.solverOrDefaults();
  std::vector<FluidSettings> fluids;
  for (const CaseNode& node : settings.fluids->asArray()) {
    FluidSettings fluid = fluidSection().read(node, settings.dimension);
    fluid.node = node;
    checkPositions(fluid);
    // A file's particles need not be d_ref apart: the cell of a lattice is not theirs.
    if (fluid.positions && node.find("mass") == nullptr) fluid.mass = "exact";
    if (fluid.lattice.empty()) fluid.lattice = latticeNames(settings.dimension).front();
    checkFluid(fluid, settings.dimension, solver);
    fluids.push_back(std::move(fluid));
  }
  if (fluids.empty()) settings.fluids->fail("is empty; a case needs at least one [[fluid]]");
  nameAll(fluids, "fluid");
  for (const FluidSettings& fluid : fluids) checkEqualMasses(fluid, fluids);
  return fluids;
}

}  // namespace plenum
