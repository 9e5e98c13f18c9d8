// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_settings.hpp"
#include "particles/kernels.hpp"
#include "particles/scene.hpp"

#include <optional>
#include <string>

namespace plenum {

/// What a measure sees of a run at one time. With symplectic Euler, density and pressure are those
/// that moved the particles to where they are: of the positions one step before.
template <int Dim>
struct Observed {
  const ParticleSet<Dim>& particles;
  const SceneInfo<Dim>& info;
  const SolverSettings& settings;
  KernelId kernel;
  double smoothingLength = 0;  ///< h [m]
  Vec<Dim> gravity{};          ///< [m/s^2]
};

/// The axis along which gravity acts and the direction of "up" on it.
struct Vertical {
  int axis = 0;
  double up = 1;  ///< +1 or -1
};

/// Throws InputError that names `key` if there is no gravity or it acts along no single axis.
template <int Dim>
Vertical verticalOf(const Vec<Dim>& gravity, const std::string& key);

/// The smallest box that holds all particles at the start, walls included, the container and
/// whole periods: a measure further outside can never see fluid of the scene as it is meant.
template <int Dim>
Box<Dim> reachOf(const Observed<Dim>& start);

/// Fluid particles that a measure counts: those of one material or all.
class FluidChoice {
 public:
  /// `name` "" stands for all. Throws InputError that names `key` and the nearest material.
  template <int Dim>
  FluidChoice(const std::string& name, const SceneInfo<Dim>& info, const std::string& key);

  template <int Dim>
  bool has(const ParticleSet<Dim>& particles, std::size_t i) const {
    return !material_ || particles[field::material][i] == *material_;
  }

  /// Of the only material where all count.
  std::size_t row() const { return material_ ? static_cast<std::size_t>(*material_) : 0; }

 private:
  std::optional<std::int32_t> material_;  // absent: all, or there is only one
};

}  // namespace plenum
