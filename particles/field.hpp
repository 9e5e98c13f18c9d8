// SPDX-License-Identifier: GPL-3.0-or-later
//
// The names of fields in the program: typed by their rank, and sets of them.
#pragma once

#include "particles/field_table.hpp"
#include "particles/vec.hpp"

#include <cstdint>
#include <initializer_list>

namespace plenum {

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
