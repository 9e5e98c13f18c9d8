// SPDX-License-Identifier: GPL-3.0-or-later
//
// The case file as plain structs. `plenum-ic` reads all of it, `plenum-sph` the part that concerns
// the run; geometry, fluids and walls are read by geometry/ and ictools/ from the nodes kept here.
#pragma once

#include "particles/case_node.hpp"
#include "particles/measure_settings.hpp"
#include "particles/section.hpp"
#include "particles/stream_settings.hpp"
#include "particles/validate_settings.hpp"

#include <optional>
#include <string>
#include <vector>

namespace plenum {

struct DomainSettings {
  std::vector<double> lower;              ///< [m]
  std::vector<double> upper;              ///< [m]
  std::vector<std::string> periodicAxes;  ///< of "x", "y", "z"
};

struct MonaghanSettings {
  double alpha = 0.1;
  double beta = 0;
  bool balsara = false;  ///< less where the flow shears rather than converges
};

/// The viscosity that Gingold and Monaghan's tensor is with [A]: Monaghan's with another softening.
struct TensorSettings {
  double alpha1 = 0.8;
  double alpha2 = 0;
  double beta = 0.1;  ///< of h^2, in mu
};

/// A viscous pressure q of what converges; see [A] (4.8), (4.9).
struct ViscousPressureSettings {
  double alpha = 0.8;
};

/// The physical viscosity of a Newtonian fluid, which sticks to walls.
struct LaminarSettings {
  double dynamicViscosity = 1e-3;  ///< mu [Pa s m^(3-d)], of fluids that name none of their own
};

struct ViscositySettings {
  std::optional<MonaghanSettings> monaghan = {};
  std::optional<LaminarSettings> laminar = {};
  std::optional<TensorSettings> tensor = {};
  std::optional<ViscousPressureSettings> bulk = {};
  std::optional<ViscousPressureSettings> neumannRichtmyer = {};
};

/// A smoothing length for each particle, that follows its density.
struct AdaptiveSettings {
  std::string form = "grad_h";
  double tolerance = 1e-4;                 ///< of densities, for grad_h
  int maxIterations = 50;                  ///< a step
  std::optional<double> changeLimit = {};  ///< of a step, for mean_density; absent: none
};

/// Artificial conduction of heat.
struct ConductivitySettings {
  double alpha = 1;
};

/// delta-SPH: diffusion of the density, in the continuity equation.
struct DensityDiffusionSettings {
  double delta = 0.1;
};

/// Moves particles towards an even arrangement after each step.
struct ShiftingSettings {
  double coefficient = 2;
  bool freeSurface = false;  ///< leaves particles at a free surface where they are
};

struct CollisionSettings {
  double restitution = 0.01;  ///< C_R
  double range = 0.85;        ///< delta_c, in d_ref
  std::string pairs = "all";
};

struct SolverSettings {
  std::string kernel = "wendland_c2";
  double smoothingLength = 1.5;  ///< h / d_ref
  std::string density = "summation";
  std::string momentum = "matching";
  std::string equationOfState = "tait";
  double soundSpeed = 10;                    ///< [m/s]
  double backgroundPressure = 0;             ///< p0 [Pa m^(3-d)]
  double taitExponent = 1;                   ///< gamma
  std::optional<double> cavitationPressure;  ///< the least [Pa m^(3-d)]; absent: none
  double adiabaticIndex = 5.0 / 3;           ///< gamma of an ideal gas
  double molecularWeight = 1;                ///< nu of an ideal gas: its particle's mass [m_H]
  std::optional<AdaptiveSettings> adaptive;  ///< absent: all have the same smoothing length
  bool selfTermCorrection = false;           ///< of summed densities
  std::optional<ViscositySettings> viscosity;
  std::optional<ConductivitySettings> conductivity;
  std::optional<CollisionSettings> collisions;
  std::optional<DensityDiffusionSettings> densityDiffusion;
  std::optional<ShiftingSettings> shifting;
  std::vector<double> gravity;  ///< [m/s^2]; empty: none
  std::vector<StreamSettings> inflows;
  std::vector<StreamSettings> outflows;
  std::string wallPressure = "zero";
  std::string integrator = "symplectic_euler";
  std::optional<double> timeStep;  ///< fixed [s]; absent: from cfl
  double cfl = 0.2;
  std::optional<double> speedLimit;  ///< [c]: a particle that is faster ends the run; absent: 5,
                                     ///< none in an ideal gas
  std::string precision = "mixed";   ///< of pairs; the state is in double
  double endTime = 1;                ///< [s]

  /// Fluid comes in or leaves during the run.
  bool hasStreams() const { return !inflows.empty() || !outflows.empty(); }
  /// Density and pressure of walls follow the fluid's equations.
  bool wallsEvolve() const { return wallPressure == "equation_of_state"; }
  /// They are those of the fluid in front of them.
  bool wallsExtrapolate() const { return wallPressure == "extrapolated"; }
  bool sumsDensity() const { return density == "summation"; }
  bool kicksTwice() const { return integrator == "kick_drift_kick"; }
  /// Particles have an internal energy, and pressure and speed of sound follow from it.
  bool isIdealGas() const { return equationOfState == "ideal_gas"; }
  const MonaghanSettings* monaghan() const {
    return viscosity && viscosity->monaghan ? &*viscosity->monaghan : nullptr;
  }
  const TensorSettings* tensor() const {
    return viscosity && viscosity->tensor ? &*viscosity->tensor : nullptr;
  }
  const ViscousPressureSettings* bulk() const {
    return viscosity && viscosity->bulk ? &*viscosity->bulk : nullptr;
  }
  const ViscousPressureSettings* neumannRichtmyer() const {
    return viscosity && viscosity->neumannRichtmyer ? &*viscosity->neumannRichtmyer : nullptr;
  }
  bool usesBalsara() const { return monaghan() != nullptr && monaghan()->balsara; }
  bool hasForm(const char* form) const { return adaptive && adaptive->form == form; }
  /// Smoothing lengths follow the density; else they are the same all the time.
  bool lengthsFollow() const { return adaptive && adaptive->form != "constant"; }
  /// Particles have a smoothing length each in the loops, be it the same.
  bool hasOwnLengths() const {
    return adaptive || isIdealGas() || usesBalsara() || bulk() != nullptr ||
           neumannRichtmyer() != nullptr;
  }
  const LaminarSettings* laminar() const {
    return viscosity && viscosity->laminar ? &*viscosity->laminar : nullptr;
  }
};

/// How pictures of a run look at it; absent: disks in 2-D, balls in 3-D.
struct LookSettings {
  std::string along = "none";  ///< 3-D: "x", "y" or "z", the axis to look along
  std::optional<double> at;    ///< 3-D: a cut there [m]; absent: whole columns
  bool smooth = false;         ///< 2-D and cuts: by the kernels instead of disks
};

struct OutputSettings {
  double every = 0.1;                  ///< of VTU files [s]
  std::optional<double> historyEvery;  ///< of rows of history.csv [s]; absent: `every`
  std::vector<std::string> fields;     ///< empty: all state fields
  std::string picture = "velocity";    ///< field that colours the pictures
  std::optional<LookSettings> look;
  std::optional<double> checkpointEvery;  ///< of checkpoints [s]
  double checkpointWallClock = 600;       ///< and in real time [s]
  int checkpointsKept = 2;
};

struct CaseSettings {
  std::string title;
  int dimension = 2;
  double spacing = 0;  ///< d_ref [m]
  std::optional<DomainSettings> domain;
  std::optional<CaseNode> geometry;
  std::optional<CaseNode> fluids;
  std::optional<CaseNode> walls;
  std::optional<CaseNode> refinements;
  std::optional<CaseNode> relax;
  std::optional<CaseNode> quick;
  std::string uniform = "none";  ///< axis along which a 3-D scene does not vary
  std::string container;  ///< name of the region in which fluid may be; "": where fluid starts
  std::optional<SolverSettings> solver;
  std::optional<OutputSettings> output;
  std::optional<MeasureSettings> measures;
  std::vector<ValidateSettings> validations;

  SolverSettings solverOrDefaults() const { return solver.value_or(SolverSettings{}); }
  OutputSettings outputOrDefaults() const { return output.value_or(OutputSettings{}); }
  MeasureSettings measuresOrDefaults() const { return measures.value_or(MeasureSettings{}); }
};

/// The declarations of the sections above, for reading, help and docs.
const Section<SolverSettings>& solverSection();
const Section<OutputSettings>& outputSection();
const Section<CaseSettings>& caseSection();

/// Sets what [quick] says, if that is asked for, then "key=value" pairs. Throws InputError.
void applyChanges(CaseNode& root, bool quick, const std::vector<std::string>& assignments);

/// Throws InputError for anything that is wrong in the parts that are read here.
CaseSettings readCase(const CaseNode& root);

}  // namespace plenum
