// SPDX-License-Identifier: GPL-3.0-or-later
//
// Linear stability of a lattice under the discrete equations of SPH, (2.2)/(2.3) of [C],
//   rho_i = sum_j m W_ij,   dv_i/dt = -sum_j m (p_i/rho_i^2 + p_j/rho_j^2) grad_i W_ij,
// with p = p0 + c^2 (rho - rho0) and no viscosity. A displacement xi_s exp(i k.r - i omega t) of
// the sites s of a cell obeys omega^2 xi = D(k) xi with, P = p/rho^2 and P' = dP/drho on the
// lattice,
//   D = m^2 P' B A + 2 P m H,
//   A_st xi_t = sum over neighbours of grad W . (xi_s - xi_t e),  e = exp(-i k.R), R = r_s - r_t,
//   B_st as A_st, with + for -, and H of the second derivatives of W as A of the first.
// Units: spacing d_ref, rho0 and c are 1.
//
// Where W'' jumps at the kernel's end and neighbours stand just there, a particle that comes nearer
// meets another stiffness than one that goes: theory takes the mean, the solver agrees to some per
// cent. Where W' jumps (schuessler_schmitt) these neighbours are left out.
#pragma once

#include "particles/kernels.hpp"
#include "particles/vec.hpp"

#include <complex>
#include <string>
#include <vector>

namespace plenum::study {

struct LatticeState {
  std::string lattice = "hexagonal";
  KernelId kernel;
  double smoothingLength = 1.5;   ///< h [d_ref]
  double backgroundPressure = 1;  ///< p0 [rho0 c^2]
};

/// A wave on a lattice.
template <int Dim>
struct Mode {
  double omegaSquared = 0;  ///< [c^2/d_ref^2]; negative: it grows at sqrt(-omegaSquared)
  Vec<Dim> k;               ///< of the wave that carries most of it [1/d_ref]
  double longitudinal = 0;  ///< share of the displacement along k: 0 transverse, 1 longitudinal
  std::vector<Vec<Dim>> cosine;  ///< displacement of the sites of a cell, real part; norm 1 with
  std::vector<Vec<Dim>> sine;    ///< the imaginary part

  double wavelength() const;  ///< [d_ref]
};

template <int Dim>
class LatticeModes {
 public:
  /// Throws InputError for a lattice that does not exist in Dim dimensions.
  explicit LatticeModes(const LatticeState& state);

  /// Edges of the rectangular cell, and its sites [d_ref].
  const Vec<Dim>& edges() const { return edges_; }
  const std::vector<Vec<Dim>>& sites() const { return sites_; }

  double density() const { return density_; }    ///< summed, of the perfect lattice [rho0]
  double pressure() const { return pressure_; }  ///< [rho0 c^2]

  /// omega^2 of all waves whose wave vector is `k`, but for vectors of the cell's reciprocal
  /// lattice; ascending.
  std::vector<double> omegaSquared(const Vec<Dim>& k) const;

  /// A wave at `k`: branch 0 is that of the lowest omega^2.
  Mode<Dim> modeAt(const Vec<Dim>& k, std::size_t branch = 0) const;
  std::size_t nBranches() const { return Dim * sites_.size(); }

  /// The wave of the lowest omega^2 of all: on a grid of `n` wave vectors an axis, then by search
  /// around the lowest one. k = 0 is a wave, too, that goes from site to site of a cell; shifts of
  /// the whole lattice are left out.
  Mode<Dim> lowest(int n = Dim == 3 ? 8 : 24) const;

 private:
  struct Neighbour {
    std::size_t s, t;
    Vec<Dim> R;    // r_s - r_t
    double F, dF;  // grad W = F R; (dF/dr)/r
  };
  struct Matrix;
  Matrix matrixAt(const Vec<Dim>& k) const;
  Matrix matrixWithoutShifts(const Vec<Dim>& k) const;
  Mode<Dim> modeOf(const Matrix& matrix, const Vec<Dim>& k, std::size_t branch) const;

  Vec<Dim> edges_;
  std::vector<Vec<Dim>> sites_;
  std::vector<Neighbour> neighbours_;
  double mass_ = 0, density_ = 0, pressure_ = 0;
};

extern template class LatticeModes<1>;
extern template class LatticeModes<2>;
extern template class LatticeModes<3>;

}  // namespace plenum::study
