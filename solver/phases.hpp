// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fluids of a scene, with what [solver] says of all of them and what each says of itself.
#pragma once

#include "particles/case_settings.hpp"
#include "particles/scene.hpp"
#include "solver/equation_of_state.hpp"

#include <vector>

namespace plenum {

/// One fluid.
struct Phase {
  Tait state;
  double dynamicViscosity = 0;  ///< [Pa s m^(3-d)]; 0 if the run models none

  double kinematicViscosity() const { return dynamicViscosity / state.referenceDensity; }
};

/// The phases of a scene, in the order of its materials, and what they have in common.
class Phases {
 public:
  Phases(const std::vector<Material>& materials, const SolverSettings& settings);

  const Phase& operator[](std::size_t material) const { return phases_[material]; }
  std::size_t size() const { return phases_.size(); }

  /// Equations of state, a row a material.
  MaterialTable states() const;
  /// Of the walls: that of the phase which has the wall's density, else that of [solver].
  MaterialTable statesOf(const std::vector<Wall>& walls, const SolverSettings& settings) const;

  double largestSoundSpeed() const;          ///< [m/s]
  double largestKinematicViscosity() const;  ///< [m^2/s]
  bool differInSoundSpeed() const;
  bool differInViscosity() const;

 private:
  std::vector<Phase> phases_;
};

}  // namespace plenum
