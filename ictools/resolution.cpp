// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/resolution.hpp"

#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

namespace {

/// Of a point from a box [m].
template <int Dim>
double distanceTo(const Box<Dim>& box, const Vec<Dim>& x) {
  Vec<Dim> outside;
  for (int a = 0; a < Dim; ++a)
    outside[a] = std::max({0.0, box.lower[a] - x[a], x[a] - box.upper[a]});
  return norm(outside);
}

}  // namespace

template <int Dim>
Refinement<Dim>::Refinement(RefineSettings settings, GeometryPtr<Dim> region, double spacing,
                            const Box<Dim>& domain)
    : settings_(std::move(settings)),
      region_(std::move(region)),
      bounds_(region_->bounds()),
      periods_(1),
      reach_((1 - settings_.spacing) * spacing / settings_.growth) {
  for (int a = 0; a < Dim; ++a) {
    if (!domain.isPeriodic(a)) continue;
    const std::size_t before = periods_.size();
    for (const double side : {-1.0, 1.0})
      for (std::size_t k = 0; k < before; ++k) {
        periods_.push_back(periods_[k]);
        periods_.back()[a] += side * domain.extent()[a];
      }
  }
}

template <int Dim>
void Refinement<Dim>::distances(std::span<const Vec<Dim>> points, std::span<double> result) const {
  std::fill(result.begin(), result.end(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> asked;
  std::vector<Vec<Dim>> images;
  for (std::size_t k = 0; k < points.size(); ++k)
    for (const Vec<Dim>& period : periods_) {
      const Vec<Dim> image = points[k] + period;
      const double atLeast = distanceTo(bounds_, image) - settings_.distance;
      if (atLeast > reach_) {
        result[k] = std::min(result[k], atLeast);
      } else {
        asked.push_back(k);
        images.push_back(image);
      }
    }
  std::vector<double> distance(images.size());
  region_->signedDistance(images, distance);
  for (std::size_t a = 0; a < asked.size(); ++a) {
    const double here =
        settings_.near.empty() ? distance[a] : std::abs(distance[a]) - settings_.distance;
    result[asked[a]] = std::min(result[asked[a]], std::max(0.0, here));
  }
}

template <int Dim>
Resolution<Dim>::Resolution(std::vector<Refinement<Dim>> refinements, double spacing)
    : refinements_(std::move(refinements)), spacing_(spacing) {
  for (const auto& refinement : refinements_) {
    finest_ = std::min(finest_, refinement.settings().spacing);
    growth_ = std::max(growth_, refinement.settings().growth);
  }
}

template <int Dim>
void Resolution<Dim>::at(std::span<const Vec<Dim>> points, std::span<double> result) const {
  std::fill(result.begin(), result.end(), 1.0);
  std::vector<double> distance(points.size());
  for (const auto& refinement : refinements_) {
    const RefineSettings& s = refinement.settings();
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
    refinement.distances(points, distance);
    for (std::size_t k = 0; k < points.size(); ++k)
      result[k] = std::min(result[k], std::max(0.0, distance[k] - refinement.reach()));
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

template class Refinement<1>;
template class Resolution<1>;
template std::vector<double> ratiosAt(const Resolution<1>&, std::span<const Vec<1>>);
template class Refinement<2>;
template class Resolution<2>;
template std::vector<double> ratiosAt(const Resolution<2>&, std::span<const Vec<2>>);
template class Refinement<3>;
template class Resolution<3>;
template std::vector<double> ratiosAt(const Resolution<3>&, std::span<const Vec<3>>);

}  // namespace plenum
