// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/chart_script.hpp"

#include "studies/gnuplot.hpp"
#include "studies/numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plenum::study {

namespace {

/// Colours that people who see few of them can still tell apart (Okabe & Ito 2008, then Tol 2021),
/// one for each kernel, and a point type for each.
constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00",
                             "#56b4e9", "#000000", "#7f7f7f", "#8b5a2b", "#882255",
                             "#999933", "#332288", "#88ccee"};
constexpr std::array pointTypes{7, 5, 9, 11, 13, 15, 6, 4, 8, 10, 12, 14, 2};

/// Ends of an axis: those that are asked for, or the values' own with some room. A logarithmic axis
/// would else begin and end with powers of ten.
std::string rangeOf(const char* axis, const Axis& of, std::vector<double> values) {
  std::erase_if(values,
                [&](double v) { return !std::isfinite(v) || (of.isLogarithmic && v <= 0); });
  std::optional<double> lowest = of.lowest, highest = of.highest;
  if (of.isLogarithmic && !values.empty()) {
    const auto [least, most] = std::ranges::minmax(values);
    const double room = std::pow(std::max(most / least, 1.2), 0.06);
    if (!lowest) lowest = least / room;
    if (!highest) highest = most * room;
  }
  const auto end = [](std::optional<double> value) {
    return value ? fmt::format("{}", *value) : std::string("*");
  };
  return fmt::format("set {}range [{}:{}]\n", axis, end(lowest), end(highest));
}

/// Round values of a logarithmic axis among those of the points: powers of ten, 1, 2, 5 times
/// those, or equal steps where the points lie close together.
std::vector<double> ticsBetween(double lowest, double highest) {
  std::vector<double> tics;
  if (highest < 1.02 * lowest) return {lowest};
  if (highest < 8 * lowest) {
    const double step = roundedDown((highest - lowest) / 3);
    for (double k = std::ceil(lowest / step); k * step <= highest; ++k) tics.push_back(k * step);
    return tics;
  }
  const bool isWide = highest / lowest > 300;
  for (double power = std::pow(10, std::floor(std::log10(lowest))); power <= 10 * highest;
       power *= 10)
    for (const double factor : {1.0, 2.0, 5.0})
      if ((!isWide || factor == 1) && power * factor >= lowest / 2.6 &&
          power * factor <= highest * 2.6)
        tics.push_back(power * factor);
  return tics;
}

std::string ticsAmong(std::vector<double> values, std::optional<double> zero) {
  std::erase_if(values, [&](double v) { return !(v > 0) || !std::isfinite(v) || v == zero; });
  std::vector<std::string> tics;
  if (zero) tics.push_back(fmt::format("'0' {:.6g}", *zero));
  if (!values.empty()) {
    const auto [lowest, highest] = std::ranges::minmax(values);
    for (const double tic : ticsBetween(lowest, highest))
      if (!zero || tic > 1.5 * *zero) tics.push_back(fmt::format("{:.3g}", tic));
  }
  return fmt::format("{}", fmt::join(tics, ", "));
}

std::string axisScript(const char* axis, const Axis& of, const std::vector<double>& values) {
  std::string text = fmt::format("set {}label {} noenhanced\n", axis, quotedForGnuplot(of.label));
  if (of.isLogarithmic)
    text += fmt::format("set logscale {0}\nset format {0} '%g'\nset {0}tics ({1})\n", axis,
                        ticsAmong(values, of.zero));
  return text + rangeOf(axis, of, values);
}

/// Between quotation marks in a block of data. Marks become those of print, which mean nothing to
/// gnuplot, nor to the scripts that it puts around tool tips.
std::string quotedInBlock(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) switch (c) {
      case '"':
        quoted += "\u201d";
        break;
      case '\'':
        quoted += "\u2019";
        break;
      case '\n':
      case '\\':
        quoted += ' ';
        break;
      default:
        quoted += c;
    }
  return quoted + "\"";
}

std::string block(std::size_t s, const Series& series) {
  std::string text = fmt::format("$series{} << END_OF_SERIES\n", s);
  for (const ChartPoint& point : series.points)
    text += fmt::format("{} {} {}\n", point.x, point.y,
                        point.label.empty() ? "\" \"" : quotedInBlock(point.label));
  return text + "END_OF_SERIES\n";
}

/// What stands after `plot` for one series.
std::vector<std::string> plotsOf(std::size_t s, std::size_t colour, const Series& series,
                                 bool hasTips) {
  const std::string data = fmt::format("$series{} using 1:2", s);
  const std::string paint = fmt::format("lc rgb '{}'", colours[colour % colours.size()]);
  const std::string points = fmt::format("pt {} ps 1.1", pointTypes[colour % pointTypes.size()]);
  const std::string title = series.name.empty()
                                ? "notitle"
                                : fmt::format("title {} noenhanced", quotedForGnuplot(series.name));
  std::vector<std::string> plots;
  switch (series.style) {
    case SeriesStyle::points:
      plots.push_back(fmt::format("{} with points {} {} {}", data, points, paint, title));
      break;
    case SeriesStyle::line:
      plots.push_back(fmt::format("{} with lines lw 1.6 {} {}", data, paint, title));
      break;
    case SeriesStyle::dashed:
      plots.push_back(fmt::format("{} with lines lw 1.6 dt 2 {} {}", data, paint, title));
      break;
    case SeriesStyle::linesAndPoints:
      plots.push_back(
          fmt::format("{} with linespoints lw 1.6 {} {} {}", data, points, paint, title));
      break;
  }
  const bool isTipped =
      std::ranges::any_of(series.points, [](const ChartPoint& p) { return !p.label.empty(); });
  if (hasTips && isTipped)
    plots.push_back(
        fmt::format("$series{} using 1:2:3 with labels hypertext noenhanced point pt 7 "
                    "ps 1.1 lc rgb '#ff000000' notitle",
                    s));
  if (series.isNumbered)
    plots.push_back(
        fmt::format("$series{} using 1:2:(sprintf('%d', $0 + 1)) with labels left offset .6,.6 "
                    "font ',9' textcolor rgb '#444444' notitle",
                    s));
  return plots;
}

/// A line without a name goes with the series before it.
std::vector<std::size_t> coloursOf(const std::vector<Series>& all) {
  std::vector<std::size_t> places;
  std::size_t next = 0;
  for (const Series& series : all) {
    if (!series.name.empty()) ++next;
    places.push_back(next == 0 ? 0 : next - 1);
  }
  return places;
}

constexpr const char* common = R"(set encoding utf8
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#e4e4e4' lt 1
set key outside right top
)";

}  // namespace

ChartSize sizeOf(const Chart&) { return {}; }

ChartSize sizeOf(const HeatMap& map) {
  std::size_t longest = 0;  // of the texts in cells, of some 8 pixels a letter
  for (const auto& row : map.texts)
    for (const std::string& text : row) longest = std::max(longest, text.size());
  const int width = std::max(62, 8 * static_cast<int>(longest));
  return {std::max(520, 330 + width * static_cast<int>(map.columns.size())),
          std::max(260, 150 + 30 * static_cast<int>(map.rows.size()))};
}

std::string scriptOf(const Chart& chart, bool hasTips) {
  std::vector<double> xs, ys;
  for (const Series& series : chart.series)
    for (const ChartPoint& point : series.points) {
      xs.push_back(point.x);
      ys.push_back(point.y);
    }
  std::string text = common;
  text += fmt::format("set title {} noenhanced\n", quotedForGnuplot(chart.title));
  text += axisScript("x", chart.x, xs) + axisScript("y", chart.y, ys);
  const std::vector<std::size_t> places = coloursOf(chart.series);
  std::vector<std::string> plots;
  for (std::size_t s = 0; s < chart.series.size(); ++s) {
    if (chart.series[s].points.empty()) continue;
    text += block(s, chart.series[s]);
    for (std::string& plot : plotsOf(s, places[s], chart.series[s], hasTips))
      plots.push_back(std::move(plot));
  }
  return text + fmt::format("plot {}\n", fmt::join(plots, ", \\\n  "));
}

namespace {

/// From white to deep blue: one hue, darker as values rise; readable in grey.
constexpr const char* palette =
    "set palette defined (0 '#f7fbff', .25 '#c6dbef', .5 '#6baed6', .75 '#2171b5', 1 '#08306b')\n";

std::string tics(const char* axis, const std::vector<std::string>& names) {
  std::vector<std::string> entries;
  for (std::size_t k = 0; k < names.size(); ++k)
    entries.push_back(fmt::format("{} {}", quotedForGnuplot(names[k]), k));
  return fmt::format("set {}tics ({}) noenhanced\nset {}range [-.5:{}]\n", axis,
                     fmt::join(entries, ", "), axis, static_cast<double>(names.size()) - 0.5);
}

std::string cellText(const HeatMap& map, std::size_t r, std::size_t c) {
  if (!map.texts.empty()) return map.texts[r][c];
  const double value = map.values[r][c];
  return std::isfinite(value) ? fmt::format("{:.2g}", value) : "";
}

}  // namespace

std::string scriptOf(const HeatMap& map, bool) {
  std::vector<double> all;
  for (const auto& row : map.values)
    for (const double value : row)
      if (std::isfinite(value)) all.push_back(value);
  const auto [least, most] =
      all.empty() ? std::ranges::min_max_result<double>{0, 1} : std::ranges::minmax(all);
  const double lowest = map.lowest.value_or(least);
  const double highest = std::max(map.highest.value_or(most), lowest + 1e-12);
  std::string text = common;
  text += fmt::format("{}set title {} noenhanced\nset cblabel {} noenhanced\nset cbrange [{}:{}]\n",
                      palette, quotedForGnuplot(map.title), quotedForGnuplot(map.valueLabel),
                      lowest, highest);
  text += fmt::format("set xlabel {} noenhanced\nset ylabel {} noenhanced\nunset grid\nunset key\n",
                      quotedForGnuplot(map.columnLabel), quotedForGnuplot(map.rowLabel));
  text += tics("x", map.columns) + tics("y", map.rows);
  text += fmt::format("set yrange [{}:-.5]\n", static_cast<double>(map.rows.size()) - 0.5);
  text +=
      "set object 1 rectangle from graph 0,0 to graph 1,1 behind fillcolor rgb '#d9d9d9' fillstyle "
      "solid noborder\n";
  std::string cells = "$cells << END_OF_CELLS\n", texts = "$texts << END_OF_TEXTS\n";
  for (std::size_t r = 0; r < map.rows.size(); ++r)
    for (std::size_t c = 0; c < map.columns.size(); ++c) {
      const double value = map.values[r][c];
      if (std::isfinite(value)) cells += fmt::format("{} {} {}\n", c, r, value);
      const bool isDark = std::isfinite(value) && (value - lowest) / (highest - lowest) > 0.55;
      const std::string shown = cellText(map, r, c);
      if (!shown.empty())
        texts +=
            fmt::format("{} {} {} {}\n", c, r, quotedInBlock(shown), isDark ? 0xffffff : 0x222222);
    }
  const std::string boxes =
      all.empty()
          ? ""
          : "$cells using 1:2:(.5):(.5):3 with boxxyerror fillstyle solid noborder palette, ";
  return text + cells + "END_OF_CELLS\n" + texts + "END_OF_TEXTS\n" +
         fmt::format(
             "plot {}$texts using 1:2:3:4 with labels noenhanced font ',9' textcolor rgb "
             "variable\n",
             boxes);
}

}  // namespace plenum::study
