// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace plenum {

/// One named figure of a state: a cell of history.csv.
struct Figure {
  std::string name;
  std::string unit;
  double value = 0;  ///< NaN: there is nothing to measure now; an empty cell
};

/// The value of a named figure. Throws std::out_of_range if there is none.
double valueOf(const std::vector<Figure>& figures, const std::string& name);

/// Throws InputError if two figures have the same name.
void requireDistinct(const std::vector<Figure>& figures);

/// "name = value unit" in columns, one line a figure; "-" where there is nothing to measure.
std::string printed(const std::vector<Figure>& figures);

/// Pressure and volume in `dim` dimensions, in which a density is in kg/m^d.
std::string pressureUnit(int dim);
std::string volumeUnit(int dim);

}  // namespace plenum
