// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

namespace plenum {

/// A point or vector of `Dim` components over a number type `Real` (double, float or a pack of
/// them).
template <int Dim, class Real = double>
struct Vec {
  std::array<Real, Dim> components{};

  static constexpr Vec filled(Real value) {
    Vec v;
    v.components.fill(value);
    return v;
  }

  constexpr Real& operator[](int axis) { return components[static_cast<std::size_t>(axis)]; }
  constexpr const Real& operator[](int axis) const {
    return components[static_cast<std::size_t>(axis)];
  }

  // Written out per axis, without a loop: so the compiler keeps a vector of packs in registers.
  constexpr Vec& operator+=(const Vec& b) {
    (*this)[0] += b[0];
    if constexpr (Dim > 1) (*this)[1] += b[1];
    if constexpr (Dim > 2) (*this)[2] += b[2];
    return *this;
  }
  constexpr Vec& operator-=(const Vec& b) {
    (*this)[0] -= b[0];
    if constexpr (Dim > 1) (*this)[1] -= b[1];
    if constexpr (Dim > 2) (*this)[2] -= b[2];
    return *this;
  }
  constexpr Vec& operator*=(const Real& s) {
    (*this)[0] *= s;
    if constexpr (Dim > 1) (*this)[1] *= s;
    if constexpr (Dim > 2) (*this)[2] *= s;
    return *this;
  }

  friend constexpr Vec operator+(Vec a, const Vec& b) { return a += b; }
  friend constexpr Vec operator-(Vec a, const Vec& b) { return a -= b; }
  friend constexpr Vec operator*(Vec a, const Real& s) { return a *= s; }
  friend constexpr Vec operator*(const Real& s, Vec a) { return a *= s; }
  friend constexpr Vec operator/(Vec a, const Real& s) {
    for (int k = 0; k < Dim; ++k) a[k] = a[k] / s;
    return a;
  }
  friend constexpr Vec operator-(Vec a) {
    a[0] = -a[0];
    if constexpr (Dim > 1) a[1] = -a[1];
    if constexpr (Dim > 2) a[2] = -a[2];
    return a;
  }
  friend constexpr bool operator==(const Vec&, const Vec&) = default;
};

template <int Dim, class Real>
constexpr Real dot(const Vec<Dim, Real>& a, const Vec<Dim, Real>& b) {
  Real sum = a[0] * b[0];
  if constexpr (Dim > 1) sum += a[1] * b[1];
  if constexpr (Dim > 2) sum += a[2] * b[2];
  return sum;
}

template <int Dim, class Real>
constexpr Real normSquared(const Vec<Dim, Real>& a) {
  return dot(a, a);
}

template <int Dim>
double norm(const Vec<Dim>& a) {
  return std::sqrt(normSquared(a));
}

/// The vector in three dimensions, missing components filled with zero (files and pictures are
/// 3-D).
template <int Dim>
constexpr std::array<double, 3> toThree(const Vec<Dim>& a) {
  std::array<double, 3> three{};
  for (int k = 0; k < Dim; ++k) three[static_cast<std::size_t>(k)] = a[k];
  return three;
}

/// The first `Dim` of three components.
template <int Dim>
constexpr Vec<Dim> fromThree(const std::array<double, 3>& three) {
  Vec<Dim> a;
  for (int k = 0; k < Dim; ++k) a[k] = three[static_cast<std::size_t>(k)];
  return a;
}

}  // namespace plenum
