// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of a picture around its particles: where they stand and how they are drawn. Only
// particles/*.cpp include this.
#pragma once

#include "particles/picture_canvas.hpp"
#include "particles/picture_scale.hpp"
#include "particles/picture_values.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace plenum {

/// The part of the drawing plane that is shown (metres, or a field's unit along y in 1-D).
struct PlaneView {
  double left = 0;
  double right = 1;
  double bottom = 0;
  double top = 1;
  double width() const { return right - left; }
  double height() const { return top - bottom; }
};

/// What the frame needs to know of the picture.
struct FrameText {
  std::string title;
  std::string info;   ///< second line: time, counts
  std::string xName;  ///< axis titles without unit; both empty: no axes (3-D draws its own)
  std::string yName;
  std::string xUnit = "m";
  std::string yUnit = "m";
  bool showsWalls = false;
  /// Colour bar: name, unit and scale; or categories with their colours.
  std::string barName;
  std::string barUnit;
  bool hasBar = false;
  std::vector<std::pair<std::string, Colour>> categories;
};

/// Places plot, axes and colour bar on a canvas. The plot keeps the view's aspect unless
/// `freeAspect` asks for height = width / 1.8.
class PictureFrame {
 public:
  PictureFrame(const PlaneView& view, const FrameText& text, const ColourScale& scale, int width,
               bool freeAspect);

  Canvas& canvas() { return *canvas_; }
  const PixelBox& plot() const { return plot_; }
  double toX(double x) const {
    return plot_.left + (x - view_.left) / view_.width() * plot_.width();
  }
  double toY(double y) const {
    return plot_.bottom - (y - view_.bottom) / view_.height() * plot_.height();
  }
  double pixelsPerUnit() const { return plot_.width() / view_.width(); }

  /// Title, axes, colour bar: everything but the particles.
  void draw();

 private:
  void place(int width, bool freeAspect);
  void growView(double minimalAspect);
  void drawAxes();
  void drawBar();
  void drawCategories();
  double legendWidth() const;

  PlaneView view_;
  const FrameText& text_;
  const ColourScale& scale_;
  PixelBox plot_;
  PixelBox bar_;
  bool barIsBelow_ = false;
  Ticks xTicks_, yTicks_, barTicks_;
  std::unique_ptr<Canvas> canvas_;
};

}  // namespace plenum
