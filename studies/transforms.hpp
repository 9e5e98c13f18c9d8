// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-study stability transforms: where the Fourier transforms of kernels are negative.
#pragma once

#include "particles/kernel_transform.hpp"
#include "studies/chart.hpp"

#include <array>
#include <string>
#include <vector>

namespace plenum::study {

struct KernelTransforms {
  std::string kernel;
  std::array<TransformSign, 3> sign;  ///< in 1, 2 and 3 dimensions
};

/// Of the kernels named, or of all. Throws InputError for a name that is none.
std::vector<KernelTransforms> transformsOf(const std::vector<std::string>& kernels);

/// Wavelength of the first negative k over the particle spacing, at h/d_ref; NaN where there is
/// none. Below two spacings no lattice carries such a wave.
double firstNegativeWavelength(const TransformSign& sign, double smoothingLengthOverSpacing);

std::string tableOf(const std::vector<KernelTransforms>& transforms);
std::string csvOf(const std::vector<KernelTransforms>& transforms,
                  const std::vector<double>& smoothingLengths);

/// |W^(k)| in `dimension` dimensions over k h, lines where it is positive, dashed where negative.
Chart transformChart(const std::vector<KernelTransforms>& transforms, int dimension);

}  // namespace plenum::study
