// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/self_term.hpp"

#include "particles/kernels.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace plenum {

namespace {

struct Row {
  std::string_view kernel;
  double epsilon, alpha;
};

constexpr std::array table{Row{"wendland_c2", 0.0294, 0.977}, Row{"wendland_c4", 0.01342, 1.579},
                           Row{"wendland_c6", 0.0116, 2.236}};

const Row* rowOf(const std::string& kernel, int dimension) {
  if (dimension != 3) return nullptr;
  for (const Row& row : table)
    if (row.kernel == kernel) return &row;
  return nullptr;
}

}  // namespace

bool hasSelfTermCorrection(const std::string& kernel, int dimension) {
  return rowOf(kernel, dimension) != nullptr;
}

double selfTermCorrection(const SolverSettings& settings, int dimension) {
  const Row* row = rowOf(settings.kernel, dimension);
  if (!settings.selfTermCorrection || row == nullptr) return 0;
  const double support = 2 * settings.smoothingLength;  // in (m/rho)^(1/3)
  const double neighbours = 4 * std::numbers::pi / 3 * support * support * support;
  double atZero = 0;
  kernel::withProfile(KernelId::named(settings.kernel),
                      [&](auto profile) { atZero = Kernel<3, decltype(profile)>::W(0, 1); });
  return row->epsilon * std::pow(neighbours / 100, -row->alpha) * atZero;
}

}  // namespace plenum
