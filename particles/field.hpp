// SPDX-License-Identifier: GPL-3.0-or-later
//
// The field table: every quantity a particle may carry, with its unit and rank. It alone drives
// allocation, sorting, particle files and VTU output. A new field is a FieldId, a row and a name
// here; a field that pair terms use has a member in engine/pair.hpp, too.
#pragma once

#include "particles/vec.hpp"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

namespace plenum {

enum class Rank : std::uint8_t {
  scalar,  ///< double
  vector,  ///< Vec<Dim>
  label,   ///< std::int32_t
  id       ///< std::uint64_t
};

/// Which particles carry a field: its array has that many entries.
enum class Scope : std::uint8_t { all, fluid, walls };

enum class FieldId : std::uint8_t {
  position,
  velocity,
  mass,
  density,
  pressure,
  smoothingLength,
  internalEnergy,
  id,
  material,
  wall,
  normal,
  wallDistance,
  referencePosition,
  referenceNormal,
  acceleration,
  internalEnergyRate,
  velocityDivergence,
  // constants of a particle's material, where these differ
  dynamicViscosity,
  soundSpeed,
  // computed from others as pairs are loaded, never stored
  volume,
  specificVolume,
  pressureOverDensitySquared,
  // of a gas, anew in each step
  omegaDensity,
  viscousPressure,
  viscosityLimiter,
  // sums of a step
  densityRate,
  densityMoment,
  velocityCurl,
  power,
  force,
  impulse,
  massMoment,
  slipVelocity,
  densityGradient,
  momentDiagonal,
  momentMixed,
  positionDivergence,
  // sums that judge a particle set or arrange it
  kernelSum,
  kernelGradient,
  push,
  clearance,
  count
};

inline constexpr std::size_t nFields = static_cast<std::size_t>(FieldId::count);
static_assert(nFields <= 64, "FieldSet keeps one bit a field in 64 bits");

/// Powers of the units of mass, length (with one part a dimension) and time in a unit.
struct UnitPowers {
  int mass = 0, length = 0, lengthPerDimension = 0, time = 0;
};

struct FieldInfo {
  FieldId id;
  std::string_view name;      ///< in messages, VTU files and `--help`
  std::string_view fileName;  ///< dataset name in /PartType0 (GADGET's where it has one)
  std::string_view unit;      ///< SI; d is the dimension
  Rank rank;
  Scope scope;
  bool isState;  ///< written to files; all others live for a step at most
  std::string_view description;
  UnitPowers powers = {};
};

inline constexpr std::array<FieldInfo, nFields> fieldTable{{
    {FieldId::position,
     "position",
     "Coordinates",
     "m",
     Rank::vector,
     Scope::all,
     true,
     "particle position",
     {0, 1, 0, 0}},
    {FieldId::velocity,
     "velocity",
     "Velocities",
     "m/s",
     Rank::vector,
     Scope::all,
     true,
     "particle velocity",
     {0, 1, 0, -1}},
    {FieldId::mass,
     "mass",
     "Masses",
     "kg",
     Rank::scalar,
     Scope::all,
     true,
     "particle mass",
     {1, 0, 0, 0}},
    {FieldId::density,
     "density",
     "Density",
     "kg/m^d",
     Rank::scalar,
     Scope::all,
     true,
     "mass density",
     {1, 0, -1, 0}},
    {FieldId::pressure,
     "pressure",
     "Pressure",
     "Pa m^(3-d)",
     Rank::scalar,
     Scope::all,
     true,
     "pressure",
     {1, 2, -1, -2}},
    {FieldId::smoothingLength,
     "smoothing_length",
     "SmoothingLength",
     "m",
     Rank::scalar,
     Scope::all,
     true,
     "smoothing length h; the kernel's support is 2h",
     {0, 1, 0, 0}},
    {FieldId::internalEnergy,
     "internal_energy",
     "InternalEnergy",
     "J/kg",
     Rank::scalar,
     Scope::all,
     true,
     "specific internal energy",
     {0, 2, 0, -2}},
    {FieldId::id, "id", "ParticleIDs", "", Rank::id, Scope::all, true,
     "unique number; walls come first"},
    {FieldId::material, "material", "MaterialIDs", "", Rank::label, Scope::fluid, true,
     "row of the fluid in /Plenum/Materials; -1 in walls' rows of files"},
    {FieldId::wall, "wall", "WallIDs", "", Rank::label, Scope::walls, true,
     "row of the wall in /Plenum/Walls; -1 in fluids' rows of files"},
    {FieldId::normal, "normal", "Normals", "", Rank::vector, Scope::walls, true,
     "unit normal of the nearest wall surface, into the fluid; zero in fluids"},
    {FieldId::wallDistance,
     "wall_distance",
     "WallDistances",
     "m",
     Rank::scalar,
     Scope::walls,
     true,
     "depth of a wall particle behind its surface; zero in fluids",
     {0, 1, 0, 0}},
    {FieldId::referencePosition,
     "reference_position",
     "ReferencePositions",
     "m",
     Rank::vector,
     Scope::walls,
     true,
     "where a particle of a moving wall stood when the run began; zero in fluids",
     {0, 1, 0, 0}},
    {FieldId::referenceNormal, "reference_normal", "ReferenceNormals", "", Rank::vector,
     Scope::walls, true, "the normal that a particle of a moving wall had when the run began"},
    {FieldId::acceleration,
     "acceleration",
     "Accelerations",
     "m/s^2",
     Rank::vector,
     Scope::fluid,
     true,
     "acceleration at the end of the last step",
     {0, 1, 0, -2}},
    {FieldId::internalEnergyRate,
     "internal_energy_rate",
     "InternalEnergyRates",
     "W/kg",
     Rank::scalar,
     Scope::fluid,
     true,
     "rate of the specific internal energy at the end of the last step",
     {0, 2, 0, -3}},
    {FieldId::velocityDivergence,
     "velocity_divergence",
     "VelocityDivergences",
     "1/s",
     Rank::scalar,
     Scope::all,
     true,
     "divergence of the velocity",
     {0, 0, 0, -1}},
    {FieldId::dynamicViscosity,
     "dynamic_viscosity",
     "DynamicViscosities",
     "Pa s m^(3-d)",
     Rank::scalar,
     Scope::all,
     false,
     "dynamic viscosity of the particle's fluid",
     {1, 2, -1, -1}},
    {FieldId::soundSpeed,
     "sound_speed",
     "SoundSpeeds",
     "m/s",
     Rank::scalar,
     Scope::all,
     false,
     "speed of sound",
     {0, 1, 0, -1}},
    {FieldId::volume,
     "volume",
     "Volumes",
     "m^d",
     Rank::scalar,
     Scope::all,
     false,
     "mass over density",
     {0, 0, 1, 0}},
    {FieldId::specificVolume,
     "specific_volume",
     "SpecificVolumes",
     "m^d/kg",
     Rank::scalar,
     Scope::all,
     false,
     "1/density",
     {-1, 0, 1, 0}},
    {FieldId::pressureOverDensitySquared,
     "pressure_over_density_squared",
     "PressuresOverDensitySquared",
     "m^(d+2)/(kg s^2)",
     Rank::scalar,
     Scope::all,
     false,
     "pressure over density squared; in a gas (p + q)/(Omega rho^2)",
     {-1, 2, 1, -2}},
    {FieldId::omegaDensity,
     "omega_density",
     "OmegaDensities",
     "kg/m^d",
     Rank::scalar,
     Scope::all,
     false,
     "density times Omega, the correction for smoothing lengths that vary",
     {1, 0, -1, 0}},
    {FieldId::viscousPressure,
     "viscous_pressure",
     "ViscousPressures",
     "Pa m^(3-d)",
     Rank::scalar,
     Scope::all,
     false,
     "pressure that opposes convergence",
     {1, 2, -1, -2}},
    {FieldId::viscosityLimiter, "viscosity_limiter", "ViscosityLimiters", "", Rank::scalar,
     Scope::all, false, "share of the artificial viscosity that acts; small in shear"},
    {FieldId::densityRate,
     "density_rate",
     "DensityRates",
     "kg/(m^d s)",
     Rank::scalar,
     Scope::all,
     false,
     "sum of m v . grad W, Omega times the density's rate",
     {1, 0, -1, -1}},
    {FieldId::densityMoment,
     "density_moment",
     "DensityMoments",
     "kg^2/m^(2d)",
     Rank::scalar,
     Scope::all,
     false,
     "sum of m rho W",
     {2, 0, -2, 0}},
    {FieldId::velocityCurl,
     "velocity_curl",
     "VelocityCurls",
     "kg/(m^d s)",
     Rank::vector,
     Scope::all,
     false,
     "sum of m grad W x v, Omega times density times the curl of the velocity; in 2-D its z first",
     {1, 0, -1, -1}},
    {FieldId::power,
     "power",
     "Powers",
     "W",
     Rank::scalar,
     Scope::fluid,
     false,
     "change of the internal energy in time",
     {1, 2, 0, -3}},
    {FieldId::force,
     "force",
     "Forces",
     "N",
     Rank::vector,
     Scope::fluid,
     false,
     "force on the particle",
     {1, 1, 0, -2}},
    {FieldId::impulse,
     "impulse",
     "Impulses",
     "N s",
     Rank::vector,
     Scope::fluid,
     false,
     "change of momentum by collisions in this step",
     {1, 1, 0, -1}},
    {FieldId::massMoment,
     "mass_moment",
     "MassMoments",
     "kg/m^(d-1)",
     Rank::vector,
     Scope::walls,
     false,
     "sum of m W times the way from the neighbour",
     {1, 1, -1, 0}},
    {FieldId::slipVelocity,
     "slip_velocity",
     "SlipVelocities",
     "m/s",
     Rank::vector,
     Scope::walls,
     false,
     "velocity that the fluid sees behind a wall that it sticks to",
     {0, 1, 0, -1}},
    {FieldId::densityGradient,
     "density_gradient",
     "DensityGradients",
     "kg/m^(d+1)",
     Rank::vector,
     Scope::all,
     false,
     "gradient of the density",
     {1, -1, -1, 0}},
    {FieldId::momentDiagonal, "moment_diagonal", "MomentDiagonals", "", Rank::vector, Scope::all,
     false, "xx, yy, zz of minus the sum of V r grad W; 1 where particles stand evenly"},
    {FieldId::momentMixed, "moment_mixed", "MomentsMixed", "", Rank::vector, Scope::all, false,
     "yz, zx, xy of minus the sum of V r grad W (xy alone, first, in 2-D); 0 where particles stand "
     "evenly"},
    {FieldId::positionDivergence, "position_divergence", "PositionDivergences", "", Rank::scalar,
     Scope::all, false, "minus the sum of V r . grad W; d inside a fluid, less at its surface"},
    {FieldId::kernelSum, "kernel_sum", "KernelSums", "", Rank::scalar, Scope::all, false,
     "sum of V W over the neighbours; 1 where particles fill space evenly"},
    {FieldId::kernelGradient,
     "kernel_gradient",
     "KernelGradients",
     "1/m",
     Rank::vector,
     Scope::all,
     false,
     "sum of V grad W over the neighbours; 0 where particles stand evenly",
     {0, -1, 0, 0}},
    {FieldId::push, "push", "Pushes", "", Rank::vector, Scope::fluid, false,
     "sum of W h^d times the direction away from the neighbour"},
    {FieldId::clearance,
     "clearance",
     "Clearances",
     "m",
     Rank::scalar,
     Scope::fluid,
     false,
     "how far a particle that is being arranged may move before it could meet a surface",
     {0, 1, 0, 0}},
}};

constexpr const FieldInfo& infoOf(FieldId id) { return fieldTable[static_cast<std::size_t>(id)]; }

constexpr std::optional<FieldId> fieldNamed(std::string_view name) {
  for (const FieldInfo& info : fieldTable)
    if (info.name == name) return info.id;
  return std::nullopt;
}

/// A field whose rank is known to the compiler: `particles[field::density]` is a span of doubles.
template <Rank R>
struct Field {
  FieldId id;
  constexpr operator FieldId() const { return id; }
};

namespace field {
inline constexpr Field<Rank::vector> position{FieldId::position};
inline constexpr Field<Rank::vector> velocity{FieldId::velocity};
inline constexpr Field<Rank::scalar> mass{FieldId::mass};
inline constexpr Field<Rank::scalar> density{FieldId::density};
inline constexpr Field<Rank::scalar> pressure{FieldId::pressure};
inline constexpr Field<Rank::scalar> smoothingLength{FieldId::smoothingLength};
inline constexpr Field<Rank::scalar> internalEnergy{FieldId::internalEnergy};
inline constexpr Field<Rank::id> id{FieldId::id};
inline constexpr Field<Rank::label> material{FieldId::material};
inline constexpr Field<Rank::label> wall{FieldId::wall};
inline constexpr Field<Rank::vector> normal{FieldId::normal};
inline constexpr Field<Rank::scalar> wallDistance{FieldId::wallDistance};
inline constexpr Field<Rank::vector> referencePosition{FieldId::referencePosition};
inline constexpr Field<Rank::vector> referenceNormal{FieldId::referenceNormal};
inline constexpr Field<Rank::vector> acceleration{FieldId::acceleration};
inline constexpr Field<Rank::scalar> internalEnergyRate{FieldId::internalEnergyRate};
inline constexpr Field<Rank::scalar> velocityDivergence{FieldId::velocityDivergence};
inline constexpr Field<Rank::scalar> dynamicViscosity{FieldId::dynamicViscosity};
inline constexpr Field<Rank::scalar> soundSpeed{FieldId::soundSpeed};
inline constexpr Field<Rank::scalar> volume{FieldId::volume};
inline constexpr Field<Rank::scalar> specificVolume{FieldId::specificVolume};
inline constexpr Field<Rank::scalar> pressureOverDensitySquared{
    FieldId::pressureOverDensitySquared};
inline constexpr Field<Rank::scalar> omegaDensity{FieldId::omegaDensity};
inline constexpr Field<Rank::scalar> viscousPressure{FieldId::viscousPressure};
inline constexpr Field<Rank::scalar> viscosityLimiter{FieldId::viscosityLimiter};
inline constexpr Field<Rank::scalar> densityRate{FieldId::densityRate};
inline constexpr Field<Rank::scalar> densityMoment{FieldId::densityMoment};
inline constexpr Field<Rank::vector> velocityCurl{FieldId::velocityCurl};
inline constexpr Field<Rank::scalar> power{FieldId::power};
inline constexpr Field<Rank::vector> force{FieldId::force};
inline constexpr Field<Rank::vector> impulse{FieldId::impulse};
inline constexpr Field<Rank::vector> massMoment{FieldId::massMoment};
inline constexpr Field<Rank::vector> slipVelocity{FieldId::slipVelocity};
inline constexpr Field<Rank::vector> densityGradient{FieldId::densityGradient};
inline constexpr Field<Rank::vector> momentDiagonal{FieldId::momentDiagonal};
inline constexpr Field<Rank::vector> momentMixed{FieldId::momentMixed};
inline constexpr Field<Rank::scalar> positionDivergence{FieldId::positionDivergence};
inline constexpr Field<Rank::scalar> kernelSum{FieldId::kernelSum};
inline constexpr Field<Rank::vector> kernelGradient{FieldId::kernelGradient};
inline constexpr Field<Rank::vector> push{FieldId::push};
inline constexpr Field<Rank::scalar> clearance{FieldId::clearance};
}  // namespace field

/// A set of fields, usable at compile time.
class FieldSet {
 public:
  constexpr FieldSet() = default;
  constexpr FieldSet(std::initializer_list<FieldId> ids) {
    for (FieldId id : ids) bits_ |= bit(id);
  }
  constexpr bool has(FieldId id) const { return (bits_ & bit(id)) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr FieldSet operator|(FieldSet other) const { return fromBits(bits_ | other.bits_); }
  constexpr FieldSet& operator|=(FieldSet other) { return *this = *this | other; }
  constexpr FieldSet without(FieldSet other) const { return fromBits(bits_ & ~other.bits_); }
  constexpr bool operator==(const FieldSet&) const = default;

 private:
  static constexpr std::uint64_t bit(FieldId id) {
    return std::uint64_t{1} << static_cast<unsigned>(id);
  }
  static constexpr FieldSet fromBits(std::uint64_t bits) {
    FieldSet set;
    set.bits_ = bits;
    return set;
  }
  std::uint64_t bits_ = 0;
};

namespace detail {
template <Rank R, int Dim>
struct ValueOf;
template <int Dim>
struct ValueOf<Rank::scalar, Dim> {
  using type = double;
};
template <int Dim>
struct ValueOf<Rank::vector, Dim> {
  using type = Vec<Dim>;
};
template <int Dim>
struct ValueOf<Rank::label, Dim> {
  using type = std::int32_t;
};
template <int Dim>
struct ValueOf<Rank::id, Dim> {
  using type = std::uint64_t;
};
}  // namespace detail

/// The C++ type of one particle's value of a field of rank R.
template <Rank R, int Dim>
using ValueOf = typename detail::ValueOf<R, Dim>::type;

}  // namespace plenum
