// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/case_settings.hpp"

#include "particles/errors.hpp"
#include "particles/kernels.hpp"
#include "particles/solver_conflicts.hpp"

#include <fmt/format.h>

namespace plenum {

namespace {

Section<DomainSettings> domainSection() {
  Section<DomainSettings> section("the box around everything; needed for periodic axes only");
  section.vector("lower", &DomainSettings::lower, "m", "lower corner").required();
  section.vector("upper", &DomainSettings::upper, "m", "upper corner").required();
  section.texts("periodic", &DomainSettings::periodicAxes, "axes that repeat", {"x", "y", "z"});
  return section;
}

Section<ViscositySettings> viscositySection() {
  Section<MonaghanSettings> monaghan("Monaghan's artificial viscosity Pi_ij (Monaghan 1992)");
  monaghan.number("alpha", &MonaghanSettings::alpha, "", Range::notNegative(), "linear coefficient")
      .number("beta", &MonaghanSettings::beta, "", Range::notNegative(), "quadratic coefficient")
      .flag("balsara", &MonaghanSettings::balsara,
            "weaker where the flow shears rather than converges (Balsara 1995)");
  Section<TensorSettings> tensor(
      "Gingold and Monaghan's tensor: (-alpha_1 c mu + alpha_2 mu^2)/rho, mu = h v.r/(r^2 + beta "
      "h^2)");
  tensor.number("alpha_1", &TensorSettings::alpha1, "", Range::notNegative(), "linear coefficient")
      .number("alpha_2", &TensorSettings::alpha2, "", Range::notNegative(), "quadratic coefficient")
      .number("beta", &TensorSettings::beta, "", Range::positive(), "softening, of h^2");
  Section<ViscousPressureSettings> bulk(
      "bulk viscosity: q = -alpha rho h c div v where particles converge");
  bulk.number("alpha", &ViscousPressureSettings::alpha, "", Range::notNegative(), "its strength");
  Section<ViscousPressureSettings> neumannRichtmyer(
      "von Neumann and Richtmyer's: q = alpha rho h^2 (div v)^2 where particles converge");
  neumannRichtmyer.number("alpha", &ViscousPressureSettings::alpha, "", Range::notNegative(),
                          "its strength");
  Section<LaminarSettings> laminar(
      "viscosity of a Newtonian fluid that sticks to walls (Morris et al. 1997)");
  laminar.number("dynamic_viscosity", &LaminarSettings::dynamicViscosity, "Pa s m^(3-d)",
                 Range::positive(), "mu, of fluids that name none of their own");
  Section<ViscositySettings> section(
      "viscosity; absent: none. bulk and neumann_richtmyer together are their linear combination");
  section.section("monaghan", &ViscositySettings::monaghan, monaghan)
      .section("tensor", &ViscositySettings::tensor, tensor)
      .section("bulk", &ViscositySettings::bulk, bulk)
      .section("neumann_richtmyer", &ViscositySettings::neumannRichtmyer, neumannRichtmyer)
      .section("laminar", &ViscositySettings::laminar, laminar);
  return section;
}

Section<AdaptiveSettings> adaptiveSection() {
  using S = AdaptiveSettings;
  Section<S> section(
      "a smoothing length for each particle, h = smoothing_length (m/rho)^(1/d); absent: one for "
      "all, smoothing_length times d_ref");
  section
      .text("form", &S::form,
            "grad_h: h and the particle's own density fit each other, and forces have the terms of "
            "grad h (Springel & Hernquist 2002, Price 2012); mean_density: h from the mean density "
            "around it, and forces with the mean kernel; constant: smoothing_length times d_ref, "
            "even where particles stand closer, to see what adaptive ones are good for",
            {"grad_h", "mean_density", "constant"})
      .number("tolerance", &S::tolerance, "", Range::above(0, 0.1),
              "of grad_h: by how much a density may miss its smoothing length")
      .integer("max_iterations", &S::maxIterations, Range::between(1, 1000),
               "of grad_h: how often a step may try")
      .number("change_limit", &S::changeLimit, "", Range::above(0, 1),
              "of mean_density: the part of itself by which h may change in a step; absent: none");
  return section;
}

Section<ConductivitySettings> conductivitySection() {
  Section<ConductivitySettings> section(
      "artificial conduction of heat, which smooths contacts (Price 2008); absent: none");
  section.number("alpha", &ConductivitySettings::alpha, "", Range::notNegative(), "its strength");
  return section;
}

Section<DensityDiffusionSettings> densityDiffusionSection() {
  Section<DensityDiffusionSettings> section(
      "diffusion of density between particles that have one of their own (delta-SPH, Marrone et "
      "al. 2011); absent: "
      "none");
  section.number("delta", &DensityDiffusionSettings::delta, "", Range::above(0, 1), "its strength");
  return section;
}

Section<ShiftingSettings> shiftingSection() {
  using S = ShiftingSettings;
  Section<S> section(
      "particles move to where fewer are after each step (Lind et al. 2012); absent: they do not");
  section
      .number("coefficient", &S::coefficient, "", Range::above(0, 20),
              "A: the way is A h |v| dt times the gradient of the concentration")
      .flag("free_surface", &S::freeSurface, "particles at a free surface stay where they are");
  return section;
}

Section<CollisionSettings> collisionSection() {
  Section<CollisionSettings> section(
      "collisions of approaching particles, Kruisbrink et al. 2018 (4.20); absent: none");
  section
      .number("restitution", &CollisionSettings::restitution, "", Range::between(0, 1),
              "C_R: 0 inelastic, 1 elastic")
      .number("range", &CollisionSettings::range, "d_ref", Range::above(0, 2),
              "delta_c: pairs closer than this collide; above 0.95 the order of the particles "
              "suffers")
      .text("pairs", &CollisionSettings::pairs, "which pairs collide", {"all", "fluid", "wall"});
  return section;
}

}  // namespace

const Section<SolverSettings>& solverSection() {
  using S = SolverSettings;
  static const Section<S> section =
      Section<S>("physics and numerics of the run")
          .text("kernel", &S::kernel, "smoothing kernel", KernelId::names())
          .number("smoothing_length", &S::smoothingLength, "d_ref", Range::between(0.6, 6),
                  "smoothing length h; the kernel's support is 2h. With adaptive in (m/rho)^(1/d)")
          .section("adaptive", &S::adaptive, adaptiveSection())
          .text("density", &S::density,
                "sum over neighbours (2.2), or integrated by continuity (5.23) for free surfaces",
                {"summation", "continuity"})
          .text("momentum", &S::momentum,
                "p/rho^2 form (2.3), (p+p)/(rho rho) form (5.24), or what matches the density",
                {"matching", "density_squared", "density_product"})
          .flag("self_term_correction", &S::selfTermCorrection,
                "takes from summed densities what they have too much (Dehnen & Aly 2012): in 3-D, "
                "of wendland_c2, c4 and c6")
          .text("equation_of_state", &S::equationOfState,
                "Tait's of a liquid (2.4); p = c^2 rho; or p = (gamma - 1) rho e with an equation "
                "for the specific internal energy e",
                {"tait", "isothermal", "ideal_gas"})
          .number("sound_speed", &S::soundSpeed, "m/s", Range::positive(),
                  "c of the Tait equation of state (2.4) and of an isothermal gas")
          .number("background_pressure", &S::backgroundPressure, "Pa m^(3-d)", Range::any(),
                  "p0 of the equation of state")
          .number("tait_exponent", &S::taitExponent, "", Range::between(1, 20),
                  "gamma of the equation of state")
          .number(
              "cavitation_pressure", &S::cavitationPressure, "Pa m^(3-d)", Range::any(),
              "pressures of liquids, and of walls that follow their equations, fall no lower: with "
              "0 water pulls neither at itself nor at walls; absent: no limit")
          .number("adiabatic_index", &S::adiabaticIndex, "", Range::above(1, 10),
                  "gamma of an ideal gas")
          .number("molecular_weight", &S::molecularWeight, "m_H", Range::positive(),
                  "nu, mean mass of the particles of an ideal gas: p = rho k_B T/(nu m_H)")
          .section("viscosity", &S::viscosity, viscositySection())
          .section("conductivity", &S::conductivity, conductivitySection())
          .section("collisions", &S::collisions, collisionSection())
          .section("density_diffusion", &S::densityDiffusion, densityDiffusionSection())
          .section("shifting", &S::shifting, shiftingSection())
          .vector("gravity", &S::gravity, "m/s^2", "acceleration of gravity; absent: none")
          .sections("inflow", &S::inflows, inflowSection())
          .sections("outflow", &S::outflows, outflowSection())
          .text(
              "wall_pressure", &S::wallPressure,
              "walls keep p = 0 and their density; keep the pressure that they start with; follow "
              "the fluid's equations; or take the pressure of the fluid before them (Adami et "
              "al. 2012)",
              {"zero", "initial", "equation_of_state", "extrapolated"})
          .text("integrator", &S::integrator,
                "symplectic Euler as in the sources, or kick-drift-kick, of second order",
                {"symplectic_euler", "kick_drift_kick"})
          .number("time_step", &S::timeStep, "s", Range::positive(),
                  "fixed time step; absent: from cfl")
          .number("cfl", &S::cfl, "", Range::above(0, 2),
                  "time step = cfl min(h/(c + |v|), sqrt(h/|a|)), at most h^2/(8 nu); in gases "
                  "docs/gas.md")
          .number("speed_limit", &S::speedLimit, "c", Range::positive(),
                  "the run stops when a particle is faster; absent: 5, and none for an ideal gas")
          .text("precision", &S::precision,
                "numbers in which pairs are computed: float with the state in double (mixed), or "
                "double",
                {"mixed", "double"})
          .number("end_time", &S::endTime, "s", Range::notNegative(), "when the run ends")
          .condition(checkSolverTable);
  return section;
}

namespace {

Section<LookSettings> lookSection() {
  using S = LookSettings;
  return Section<S>("how pictures look at the particles; absent: disks in 2-D, balls in 3-D")
      .text("along", &S::along,
            "3-D: axis to look along; density becomes column density, other fields their mean",
            {"none", "x", "y", "z"})
      .number("at", &S::at, "m", Range::any(), "3-D: a cut at this place on the axis instead")
      .flag("smooth", &S::smooth, "2-D and cuts: smoothed by the kernels instead of disks")
      .condition([](const S& look, const CaseNode& table, int dimension) {
        if (dimension != 3 && (look.along != "none" || look.at))
          table.fail(fmt::format("along and at are for 3-D cases, this one is {}-D", dimension));
        if (look.at && look.along == "none")
          table.fail("at needs an axis: along = \"x\", \"y\" or \"z\"");
        if (look.smooth && (dimension == 1 || (dimension == 3 && look.along == "none")))
          table.fail("smooth is for 2-D cases and for columns and cuts of 3-D ones; set along");
      });
}

}  // namespace

const Section<OutputSettings>& outputSection() {
  using S = OutputSettings;
  static const Section<S> section =
      Section<S>("what the run writes")
          .number("every", &S::every, "s", Range::positive(), "time between VTU files")
          .number("history_every", &S::historyEvery, "s", Range::positive(),
                  "time between rows of history.csv; absent: as the VTU files")
          .texts("fields", &S::fields, "fields in the VTU files; absent: all that are modelled")
          .text("picture", &S::picture, "field that colours the pictures")
          .section("look", &S::look, lookSection())
          .number("checkpoint_every", &S::checkpointEvery, "s", Range::positive(),
                  "time between checkpoints, which `plenum-sph resume` goes on from; absent: by "
                  "checkpoint_wall_clock only")
          .number("checkpoint_wall_clock", &S::checkpointWallClock, "s", Range::positive(),
                  "real time between checkpoints")
          .integer("checkpoints_kept", &S::checkpointsKept, Range::between(1, 1000),
                   "how many of the last checkpoints are kept");
  return section;
}

const Section<CaseSettings>& caseSection() {
  using S = CaseSettings;
  static const Section<S> section =
      Section<S>("a case file")
          .text("title", &S::title, "one line that says what the scene is")
          .integer("dimension", &S::dimension, Range::between(1, 3), "1, 2 or 3")
          .number("spacing", &S::spacing, "m", Range::positive(),
                  "d_ref: nearest-neighbour distance on hexagonal, hcp, fcc and bcc lattices, edge "
                  "on square and cubic ones")
          .required()
          .section("domain", &S::domain, domainSection())
          .node("geometry", &S::geometry, "table", "named regions")
          .node("fluid", &S::fluids, "list of tables", "fluids, each filling a region")
          .required()
          .node("wall", &S::walls, "list of tables", "walls, each behind a surface")
          .node("refine", &S::refinements, "list of tables",
                "places of finer spacing, of all fluids; where several reach, the finest counts")
          .node("relax", &S::relax, "table", "arranges the particles until they stand evenly")
          .node("quick", &S::quick, "table",
                "values of other keys (\"solver.end_time\" = 0.1) for a look that takes seconds: "
                "`plenum-ic generate --quick`, `./run --quick`")
          .text("uniform", &S::uniform,
                "3-D: an axis along which the scene does not vary; `plenum-study minimal` tries it "
                "without",
                {"none", "x", "y", "z"})
          .text("container", &S::container,
                "region in which fluid may be, for the measures; absent: where it starts")
          .section("solver", &S::solver, solverSection())
          .section("output", &S::output, outputSection())
          .section("measures", &S::measures, measureSection())
          .sections("validate", &S::validations, validateSection());
  return section;
}

namespace {

/// Values of a table by their whole keys: "solver.end_time".
void collect(const CaseNode& table, const std::string& prefix,
             std::vector<std::pair<std::string, const CaseNode*>>& values) {
  for (const auto& [key, node] : table.asTable()) {
    if (node.isTable())
      collect(node, prefix + key + ".", values);
    else
      values.emplace_back(prefix + key, &node);
  }
}

}  // namespace

void applyChanges(CaseNode& root, bool quick, const std::vector<std::string>& assignments) {
  if (quick) {
    const CaseNode* table = root.find("quick");
    if (table == nullptr)
      throw InputError(root.fileName() + ": has no table [quick] that says what to reduce");
    const CaseNode copy = *table;
    std::vector<std::pair<std::string, const CaseNode*>> values;
    collect(copy, "", values);
    for (const auto& [key, node] : values) root.set(key, node->printed());
  }
  for (const std::string& assignment : assignments) {
    const auto [key, value] = CaseNode::splitAssignment(assignment);
    root.set(key, value);
  }
}

CaseSettings readCase(const CaseNode& root) {
  int dimension = 2;
  if (const CaseNode* node = root.find("dimension")) {
    dimension = static_cast<int>(node->asInteger());
    section_detail::checkNumber(*node, dimension, Range::between(1, 3), "");
  }
  CaseSettings settings = caseSection().read(root, dimension);
  if (settings.domain)
    for (int a = 0; a < dimension; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      if (settings.domain->upper[axis] <= settings.domain->lower[axis])
        root.find("domain")->fail("upper must be above lower on every axis");
    }
  return settings;
}

}  // namespace plenum
