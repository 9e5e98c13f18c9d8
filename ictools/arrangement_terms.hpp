// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums that judge how evenly particles stand, or that tell where they should go. Units for d
// dimensions.
#pragma once

#include "engine/common_terms.hpp"

namespace plenum::term {

/// sum_j V_j W_ij(h_i), the particle itself included; 1 where particles fill space evenly.
struct KernelSum {
  static constexpr FieldSet reads{field::volume};
  static constexpr FieldSet writes{field::kernelSum};

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.kernelSum += ij.j.volume * ij.ofI.W;
  }
};

/// sum_j V_j grad_i W_ij  [1/m]; zero where particles stand evenly.
struct KernelGradientSum {
  static constexpr FieldSet reads{field::volume};
  static constexpr FieldSet writes{field::kernelGradient};

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.kernelGradient += ij.j.volume * ij.gradW();
  }
};

/// -sum_j V_i V_j (p_i grad_i W(h_i) + p_j grad_i W(h_j))   [N]: the force of
/// PressureDensityProduct where smoothing lengths differ, each pressure with the kernel that it was
/// found with.
struct OwnKernelPressure {
  static constexpr FieldSet reads{field::volume, field::pressure};
  static constexpr FieldSet writes{field::force};

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i) const {
    i.force -=
        ij.i.volume * ij.j.volume * (ij.i.pressure * ij.ofI.F + ij.j.pressure * ij.ofJ.F) * ij.r;
  }
};

/// sum_j (h/h_i)^(d-1) h^d W(r_ij, h) r_ij/|r_ij|, h = (h_i + h_j)/2: the push of weighted Voronoi
/// tessellations without the tessellation. Diehl et al. 2015, doi 10.1017/pasa.2015.50; with the
/// kernel as the weight: Arth et al. 2019, arXiv 1907.11250. The first factor is ours: where the
/// number density n ~ h^-d has a gradient, the pushes integral n h^k f(r/h) r/|r| of the many small
/// and the few large neighbours cancel to first order for k = d - 1 only (docs/relaxation.md).
struct VoronoiPush {
  static constexpr FieldSet reads{field::smoothingLength};
  static constexpr FieldSet writes{field::push};

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    const Real tiny = Real(1e-12) * ij.h * ij.h;  // coincident particles do not push each other
    const Real share = power<Dim - 1>(ij.h / ij.i.smoothingLength) * power<Dim>(ij.h);
    i.push += share * ij.W / squareRoot(max(ij.distanceSquared, tiny)) * ij.r;
  }
};

}  // namespace plenum::term
