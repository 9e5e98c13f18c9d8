// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/pairing_map.hpp"

#include "particles/kernels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plenum::study {

namespace {

RunRequest requestOf(const StabilityOptions& options, const std::string& kernel, double h,
                     int seed) {
  return {options.cases / "gas_box.toml",
          {"solver.kernel=" + kernel, fmt::format("solver.smoothing_length={:g}", h),
           fmt::format("fluid[0].seed={}", seed)},
          1,
          false};
}

PairingCell cellOf(const std::vector<RunOutcome>& runs) {
  PairingCell cell;
  cell.f5Lowest = 1;
  for (const RunOutcome& run : runs) {
    if (run.hasFailed()) {
      ++cell.nFailed;
      continue;
    }
    ++cell.nRuns;
    const double f5 = run.figure("f.5");
    cell.f5 += f5;
    cell.f5Lowest = std::min(cell.f5Lowest, f5);
    cell.f5Highest = std::max(cell.f5Highest, f5);
    cell.nnMin += run.figure("nn_min");
    cell.psi6 += run.figure("psi6");
  }
  for (double* mean : {&cell.f5, &cell.nnMin, &cell.psi6}) *mean /= std::max(1, cell.nRuns);
  return cell;
}

std::vector<std::string> printed(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(fmt::format("{:g}", value));
  return texts;
}

}  // namespace

PairingMap measurePairing(const StabilityOptions& options) {
  PairingMap map{options.kernels, options.smoothingLengths, {}};
  for (const std::string& kernel : map.kernels) KernelId::named(kernel);  // refuses unknown names
  std::vector<RunRequest> requests;
  for (const std::string& kernel : map.kernels)
    for (const double h : map.smoothingLengths)
      for (int seed = 1; seed <= options.seeds; ++seed)
        requests.push_back(requestOf(options, kernel, h, seed));
  RunStore store(options.folder / "runs", Programs::find(options.programs), options.quiet);
  const std::vector<RunOutcome> outcomes = store.run(requests, options.jobs, "pairing");
  auto next = outcomes.begin();
  for (std::size_t k = 0; k < map.kernels.size(); ++k) {
    map.cells.emplace_back();
    for (std::size_t s = 0; s < map.smoothingLengths.size(); ++s, next += options.seeds)
      map.cells.back().push_back(cellOf({next, next + options.seeds}));
  }
  return map;
}

HeatMap heatMapOf(const PairingMap& map) {
  HeatMap heat{"Particles that have paired in a gas box (2-D, from random places)",
               "",
               "h/d_ref",
               "share nearer than .5 d_ref to another",
               map.kernels,
               printed(map.smoothingLengths),
               {},
               {},
               0,
               1};
  for (const auto& row : map.cells) {
    heat.values.emplace_back();
    heat.texts.emplace_back();
    for (const PairingCell& cell : row) {
      heat.values.back().push_back(cell.nRuns > 0 ? cell.f5 : std::nan(""));
      heat.texts.back().push_back(cell.nRuns > 0 ? fmt::format("{:.2f}", cell.f5) : "failed");
    }
  }
  return heat;
}

std::string tableOf(const PairingMap& map) {
  std::string text = fmt::format("{:<20}", "f.5 at h/d_ref");
  for (const double h : map.smoothingLengths) text += fmt::format("{:>9g}", h);
  text += "\n";
  for (std::size_t k = 0; k < map.kernels.size(); ++k) {
    text += fmt::format("{:<20}", map.kernels[k]);
    for (const PairingCell& cell : map.cells[k])
      text += cell.nRuns > 0 ? fmt::format("{:>9.3f}", cell.f5) : fmt::format("{:>9}", "failed");
    text += "\n";
  }
  return text;
}

std::string csvOf(const PairingMap& map) {
  std::string text = "kernel,h/d_ref,runs,failed,f.5,f.5 lowest,f.5 highest,nn_min [d_ref],psi6\n";
  for (std::size_t k = 0; k < map.kernels.size(); ++k)
    for (std::size_t s = 0; s < map.smoothingLengths.size(); ++s) {
      const PairingCell& cell = map.cells[k][s];
      text += fmt::format("{},{:g},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}\n", map.kernels[k],
                          map.smoothingLengths[s], cell.nRuns, cell.nFailed, cell.f5, cell.f5Lowest,
                          cell.f5Highest, cell.nnMin, cell.psi6);
    }
  return text;
}

}  // namespace plenum::study
