// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/front.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plenum::study {

std::vector<std::size_t> paretoFront(const std::vector<CostAndError>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return points[a].cost != points[b].cost ? points[a].cost < points[b].cost
                                            : points[a].error < points[b].error;
  });
  std::vector<std::size_t> front;
  for (const std::size_t k : order)
    if (front.empty() || points[k].error < points[front.back()].error) front.push_back(k);
  return front;
}

std::optional<double> costAtError(const std::vector<CostAndError>& points, double error) {
  const std::vector<std::size_t> front = paretoFront(points);
  for (std::size_t k = 0; k < front.size(); ++k) {
    const CostAndError& right = points[front[k]];
    if (right.error == error) return right.cost;
    if (k == 0 || right.error > error || points[front[k - 1]].error < error) continue;
    const CostAndError& left = points[front[k - 1]];
    const double part = std::log(left.error / error) / std::log(left.error / right.error);
    return left.cost * std::pow(right.cost / left.cost, part);
  }
  return std::nullopt;
}

}  // namespace plenum::study
