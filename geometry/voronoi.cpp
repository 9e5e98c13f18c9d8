// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/voronoi.hpp"

#include "geometry/voronoi_facets.hpp"
#include "particles/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace plenum {

namespace {

/// A simplex of a facet, relative to a generator, and its measure [m^(d-1)]: negative if it runs
/// around the other way than the first.
template <int Dim>
struct FacetPiece {
  std::array<Vec<Dim>, Dim> corners;
  double area;
};

double signedArea(const std::array<Vec<1>, 1>&, const Vec<1>&) { return 1; }

double signedArea(const std::array<Vec<2>, 2>& q, const Vec<2>& normal) {
  const Vec<2> along = q[1] - q[0];
  return normal[0] * along[1] - normal[1] * along[0];
}

double signedArea(const std::array<Vec<3>, 3>& q, const Vec<3>& normal) {
  const Vec<3> a = q[1] - q[0], b = q[2] - q[0];
  return 0.5 * (normal[0] * (a[1] * b[2] - a[2] * b[1]) + normal[1] * (a[2] * b[0] - a[0] * b[2]) +
                normal[2] * (a[0] * b[1] - a[1] * b[0]));
}

/// Facets as one of the two cells sees them.
template <int Dim>
struct CellFacet {
  std::size_t facet;
  std::uint32_t other;
};

/// For each of the first n generators where its facets begin, and the facets in the order of the
/// generators behind them: so sums have the same bits however the facets were found.
template <int Dim>
struct CellFacets {
  std::vector<std::size_t> first;
  std::vector<CellFacet<Dim>> all;

  CellFacets(const VoronoiFacets<Dim>& facets, std::size_t n) : first(n + 1) {
    for (const auto& facet : facets.facets)
      for (const auto g : {facet.a, facet.b})
        if (g < n) ++first[g + 1];
    for (std::size_t i = 0; i < n; ++i) first[i + 1] += first[i];
    all.resize(first[n]);
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (std::size_t f = 0; f < facets.facets.size(); ++f) {
      const auto& facet = facets.facets[f];
      if (facet.a < n) all[next[facet.a]++] = {f, facet.b};
      if (facet.b < n) all[next[facet.b]++] = {f, facet.a};
    }
    forEachIndex(n, [&](std::size_t i) {
      std::ranges::sort(std::span(all).subspan(first[i], first[i + 1] - first[i]), {},
                        &CellFacet<Dim>::other);
    });
  }

  std::span<const CellFacet<Dim>> of(std::size_t i) const {
    return std::span(all).subspan(first[i], first[i + 1] - first[i]);
  }
};

/// Integrals over the facets and the inside of cells; all places relative to the generator, so that
/// nothing cancels far from the origin.
template <int Dim>
class Cells {
 public:
  Cells(const Generators<Dim>& generators, const VoronoiFacets<Dim>& facets)
      : generators_(generators), facets_(facets), cellFacets_(facets, generators.n) {}

  VoronoiCell<Dim> at(std::size_t i) const {
    double volume = 0;
    Vec<Dim> moment, slope;  // int x dV; int grad ln w dV
    double least = 0, most = 0;
    for (const auto& cellFacet : cellFacets_.of(i)) {
      const Vec<Dim> across = acrossTo(cellFacet.other, i);
      const double r = norm(across);
      const FacetSums sums = sumsOver(cellFacet.facet, i, across / r);
      volume += r / 2 / Dim * sums.area;  // a pyramid on the facet
      moment += r / 2 / (Dim + 1) * sums.moment;
      if (generators_.logWeights.empty()) continue;
      const double rise = generators_.logWeights[cellFacet.other] - generators_.logWeights[i];
      slope += rise / r * sums.moment;
      least = std::min(least, rise);
      most = std::max(most, rise);
    }
    const Vec<Dim>& x = generators_.points[i];
    if (!(volume > 0)) return {x, 0};
    if (least == 0 && most == 0) return {x + moment / volume, volume};
    return {x + weightedCentroid(i, slope / volume, least, most), volume};
  }

 private:
  struct FacetSums {
    double area = 0;    // int dA
    Vec<Dim> moment{};  // int x dA
  };

  Vec<Dim> acrossTo(std::size_t j, std::size_t i) const {
    return generators_.points[j] - generators_.points[i];
  }

  /// Calls body(piece) for the simplices that a facet consists of.
  template <class Body>
  void forEachPiece(std::size_t facet, std::size_t i, const Vec<Dim>& normal, Body&& body) const {
    const auto corners = facets_.cornersOf(facet);
    const auto corner = [&](std::size_t k) {
      return facets_.corners[corners[k]] - generators_.points[i];
    };
    constexpr auto nCorners = static_cast<std::size_t>(Dim);
    FacetPiece<Dim> piece;
    piece.corners[0] = corner(0);
    for (std::size_t k = 0; k + nCorners <= corners.size(); ++k) {
      for (std::size_t c = 1; c < nCorners; ++c) piece.corners[c] = corner(k + c);
      piece.area = signedArea(piece.corners, normal);
      body(piece);
    }
  }

  FacetSums sumsOver(std::size_t facet, std::size_t i, const Vec<Dim>& normal) const {
    FacetSums sums;
    forEachPiece(facet, i, normal, [&](const FacetPiece<Dim>& piece) {
      Vec<Dim> sum;
      for (const Vec<Dim>& q : piece.corners) sum += q;
      sums.area += piece.area;
      sums.moment += piece.area / Dim * sum;
    });
    if (sums.area < 0) return {-sums.area, -sums.moment};
    return sums;
  }

  /// Relative to the generator, where w = 1 here.
  Vec<Dim> weightedCentroid(std::size_t i, const Vec<Dim>& slope, double least, double most) const {
    double weight = 0;
    Vec<Dim> moment;
    for (const auto& cellFacet : cellFacets_.of(i)) {
      const Vec<Dim> across = acrossTo(cellFacet.other, i);
      const double r = norm(across);
      double area = 0, facetWeight = 0;
      Vec<Dim> facetMoment;
      forEachPiece(cellFacet.facet, i, across / r, [&](const FacetPiece<Dim>& piece) {
        double sum = 1;
        Vec<Dim> places, weighted;
        for (const Vec<Dim>& q : piece.corners) {
          const double w = std::exp(std::clamp(dot(slope, q), least, most));
          sum += w;
          places += q;
          weighted += w * q;
        }
        area += piece.area;
        facetWeight += piece.area * sum / (Dim + 1);
        facetMoment += piece.area / ((Dim + 1) * (Dim + 2)) * (weighted + sum * places);
      });
      const double height = (area < 0 ? -r : r) / 2 / Dim;
      weight += height * facetWeight;
      moment += height * facetMoment;
    }
    return moment / weight;
  }

  const Generators<Dim>& generators_;
  const VoronoiFacets<Dim>& facets_;
  CellFacets<Dim> cellFacets_;
};

/// Points and weights with those of the images behind.
template <int Dim>
struct WithImages {
  std::vector<Vec<Dim>> points;
  std::vector<double> logWeights;
};

template <int Dim>
WithImages<Dim> withImages(const Generators<Dim>& generators, const Box<Dim>& box, double margin) {
  WithImages<Dim> all{{generators.points.begin(), generators.points.end()},
                      {generators.logWeights.begin(), generators.logWeights.end()}};
  for (int a = 0; a < Dim; ++a) {
    if (!box.isPeriodic(a)) continue;
    const double length = box.extent()[a];
    const int nPeriods = static_cast<int>(std::ceil(margin / length));
    const std::size_t count = all.points.size();  // images along earlier axes repeat along this one
    for (int period = -nPeriods; period <= nPeriods; ++period)
      for (std::size_t i = 0; i < count && period != 0; ++i) {
        Vec<Dim> image = all.points[i];
        image[a] += period * length;
        if (image[a] < box.lower[a] - margin || image[a] > box.upper[a] + margin) continue;
        all.points.push_back(image);
        if (!all.logWeights.empty()) all.logWeights.push_back(all.logWeights[i]);
      }
  }
  return all;
}

/// How far the empty spheres around the corners reach beyond periodic faces: an image that was left
/// out lies in none of them if that is no more than the margin.
template <int Dim>
double reachOf(const VoronoiFacets<Dim>& facets, std::span<const Vec<Dim>> points,
               const Box<Dim>& box) {
  double reach = 0;
  for (std::size_t f = 0; f < facets.facets.size(); ++f)
    for (const auto k : facets.cornersOf(f)) {
      const Vec<Dim>& corner = facets.corners[k];
      const double radius = norm(corner - points[facets.facets[f].a]);
      for (int a = 0; a < Dim; ++a)
        if (box.isPeriodic(a))
          reach = std::max(
              {reach, box.lower[a] - (corner[a] - radius), corner[a] + radius - box.upper[a]});
    }
  return reach;
}

/// No sphere without any image in it is wider than the diagonal of the periods.
template <int Dim>
double mostReach(const Box<Dim>& box) {
  double squares = 0;
  for (int a = 0; a < Dim; ++a)
    if (box.isPeriodic(a)) squares += box.extent()[a] * box.extent()[a];
  return std::sqrt(squares);
}

}  // namespace

template <int Dim>
std::vector<VoronoiCell<Dim>> voronoiCells(const Generators<Dim>& generators, const Box<Dim>& box,
                                           double margin) {
  if (!generators.logWeights.empty() && generators.logWeights.size() != generators.points.size())
    throw std::invalid_argument("voronoiCells: weights and points differ in number");
  if (box.anyPeriodic() && !(margin > 0))
    throw std::invalid_argument("voronoiCells: images need a margin > 0");
  for (const double most = mostReach(box);;) {
    const WithImages<Dim> all = withImages(generators, box, margin);
    const auto facets = voronoiFacets<Dim>(all.points, generators.n);
    const double reach = facets.isBounded ? reachOf<Dim>(facets, all.points, box) : most;
    if (reach > margin && margin < most) {
      margin = std::min(most, std::max(reach, 1.5 * margin));
      continue;
    }
    if (!facets.isBounded)
      throw std::invalid_argument(
          "voronoiCells: a cell reaches infinity; points all around must bound it");
    const Generators<Dim> imaged{all.points, generators.n, all.logWeights};
    const Cells<Dim> cells(imaged, facets);
    std::vector<VoronoiCell<Dim>> result(generators.n);
    forEachIndex(generators.n, [&](std::size_t i) { result[i] = cells.at(i); });
    return result;
  }
}

template std::vector<VoronoiCell<1>> voronoiCells(const Generators<1>&, const Box<1>&, double);
template std::vector<VoronoiCell<2>> voronoiCells(const Generators<2>&, const Box<2>&, double);
template std::vector<VoronoiCell<3>> voronoiCells(const Generators<3>&, const Box<3>&, double);

}  // namespace plenum
