// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plenum {

namespace {

/// How far, in cells, a point may lie outside a box and still count as on its face.
constexpr double faceRoundOff = 1e-9;

template <int Dim>
struct UnitCell {
  Vec<Dim> edges;                // in d_ref
  Vec<Dim> firstPoint;           // of the half-spacing rule, in edges
  std::vector<Vec<Dim>> points;  // in edges
};

UnitCell<1> unitCell(const std::string&, Vec<1>) { return {{{1}}, {{0.5}}, {{}}}; }

UnitCell<2> unitCell(const std::string& name, Vec<2>) {
  if (name == "square") return {{{1, 1}}, {{0.5, 0.5}}, {{}}};
  return {{{1, std::sqrt(3.0)}}, {{0.25, 0.25}}, {{{0, 0}}, {{0.5, 0.5}}}};
}

UnitCell<3> unitCell(const std::string& name, Vec<3>) {
  if (name == "cubic") return {{{1, 1, 1}}, {{0.5, 0.5, 0.5}}, {{}}};
  if (name == "bcc") {
    const double a = 2 / std::sqrt(3.0);
    return {{{a, a, a}}, {{0.25, 0.25, 0.25}}, {{{0, 0, 0}}, {{0.5, 0.5, 0.5}}}};
  }
  if (name == "fcc") {
    const double a = std::sqrt(2.0);
    return {{{a, a, a}},
            {{0.25, 0.25, 0.25}},
            {{{0, 0, 0}}, {{0.5, 0.5, 0}}, {{0.5, 0, 0.5}}, {{0, 0.5, 0.5}}}};
  }
  return {{{1, std::sqrt(3.0), std::sqrt(8.0 / 3)}},  // hcp: close-packed layers A, B along z
          {{0.25, 1.0 / 6, 0.25}},
          {{{0, 0, 0}}, {{0.5, 0.5, 0}}, {{0.5, 1.0 / 6, 0.5}}, {{0, 2.0 / 3, 0.5}}}};
}

}  // namespace

const std::vector<std::string>& latticeNames(int dimension) {
  static const std::vector<std::string> names[] = {
      {"uniform"}, {"hexagonal", "square"}, {"hcp", "cubic", "bcc", "fcc"}};
  return names[dimension - 1];
}

template <int Dim>
Lattice<Dim>::Lattice(const std::string& name, double spacing) {
  const auto& known = latticeNames(Dim);
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw std::invalid_argument("no lattice '" + name + "' in this dimension");
  UnitCell<Dim> cell = unitCell(name, Vec<Dim>{});
  edges_ = spacing * cell.edges;
  firstPoint_ = cell.firstPoint;
  points_ = std::move(cell.points);
}

template <int Dim>
void Lattice<Dim>::fitTo(const Box<Dim>& domain) {
  for (int a = 0; a < Dim; ++a) {
    if (!domain.isPeriodic(a)) continue;
    const double length = domain.upper[a] - domain.lower[a];
    const double fitted = length / std::max(1.0, std::round(length / edges_[a]));
    stretch_[a] *= fitted / edges_[a];
    edges_[a] = fitted;
  }
}

template <int Dim>
void Lattice<Dim>::startAt(const Vec<Dim>& lower) {
  for (int a = 0; a < Dim; ++a) origin_[a] = lower[a] + firstPoint_[a] * edges_[a];
}

template <int Dim>
double Lattice<Dim>::cellVolume() const {
  double volume = 1;
  for (int a = 0; a < Dim; ++a) volume *= edges_[a];
  return volume / static_cast<double>(points_.size());
}

template <int Dim>
typename Lattice<Dim>::IndexRange Lattice<Dim>::cells(const Box<Dim>& box, int axis,
                                                      double fraction) const {
  const double lower = (box.lower[axis] - origin_[axis]) / edges_[axis] - fraction;
  const double upper = (box.upper[axis] - origin_[axis]) / edges_[axis] - fraction;
  const auto first = static_cast<std::int64_t>(std::ceil(lower - faceRoundOff));
  if (box.isPeriodic(axis)) return {first, std::llround(upper - lower)};
  return {first, static_cast<std::int64_t>(std::floor(upper + faceRoundOff)) - first + 1};
}

template <int Dim>
std::vector<LatticeRow<Dim>> Lattice<Dim>::rows(const Box<Dim>& box) const {
  std::vector<LatticeRow<Dim>> result;
  const auto add = [&](const Vec<Dim>& point, std::int64_t j, std::int64_t k) {
    const IndexRange x = cells(box, 0, point[0]);
    if (x.count <= 0) return;
    LatticeRow<Dim> row{origin_, point[0], edges_[0], x.first, x.count};
    const std::int64_t index[] = {0, j, k};
    for (int a = 1; a < Dim; ++a)
      row.at[a] += (static_cast<double>(index[a]) + point[a]) * edges_[a];
    result.push_back(row);
  };
  for (const Vec<Dim>& point : points_) {
    IndexRange y{0, 1};
    IndexRange z{0, 1};
    if constexpr (Dim > 1) y = cells(box, 1, point[1]);
    if constexpr (Dim > 2) z = cells(box, 2, point[2]);
    for (std::int64_t k = z.first; k < z.first + z.count; ++k)
      for (std::int64_t j = y.first; j < y.first + y.count; ++j) add(point, j, k);
  }
  // From the bottom up, so that neighbours in space are near in memory whatever the cell is.
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    for (int axis = Dim - 1; axis > 0; --axis)
      if (a.at[axis] != b.at[axis]) return a.at[axis] < b.at[axis];
    return false;
  });
  return result;
}

template class Lattice<1>;
template class Lattice<2>;
template class Lattice<3>;

}  // namespace plenum
