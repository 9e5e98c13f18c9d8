// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/maps/onset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plenum::study {

std::vector<PairedRange> pairedRanges(std::vector<double> places, std::vector<double> shares) {
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::size_t k) { return places[k]; });
  std::vector<PairedRange> ranges;
  bool wasPaired = false;
  double last = order.empty() ? 0 : places[order.front()];
  for (const std::size_t k : order) {
    const bool isPaired = std::isnan(shares[k]) || shares[k] > pairedShare;
    if (isPaired && !wasPaired) ranges.push_back({last, places[k], places[k], places[k]});
    if (wasPaired) ranges.back().after = places[k];
    if (isPaired) ranges.back().to = places[k];
    wasPaired = isPaired;
    last = places[k];
  }
  return ranges;
}

std::string onsetSentence(const std::vector<double>& places, const std::vector<double>& shares,
                          const std::string& axis) {
  const std::vector<PairedRange> ranges = pairedRanges(places, shares);
  if (ranges.empty()) return "no pairs at any " + axis + " of the map";
  std::string text;
  for (const PairedRange& range : ranges) {
    text += text.empty() ? "pairs from " + axis + " " : ", and again from ";
    text += range.before < range.from ? fmt::format("{:g} - {:g} on", range.before, range.from)
                                      : fmt::format("{:g}, the least of the map, on", range.from);
    if (range.to < range.after) text += fmt::format(" up to {:g} - {:g}", range.to, range.after);
  }
  return text;
}

}  // namespace plenum::study
