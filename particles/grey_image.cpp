// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/grey_image.hpp"

#include "particles/errors.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <memory>

namespace plenum {

namespace {

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* pen) const { cairo_destroy(pen); }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroy>;

/// Luma of a pixel 0x00RRGGBB, ITU-R BT.601.
double lumaOf(std::uint32_t pixel) {
  const double red = pixel >> 16 & 255, green = pixel >> 8 & 255, blue = pixel & 255;
  return (0.299 * red + 0.587 * green + 0.114 * blue) / 255;
}

}  // namespace

GreyImage readGreyImage(const std::filesystem::path& path) {
  const Surface file(cairo_image_surface_create_from_png(path.c_str()));
  const int width = cairo_image_surface_get_width(file.get());
  const int height = cairo_image_surface_get_height(file.get());
  const cairo_status_t status = cairo_surface_status(file.get());
  if (status != CAIRO_STATUS_SUCCESS || width < 2 || height < 2)
    throw InputError(fmt::format("{}: is no PNG of at least 2 x 2 pixels ({})", path.string(),
                                 cairo_status_to_string(status)));
  // Whatever the file holds, drawn in 8-bit colours; what is transparent is black.
  const Surface plain(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  const std::unique_ptr<cairo_t, Destroy> pen(cairo_create(plain.get()));
  cairo_set_source_surface(pen.get(), file.get(), 0, 0);
  cairo_paint(pen.get());
  cairo_surface_flush(plain.get());
  const unsigned char* data = cairo_image_surface_get_data(plain.get());
  const int stride = cairo_image_surface_get_stride(plain.get());
  GreyImage image{static_cast<std::size_t>(width), static_cast<std::size_t>(height), {}};
  image.grey.reserve(image.width * image.height);
  for (int y = height - 1; y >= 0; --y)
    for (int x = 0; x < width; ++x) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, data + std::ptrdiff_t{y} * stride + std::ptrdiff_t{x} * 4, 4);
      image.grey.push_back(lumaOf(pixel));
    }
  return image;
}

}  // namespace plenum
