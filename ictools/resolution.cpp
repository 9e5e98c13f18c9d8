// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/resolution.hpp"

#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

template <int Dim>
void Refinement<Dim>::distances(std::span<const Vec<Dim>> points, std::span<double> result) const {
  region->signedDistance(points, result);
  for (double& distance : result)
    distance =
        std::max(0.0, settings.near.empty() ? distance : std::abs(distance) - settings.distance);
}

template <int Dim>
Resolution<Dim>::Resolution(std::vector<Refinement<Dim>> refinements, double spacing)
    : refinements_(std::move(refinements)), spacing_(spacing) {
  for (const auto& refinement : refinements_) {
    finest_ = std::min(finest_, refinement.settings.spacing);
    growth_ = std::max(growth_, refinement.settings.growth);
  }
}

template <int Dim>
void Resolution<Dim>::at(std::span<const Vec<Dim>> points, std::span<double> result) const {
  std::fill(result.begin(), result.end(), 1.0);
  std::vector<double> distance(points.size());
  for (const auto& refinement : refinements_) {
    const RefineSettings& s = refinement.settings;
    refinement.distances(points, distance);
    for (std::size_t k = 0; k < points.size(); ++k)
      result[k] = std::min(result[k], s.spacing + s.growth * distance[k] / spacing_);
  }
}

template <int Dim>
void Resolution<Dim>::plainAround(std::span<const Vec<Dim>> points,
                                  std::span<double> result) const {
  std::fill(result.begin(), result.end(), std::numeric_limits<double>::infinity());
  std::vector<double> distance(points.size());
  for (const auto& refinement : refinements_) {
    const RefineSettings& s = refinement.settings;
    const double reach = (1 - s.spacing) * spacing_ / s.growth;
    refinement.distances(points, distance);
    for (std::size_t k = 0; k < points.size(); ++k)
      result[k] = std::min(result[k], std::max(0.0, distance[k] - reach));
  }
}

template <int Dim>
std::vector<double> ratiosAt(const Resolution<Dim>& resolution, std::span<const Vec<Dim>> points) {
  std::vector<double> ratios(points.size());
  constexpr std::size_t batch = 1024;
  parallelFor((points.size() + batch - 1) / batch, [&](std::size_t b) {
    const std::size_t first = b * batch, count = std::min(batch, points.size() - first);
    resolution.at(points.subspan(first, count), std::span(ratios).subspan(first, count));
  });
  return ratios;
}

template struct Refinement<1>;
template class Resolution<1>;
template std::vector<double> ratiosAt(const Resolution<1>&, std::span<const Vec<1>>);
template struct Refinement<2>;
template class Resolution<2>;
template std::vector<double> ratiosAt(const Resolution<2>&, std::span<const Vec<2>>);
template struct Refinement<3>;
template class Resolution<3>;
template std::vector<double> ratiosAt(const Resolution<3>&, std::span<const Vec<3>>);

}  // namespace plenum
