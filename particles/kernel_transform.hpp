// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/kernels.hpp"

namespace plenum {

/// Fourier transform of a kernel with h = 1 in `dimension` dimensions at the wave number `k` [1/h]:
/// the integral of W(r) exp(-i k.r), 1 at k = 0. To about 1e-12, by quadrature.
double kernelTransform(KernelId kernel, int dimension, double k);

/// Where a kernel's transform is negative, particles gain by pairing once enough neighbours lie in
/// the support (Dehnen & Aly 2012, doi 10.1111/j.1365-2966.2012.21439.x).
struct TransformSign {
  bool isNegative = false;   ///< below -1e-10 somewhere up to k h = 80
  double firstNegative = 0;  ///< k h where it first turns negative
  double lowest = 0;         ///< its smallest value
};

TransformSign transformSign(KernelId kernel, int dimension);

}  // namespace plenum
