// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/picture_canvas.hpp"

#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>

namespace plenum {

namespace {

void chooseFont(cairo_t* cairo, const TextStyle& style) {
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, style.size);
}

}  // namespace

Canvas::Canvas(int width, int height)
    : width_(width),
      height_(height),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
      cairo_(cairo_create(surface_)) {
  if (cairo_status(cairo_) != CAIRO_STATUS_SUCCESS)
    throw RunError(std::string("a picture cannot be drawn: ") +
                   cairo_status_to_string(cairo_status(cairo_)));
  fill({0, 0, static_cast<double>(width), static_cast<double>(height)}, {255, 255, 255});
}

Canvas::~Canvas() {
  cairo_destroy(cairo_);
  cairo_surface_destroy(surface_);
}

void Canvas::use(Colour colour) {
  cairo_set_source_rgb(cairo_, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
}

void Canvas::line(double x0, double y0, double x1, double y1, Colour colour, double thickness) {
  use(colour);
  cairo_set_line_width(cairo_, thickness);
  cairo_move_to(cairo_, x0, y0);
  cairo_line_to(cairo_, x1, y1);
  cairo_stroke(cairo_);
}

void Canvas::fill(const PixelBox& box, Colour colour) {
  use(colour);
  cairo_rectangle(cairo_, box.left, box.top, box.width(), box.height());
  cairo_fill(cairo_);
}

void Canvas::outline(const PixelBox& box, Colour colour) {
  use(colour);
  cairo_set_line_width(cairo_, 1);
  cairo_rectangle(cairo_, std::floor(box.left) - 0.5, std::floor(box.top) - 0.5,
                  std::ceil(box.width()) + 1, std::ceil(box.height()) + 1);
  cairo_stroke(cairo_);
}

void Canvas::triangle(const double (&x)[3], const double (&y)[3], Colour colour) {
  use(colour);
  cairo_move_to(cairo_, x[0], y[0]);
  cairo_line_to(cairo_, x[1], y[1]);
  cairo_line_to(cairo_, x[2], y[2]);
  cairo_close_path(cairo_);
  cairo_fill(cairo_);
}

void Canvas::text(double x, double y, const std::string& text, const TextStyle& style) {
  chooseFont(cairo_, style);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo_, text.c_str(), &extents);
  use(style.colour);
  cairo_save(cairo_);
  cairo_translate(cairo_, x, y);
  if (style.upwards) cairo_rotate(cairo_, -std::numbers::pi / 2);
  // Capitals are .73 of the size high; taking that for all text keeps lines of text level.
  cairo_move_to(cairo_, -style.horizontal * extents.x_advance,
                (1 - style.vertical) * 0.73 * style.size);
  cairo_show_text(cairo_, text.c_str());
  cairo_restore(cairo_);
}

double Canvas::widthOf(const std::string& text, const TextStyle& style) {
  static const Canvas scratch(1, 1);
  chooseFont(scratch.cairo_, style);
  cairo_text_extents_t extents;
  cairo_text_extents(scratch.cairo_, text.c_str(), &extents);
  return extents.x_advance;
}

std::string Canvas::shortened(std::string text, double width, const TextStyle& style) {
  if (widthOf(text, style) <= width) return text;
  const auto isContinuation = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };
  do {
    while (!text.empty() && isContinuation(text.back())) text.pop_back();
    if (!text.empty()) text.pop_back();
  } while (!text.empty() && widthOf(text + "…", style) > width);
  return text + "…";
}

std::uint32_t* Canvas::pixels(int& stride) {
  cairo_surface_flush(surface_);
  stride = cairo_image_surface_get_stride(surface_) / 4;
  return reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(surface_));
}

void Canvas::pixelsDone() { cairo_surface_mark_dirty(surface_); }

void Canvas::save(const std::filesystem::path& path) const {
  struct Sink {
    AtomicFile file;
    std::exception_ptr error;
  } sink{AtomicFile(path), nullptr};
  const auto take = [](void* closure, const unsigned char* data, unsigned int n) {
    auto* to = static_cast<Sink*>(closure);
    try {
      to->file.write(data, n);
      return CAIRO_STATUS_SUCCESS;
    } catch (...) {  // must not pass through cairo's C code
      to->error = std::current_exception();
      return CAIRO_STATUS_WRITE_ERROR;
    }
  };
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface_, take, &sink);
  if (sink.error) std::rethrow_exception(sink.error);
  if (status != CAIRO_STATUS_SUCCESS)
    throw RunError(path.string() + ": cannot be written: " + cairo_status_to_string(status));
  sink.file.commit();
}

DiskStamp::DiskStamp(double diameter, bool shaded)
    : size_(static_cast<int>(std::ceil(diameter)) + 2), positions_(diameter < 48 ? 4 : 1) {
  const double radius = diameter / 2;
  constexpr int fine = 4;  // samples per pixel and axis
  masks_.resize(static_cast<std::size_t>(size_) *
                static_cast<std::size_t>(size_ * positions_ * positions_));
  auto texel = masks_.begin();
  for (int py = 0; py < positions_; ++py)
    for (int px = 0; px < positions_; ++px) {
      const double cx = size_ / 2 + (px + 0.5) / positions_;
      const double cy = size_ / 2 + (py + 0.5) / positions_;
      for (int y = 0; y < size_; ++y)
        for (int x = 0; x < size_; ++x, ++texel) {
          int hits = 0;
          for (int s = 0; s < fine * fine; ++s) {
            const double dx = x + (s % fine + 0.5) / fine - cx;
            const double dy = y + (s / fine + 0.5) / fine - cy;
            hits += dx * dx + dy * dy <= radius * radius ? 1 : 0;
          }
          texel->coverage = static_cast<std::uint8_t>(hits * 255 / (fine * fine));
          const double nx = (x + 0.5 - cx) / radius, ny = (y + 0.5 - cy) / radius;
          const double nz = std::sqrt(std::max(0.0, 1 - nx * nx - ny * ny));
          const double light =
              std::clamp(0.62 + 0.45 * (0.8 * nz - 0.35 * nx - 0.5 * ny), 0.35, 1.0);
          texel->light = static_cast<std::uint8_t>(shaded ? 255 * light : 255);
        }
    }
}

void DiskStamp::draw(std::uint32_t* pixels, int stride, const PixelBox& clip, double x, double y,
                     Colour colour) const {
  const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
  const int px = std::min(positions_ - 1, static_cast<int>((x - ix) * positions_));
  const int py = std::min(positions_ - 1, static_cast<int>((y - iy) * positions_));
  const Texel* mask =
      masks_.data() + static_cast<std::ptrdiff_t>(py * positions_ + px) * size_ * size_;
  const int left = ix - size_ / 2, top = iy - size_ / 2;
  const int x0 = std::max(0, static_cast<int>(clip.left) - left);
  const int x1 = std::min(size_, static_cast<int>(clip.right) - left);
  const int y0 = std::max(0, static_cast<int>(clip.top) - top);
  const int y1 = std::min(size_, static_cast<int>(clip.bottom) - top);
  const auto mixed = [](std::uint32_t under, std::uint32_t over, std::uint32_t light,
                        std::uint32_t coverage) {
    return (under * (255 - coverage) + over * light / 255 * coverage + 127) / 255;
  };
  for (int v = y0; v < y1; ++v) {
    std::uint32_t* row = pixels + static_cast<std::ptrdiff_t>(top + v) * stride + left;
    for (int u = x0; u < x1; ++u) {
      const Texel& t = mask[v * size_ + u];
      if (t.coverage == 0) continue;
      const std::uint32_t under = row[u];
      row[u] = 0xff000000u | mixed(under >> 16 & 255, colour.red, t.light, t.coverage) << 16 |
               mixed(under >> 8 & 255, colour.green, t.light, t.coverage) << 8 |
               mixed(under & 255, colour.blue, t.light, t.coverage);
    }
  }
}

}  // namespace plenum
