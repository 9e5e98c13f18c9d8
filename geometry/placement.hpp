// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"

#include <array>

namespace plenum {

/// Where a shape or file is put: scaled about the origin, then rotated about the origin, then
/// moved.
template <int Dim>
struct Placement {
  double scale = 1;                      ///< > 0; 0.001 reads millimetres as metres
  std::array<Vec<Dim>, Dim> rotation{};  ///< rows of an orthogonal matrix of determinant 1
  Vec<Dim> translation{};                ///< [m]

  Placement() {
    for (int a = 0; a < Dim; ++a) rotation[static_cast<std::size_t>(a)][a] = 1;
  }

  bool isIdentity() const {
    const Placement none;
    return scale == 1 && rotation == none.rotation && translation == none.translation;
  }

  /// A direction of the shape, turned.
  Vec<Dim> turned(const Vec<Dim>& v) const {
    Vec<Dim> result;
    for (int a = 0; a < Dim; ++a) result[a] = dot(rotation[static_cast<std::size_t>(a)], v);
    return result;
  }

  /// A direction of space, turned back.
  Vec<Dim> turnedBack(const Vec<Dim>& v) const {
    Vec<Dim> result;
    for (int a = 0; a < Dim; ++a) result += v[a] * rotation[static_cast<std::size_t>(a)];
    return result;
  }

  Vec<Dim> apply(const Vec<Dim>& x) const { return turned(scale * x) + translation; }
  Vec<Dim> invert(const Vec<Dim>& x) const { return turnedBack(x - translation) / scale; }

  /// Turns by `angle` [degrees], counter-clockwise in 2-D, about `axis` in 3-D (right hand);
  /// nothing in 1-D.
  void rotate(double angle, const std::array<double, 3>& axis);
};

/// `shape` moved as `placement` says; the shape itself if it says nothing.
template <int Dim>
GeometryPtr<Dim> placed(GeometryPtr<Dim> shape, const Placement<Dim>& placement);

}  // namespace plenum
