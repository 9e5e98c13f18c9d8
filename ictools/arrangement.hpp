// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/containment.hpp"
#include "ictools/neighbour_sums.hpp"
#include "ictools/relaxation.hpp"
#include "ictools/surroundings.hpp"

#include <cmath>
#include <memory>

namespace plenum {

/// Edge of a cube of that volume [m].
template <int Dim>
double spacingOf(double volume) {
  return Dim == 1 ? volume : Dim == 2 ? std::sqrt(volume) : std::cbrt(volume);
}

/// Fluid particles that are being moved among fixed ones, and the sums over their neighbours.
/// field::mass holds the volumes that particles are meant to have [m^d] (their density is 1),
/// field::material their fluid, field::velocity their moves [m an iteration], field::pressure the
/// kernel sum over its mean.
template <int Dim>
class Arrangement {
 public:
  /// `adaptive`: smoothing lengths follow the volumes; else all have that of the frame.
  /// `fluids` must outlive this.
  Arrangement(const std::vector<FluidFill<Dim>>& fluids, const std::vector<WallFill<Dim>>& walls,
              const SceneFrame<Dim>& frame, bool adaptive);

  ParticleSet<Dim>& particles() { return particles_; }
  const Box<Dim>& domain() const { return domain_; }
  std::size_t nFluid() const { return particles_.nFluid(); }
  double smoothingLength(std::size_t i) const {
    return smoothing_.adaptive ? particles_[field::smoothingLength][i] : smoothing_.length;
  }

  /// Gives particles whose spacing follows a density the volumes that belong to their places. To be
  /// called when they have moved.
  void retarget();

  /// Sums V_j W_ij, fills field::pressure, returns mean, scatter and largest deviation.
  RelaxationState sumKernels();

  /// Calls body(i, sum) for all fluid particles, from all threads; the sum of `NeighbourSum`
  /// pressure is field::force, of voronoi field::push.
  template <Rank R, class Body>
  void forEachSum(NeighbourSum sum, Field<R> field, Body&& body) {
    engine_->run(passOf(sum), particles_);
    engine_->withSums(field, [&](const auto& sums) {
      forEachIndex(sums.nClusters(false), [&](std::size_t c) { sums.forEach(c, body); });
    });
  }

  /// Moves every fluid particle by its field::velocity, kept within its fluid, and puts there how
  /// far it really went. Returns the root mean square of moves, in spacings.
  double move();

  /// Positions of the fluid particles, in the order in which they came.
  std::vector<Vec<Dim>> positions() const;

 private:
  void addFluids();
  void setSmoothingLengths();
  const PairPass<Dim>& passOf(NeighbourSum sum);
  void keepAll(std::span<const Vec<Dim>> before);

  const std::vector<FluidFill<Dim>>& fluids_;
  Box<Dim> domain_;
  Smoothing smoothing_;
  double lengthOverSpacing_;  // h/V^(1/d) of adaptive smoothing
  ParticleSet<Dim> particles_;
  std::unique_ptr<Engine<Dim>> engine_;
  std::vector<Containment<Dim>> containments_;
  PairPass<Dim> kernelSum_, pressure_, voronoi_;
};

extern template class Arrangement<1>;
extern template class Arrangement<2>;
extern template class Arrangement<3>;

}  // namespace plenum
