// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "studies/chart.hpp"

#include <string>

namespace plenum::study {

/// The gnuplot script of a chart, without terminal and output. With `hasTips` the labels of points
/// become hypertext.
std::string scriptOf(const Chart& chart, bool hasTips);
std::string scriptOf(const HeatMap& map, bool hasTips);

/// Width and height that a chart wants [pixels].
struct ChartSize {
  int width = 900, height = 560;
};
ChartSize sizeOf(const Chart& chart);
ChartSize sizeOf(const HeatMap& map);

}  // namespace plenum::study
