// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/cells.hpp"

#include "ictools/hilbert.hpp"
#include "ictools/random.hpp"
#include "particles/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace plenum {

namespace {

constexpr std::size_t batch = 1024;

/// A cell that may be cut again; all of one list have the same size.
template <int Dim>
struct Piece {
  Vec<Dim> center;       ///< [m]
  double clearance = 0;  ///< the region reaches at least as far from the center [m]; <= 0: unknown
};

/// Cuts level by level.
template <int Dim>
class Cutter {
 public:
  Cutter(const Geometry<Dim>* region, const Box<Dim>& box, const CellSizes<Dim>& sizes,
         double roundOff)
      : region_(region), box_(box), sizes_(sizes), roundOff_(roundOff) {
    // From cells so large that there are few: a thin region has nothing in most of its bounds.
    constexpr double few = 1e5;
    while (nFirst() > few) ++coarser_;
    for (int a = 0; a < Dim; ++a) edge_[a] = (box.upper[a] - box.lower[a]) / firstAlong(a);
  }

  Cells<Dim> run() {
    for (std::vector<Piece<Dim>> pieces = first(); !pieces.empty(); --coarser_) {
      if (pieces.size() + cells_.centers.size() > sizes_.limit) {
        cells_.isComplete = false;
        break;
      }
      thin(pieces);
      measure(pieces);
      pieces = cut(pieces);
    }
    return std::move(cells_);
  }

 private:
  /// Cells along an axis before anything is cut.
  double firstAlong(int axis) const {
    const double cells = (box_.upper[axis] - box_.lower[axis]) / sizes_.coarsest;
    return std::max(1.0, std::ceil(std::ldexp(cells, -coarser_) - 1e-9));
  }

  double nFirst() const {
    double product = 1;
    for (int a = 0; a < Dim; ++a) product *= firstAlong(a);
    return product;
  }

  double volume() const {
    double product = weight_;
    for (int a = 0; a < Dim; ++a) product *= edge_[a];
    return product;
  }

  /// The whole box in cells of the first size.
  std::vector<Piece<Dim>> first() const {
    std::vector<Piece<Dim>> pieces(1);
    pieces[0].center = box_.lower + 0.5 * edge_;
    for (int a = 0; a < Dim; ++a) {
      const auto n = static_cast<int>(std::lround(box_.extent()[a] / edge_[a]));
      const std::size_t before = pieces.size();
      for (int i = 1; i < n; ++i)
        for (std::size_t k = 0; k < before; ++k) {
          pieces.push_back(pieces[k]);
          pieces.back().center[a] += i * edge_[a];
        }
    }
    return pieces;
  }

  void thin(std::vector<Piece<Dim>>& pieces) {
    while (pieces.size() > sizes_.most) {
      const double before = static_cast<double>(pieces.size());
      std::erase_if(pieces, [&](const auto&) { return random_.number() < 0.5; });
      weight_ *= before / static_cast<double>(pieces.size());
      cells_.isSampled = true;
    }
  }

  /// Finds clearances where they are not known; leaves out what lies outside.
  void measure(std::vector<Piece<Dim>>& pieces) const {
    if (region_ == nullptr) return;
    parallelFor((pieces.size() + batch - 1) / batch, [&](std::size_t b) {
      std::vector<std::size_t> asked;
      std::vector<Vec<Dim>> points;
      for (std::size_t k = b * batch; k < std::min(pieces.size(), (b + 1) * batch); ++k) {
        if (pieces[k].clearance > 0) continue;
        asked.push_back(k);
        points.push_back(pieces[k].center);
      }
      std::vector<double> distance(points.size());
      region_->signedDistance(points, distance);
      for (std::size_t a = 0; a < asked.size(); ++a) pieces[asked[a]].clearance = -distance[a];
    });
    const double halfDiagonal = 0.5 * norm(edge_);
    std::erase_if(pieces, [&](const auto& piece) { return piece.clearance < -halfDiagonal; });
  }

  /// Keeps the pieces that are small enough and returns the parts of the others.
  std::vector<Piece<Dim>> cut(const std::vector<Piece<Dim>>& pieces) {
    std::vector<Vec<Dim>> centers;
    centers.reserve(pieces.size());
    for (const auto& piece : pieces) centers.push_back(piece.center);
    std::vector<double> allowed(pieces.size());
    parallelFor((pieces.size() + batch - 1) / batch, [&](std::size_t b) {
      const std::size_t from = b * batch, count = std::min(batch, pieces.size() - from);
      sizes_.at(std::span(std::as_const(centers)).subspan(from, count),
                std::span(allowed).subspan(from, count));
    });
    const double edge = std::pow(volume() / weight_, 1.0 / Dim);
    std::vector<Piece<Dim>> parts;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      if (coarser_ > 0 || edge > allowed[k] * (1 + 1e-9)) {
        halve(pieces[k], parts);
      } else if (region_ == nullptr || pieces[k].clearance > roundOff_) {
        cells_.centers.push_back(pieces[k].center);
        cells_.volumes.push_back(volume());
      }
    }
    edge_ = 0.5 * edge_;
    return parts;
  }

  void halve(const Piece<Dim>& piece, std::vector<Piece<Dim>>& parts) const {
    const double way = 0.25 * norm(edge_);
    for (int corner = 0; corner < (1 << Dim); ++corner) {
      Piece<Dim> part{piece.center, piece.clearance - way};
      for (int a = 0; a < Dim; ++a) part.center[a] += ((corner >> a) & 1 ? 0.25 : -0.25) * edge_[a];
      parts.push_back(part);
    }
  }

  const Geometry<Dim>* region_;
  const Box<Dim>& box_;
  const CellSizes<Dim>& sizes_;
  double roundOff_;
  Vec<Dim> edge_;
  int coarser_ = 0;  ///< times that pieces must be cut until none is too long
  double weight_ = 1;
  Random random_{1};
  Cells<Dim> cells_;
};

template <int Dim>
void sortAlongCurve(const Box<Dim>& box, Cells<Dim>& cells) {
  double longest = 0;
  for (int a = 0; a < Dim; ++a) longest = std::max(longest, box.extent()[a]);
  const double scale = std::ldexp(1 - 1e-9, hilbertBits<Dim>) / longest;
  std::vector<std::pair<std::uint64_t, std::size_t>> keys(cells.centers.size());
  forEachIndex(keys.size(), [&](std::size_t k) {
    std::array<std::uint64_t, Dim> x;
    for (int a = 0; a < Dim; ++a)
      x[static_cast<std::size_t>(a)] =
          static_cast<std::uint64_t>((cells.centers[k][a] - box.lower[a]) * scale);
    keys[k] = {hilbertKey<Dim>(x), k};
  });
  std::sort(keys.begin(), keys.end());
  Cells<Dim> sorted;
  sorted.isSampled = cells.isSampled;
  sorted.isComplete = cells.isComplete;
  sorted.centers.reserve(keys.size());
  for (const auto& [key, k] : keys) sorted.centers.push_back(cells.centers[k]);
  std::vector<Vec<Dim>>().swap(cells.centers);
  sorted.volumes.reserve(keys.size());
  for (const auto& [key, k] : keys) sorted.volumes.push_back(cells.volumes[k]);
  cells = std::move(sorted);
}

}  // namespace

template <int Dim>
Cells<Dim> cellsOf(const Geometry<Dim>* region, const Box<Dim>& box, const CellSizes<Dim>& sizes,
                   double roundOff) {
  Cells<Dim> cells = Cutter<Dim>(region, box, sizes, roundOff).run();
  sortAlongCurve(box, cells);
  return cells;
}

template Cells<1> cellsOf(const Geometry<1>*, const Box<1>&, const CellSizes<1>&, double);
template Cells<2> cellsOf(const Geometry<2>*, const Box<2>&, const CellSizes<2>&, double);
template Cells<3> cellsOf(const Geometry<3>*, const Box<3>&, const CellSizes<3>&, double);

}  // namespace plenum
