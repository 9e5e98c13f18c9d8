// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/picture_frame.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

constexpr Colour ink{30, 30, 30};
constexpr Colour faint{110, 110, 110};
constexpr double edge = 16;      // white around everything [px]
constexpr double gap = 7;        // between a tick and its number [px]
constexpr double tick = 5;       // length of a tick [px]
constexpr double barWidth = 18;  // [px]
constexpr double titleHeight = 26, infoHeight = 24, numberHeight = 14, nameHeight = 20;
constexpr double tallest = 1.0;  // plot height / plot width
constexpr double flattest = 0.12;
constexpr double shortForBar = 220;  // plots lower than that have their colour bar below [px]

const TextStyle numberStyle{.size = 14};
const TextStyle nameStyle{.size = 15};
const TextStyle titleStyle{.size = 19, .vertical = 0.5, .bold = true};
const TextStyle infoStyle{.size = 14, .colour = {90, 90, 90}};

TextStyle aligned(TextStyle style, double horizontal, double vertical) {
  style.horizontal = horizontal;
  style.vertical = vertical;
  return style;
}

double widest(const std::vector<std::string>& texts) {
  double width = 0;
  for (const std::string& text : texts) width = std::max(width, Canvas::widthOf(text, numberStyle));
  return width;
}

}  // namespace

PictureFrame::PictureFrame(const PlaneView& view, const FrameText& text, const ColourScale& scale,
                           int width, bool freeAspect)
    : view_(view), text_(text), scale_(scale) {
  place(width, freeAspect);
  canvas_ = std::make_unique<Canvas>(
      static_cast<int>(
          std::lround(plot_.right + (bar_.width() > 0 && barIsBelow_ ? edge : legendWidth()))),
      static_cast<int>(std::lround(
          (barIsBelow_
               ? bar_.bottom + tick + gap + numberHeight
               : plot_.bottom +
                     (text_.xName.empty() ? 0 : tick + gap + numberHeight + gap + nameHeight)) +
          edge)));
}

/// Makes a view that is too flat or too tall for a picture larger, about its centre.
void PictureFrame::growView(double minimalAspect) {
  const double height = std::max(view_.height(), minimalAspect * view_.width());
  const double width = std::max(view_.width(), view_.height() / 4);
  const double x = (view_.left + view_.right) / 2, y = (view_.bottom + view_.top) / 2;
  view_ = {x - width / 2, x + width / 2, y - height / 2, y + height / 2};
}

double PictureFrame::legendWidth() const {
  if (!text_.categories.empty()) {
    double width = Canvas::widthOf(text_.barName, nameStyle);
    for (const auto& [name, colour] : text_.categories)
      width = std::max(width, barWidth + gap + Canvas::widthOf(name, numberStyle));
    return edge + width + edge;
  }
  if (!text_.hasBar) return edge;
  return edge + barWidth + gap + widest(barTicks_.labels) + gap + nameHeight + edge;
}

void PictureFrame::place(int width, bool freeAspect) {
  const bool hasAxes = !text_.xName.empty();
  if (!freeAspect) growView(flattest);
  const double aspect = freeAspect ? 1 / 1.8 : view_.height() / view_.width();
  // Numbers decide how much room is left for the plot, the plot how many numbers there are: twice
  // is enough.
  double plotWidth = width - 160, plotHeight = 0, left = 0;
  for (int pass = 0; pass < 2; ++pass) {
    plotHeight = std::min(plotWidth * aspect, tallest * width);
    plotWidth = freeAspect ? plotWidth : plotHeight / aspect;
    xTicks_ = niceTicks(view_.left, view_.right, static_cast<int>(plotWidth / 110) + 1);
    yTicks_ = niceTicks(view_.bottom, view_.top, static_cast<int>(plotHeight / 100) + 1);
    barIsBelow_ = text_.hasBar && plotHeight < shortForBar;
    const double barLength = barIsBelow_ ? plotWidth : plotHeight;
    barTicks_ = niceTicks(scale_.lower, scale_.upper,
                          static_cast<int>(barLength / (barIsBelow_ ? 120 : 90)) + 1);
    left = hasAxes ? edge + nameHeight + gap + widest(yTicks_.labels) + gap + tick : edge;
    const double right = barIsBelow_ ? edge : legendWidth();
    const double most = width - left - right;
    plotWidth = std::min(most, freeAspect ? most : tallest * width / aspect);
  }
  plotHeight = plotWidth * aspect;
  plot_.left = std::round(left);
  plot_.top = edge + titleHeight + infoHeight;
  plot_.right = plot_.left + std::round(plotWidth);
  plot_.bottom = plot_.top + std::round(plotHeight);
  if (!text_.hasBar) return;
  if (barIsBelow_) {
    bar_.left = plot_.left;
    bar_.right = plot_.right;
    bar_.top = plot_.bottom + nameHeight + edge +
               (hasAxes ? tick + gap + numberHeight + gap + nameHeight : 0);
    bar_.bottom = bar_.top + barWidth;
  } else {
    bar_ = {plot_.right + edge, plot_.top, plot_.right + edge + barWidth, plot_.bottom};
  }
}

void PictureFrame::draw() {
  Canvas& c = *canvas_;
  const double room = c.width() - 2 * edge;
  c.text(edge, edge + titleHeight / 2 - 3, Canvas::shortened(text_.title, room, titleStyle),
         titleStyle);
  const double keyWidth = text_.showsWalls ? Canvas::widthOf("walls", infoStyle) + 18 : 0;
  const double y = edge + titleHeight + infoHeight / 2 - 5;
  const std::string info = Canvas::shortened(text_.info, room - keyWidth - gap, infoStyle);
  c.text(edge, y, info, infoStyle);
  if (text_.showsWalls) {
    const double x = edge + Canvas::widthOf(info, infoStyle) + 2 * gap;
    c.fill({x, y - 5, x + 11, y + 6}, wallGrey);
    c.text(x + 16, y, "walls", infoStyle);
  }
  if (!text_.xName.empty()) drawAxes();
  if (text_.hasBar) drawBar();
  if (!text_.categories.empty()) drawCategories();
}

void PictureFrame::drawAxes() {
  Canvas& c = *canvas_;
  c.outline(plot_, faint);
  for (std::size_t k = 0; k < xTicks_.at.size(); ++k) {
    const double x = std::floor(toX(xTicks_.at[k])) + 0.5;
    c.line(x, plot_.bottom, x, plot_.bottom + tick, faint);
    c.text(x, plot_.bottom + tick + gap, xTicks_.labels[k], aligned(numberStyle, 0.5, 0));
  }
  for (std::size_t k = 0; k < yTicks_.at.size(); ++k) {
    const double y = std::floor(toY(yTicks_.at[k])) + 0.5;
    c.line(plot_.left - tick, y, plot_.left, y, faint);
    c.text(plot_.left - tick - gap, y, yTicks_.labels[k], aligned(numberStyle, 1, 0.5));
  }
  c.text((plot_.left + plot_.right) / 2, plot_.bottom + tick + gap + numberHeight + gap,
         axisTitle(text_.xName, text_.xUnit, xTicks_.exponent), aligned(nameStyle, 0.5, 0));
  TextStyle upwards = aligned(nameStyle, 0.5, 0);
  upwards.upwards = true;
  c.text(edge, (plot_.top + plot_.bottom) / 2,
         axisTitle(text_.yName, text_.yUnit, yTicks_.exponent), upwards);
}

void PictureFrame::drawBar() {
  Canvas& c = *canvas_;
  const double length = barIsBelow_ ? bar_.width() : bar_.height();
  for (int k = 0; k < static_cast<int>(length); ++k) {
    const double t = scale_.upper > scale_.lower ? (k + 0.5) / length : 0.5;
    if (barIsBelow_)
      c.fill({bar_.left + k, bar_.top, bar_.left + k + 1, bar_.bottom}, sequentialColour(t));
    else
      c.fill({bar_.left, bar_.bottom - k - 1, bar_.right, bar_.bottom - k}, sequentialColour(t));
  }
  c.outline(bar_, faint);
  // Arrows past the ends say that there are values beyond.
  const double mx = (bar_.left + bar_.right) / 2, my = (bar_.top + bar_.bottom) / 2, r = 6, a = 9;
  if (scale_.cutAbove && barIsBelow_)
    c.triangle({bar_.right + 2, bar_.right + 2, bar_.right + 2 + a}, {my - r, my + r, my},
               sequentialColour(1));
  else if (scale_.cutAbove)
    c.triangle({mx - r, mx + r, mx}, {bar_.top - 2, bar_.top - 2, bar_.top - 2 - a},
               sequentialColour(1));
  if (scale_.cutBelow && barIsBelow_)
    c.triangle({bar_.left - 2, bar_.left - 2, bar_.left - 2 - a}, {my - r, my + r, my},
               sequentialColour(0));
  else if (scale_.cutBelow)
    c.triangle({mx - r, mx + r, mx}, {bar_.bottom + 2, bar_.bottom + 2, bar_.bottom + 2 + a},
               sequentialColour(0));
  for (std::size_t k = 0; k < barTicks_.at.size(); ++k) {
    const double range = scale_.upper - scale_.lower;
    const double t = range > 0 ? (barTicks_.at[k] - scale_.lower) / range : 0.5;
    if (barIsBelow_)
      c.text(bar_.left + t * length, bar_.bottom + gap, barTicks_.labels[k],
             aligned(numberStyle, 0.5, 0));
    else
      c.text(bar_.right + gap, bar_.bottom - t * length, barTicks_.labels[k],
             aligned(numberStyle, 0, 0.5));
  }
  const std::string name = axisTitle(text_.barName, text_.barUnit, barTicks_.exponent);
  if (barIsBelow_) {
    c.text(mx, bar_.top - gap, name, aligned(nameStyle, 0.5, 1));
  } else {
    TextStyle upwards = aligned(nameStyle, 0.5, 0);
    upwards.upwards = true;
    c.text(bar_.right + gap + widest(barTicks_.labels) + gap, my, name, upwards);
  }
}

void PictureFrame::drawCategories() {
  Canvas& c = *canvas_;
  double y = plot_.top + numberHeight;
  c.text(plot_.right + edge, y, text_.barName, nameStyle);
  for (const auto& [name, colour] : text_.categories) {
    y += 24;
    c.fill({plot_.right + edge, y - 7, plot_.right + edge + barWidth, y + 7}, colour);
    c.text(plot_.right + edge + barWidth + gap, y, name, numberStyle);
  }
}

}  // namespace plenum
