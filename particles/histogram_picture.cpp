// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/histogram_picture.hpp"

#include "particles/picture_canvas.hpp"
#include "particles/picture_scale.hpp"

#include <algorithm>

namespace plenum {

namespace {

// All in pixels.
constexpr int panelWidth = 560, plotHeight = 300, lineHeight = 22, margin = 24;
constexpr double leftOfPlot = 70, aboveAxis = 90, belowAxis = 58;

void drawAxes(Canvas& canvas, const PixelBox& plot, const HistogramPanel& panel, double most) {
  const double upper = panel.lower + panel.width * static_cast<double>(panel.share.size());
  const Ticks x = niceTicks(panel.lower, upper, 6);
  for (std::size_t k = 0; k < x.at.size(); ++k) {
    const double at = plot.left + (x.at[k] - panel.lower) / (upper - panel.lower) * plot.width();
    canvas.line(at, plot.bottom, at, plot.bottom + 5, {30, 30, 30});
    canvas.text(at, plot.bottom + 8, x.labels[k], {.size = 13, .horizontal = 0.5, .vertical = 0});
  }
  const Ticks y = niceTicks(0, 100 * most, 5);
  for (std::size_t k = 0; k < y.at.size(); ++k) {
    const double at = plot.bottom - y.at[k] / (100 * most) * plot.height();
    canvas.line(plot.left, at, plot.right, at, paleGrey);
    canvas.text(plot.left - 8, at, y.labels[k], {.size = 13, .horizontal = 1});
  }
  canvas.text(plot.left + plot.width() / 2, plot.bottom + 32,
              axisTitle(panel.xName, "", x.exponent),
              {.size = 14, .horizontal = 0.5, .vertical = 0});
  canvas.text(plot.left - 52, plot.top + plot.height() / 2,
              axisTitle("share of particles", "%", y.exponent),
              {.size = 14, .horizontal = 0.5, .vertical = 0.5, .upwards = true});
}

void drawPanel(Canvas& canvas, double left, const HistogramPanel& panel) {
  const PixelBox plot{left + leftOfPlot, aboveAxis, left + panelWidth - margin,
                      aboveAxis + plotHeight};
  canvas.text(plot.left, aboveAxis - 14, panel.title, {.size = 16, .vertical = 1});
  const double most =
      std::max(1e-6, 1.08 * *std::max_element(panel.share.begin(), panel.share.end()));
  drawAxes(canvas, plot, panel, most);
  const double bin = plot.width() / static_cast<double>(panel.share.size());
  for (std::size_t k = 0; k < panel.share.size(); ++k) {
    const double at = plot.left + bin * static_cast<double>(k);
    canvas.fill({at + 0.5, plot.bottom - panel.share[k] / most * plot.height(), at + bin - 0.5,
                 plot.bottom},
                sequentialColour(0.35));
  }
  canvas.outline(plot, {110, 110, 110});
  double y = plot.bottom + belowAxis + lineHeight / 2.0;
  for (const std::string& note : panel.notes) {
    const TextStyle style{.size = 14};
    canvas.text(plot.left, y, Canvas::shortened(note, plot.width(), style), style);
    y += lineHeight;
  }
}

}  // namespace

void drawHistograms(const std::filesystem::path& path, const std::string& title,
                    const std::vector<HistogramPanel>& panels) {
  std::size_t nNotes = 0;
  for (const HistogramPanel& panel : panels) nNotes = std::max(nNotes, panel.notes.size());
  const int width = panelWidth * static_cast<int>(panels.size()) + margin;
  const int height = static_cast<int>(aboveAxis + plotHeight + belowAxis) +
                     lineHeight * static_cast<int>(nNotes) + margin;
  Canvas canvas(width, height);
  const TextStyle style{.size = 20, .vertical = 0, .bold = true};
  canvas.text(margin, 18, Canvas::shortened(title, width - 2 * margin, style), style);
  for (std::size_t k = 0; k < panels.size(); ++k)
    drawPanel(canvas, panelWidth * static_cast<double>(k), panels[k]);
  canvas.save(path);
}

}  // namespace plenum
