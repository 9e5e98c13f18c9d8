// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"
#include "ictools/ic_settings.hpp"
#include "ictools/state.hpp"

#include <filesystem>
#include <memory>
#include <span>

namespace plenum {

/// A density that depends on the place. May be asked from several threads.
template <int Dim>
class DensityProfile {
 public:
  virtual ~DensityProfile() = default;

  /// density[k] [kg/m^d] at points[k] [m]; may be NaN where the profile does not reach.
  virtual void at(std::span<const Vec<Dim>> points, std::span<double> density) const = 0;

  double at(const Vec<Dim>& point) const {
    double density = 0;
    at(std::span(&point, 1), std::span(&density, 1));
    return density;
  }
};

template <int Dim>
using DensityProfilePtr = std::shared_ptr<const DensityProfile<Dim>>;

/// What a case's `profile` says. Files are relative to `folder`. Throws InputError for missing or
/// bad files and formulas.
template <int Dim>
DensityProfilePtr<Dim> makeProfile(const ProfileKeys& keys, const CaseNode& node,
                                   const std::filesystem::path& folder);

/// The density of `state`: that of its pressure by the equation of state.
template <int Dim>
DensityProfilePtr<Dim> profileOf(const InitialState& state);

/// Densities at all points, from all threads. Throws InputError of `node`, with the place, where
/// one is not positive and finite.
template <int Dim>
std::vector<double> densitiesAt(const DensityProfile<Dim>& profile,
                                std::span<const Vec<Dim>> points, const CaseNode& node);

}  // namespace plenum
