// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/report.hpp"

#include "particles/histogram_picture.hpp"

#include <fmt/format.h>

namespace plenum {

namespace {

HistogramPanel panelOf(const Histogram& histogram, std::string title, std::string xName,
                       double scale) {
  return {std::move(title),        std::move(xName), scale * histogram.lower,
          scale * histogram.width, histogram.share,  {}};
}

}  // namespace

void drawReport(const std::filesystem::path& path, const Report& report) {
  HistogramPanel distances =
      panelOf(report.nearestHistogram, "distance to the nearest particle", "d_ref", 1);
  distances.notes = {
      fmt::format("least {:.3f}, mean {:.3f} of the fluid", report.nearest.least,
                  report.nearest.mean),
      fmt::format("overlaps {}, isolated {}", report.nOverlaps, report.nIsolated),
      fmt::format("{} {:.3f}", report.dimension == 3 ? "q_6" : "psi_6", report.bondOrder)};
  HistogramPanel density = panelOf(report.densityHistogram, "density by summation, inside",
                                   "deviation from the density meant [%]", 100);
  for (std::size_t p = 0; p < nPlaces; ++p) {
    const PlaceFigures& f = report.places[p];
    if (f.n > 0)
      density.notes.push_back(fmt::format("{}: bias {:+.3f} %, scatter {:.3f} %, worst {:.3f} %",
                                          nameOf(Place(p)), 100 * f.bias, 100 * f.scatter,
                                          100 * f.worst));
  }
  const std::string title = report.title.empty() ? "Report card" : report.title;
  drawHistograms(
      path,
      fmt::format("{}: {} particles, {}, h = {:g} d_ref", title, report.nFluid + report.nWalls,
                  report.kernel, report.smoothingLength / report.spacing),
      {distances, density});
}

}  // namespace plenum
