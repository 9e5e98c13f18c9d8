// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plenum::study {

/// What all maps of stability have.
struct StabilityOptions {
  std::filesystem::path folder;
  std::filesystem::path programs;
  std::filesystem::path cases;  ///< folder of the shipped cases
  std::vector<std::string> kernels;
  std::vector<double> smoothingLengths;  ///< h/d_ref
  std::string lattice = "hexagonal";
  double backgroundPressure = 1;  ///< p0 [rho0 c^2]
  int seeds = 8;
  int jobs = 1;
  bool quiet = false;
};

}  // namespace plenum::study
