// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/picture.hpp"

#include "particles/errors.hpp"
#include "particles/picture_frame.hpp"
#include "particles/picture_map.hpp"
#include "particles/picture_projection.hpp"
#include "particles/picture_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

namespace plenum {

namespace {

/// Names and colours of the labels that occur.
std::vector<std::pair<std::string, Colour>> categoriesOf(const PictureValues& values,
                                                         const std::vector<std::string>& labels) {
  std::vector<std::pair<std::string, Colour>> categories;
  if (!values.isCategory || values.name == "type") return categories;
  std::set<int> numbers;
  for (const auto* part : {&values.fluid, &values.walls})
    for (double value : *part) numbers.insert(static_cast<int>(value));
  for (int k : numbers) {
    const bool isNamed = k >= 0 && static_cast<std::size_t>(k) < labels.size();
    categories.emplace_back(isNamed ? labels[static_cast<std::size_t>(k)] : std::to_string(k),
                            categoryColour(k));
    if (categories.size() == 30) break;  // no picture has room for more
  }
  return categories;
}

template <int Dim>
FrameText frameText(const ParticleSet<Dim>& particles, const PictureOptions<Dim>& options,
                    const PictureValues& values, std::size_t nOutside) {
  FrameText text;
  text.title = options.title.empty() ? "Particles" : options.title;
  text.info = fmt::format("t = {:.6g} s    {} fluid", options.time, particles.nFluid());
  if (particles.nWalls() > 0) text.info += fmt::format(", {} wall", particles.nWalls());
  text.info += particles.size() == 1 ? " particle" : " particles";
  if (nOutside > 0) text.info += fmt::format("    {} outside the picture", nOutside);
  text.showsWalls = particles.nWalls() > 0 && values.walls.empty();
  text.barName = values.name;
  text.barUnit = values.unit;
  text.hasBar = !values.isCategory && !(values.fluid.empty() && values.walls.empty());
  text.categories = categoriesOf(values, options.labels);
  return text;
}

/// Colour of every particle.
template <int Dim>
std::vector<Colour> coloursOf(const ParticleSet<Dim>& particles, const PictureValues& values,
                              const ColourScale& scale) {
  std::vector<Colour> colours(particles.size(), wallGrey);
  const auto nFluid = static_cast<std::ptrdiff_t>(particles.nFluid());
  if (values.fluid.empty())
    std::fill_n(colours.begin(), nFluid, paleGrey);
  else
    std::transform(values.fluid.begin(), values.fluid.end(), colours.begin(), scale);
  std::transform(values.walls.begin(), values.walls.end(), colours.begin() + nFluid, scale);
  return colours;
}

/// The view with some room around, so that no disk at the rim is cut.
template <int Dim>
Box<Dim> viewOf(const ParticleSet<Dim>& particles, const PictureOptions<Dim>& options,
                double diameter) {
  if (!options.view) return defaultView(particles, options.container).grown(diameter);
  for (int a = 0; a < Dim; ++a)
    if (!(options.view->upper[a] > options.view->lower[a]) || !options.view->isFinite())
      throw InputError(fmt::format("view: upper must be above lower on the axis {}", "xyz"[a]));
  return *options.view;
}

/// Smallest disk that still shows its colour [px].
constexpr double leastDiameter = 1.8;

/// Sizes of disks over the usual one; empty if all are the same.
template <int Dim>
std::vector<double> relativeSizes(const ParticleSet<Dim>& particles,
                                  const PictureOptions<Dim>& options) {
  if (!(options.smoothingLength > 0) || !particles.has(field::smoothingLength)) return {};
  const auto lengths = particles[field::smoothingLength];
  const auto [least, most] = std::ranges::minmax(lengths);
  if (!(most > least * (1 + 1e-6))) return {};
  std::vector<double> sizes(lengths.begin(), lengths.end());
  for (double& size : sizes) size /= options.smoothingLength;
  return sizes;
}

/// `diameter` [px] is that of a disk of relative size 1.
void stampAll(PictureFrame& frame, const PlaneDots& dots, const std::vector<Colour>& colours,
              const std::vector<double>& sizes, double diameter, bool shaded) {
  int stride = 0;
  std::uint32_t* pixels = frame.canvas().pixels(stride);
  constexpr double perPixel = 4;  // sizes in between are not told apart
  std::map<long, DiskStamp> stamps;
  for (const PlaneDots::Dot& dot : dots.dots) {
    const double size = sizes.empty() ? 1 : sizes[dot.particle];
    const double wanted = std::max(leastDiameter, size * diameter);
    const long step = sizes.empty() ? 0 : std::lround(perPixel * wanted);
    auto stamp = stamps.find(step);
    if (stamp == stamps.end()) stamp = stamps.emplace(step, DiskStamp(wanted, shaded)).first;
    stamp->second.draw(pixels, stride, frame.plot(), frame.toX(dot.x), frame.toY(dot.y),
                       colours[dot.particle]);
  }
  frame.canvas().pixelsDone();
}

template <int Dim>
double diameterOf(const ParticleSet<Dim>& particles, const PictureOptions<Dim>& options) {
  return options.spacing > 0 ? options.spacing : estimatedSpacing(particles, options.container);
}

/// 1-D: the field against x.
void drawGraph(const std::filesystem::path& path, const ParticleSet<1>& particles,
               const PictureOptions<1>& options) {
  const PictureValues values = pictureValues(particles, options.field, true);
  const Box<1> box = viewOf(particles, options, diameterOf(particles, options));
  ColourScale scale = scaleFor(values);
  if (options.range) std::tie(scale.lower, scale.upper) = *options.range;
  const double range = scale.upper - scale.lower;
  const double room = range > 0 ? 0.06 * range : std::max(0.5 * std::fabs(scale.upper), 0.5);
  const PlaneView view{box.lower[0], box.upper[0], scale.lower - room, scale.upper + room};

  PlaneDots dots;
  std::vector<Colour> colours(particles.size(),
                              values.fluid.empty() ? paleGrey : sequentialColour(0.25));
  std::fill(colours.begin() + static_cast<std::ptrdiff_t>(particles.nFluid()), colours.end(),
            wallGrey);
  const auto positions = particles[field::position];
  for (std::size_t k = particles.size(); k-- > 0;) {  // walls first, fluids above them
    const bool isFluid = k < particles.nFluid();
    const auto& part = isFluid ? values.fluid : values.walls;
    const double value = part.empty() ? scale.lower : part[isFluid ? k : k - particles.nFluid()];
    if (!box.contains(positions[k]) || !(value >= view.bottom && value <= view.top))
      ++dots.nOutside;
    else
      dots.dots.push_back({positions[k][0], value, 0, static_cast<std::uint32_t>(k)});
  }
  FrameText text = frameText(particles, options, values, dots.nOutside);
  text.hasBar = false;
  text.categories.clear();
  text.showsWalls = particles.nWalls() > 0;
  text.xName = std::string(1, 'x');
  text.yName = values.name;
  text.yUnit = values.unit;
  PictureFrame frame(view, text, scale, options.width, true);
  const double diameter =
      std::clamp(options.width / 2.0 / static_cast<double>(particles.size()), 4.0, 7.0);
  frame.draw();
  stampAll(frame, dots, colours, {}, diameter, false);
  frame.canvas().save(path);
}

/// 2-D, and slices of 3-D: disks in the plane.
template <int Dim>
void drawPlane(const std::filesystem::path& path, const ParticleSet<Dim>& particles,
               const PictureOptions<Dim>& options, int horizontal, int vertical) {
  const PictureValues values = pictureValues(particles, options.field, false);
  ColourScale scale = scaleFor(values);
  if (options.range) std::tie(scale.lower, scale.upper) = *options.range;
  const double diameter = diameterOf(particles, options);
  const Box<Dim> box = viewOf(particles, options, diameter);
  Box<Dim> shown = box;
  if (options.slice) {
    const double half = (options.slice->thickness > 0 ? options.slice->thickness : diameter) / 2;
    shown.lower[options.slice->axis] = options.slice->position - half;
    shown.upper[options.slice->axis] = options.slice->position + half;
  }
  const PlaneDots dots = dotsInPlane(particles, box, shown, horizontal, vertical);
  FrameText text = frameText(particles, options, values, dots.nOutside);
  if (options.slice)
    text.info += fmt::format("    slice at {} = {:.6g} m", "xyz"[options.slice->axis],
                             options.slice->position);
  text.xName = std::string(1, "xyz"[horizontal]);
  text.yName = std::string(1, "xyz"[vertical]);
  PictureFrame frame(
      {box.lower[horizontal], box.upper[horizontal], box.lower[vertical], box.upper[vertical]},
      text, scale, options.width, false);
  frame.draw();
  stampAll(frame, dots, coloursOf(particles, values, scale), relativeSizes(particles, options),
           diameter * frame.pixelsPerUnit(), false);
  frame.canvas().save(path);
}

/// The number of a map at a place in its pixels, between the centres of four.
double interpolated(const PixelMap& map, double x, double y) {
  const auto clamped = [](double at, int n) { return std::clamp(at - 0.5, 0.0, n - 1.0); };
  const double u = clamped(x, map.width), v = clamped(y, map.height);
  const int column = std::min(static_cast<int>(u), std::max(0, map.width - 2));
  const int row = std::min(static_cast<int>(v), std::max(0, map.height - 2));
  const int right = std::min(column + 1, map.width - 1), above = std::min(row + 1, map.height - 1);
  const double a = u - column, b = v - row;
  return (1 - b) * ((1 - a) * map.at(column, row) + a * map.at(right, row)) +
         b * ((1 - a) * map.at(column, above) + a * map.at(right, above));
}

void paint(PictureFrame& frame, const PixelMap& map, const PlaneView& view,
           const ColourScale& scale) {
  int stride = 0;
  std::uint32_t* pixels = frame.canvas().pixels(stride);
  const PixelBox& plot = frame.plot();
  const double perPixel = map.width / view.width() / frame.pixelsPerUnit();
  for (int y = static_cast<int>(plot.top); y < static_cast<int>(plot.bottom); ++y)
    for (int x = static_cast<int>(plot.left); x < static_cast<int>(plot.right); ++x) {
      const double u = (x + 0.5 - frame.toX(view.left)) * perPixel;
      const double v = (frame.toY(view.bottom) - y - 0.5) * perPixel;
      if (u < 0 || v < 0 || u > map.width || v > map.height) continue;
      const double value = interpolated(map, u, v);
      if (std::isnan(value)) continue;
      const Colour colour = scale(value);
      pixels[static_cast<std::ptrdiff_t>(y) * stride + x] =
          0xff000000u | std::uint32_t{colour.red} << 16 | std::uint32_t{colour.green} << 8 |
          colour.blue;
    }
  frame.canvas().pixelsDone();
}

/// Fluids smoothed over a plane, or along columns.
template <int Dim>
void drawMap(const std::filesystem::path& path, const ParticleSet<Dim>& particles,
             const PictureOptions<Dim>& options, int horizontal, int vertical) {
  PictureValues values = pictureValues(particles, options.field, false);
  if (values.isCategory || values.fluid.empty())
    throw InputError(
        fmt::format("{}: has no numbers that can be smoothed; draw particles, or "
                    "choose another field",
                    options.field));
  const Box<Dim> box =
      options.view ? viewOf(particles, options, 0) : defaultView(particles, options.container);
  MapPlane<Dim> plane{
      {box.lower[horizontal], box.upper[horizontal], box.lower[vertical], box.upper[vertical]},
      options.width,
      horizontal,
      vertical};
  if (options.slice) plane.cut = options.slice->position;
  const MapKernel<Dim> kernel{KernelId::named(options.kernel), options.smoothingLength,
                              options.domain};
  const bool isDensity = options.field == "density";
  const PixelMap map = isDensity ? densityMap(particles, plane, kernel)
                                 : meanMap(particles, values.fluid, plane, kernel);
  FrameText text = frameText(particles, options, values, 0);
  text.showsWalls = false;
  if (options.column) {
    text.info += fmt::format("    along {}", "xyz"[*options.column]);
    text.barName = isDensity ? "column density" : "mean " + values.name;
    if (isDensity) text.barUnit = "kg/m²";
  } else if (options.slice) {
    text.info +=
        fmt::format("    at {} = {:.6g} m", "xyz"[options.slice->axis], options.slice->position);
  }
  text.xName = std::string(1, "xyz"[horizontal]);
  text.yName = std::string(1, "xyz"[vertical]);
  values.walls.clear();
  values.fluid.clear();
  std::ranges::copy_if(map.values, std::back_inserter(values.fluid),
                       [](double value) { return !std::isnan(value); });
  ColourScale scale = scaleFor(values);
  if (options.range) std::tie(scale.lower, scale.upper) = *options.range;
  PictureFrame frame(plane.view, text, scale, options.width, false);
  frame.draw();
  paint(frame, map, plane.view, scale);
  frame.canvas().save(path);
}

/// 3-D: lit balls, the nearest drawn last.
void drawSpace(const std::filesystem::path& path, const ParticleSet<3>& particles,
               const PictureOptions<3>& options) {
  const PictureValues values = pictureValues(particles, options.field, false);
  ColourScale scale = scaleFor(values);
  if (options.range) std::tie(scale.lower, scale.upper) = *options.range;
  const double diameter = diameterOf(particles, options);
  const Box<3> box = viewOf(particles, options, diameter);
  const PlaneDots dots = dotsInSpace(particles, box);
  FrameText text = frameText(particles, options, values, dots.nOutside);
  if (dots.leavesWallsOut) text.info += "    walls in front of the fluid left out";
  const SpaceAxes axes(box, options.width);
  PictureFrame frame(axes.view(), text, scale, options.width, false);
  frame.draw();
  axes.draw(frame);
  stampAll(frame, dots, coloursOf(particles, values, scale), relativeSizes(particles, options),
           diameter * frame.pixelsPerUnit(), true);
  frame.canvas().save(path);
}

}  // namespace

template <int Dim>
PictureOptions<Dim> pictureOptions(const SceneInfo<Dim>& info, const std::string& field) {
  PictureOptions<Dim> options;
  options.field = field;
  options.title = info.title;
  options.time = info.time;
  options.spacing = info.spacing;
  options.smoothingLength = info.smoothingLength;
  options.container = containerBounds(info);
  options.kernel = info.kernel;
  options.domain = info.domain;
  if (field == "material")
    for (const Material& material : info.materials) options.labels.push_back(material.name);
  if (field == "wall")
    for (const Wall& wall : info.walls) options.labels.push_back(wall.name);
  return options;
}

template <int Dim>
void drawParticles(const std::filesystem::path& path, const ParticleSet<Dim>& particles,
                   const PictureOptions<Dim>& options) {
  if (particles.size() == 0 || !particles.has(FieldId::position))
    throw InputError(path.string() + ": not drawn: there are no particles");
  if constexpr (Dim == 1) {
    drawGraph(path, particles, options);
  } else if constexpr (Dim == 2) {
    if (options.smooth)
      drawMap(path, particles, options, 0, 1);
    else
      drawPlane(path, particles, options, 0, 1);
  } else if (options.slice || options.column) {
    const int axis = options.column ? *options.column : options.slice->axis;
    if (axis < 0 || axis > 2) throw InputError("slice: the axis must be x, y or z");
    const int horizontal = axis == 0 ? 1 : 0, vertical = axis == 2 ? 1 : 2;
    if (options.column || options.smooth)
      drawMap(path, particles, options, horizontal, vertical);
    else
      drawPlane(path, particles, options, horizontal, vertical);
  } else {
    drawSpace(path, particles, options);
  }
}

template PictureOptions<1> pictureOptions(const SceneInfo<1>&, const std::string&);
template PictureOptions<2> pictureOptions(const SceneInfo<2>&, const std::string&);
template PictureOptions<3> pictureOptions(const SceneInfo<3>&, const std::string&);
template void drawParticles(const std::filesystem::path&, const ParticleSet<1>&,
                            const PictureOptions<1>&);
template void drawParticles(const std::filesystem::path&, const ParticleSet<2>&,
                            const PictureOptions<2>&);
template void drawParticles(const std::filesystem::path&, const ParticleSet<3>&,
                            const PictureOptions<3>&);

}  // namespace plenum
