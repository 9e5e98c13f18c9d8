// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/set_operation.hpp"

#include "geometry/set_volume.hpp"
#include "particles/errors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plenum {

namespace {

enum class Operation { unite, intersect, subtract };

template <int Dim>
Box<Dim> boundsOf(Operation operation, const std::vector<GeometryPtr<Dim>>& parts) {
  Box<Dim> box = parts.front()->bounds();
  if (operation == Operation::subtract) return box;
  for (std::size_t k = 1; k < parts.size(); ++k)
    box = operation == Operation::unite ? Box<Dim>(box).extend(parts[k]->bounds())
                                        : commonBox(box, parts[k]->bounds());
  return box;
}

/// A finite box that has some of the common region's interior: for a union (whose common region is
/// what lies outside) it reaches beyond the parts.
template <int Dim>
Box<Dim> searchBoxOf(Operation operation, const std::vector<GeometryPtr<Dim>>& parts) {
  double size = 0;
  for (const GeometryPtr<Dim>& part : parts) {
    const SurfacePoint<Dim> hit = part->closest(Vec<Dim>{});
    size = std::max(size, std::abs(hit.signedDistance));
    const Box<Dim> box = part->bounds();
    for (int a = 0; a < Dim; ++a)
      for (const double x : {box.lower[a], box.upper[a]})
        if (std::isfinite(x)) size = std::max(size, std::abs(x));
  }
  if (size == 0) size = 1;
  Box<Dim> box = boundsOf(operation, parts);
  for (int a = 0; a < Dim; ++a) {
    const double margin = operation == Operation::unite ? size : 0;
    box.lower[a] = std::isfinite(box.lower[a]) ? box.lower[a] - margin : -10 * size;
    box.upper[a] = std::isfinite(box.upper[a]) ? box.upper[a] + margin : 10 * size;
  }
  return box;
}

template <int Dim>
std::vector<Part<Dim>> signedParts(Operation operation,
                                   const std::vector<GeometryPtr<Dim>>& parts) {
  std::vector<Part<Dim>> result;
  for (const GeometryPtr<Dim>& part : parts) {
    const bool turned =
        operation == Operation::unite || (operation == Operation::subtract && !result.empty());
    result.push_back({part, turned ? -1. : 1.});
  }
  return result;
}

/// Combines what the parts know. Where two parts only touch, each says "unknown", and so do they
/// together: on a seam the exact question decides.
template <int Dim>
class CombinedRows final : public RowClassifier<Dim> {
 public:
  CombinedRows(Operation operation, const std::vector<GeometryPtr<Dim>>& parts,
               const Vec<Dim>& step, double near)
      : operation_(operation) {
    for (const GeometryPtr<Dim>& part : parts) parts_.push_back(part->rowClassifier(step, near));
  }

  void classify(std::span<const Row<Dim>> rows, RowRuns& runs) const override {
    parts_.front()->classify(rows, runs);
    RowRuns other;
    for (std::size_t k = 1; k < parts_.size(); ++k) {
      parts_[k]->classify(rows, other);
      runs = combined(runs, other, [this](PointPlace a, PointPlace b) {
        return operation_ == Operation::unite       ? std::max(a, b)
               : operation_ == Operation::intersect ? std::min(a, b)
                                                    : std::min(a, opposite(b));
      });
    }
  }

 private:
  Operation operation_;
  std::vector<std::unique_ptr<const RowClassifier<Dim>>> parts_;
};

template <int Dim>
class SetOperation final : public Geometry<Dim> {
 public:
  using Geometry<Dim>::signedDistance;
  using Geometry<Dim>::closest;
  using Geometry<Dim>::distanceBound;

  SetOperation(Operation operation, std::vector<GeometryPtr<Dim>> parts)
      : operation_(operation),
        sign_(operation == Operation::unite ? -1 : 1),
        parts_(std::move(parts)),
        common_(signedParts(operation, parts_), searchBoxOf(operation, parts_)) {}

  bool isEmpty() const { return common_.isEmpty(); }

  void inside(std::span<const Vec<Dim>> points, std::span<std::uint8_t> result) const override {
    for (std::size_t k = 0; k < points.size(); ++k) {
      double value = common_.value(points[k]);
      // On surfaces of parts, and only there, the sign may not be that of the operation.
      if (std::abs(value) <= common_.resolution())
        value = common_.closest(points[k]).signedDistance;
      result[k] = sign_ * value < 0 ? 1 : 0;
    }
  }

  void distanceBound(std::span<const Vec<Dim>> points, std::span<double> result) const override {
    std::vector<double> ofPart(points.size());
    std::ranges::fill(result, -std::numeric_limits<double>::infinity());
    for (const Part<Dim>& part : common_.parts()) {
      part.geometry->distanceBound(points, ofPart);
      for (std::size_t k = 0; k < points.size(); ++k)
        result[k] = std::max(result[k], part.sign * ofPart[k]);
    }
    for (double& bound : result) bound *= sign_;
  }

  void closest(std::span<const Vec<Dim>> points,
               std::span<SurfacePoint<Dim>> result) const override {
    for (std::size_t k = 0; k < points.size(); ++k) result[k] = turned(common_.closest(points[k]));
  }

  std::unique_ptr<const RowClassifier<Dim>> rowClassifier(const Vec<Dim>& step,
                                                          double near) const override {
    // Exact answers take lengths below the resolution as zero.
    return std::make_unique<const CombinedRows<Dim>>(operation_, parts_, step,
                                                     near + 4 * common_.resolution());
  }

  Box<Dim> bounds() const override { return boundsOf(operation_, parts_); }

  Measure volume() const override {
    if (!bounds().isFinite()) return {std::numeric_limits<double>::infinity(), 0};
    if (const std::optional<Measure> exact = exactVolume()) return *exact;
    const auto surface = [this](const Vec<Dim>& x) { return turned(common_.bindingPart(x)); };
    return SetVolume<Dim>::bySubdivision(surface, bounds());
  }

  double tolerance() const override {
    double largest = 0;
    for (const GeometryPtr<Dim>& part : parts_) largest = std::max(largest, part->tolerance());
    return largest;
  }

  std::string describe() const override {
    const char* between = operation_ == Operation::unite       ? " and "
                          : operation_ == Operation::intersect ? " within "
                                                               : " without ";
    std::string text;
    for (const GeometryPtr<Dim>& part : parts_)
      text += (text.empty() ? "" : between) + part->describe();
    return "(" + text + ")";
  }

 private:
  SurfacePoint<Dim> turned(SurfacePoint<Dim> hit) const {
    hit.normal *= sign_;
    hit.signedDistance *= sign_;
    return hit;
  }

  std::optional<Measure> exactVolume() const {
    if (operation_ == Operation::unite) return SetVolume<Dim>::ofUnion(parts_);
    if (operation_ == Operation::intersect) return SetVolume<Dim>::ofIntersection(parts_);
    return SetVolume<Dim>::ofDifference(parts_);
  }

  Operation operation_;
  double sign_;
  std::vector<GeometryPtr<Dim>> parts_;
  CommonRegion<Dim> common_;
};

template <int Dim>
GeometryPtr<Dim> combined(Operation operation, std::vector<GeometryPtr<Dim>> parts) {
  if (parts.size() == 1) return parts.front();
  auto result = std::make_shared<const SetOperation<Dim>>(operation, std::move(parts));
  if (result->isEmpty())
    throw InputError(operation == Operation::unite
                         ? result->describe() + " fills all of space: nothing is outside"
                         : result->describe() + " is empty: no point belongs to it");
  return result;
}

}  // namespace

template <int Dim>
GeometryPtr<Dim> unionOf(std::vector<GeometryPtr<Dim>> parts) {
  return combined(Operation::unite, std::move(parts));
}

template <int Dim>
GeometryPtr<Dim> intersectionOf(std::vector<GeometryPtr<Dim>> parts) {
  return combined(Operation::intersect, std::move(parts));
}

template <int Dim>
GeometryPtr<Dim> differenceOf(std::vector<GeometryPtr<Dim>> parts) {
  return combined(Operation::subtract, std::move(parts));
}

template GeometryPtr<1> unionOf<1>(std::vector<GeometryPtr<1>>);
template GeometryPtr<2> unionOf<2>(std::vector<GeometryPtr<2>>);
template GeometryPtr<3> unionOf<3>(std::vector<GeometryPtr<3>>);
template GeometryPtr<1> intersectionOf<1>(std::vector<GeometryPtr<1>>);
template GeometryPtr<2> intersectionOf<2>(std::vector<GeometryPtr<2>>);
template GeometryPtr<3> intersectionOf<3>(std::vector<GeometryPtr<3>>);
template GeometryPtr<1> differenceOf<1>(std::vector<GeometryPtr<1>>);
template GeometryPtr<2> differenceOf<2>(std::vector<GeometryPtr<2>>);
template GeometryPtr<3> differenceOf<3>(std::vector<GeometryPtr<3>>);

}  // namespace plenum
