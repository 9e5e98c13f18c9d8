// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/picture.hpp"

#include "particles/errors.hpp"
#include "particles/picture_frame.hpp"
#include "particles/picture_projection.hpp"
#include "particles/picture_scale.hpp"
#include "sample_scene.hpp"

#include <cairo.h>

#include <cmath>
#include <limits>
#include <map>

namespace plenum {
namespace {

/// A PNG read back.
class Png {
 public:
  explicit Png(const std::filesystem::path& path)
      : surface_(cairo_image_surface_create_from_png(path.c_str())) {
    EXPECT_EQ(cairo_surface_status(surface_), CAIRO_STATUS_SUCCESS) << path;
  }
  ~Png() { cairo_surface_destroy(surface_); }
  Png(const Png&) = delete;
  Png& operator=(const Png&) = delete;
  int width() const { return cairo_image_surface_get_width(surface_); }
  int height() const { return cairo_image_surface_get_height(surface_); }
  Colour at(int x, int y) const {
    const auto* row = cairo_image_surface_get_data(surface_) +
                      static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface_);
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, row + 4 * x, 4);
    return {static_cast<std::uint8_t>(pixel >> 16), static_cast<std::uint8_t>(pixel >> 8),
            static_cast<std::uint8_t>(pixel)};
  }
  /// Number of pixels of exactly this colour.
  int count(Colour colour) const {
    int n = 0;
    for (int y = 0; y < height(); ++y)
      for (int x = 0; x < width(); ++x) n += at(x, y) == colour ? 1 : 0;
    return n;
  }
  /// Centre of all pixels of this colour.
  Vec<2> centreOf(Colour colour) const {
    Vec<2> sum;
    int n = 0;
    for (int y = 0; y < height(); ++y)
      for (int x = 0; x < width(); ++x)
        if (at(x, y) == colour) {
          sum += Vec<2>{{x + 0.5, y + 0.5}};
          ++n;
        }
    return sum / std::max(n, 1);
  }

 private:
  cairo_surface_t* surface_;
};

/// Two fluid particles and one wall particle on a line, with densities 1 and 2.
ParticleSet<2> threeParticles() {
  ParticleSet<2> particles({FieldId::position, FieldId::velocity, FieldId::density}, 2, 1);
  particles[field::position][0] = {{0.25, 0.25}};
  particles[field::position][1] = {{0.75, 0.25}};
  particles[field::position][2] = {{0.25, 0.75}};
  particles[field::density][0] = 1;
  particles[field::density][1] = 2;
  particles[field::density][2] = 7;
  return particles;
}

PictureOptions<2> unitSquare(const std::string& field) {
  PictureOptions<2> options{.field = field, .spacing = 0.2, .width = 800};
  options.view = Box<2>{{{0, 0}}, {{1, 1}}, {}};
  return options;
}

TEST(Picture, ColoursSizesAndPlaces) {
  const TemporaryFolder folder;
  drawParticles(folder / "a.png", threeParticles(), unitSquare("density"));
  const Png png(folder / "a.png");
  EXPECT_EQ(png.width(), 800);
  EXPECT_GT(png.height(), 600);
  EXPECT_LT(png.height(), 800);
  const Vec<2> low = png.centreOf(sequentialColour(0)), high = png.centreOf(sequentialColour(1));
  const Vec<2> wall = png.centreOf(wallGrey);
  // The bar's ends and the key beside the title have these colours too: a few hundred pixels
  // against about 12,000 of a disk, which moves a centre by some pixels.
  EXPECT_NEAR(high[1], low[1], 25);
  EXPECT_NEAR(wall[0], low[0], 25);
  const double pixels = (high[0] - low[0]) / 0.5;  // per metre, from x
  EXPECT_NEAR((low[1] - wall[1]) / 0.5, pixels, 50) << "equal aspect, y upwards";
  const double area = 3.14159 / 4 * std::pow(0.2 * pixels, 2);
  EXPECT_NEAR(png.count(wallGrey), area, 0.12 * area) << "disks have the diameter d_ref";
}

TEST(Picture, WallsHaveNoColourOfTheField) {
  const TemporaryFolder folder;
  auto particles = threeParticles();
  drawParticles(folder / "a.png", particles, unitSquare("density"));
  particles[field::density][2] = 1.5;
  drawParticles(folder / "b.png", particles, unitSquare("density"));
  const Png a(folder / "a.png"), b(folder / "b.png");
  EXPECT_EQ(a.count(wallGrey), b.count(wallGrey)) << "a wall's value changes nothing";
}

TEST(Picture, VectorsLabelsAndTypes) {
  const TemporaryFolder folder;
  auto scene = sampleScene<2>();
  for (const char* name : {"velocity", "material", "wall", "normal", "wall_distance", "id", "type"})
    EXPECT_NO_THROW(drawParticles(folder / (std::string(name) + ".png"), scene.particles,
                                  pictureOptions(scene.info, name)))
        << name;
  scene.particles[field::material][0] = 0;
  drawParticles(folder / "m.png", scene.particles, pictureOptions(scene.info, "material"));
  EXPECT_GT(Png(folder / "m.png").count(categoryColour(0)), 100);
  EXPECT_GT(Png(folder / "m.png").count(categoryColour(1)), 100);
}

TEST(Picture, ParticlesThatFlewAwayDoNotShrinkIt) {
  std::vector<Vec<2>> positions;
  ParticleSet<2> particles({FieldId::position, FieldId::density}, 1000, 0);
  for (std::size_t k = 0; k < 1000; ++k)
    particles[field::position][k] = {{static_cast<double>(k % 40), static_cast<double>(k / 40)}};
  const Box<2> all = defaultView(particles, std::optional<Box<2>>{});
  EXPECT_EQ(all.upper, (Vec<2>{{39, 24}}));
  particles[field::position][3] = {{1e6, -1e9}};
  particles[field::position][4] = {{std::numeric_limits<double>::quiet_NaN(), 0}};
  const Box<2> most = defaultView(particles, std::optional<Box<2>>{});
  EXPECT_NEAR(most.upper[0], 39, 5);  // the middle 98 % and a tenth more
  EXPECT_NEAR(most.lower[1], 0, 3);
  const Box<2> container{{{0, 0}}, {{10, 10}}, {}};
  EXPECT_EQ(defaultView(particles, std::optional(container)).upper, container.upper);
}

TEST(Picture, EveryDimensionAndOddSets) {
  const TemporaryFolder folder;
  auto one = sampleScene<1>();
  drawParticles(folder / "1.png", one.particles, pictureOptions(one.info));
  auto three = sampleScene<3>();
  drawParticles(folder / "3.png", three.particles, pictureOptions(three.info));
  auto options = pictureOptions(three.info, "density");
  options.slice = Slice{0, 0.5, 0.3};
  drawParticles(folder / "slice.png", three.particles, options);
  ParticleSet<2> same({FieldId::position, FieldId::density}, 5, 0);  // all in one place
  drawParticles(folder / "same.png", same, {.field = "density"});
  ParticleSet<3> single({FieldId::position, FieldId::velocity}, 1, 0);
  drawParticles(folder / "single.png", single);
  ParticleSet<2> onlyWalls({FieldId::position, FieldId::velocity}, 0, 4);
  onlyWalls[field::position][1] = {{1, 1}};
  drawParticles(folder / "walls.png", onlyWalls);
  auto broken = sampleScene<2>();
  for (auto& v : broken.particles[field::velocity]) v[0] = std::numeric_limits<double>::quiet_NaN();
  broken.particles[field::position][0][0] = std::numeric_limits<double>::infinity();
  drawParticles(folder / "broken.png", broken.particles, pictureOptions(broken.info));
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    const Png png(entry.path());
    EXPECT_LE(png.width(), 1200) << entry.path();
    EXPECT_GE(png.width(), 300) << entry.path();
    EXPECT_LE(png.height(), 1500) << entry.path();
    EXPECT_GE(png.height(), 150) << entry.path();
  }
}

TEST(Picture, Errors) {
  const TemporaryFolder folder;
  const auto particles = threeParticles();
  try {
    drawParticles(folder / "a.png", particles, {.field = "velocty"});
    FAIL() << "was drawn";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "field 'velocty': no such field; these particles carry: type, velocity, density; "
                 "did you mean 'velocity'?");
  }
  EXPECT_THROW(drawParticles(folder / "a.png", particles, {.field = "pressure"}), InputError);
  EXPECT_THROW(drawParticles(folder / "a.png", ParticleSet<2>({FieldId::position}, 0, 0)),
               InputError);
  EXPECT_THROW(drawParticles(folder / "none/a.png", particles, unitSquare("density")), RunError);
  auto flat = unitSquare("density");
  flat.view->upper[1] = 0;
  EXPECT_THROW(drawParticles(folder / "a.png", particles, flat), InputError);
  EXPECT_EQ(folder.size(), 0u);
}

TEST(PictureScale, LightnessGrowsEvenly) {
  const auto lightness = [](Colour c) {
    const auto linear = [](double v) {
      v /= 255;
      return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    const double y = 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
    return 116 * std::cbrt(y) - 16;
  };
  for (int k = 0; k < 20; ++k) {
    const double step =
        lightness(sequentialColour((k + 1) / 20.0)) - lightness(sequentialColour(k / 20.0));
    // 70 in 20 steps; rounding to 8 bits and the straight lines between anchors cost up to one.
    EXPECT_NEAR(step, 3.5, 1.0) << k;
  }
  EXPECT_EQ(sequentialColour(-1), sequentialColour(0));
  EXPECT_EQ(sequentialColour(2), sequentialColour(1));
}

TEST(PictureScale, NiceTicks) {
  using Labels = std::vector<std::string>;
  EXPECT_EQ(niceTicks(0, 1, 5).labels, (Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(niceTicks(-0.11, 0.11, 4).labels, (Labels{"-0.10", "-0.05", "0.00", "0.05", "0.10"}));
  EXPECT_EQ(niceTicks(0, 2.1e-4, 4).labels, (Labels{"0", "50", "100", "150", "200"}));
  EXPECT_EQ(niceTicks(0, 2.1e-4, 4).exponent, -6);
  EXPECT_EQ(niceTicks(0, 3e5, 3).labels, (Labels{"0", "100", "200", "300"}));
  EXPECT_EQ(niceTicks(0, 3e5, 3).exponent, 3);
  EXPECT_EQ(niceTicks(7, 7, 3).labels, (Labels{"7"}));
  EXPECT_EQ(niceTicks(0, 0, 3).labels, (Labels{"0"}));
}

TEST(PictureScale, UnitsInEveryDimension) {
  EXPECT_EQ(unitIn("kg/m^d", 1), "kg/m");
  EXPECT_EQ(unitIn("kg/m^d", 2), "kg/m²");
  EXPECT_EQ(unitIn("kg/m^d", 3), "kg/m³");
  EXPECT_EQ(unitIn("kg/m^(3-d)", 2), "kg/m");
  EXPECT_EQ(unitIn("kg/m^(3-d)", 3), "kg");
  EXPECT_EQ(unitIn("Pa m^(3-d)", 1), "Pa m²");
  EXPECT_EQ(unitIn("Pa m^(3-d)", 3), "Pa");
  EXPECT_EQ(unitIn("kg/(m^d s)", 2), "kg/(m² s)");
  EXPECT_EQ(unitIn("m/s^2", 2), "m/s²");
  EXPECT_EQ(axisTitle("x", "m", -3), "x [10⁻³ m]");
  EXPECT_EQ(axisTitle("psi6", "", 0), "psi6");
}

}  // namespace
}  // namespace plenum
