// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/chart.hpp"

#include "particles/atomic_file.hpp"
#include "studies/chart_script.hpp"
#include "studies/gnuplot.hpp"

#include <fmt/format.h>

#include <regex>

namespace plenum::study {

namespace {

/// Hypertext, which gnuplot shows by a script, as titles, which browsers show by themselves.
std::string withTitles(const std::string& svg) {
  static const std::regex hypertext(
      R"re(<g onmousemove="gnuplot_svg.showHypertext\(evt,'([^']*)'\)" onmouseout="[^"]*"><title> </title>)re");
  return std::regex_replace(svg, hypertext, "<g><title>$1</title>");
}

/// From <svg on, with names that no other chart of a page has.
std::string forPage(const std::string& svg, const std::string& prefix) {
  std::string inner = svg.substr(std::min(svg.find("<svg"), svg.size()));
  inner = std::regex_replace(inner, std::regex(R"re(\bid=(["']))re"), "id=$1" + prefix + "_");
  inner = std::regex_replace(inner, std::regex(R"re(href=(["'])#)re"), "href=$1#" + prefix + "_");
  return std::regex_replace(inner, std::regex(R"re(url\(#)re"), "url(#" + prefix + "_");
}

template <class Drawing>
std::string drawnAs(const char* terminal, const Drawing& drawing, bool hasTips, int scale) {
  const ChartSize size = sizeOf(drawing);
  return gnuplot(
      fmt::format("set terminal {} size {},{} {} font 'DejaVu Sans,{}'\n{}", terminal,
                  scale * size.width, scale * size.height,
                  scale == 1 ? "background rgb 'white'" : fmt::format("fontscale {}", scale), 11,
                  scriptOf(drawing, hasTips)));
}

template <class Drawing>
std::string svgFor(const Drawing& drawing, const std::string& prefix) {
  return forPage(withTitles(drawnAs("svg dynamic", drawing, true, 1)), prefix);
}

template <class Drawing>
void write(const std::filesystem::path& path, const Drawing& drawing) {
  std::filesystem::create_directories(std::filesystem::absolute(path).parent_path());
  writeTextFile(path.string() + ".svg", withTitles(drawnAs("svg", drawing, true, 1)));
  writeTextFile(path.string() + ".png", drawnAs("pngcairo noenhanced", drawing, false, 1));
}

}  // namespace

std::string svgOf(const Chart& chart, const std::string& prefix) { return svgFor(chart, prefix); }
std::string svgOf(const HeatMap& map, const std::string& prefix) { return svgFor(map, prefix); }
void writeChart(const std::filesystem::path& path, const Chart& chart) { write(path, chart); }
void writeChart(const std::filesystem::path& path, const HeatMap& map) { write(path, map); }

}  // namespace plenum::study
