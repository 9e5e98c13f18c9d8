// SPDX-License-Identifier: GPL-3.0-or-later
//
// The [[fluid]] and [[wall]] tables of the case file.
#pragma once

#include "ictools/motion_settings.hpp"
#include "particles/case_settings.hpp"

#include <optional>
#include <string>
#include <vector>

namespace plenum {

struct HydrostaticSettings {
  double surface = 0;                       ///< height against gravity [m]
  std::optional<double> pressureAtSurface;  ///< [Pa m^(3-d)]; absent: background pressure
};

struct LinearProfileKeys {
  std::vector<double> from, to;  ///< [m]
  std::vector<double> density;   ///< at these two [kg/m^d]
};

/// density (1 + r^2/core_radius^2)^exponent.
struct PowerLawKeys {
  std::vector<double> center;  ///< [m]
  double density = 1;          ///< at the centre [kg/m^d]
  double coreRadius = 1;       ///< [m]
  double exponent = -1;
};

struct RadialTableKeys {
  std::string file;
  std::vector<double> center;
};

struct ImageProfileKeys {
  std::string file;
  std::vector<double> lower, upper;  ///< its corners [m]
  std::vector<double> density;       ///< of black and of white [kg/m^d]
};

/// A density that depends on the place; exactly one of them.
struct ProfileKeys {
  std::optional<LinearProfileKeys> linear;
  std::optional<PowerLawKeys> powerLaw;
  std::optional<RadialTableKeys> radialTable;
  std::optional<ImageProfileKeys> image;
  std::string formula;
  std::string table;
};

/// Places of particles that a file holds: scaled about the origin, then moved.
struct PositionsKeys {
  std::string file;
  double scale = 1;
  std::vector<double> translate;  ///< [m]; empty: none
};

/// Energy put into an ideal gas around a point.
struct EnergyDepositSettings {
  std::vector<double> point;  ///< [m]
  double energy = 1;          ///< [J]
  double radius = 1;          ///< of the kernel's support [m]
};

struct FluidSettings {
  std::string name;
  std::string region;   ///< "": the whole periodic domain
  std::string lattice;  ///< "": the first of latticeNames()
  std::vector<double> latticeOrigin;
  std::optional<PositionsKeys> positions;  ///< instead of a lattice
  int seed = 1;
  double jitter = 0;  ///< [d_ref]
  double density = 1;
  std::optional<double> soundSpeed;  ///< [m/s]; this and the next four: absent: as [solver]
  std::optional<double> taitExponent;
  std::optional<double> backgroundPressure;  ///< [Pa m^(3-d)]
  std::optional<double> dynamicViscosity;    ///< [Pa s m^(3-d)]
  std::optional<double> cavitationPressure;  ///< [Pa m^(3-d)]
  std::string mass = "cell";
  std::string equalMassWith;  ///< the fluid whose particles have the same mass; "": spacing d_ref
  std::vector<double> velocity;
  std::vector<std::string> velocityFormula;  ///< of the place, a component each; empty: `velocity`
  std::optional<double> pressure;
  std::string pressureFormula;           ///< of the place; "": none
  std::optional<double> internalEnergy;  ///< specific, of an ideal gas [J/kg]
  std::string internalEnergyFormula;     ///< of the place; "": none
  std::optional<double> temperature;     ///< of an ideal gas [K]
  std::optional<EnergyDepositSettings> energyDeposit;
  std::optional<HydrostaticSettings> hydrostatic;
  std::optional<ProfileKeys> profile;
  std::string particles;  ///< "equal_mass", "equal_spacing"; "": the first of a profile
  CaseNode node;          ///< where it stands, for messages

  /// [solver] with this fluid's own equation of state.
  SolverSettings ownSolver(SolverSettings solver) const {
    solver.soundSpeed = soundSpeed.value_or(solver.soundSpeed);
    solver.taitExponent = taitExponent.value_or(solver.taitExponent);
    solver.backgroundPressure = backgroundPressure.value_or(solver.backgroundPressure);
    return solver;
  }

  /// Particles stand where a lattice has points, at first.
  bool hasLattice() const { return lattice != "random" && !positions; }

  /// Particles of one mass, whose spacing follows a profile or the hydrostatic density.
  bool spacingFollowsDensity() const {
    return profile ? particles != "equal_spacing" : hydrostatic && particles == "equal_mass";
  }
};

/// A place where particles stand closer (resolution.hpp).
struct RefineSettings {
  std::string near;      ///< the region whose surface it is; or else:
  std::string inside;    ///< the region
  double spacing = 0.5;  ///< there [d_ref]
  double distance = 0;   ///< of `near`: from the surface, on both sides [m]
  double growth = 0.1;   ///< of the spacing with the distance from the place
  CaseNode node;

  /// The key that names the geometry.
  const char* regionKey() const { return near.empty() ? "inside" : "near"; }
};

/// How particles are arranged before a run (relaxation.hpp).
struct RelaxSettings {
  std::string method = "packing";
  std::optional<double> tolerance;  ///< of the scatter of the kernel sum; absent: what it can reach
  int maxIterations = 1000;
  bool mayFail = false;  ///< not to reach the tolerance is a warning only
};

struct WallSettings {
  std::string name;
  std::string region;
  std::string outside;
  std::optional<int> layers;
  std::string method = "lattice";
  std::string latticeOf;
  std::optional<double> density;
  std::vector<double> velocity;
  std::optional<RotationSettings> rotation;
  std::optional<OscillationSettings> oscillation;
  std::optional<RockingSettings> rocking;
  std::optional<TableMotionSettings> motion;
  std::optional<double> pressure;
  std::optional<double> internalEnergy;  ///< specific, of an ideal gas [J/kg]
  std::optional<HydrostaticSettings> hydrostatic;
  CaseNode node;

  /// The key that names the geometry.
  const char* regionKey() const { return outside.empty() ? "region" : "outside"; }
};

const Section<HydrostaticSettings>& hydrostaticSection();
const Section<FluidSettings>& fluidSection();
const Section<WallSettings>& wallSection();

const Section<RefineSettings>& refineSection();
/// Throws InputError unless each names one place and goes with the fluids.
std::vector<RefineSettings> readRefinements(const CaseSettings& settings);

const Section<RelaxSettings>& relaxSection();
/// Nothing if the case has no [relax] table.
std::optional<RelaxSettings> readRelax(const CaseSettings& settings);

/// Names that are missing are filled in; names that occur twice, keys that exclude each other and
/// lattices of another dimension are InputErrors.
std::vector<FluidSettings> readFluids(const CaseSettings& settings);
std::vector<WallSettings> readWalls(const CaseSettings& settings);

/// The node of `key`, or the table itself if it is absent (a default is at fault).
const CaseNode& at(const CaseNode& table, const std::string& key);

/// All declarations of a case file, for `help-case` and the docs.
std::vector<SectionDoc> caseDocs();

}  // namespace plenum
