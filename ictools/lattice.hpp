// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lattices, each given by a rectangular unit cell and the points in it.
//
//   name       dimension  neighbours  d_ref is              cell volume
//   uniform    1          2           spacing               d
//   square     2          4           edge                  d^2
//   hexagonal  2          6           nearest neighbours    sqrt(3)/2 d^2
//   cubic      3          6           edge                  d^3
//   bcc        3          8           nearest neighbours    4/(3 sqrt(3)) d^3
//   fcc, hcp   3          12          nearest neighbours    d^3/sqrt(2)
//
// Half-spacing rule. Unless `lattice_origin` says otherwise, the lattice starts so that a flat wall
// at the region's lower bounds lies in the middle between two rows: rows of a hexagonal lattice at
// (j + 1/2) sqrt(3)/2 d, its columns at (i + 1/4) d and (i + 3/4) d. (hcp has uneven gaps along y:
// the wall lies in the middle of a wide one.)
#pragma once

#include "particles/box.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace plenum {

/// Lattices that exist in `dimension` dimensions, the default first; "random" is not among them.
const std::vector<std::string>& latticeNames(int dimension);

/// A row of lattice points along x: point(i) for i = 0 ... count - 1.
template <int Dim>
struct LatticeRow {
  Vec<Dim> at;             ///< y and z of the row, x of the lattice's origin [m]
  double fraction = 0;     ///< of the first point in its cell, in edges
  double edge = 0;         ///< distance of neighbours in the row [m]
  std::int64_t first = 0;  ///< number of the first cell
  std::int64_t count = 0;

  /// Made from the cell's number, never by adding up, so that every box gives the same bits.
  Vec<Dim> point(std::int64_t i) const {
    Vec<Dim> x = at;
    x[0] += (static_cast<double>(first + i) + fraction) * edge;
    return x;
  }
};

template <int Dim>
class Lattice {
 public:
  /// The lattice `name` with reference spacing `spacing` [m] and a point at zero.
  /// Throws std::invalid_argument for a name that `latticeNames(Dim)` lacks.
  Lattice(const std::string& name, double spacing);

  /// Stretches the cell along periodic axes of `domain` to whole periods, the nearest number.
  void fitTo(const Box<Dim>& domain);

  /// Puts a lattice point at `origin` [m].
  void placeAt(const Vec<Dim>& origin) { origin_ = origin; }

  /// Applies the half-spacing rule to walls at `lower` [m].
  void startAt(const Vec<Dim>& lower);

  const Vec<Dim>& edges() const { return edges_; }  ///< of the unit cell [m]

  /// Spacing used along an axis over the one asked for, minus 1; zero where nothing was fitted.
  double deviation(int axis) const { return stretch_[axis] - 1; }

  /// Volume per particle [m^d].
  double cellVolume() const;

  /// Rows that have points in `box`. Open axes include both ends (to round-off); on a periodic
  /// axis, to which the lattice must have been fitted, exactly one period is returned.
  std::vector<LatticeRow<Dim>> rows(const Box<Dim>& box) const;

 private:
  struct IndexRange {
    std::int64_t first;
    std::int64_t count;
  };
  IndexRange cells(const Box<Dim>& box, int axis, double fraction) const;

  Vec<Dim> origin_{};
  Vec<Dim> edges_;
  Vec<Dim> firstPoint_;  // of the half-spacing rule, in edges
  Vec<Dim> stretch_ = Vec<Dim>::filled(1);
  std::vector<Vec<Dim>> points_;  // in edges
};

extern template class Lattice<1>;
extern template class Lattice<2>;
extern template class Lattice<3>;

}  // namespace plenum
