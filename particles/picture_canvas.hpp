// SPDX-License-Identifier: GPL-3.0-or-later
//
// A drawing surface of pixels with lines, text and disks. Only particles/*.cpp include this.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

typedef struct _cairo cairo_t;
typedef struct _cairo_surface cairo_surface_t;

namespace plenum {

/// Red, green and blue, 0 to 255 (sRGB).
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  constexpr bool operator==(const Colour&) const = default;
};

/// Pixels [left, right) x [top, bottom).
struct PixelBox {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

struct TextStyle {
  double size = 15;       ///< [px]
  double horizontal = 0;  ///< 0: starts at the point, 0.5: centred, 1: ends there
  double vertical = 0.5;  ///< 0: hangs below the point, 0.5: centred, 1: stands on it
  bool bold = false;
  bool upwards = false;  ///< turned by 90 degrees, reading upwards
  Colour colour = {30, 30, 30};
};

/// x to the right, y downwards [px], white at first.
class Canvas {
 public:
  Canvas(int width, int height);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }

  void line(double x0, double y0, double x1, double y1, Colour colour, double thickness = 1);
  void fill(const PixelBox& box, Colour colour);
  void outline(const PixelBox& box, Colour colour);
  void triangle(const double (&x)[3], const double (&y)[3], Colour colour);
  void text(double x, double y, const std::string& text, const TextStyle& style);

  /// Width of a line of text [px].
  static double widthOf(const std::string& text, const TextStyle& style);
  /// The text, shortened with dots if it is wider than `width` [px].
  static std::string shortened(std::string text, double width, const TextStyle& style);

  /// The pixels as 0xffRRGGBB for direct drawing between `pixels` and `pixelsDone`.
  std::uint32_t* pixels(int& stride);
  void pixelsDone();

  /// Writes a PNG; it appears under its name only when it is complete. Throws RunError.
  void save(const std::filesystem::path& path) const;

 private:
  void use(Colour colour);

  int width_;
  int height_;
  cairo_surface_t* surface_;
  cairo_t* cairo_;
};

/// A disk of a given diameter, rendered once with soft edges and then stamped many times; drawing a
/// million particles takes a fraction of a second.
class DiskStamp {
 public:
  /// `shaded` makes it look like a ball lit from the upper left.
  DiskStamp(double diameter, bool shaded);

  /// Stamps the disk with its centre at (x, y), cut to `clip`.
  void draw(std::uint32_t* pixels, int stride, const PixelBox& clip, double x, double y,
            Colour colour) const;

 private:
  struct Texel {
    std::uint8_t coverage;
    std::uint8_t light;
  };
  int size_;       ///< edge of a mask [px]
  int positions_;  ///< places of the centre within a pixel, per axis
  std::vector<Texel> masks_;
};

}  // namespace plenum
