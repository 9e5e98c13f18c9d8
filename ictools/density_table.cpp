// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/density_table.hpp"

#include "geometry/text_reader.hpp"
#include "particles/errors.hpp"
#include "particles/grey_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

/// Numbers of a file, `columns` a line; commas count as blanks, # begins a comment.
std::vector<double> readColumns(const std::filesystem::path& path, std::size_t columns) {
  std::string text = readWholeFile(path);
  std::replace(text.begin(), text.end(), ',', ' ');
  TextReader reader(text, path.string());
  std::vector<double> numbers;
  while (true) {
    const std::string_view word = reader.word('#');
    if (word.empty()) break;
    numbers.push_back(reader.toNumber(word));
  }
  if (numbers.empty() || numbers.size() % columns != 0)
    throw InputError(fmt::format("{}: holds {} numbers; {} a line are needed", path.string(),
                                 numbers.size(), columns));
  return numbers;
}

/// The places of the grid along an axis. Throws unless they are evenly spaced.
std::vector<double> axisPlaces(const std::vector<double>& numbers, std::size_t columns,
                               std::size_t axis, const std::string& source) {
  std::vector<double> places;
  for (std::size_t k = axis; k < numbers.size(); k += columns) places.push_back(numbers[k]);
  std::sort(places.begin(), places.end());
  const double near = 1e-6 * (places.back() - places.front());
  places.erase(
      std::unique(places.begin(), places.end(), [&](double a, double b) { return b - a <= near; }),
      places.end());
  if (places.size() < 2)
    throw InputError(fmt::format("{}: has one place along {} only; a grid needs two or more",
                                 source, "xyz"[axis]));
  const double step = (places.back() - places.front()) / static_cast<double>(places.size() - 1);
  for (std::size_t k = 0; k < places.size(); ++k)
    if (std::abs(places[k] - places.front() - step * static_cast<double>(k)) > 1e-3 * step)
      throw InputError(
          fmt::format("{}: places along {} are not evenly spaced near {:g}; resample "
                      "the table to a regular grid",
                      source, "xyz"[axis], places[k]));
  return places;
}

}  // namespace

template <int Dim>
double GridTable<Dim>::at(const Vec<Dim>& x) const {
  std::array<std::size_t, Dim> cell;
  Vec<Dim> t;
  for (int a = 0; a < Dim; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const double last = static_cast<double>(shape[axis] - 1);
    double s = (x[a] - lower[a]) / step[a];
    if (!(s >= -1e-6 && s <= last + 1e-6)) return nowhere;
    s = std::clamp(s, 0.0, last);
    cell[axis] = std::min(static_cast<std::size_t>(s), shape[axis] - 2);
    t[a] = s - static_cast<double>(cell[axis]);
  }
  double sum = 0;
  for (unsigned corner = 0; corner < (1u << Dim); ++corner) {
    double weight = 1;
    std::size_t index = 0;
    for (int a = Dim - 1; a >= 0; --a) {
      const auto axis = static_cast<std::size_t>(a);
      const bool next = (corner >> a & 1u) != 0;
      weight *= next ? t[a] : 1 - t[a];
      index = index * shape[axis] + cell[axis] + (next ? 1 : 0);
    }
    sum += weight * value[index];
  }
  return sum;
}

template <int Dim>
GridTable<Dim> readGridTable(const std::filesystem::path& path) {
  constexpr std::size_t columns = Dim + 1;
  const std::vector<double> numbers = readColumns(path, columns);
  GridTable<Dim> table;
  std::size_t size = 1;
  for (std::size_t a = 0; a < Dim; ++a) {
    const auto places = axisPlaces(numbers, columns, a, path.string());
    const int axis = static_cast<int>(a);
    table.shape[a] = places.size();
    table.lower[axis] = places.front();
    table.step[axis] = (places.back() - places.front()) / static_cast<double>(places.size() - 1);
    size *= places.size();
  }
  const std::size_t nLines = numbers.size() / columns;
  table.value.assign(size, nowhere);
  for (std::size_t line = 0; line < nLines; ++line) {
    const double* number = &numbers[line * columns];
    std::size_t index = 0;
    for (std::size_t a = Dim; a-- > 0;) {
      const int axis = static_cast<int>(a);
      const double s = std::round((number[a] - table.lower[axis]) / table.step[axis]);
      index = index * table.shape[a] + static_cast<std::size_t>(s);
    }
    table.value[index] = number[Dim];
  }
  const auto missing =
      std::count_if(table.value.begin(), table.value.end(), [](double v) { return std::isnan(v); });
  if (missing > 0 || nLines != size)
    throw InputError(
        fmt::format("{}: {} lines for a grid of {} points, {} points without a value; "
                    "give each point once",
                    path.string(), nLines, size, missing));
  return table;
}

GridTable<2> readImage(const std::filesystem::path& path) {
  openFile(path);  // says so if it is missing, empty or a folder
  GreyImage image = readGreyImage(path);
  GridTable<2> table;
  table.shape = {image.width, image.height};
  table.step = Vec<2>::filled(1);
  table.value = std::move(image.grey);
  return table;
}

double RadialTable::at(double r) const {
  if (!(r >= radius.front() && r <= radius.back())) return nowhere;
  const auto next = std::upper_bound(radius.begin(), radius.end() - 1, r) - radius.begin();
  const auto k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(next, 1));
  const double t = (r - radius[k - 1]) / (radius[k] - radius[k - 1]);
  return value[k - 1] + t * (value[k] - value[k - 1]);
}

RadialTable readRadialTable(const std::filesystem::path& path) {
  const std::vector<double> numbers = readColumns(path, 2);
  RadialTable table;
  for (std::size_t k = 0; k < numbers.size(); k += 2) {
    if (k > 0 && !(numbers[k] > table.radius.back()))
      throw InputError(fmt::format("{}: radius {:g} follows on {:g}; radii must rise",
                                   path.string(), numbers[k], table.radius.back()));
    table.radius.push_back(numbers[k]);
    table.value.push_back(numbers[k + 1]);
  }
  if (table.radius.size() < 2)
    throw InputError(path.string() + ": needs at least two lines of radius and density");
  return table;
}

template struct GridTable<1>;
template struct GridTable<2>;
template struct GridTable<3>;
template GridTable<1> readGridTable(const std::filesystem::path&);
template GridTable<2> readGridTable(const std::filesystem::path&);
template GridTable<3> readGridTable(const std::filesystem::path&);

}  // namespace plenum
