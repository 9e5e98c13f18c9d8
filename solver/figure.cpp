// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/figure.hpp"

#include "particles/errors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace plenum {

double valueOf(const std::vector<Figure>& figures, const std::string& name) {
  for (const Figure& figure : figures)
    if (figure.name == name) return figure.value;
  throw std::out_of_range("no figure is called " + name);
}

void requireDistinct(const std::vector<Figure>& figures) {
  std::set<std::string> names;
  for (const Figure& figure : figures)
    if (!names.insert(figure.name).second)
      throw InputError(
          fmt::format("measures: two columns of history.csv would be called \"{}\"; give a measure "
                      "another name, or leave one of them out",
                      figure.name));
}

std::string printed(const std::vector<Figure>& figures) {
  std::string text;
  for (const Figure& f : figures)
    text += fmt::format("  {:<20} {:>12} {}\n", f.name,
                        std::isnan(f.value) ? "-" : fmt::format("{:.6g}", f.value), f.unit);
  return text;
}

std::string pressureUnit(int dim) { return dim == 3 ? "Pa" : dim == 2 ? "Pa m" : "Pa m^2"; }

std::string volumeUnit(int dim) { return dim == 3 ? "m^3" : dim == 2 ? "m^2" : "m"; }

}  // namespace plenum
