// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-study stability pairing: which kernels pair at which smoothing length, measured by the gas
// box of [C] in 2-D.
#pragma once

#include "studies/chart.hpp"
#include "studies/run_store.hpp"
#include "studies/stability_options.hpp"

#include <string>
#include <vector>

namespace plenum::study {

/// A cell: means over the seeds whose runs came to their end.
struct PairingCell {
  int nRuns = 0, nFailed = 0;
  double f5 = 0;  ///< share of particles nearer than .5 d_ref to another
  double f5Lowest = 0, f5Highest = 0;
  double nnMin = 0;  ///< least distance of neighbours [d_ref]
  double psi6 = 0;   ///< 1: hexagonal
};

struct PairingMap {
  std::vector<std::string> kernels;
  std::vector<double> smoothingLengths;         ///< h/d_ref
  std::vector<std::vector<PairingCell>> cells;  ///< [kernel][length]
};

/// Runs the gas box from random places, with seeds 1 to options.seeds.
PairingMap measurePairing(const StabilityOptions& options);

HeatMap heatMapOf(const PairingMap& map);
std::string tableOf(const PairingMap& map);
std::string csvOf(const PairingMap& map);

}  // namespace plenum::study
