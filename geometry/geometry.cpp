// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/geometry.hpp"

#include "geometry/march.hpp"

#include <algorithm>
#include <array>

namespace plenum {

namespace {

constexpr std::size_t chunkLength = 64;  // on the stack: no allocation beyond what `closest` does

template <int Dim>
class MarchedRows final : public RowClassifier<Dim> {
 public:
  MarchedRows(const Geometry<Dim>& geometry, const Vec<Dim>& step, double near)
      : geometry_(geometry), step_(step), near_(near) {}

  void classify(std::span<const Row<Dim>> rows, RowRuns& runs) const override {
    std::vector<std::int64_t> counts;
    for (const Row<Dim>& row : rows) counts.push_back(row.count);
    const auto pointOf = [&](std::size_t r, std::int64_t i) {
      return rows[r].first + static_cast<double>(i) * step_;
    };
    const auto judge = [&](double distance) -> Verdict {
      const double reach = std::abs(distance) - near_;
      if (!(reach > 0)) return {PointPlace::unknown, 0};
      return {distance < 0 ? PointPlace::inside : PointPlace::outside, reach};
    };
    march(geometry_, counts, norm(step_), pointOf, judge, runs);
  }

 private:
  const Geometry<Dim>& geometry_;
  Vec<Dim> step_;
  double near_;
};

}  // namespace

template <int Dim>
void Geometry<Dim>::signedDistance(std::span<const Vec<Dim>> points,
                                   std::span<double> result) const {
  std::array<SurfacePoint<Dim>, chunkLength> hits;
  for (std::size_t begin = 0; begin < points.size(); begin += chunkLength) {
    const std::size_t n = std::min(chunkLength, points.size() - begin);
    closest(points.subspan(begin, n), std::span(hits).first(n));
    for (std::size_t k = 0; k < n; ++k) result[begin + k] = hits[k].signedDistance;
  }
}

template <int Dim>
void Geometry<Dim>::distanceBound(std::span<const Vec<Dim>> points,
                                  std::span<double> result) const {
  signedDistance(points, result);
}

template <int Dim>
void Geometry<Dim>::inside(std::span<const Vec<Dim>> points, std::span<std::uint8_t> result) const {
  std::array<double, chunkLength> distances;
  for (std::size_t begin = 0; begin < points.size(); begin += chunkLength) {
    const std::size_t n = std::min(chunkLength, points.size() - begin);
    signedDistance(points.subspan(begin, n), std::span(distances).first(n));
    for (std::size_t k = 0; k < n; ++k) result[begin + k] = distances[k] < 0 ? 1 : 0;
  }
}

template <int Dim>
std::unique_ptr<const RowClassifier<Dim>> Geometry<Dim>::rowClassifier(const Vec<Dim>& step,
                                                                       double near) const {
  return std::make_unique<const MarchedRows<Dim>>(*this, step, near);
}

template <int Dim>
bool Geometry<Dim>::isInside(const Vec<Dim>& point) const {
  std::uint8_t result = 0;
  inside(std::span(&point, 1), std::span(&result, 1));
  return result != 0;
}

template <int Dim>
double Geometry<Dim>::signedDistance(const Vec<Dim>& point) const {
  double result = 0;
  signedDistance(std::span(&point, 1), std::span(&result, 1));
  return result;
}

template <int Dim>
double Geometry<Dim>::distanceBound(const Vec<Dim>& point) const {
  double result = 0;
  distanceBound(std::span(&point, 1), std::span(&result, 1));
  return result;
}

template <int Dim>
SurfacePoint<Dim> Geometry<Dim>::closest(const Vec<Dim>& point) const {
  SurfacePoint<Dim> result;
  closest(std::span(&point, 1), std::span(&result, 1));
  return result;
}

template class Geometry<1>;
template class Geometry<2>;
template class Geometry<3>;

}  // namespace plenum
