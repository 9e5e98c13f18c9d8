// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/check_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

namespace {

constexpr double mostCells = 1e9;       // of a part's bounds; a run of more fills a cluster
constexpr double fewestAcross = 3;      // spacings; fewer show nothing of a shape
constexpr double coarsestFloat = 1e-3;  // steps of floats in d_ref that nobody sees
constexpr double farInSizes = 10;       // further away a shift is worth the while

template <int Dim>
std::vector<double> listOf(const Vec<Dim>& x) {
  return {x.components.begin(), x.components.end()};
}

/// The ending of an entry's file in lower case, "" for shapes and set operations.
std::string fileEnding(const CaseNode& entry) {
  const CaseNode* file = entry.find("file");
  if (file == nullptr || !file->isString()) return "";
  std::string ending = std::filesystem::path(file->asString()).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

/// True for files whose numbers may be of any unit.
bool statesNoUnit(const std::string& ending) {
  return !ending.empty() && ending != ".step" && ending != ".stp";
}

/// What a factor on lengths would be called that is there already, times `factor`.
std::string scaleKey(const CaseNode& entry, double factor) {
  const CaseNode* scale = entry.find("scale");
  return fmt::format("scale = {:g}", factor * (scale != nullptr ? scale->asNumber() : 1));
}

template <int Dim>
void checkSize(const CaseNode& entry, const Box<Dim>& bounds, double spacing, Findings& findings) {
  const Vec<Dim> extent = bounds.extent();
  double cells = 1, longest = 0;
  for (int a = 0; a < Dim; ++a) {
    cells *= std::max(1., extent[a] / spacing);
    longest = std::max(longest, extent[a]);
  }
  const std::string size =
      fmt::format("{}: is {:.4g} m large", entry.where(), fmt::join(listOf(extent), " x "));
  const bool mayBeMillimetres = statesNoUnit(fileEnding(entry));
  if (cells > mostCells)
    findings.add(
        {Severity::warning,
         fmt::format("{}, {:.3g} spacings along its longest side and {:.1e} in volume{}", size,
                     longest / spacing, cells, mayBeMillimetres ? ": in millimetres?" : ""),
         mayBeMillimetres
             ? fmt::format("if so, give {} beside file", scaleKey(entry, 1e-3))
             : std::string("check the unit of its lengths, which are metres, or make the "
                           "spacing larger"),
         listOf(bounds.center())});
  if (longest < fewestAcross * spacing)
    findings.add(
        {Severity::warning,
         fmt::format("{}, only {:.3g} spacings along its longest side", size, longest / spacing),
         fmt::format("make the spacing {:.3g} m or less, or check the unit ({} reads "
                     "metres as millimetres the other way round)",
                     longest / 10, scaleKey(entry, 1e3)),
         listOf(bounds.center())});
}

template <int Dim>
void checkDistance(const CaseNode& entry, const Box<Dim>& bounds, double spacing,
                   Findings& findings) {
  double furthest = 0;
  for (int a = 0; a < Dim; ++a)
    furthest = std::max({furthest, std::abs(bounds.lower[a]), std::abs(bounds.upper[a])});
  const double step = furthest * std::numeric_limits<float>::epsilon();
  if (!(step > coarsestFloat * spacing && furthest > farInSizes * norm(bounds.extent()))) return;
  std::vector<double> shift = listOf(-1.0 * bounds.center());
  if (const CaseNode* given = entry.find("translate"))
    for (std::size_t a = 0; a < shift.size(); ++a) shift[a] += given->asArray()[a].asNumber();
  findings.add(
      {Severity::warning,
       fmt::format("{}: lies {:.4g} m from the origin, where float numbers (binary STL, pictures, "
                   "pairs in mixed precision) have steps of {:.2g} m or {:.2g} d_ref",
                   entry.where(), furthest, step, step / spacing),
       fmt::format("move all parts to the origin alike, this one e.g. by translate = [{:.6g}]",
                   fmt::join(shift, ", ")),
       listOf(bounds.center())});
}

}  // namespace

template <int Dim>
std::vector<PartSize> checkParts(const CaseSettings& settings, const Regions<Dim>& regions,
                                 const SceneFrame<Dim>& frame, Findings& findings) {
  std::vector<PartSize> sizes;
  if (!regions.all()) return sizes;
  const GeometrySet<Dim>& all = *regions.all();
  for (std::size_t k = 0; k < all.names().size(); ++k) {
    if (!all[k]) continue;
    const Box<Dim> bounds = all[k]->bounds();
    bool isFinite = true;
    for (int a = 0; a < Dim; ++a)
      isFinite &= std::isfinite(bounds.lower[a]) && std::isfinite(bounds.upper[a]);
    if (!isFinite) continue;
    const CaseNode& entry = *settings.geometry->find(all.names()[k]);
    sizes.push_back({all.names()[k], all[k]->describe(), listOf(bounds.extent()),
                     listOf(bounds.extent() / frame.spacing)});
    checkSize(entry, bounds, frame.spacing, findings);
    checkDistance(entry, bounds, frame.spacing, findings);
  }
  return sizes;
}

template std::vector<PartSize> checkParts(const CaseSettings&, const Regions<1>&,
                                          const SceneFrame<1>&, Findings&);
template std::vector<PartSize> checkParts(const CaseSettings&, const Regions<2>&,
                                          const SceneFrame<2>&, Findings&);
template std::vector<PartSize> checkParts(const CaseSettings&, const Regions<3>&,
                                          const SceneFrame<3>&, Findings&);

}  // namespace plenum
