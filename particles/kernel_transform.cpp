// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/kernel_transform.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

/// The integral of exp(-i k.x) over directions, times r^(d-1): 2 cos, 2 pi r J0, 4 pi r sin(kr)/k.
double shellWave(int dimension, double k, double r) {
  const double x = k * r;
  if (dimension == 1) return 2 * std::cos(x);
  if (dimension == 2) return 2 * kernel::pi * r * std::cyl_bessel_j(0, x);
  return 4 * kernel::pi * r * (x > 1e-4 ? std::sin(x) / k : r * (1 - x * x / 6));
}

/// Gauss-Legendre with eight nodes on [-1, 1].
constexpr std::array<double, 4> gaussNode{0.1834346424956498, 0.5255324099163290,
                                          0.7966664774136267, 0.9602898564975363};
constexpr std::array<double, 4> gaussWeight{0.3626837833783620, 0.3137066458778873,
                                            0.2223810344533745, 0.1012285362903763};

/// Places where some kernel's polynomial changes: R = 2 - 1/(...) of splines and core triangle. In
/// between, all of them are smooth but for sqrt(R) at zero, where the panels become narrow.
std::vector<double> panels() {
  std::vector<double> edges{0, 1e-8, 1e-6, 1e-4, 1e-3, 1e-2, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  for (const double kink : {2.0 / 3, 1.0, 4.0 / 3, 0.4, 1.2, 2.0}) edges.push_back(kink);
  for (int k = 7; k < 20; ++k) edges.push_back(0.1 * k);
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

double kernelTransform(KernelId id, int dimension, double k) {
  static const std::vector<double> edges = panels();
  const kernel::Any profile{id};
  double sum = 0;
  for (std::size_t p = 1; p < edges.size(); ++p) {
    const double half = 0.5 * (edges[p] - edges[p - 1]);
    // At most a fifth of a wave in half a panel: then eight nodes are exact to round-off.
    const int parts = std::max(1, static_cast<int>(std::ceil(k * half / 1.2)));
    const double part = half / parts;
    for (int q = 0; q < parts; ++q) {
      const double center = edges[p - 1] + (2 * q + 1) * part;
      for (std::size_t g = 0; g < gaussNode.size(); ++g)
        for (const double side : {-1.0, 1.0}) {
          const double r = center + side * part * gaussNode[g];
          sum += part * gaussWeight[g] * profile.f(r) * shellWave(dimension, k, r);
        }
    }
  }
  return profile.sigma(dimension) * sum;
}

TransformSign transformSign(KernelId kernel, int dimension) {
  // Lobes are about pi wide, because the support is 2.
  constexpr double below = -1e-10, last = 80, step = 0.1;
  TransformSign sign;
  for (double k = step; k <= last; k += step) {
    const double value = kernelTransform(kernel, dimension, k);
    sign.lowest = std::min(sign.lowest, value);
    if (value >= below || sign.isNegative) continue;
    sign.isNegative = true;
    double above = k - step, under = k;
    while (under - above > 1e-4) {
      const double middle = 0.5 * (above + under);
      (kernelTransform(kernel, dimension, middle) < below ? under : above) = middle;
    }
    sign.firstNegative = under;
  }
  return sign;
}

}  // namespace plenum
