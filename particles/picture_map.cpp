// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/picture_map.hpp"

#include "particles/number.hpp"
#include "particles/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plenum {

namespace {

/// A kernel by q^2 = (r/h)^2, or its integral along a line that passes at the distance q h.
class KernelTable {
 public:
  template <int Dim>
  static KernelTable of(KernelId id, bool isColumn) {
    KernelTable table;
    kernel::withProfile(id, [&]<class Profile>(Profile profile) {
      const double sigma = Profile::sigma[Dim - 1];
      for (int k = 0; k <= last; ++k) {
        const double squared = 4.0 * k / last;
        table.values_[static_cast<std::size_t>(k)] =
            sigma * (isColumn ? alongLine(profile, squared) : profile.f(std::sqrt(squared)));
      }
    });
    return table;
  }

  /// For q^2 < 4.
  double operator()(double squared) const {
    const double place = squared * (last / 4.0);
    const int k = static_cast<int>(place);
    const double* value = values_.data() + k;
    return value[0] + (place - k) * (value[1] - value[0]);
  }

 private:
  static constexpr int last = 4096;

  template <class Profile>
  static double alongLine(const Profile& profile, double squared) {
    constexpr int n = 400;  // the trapezoidal rule, for functions that end smoothly
    const double half = std::sqrt(std::max(0.0, 4 - squared)), step = half / n;
    double sum = 0.5 * profile.f(std::sqrt(squared));
    for (int k = 1; k < n; ++k) sum += profile.f(std::sqrt(squared + power<2>(k * step)));
    return 2 * step * sum;
  }

  std::array<double, last + 2> values_{};
};

/// A particle, or a periodic image of it, over the pixels.
struct Stamp {
  double x, y;            ///< [pixels]
  double radius;          ///< of what it reaches in the plane [pixels]
  double inverseSquared;  ///< pixels^2 to q^2
  double offset;          ///< q^2 by the distance from a cut
  double weight;
  std::uint32_t particle;
};

template <int Dim>
class Stamper {
 public:
  Stamper(const ParticleSet<Dim>& particles, const MapPlane<Dim>& plane,
          const MapKernel<Dim>& kernel)
      : particles_(particles),
        plane_(plane),
        kernel_(kernel),
        isColumn_(Dim == 3 && !plane.cut),
        table_(KernelTable::of<Dim>(kernel.kernel, isColumn_)),
        perMetre_(plane.width / plane.view.width()) {}

  /// All that reach the plane; weights are `weightOf(i)` m^-2, or m^-d in a cut.
  template <class Weight>
  std::vector<Stamp> stamps(Weight&& weightOf) const {
    std::vector<Stamp> found;
    for (std::size_t i = 0; i < particles_.nFluid(); ++i) addImages(found, i, weightOf(i));
    return found;
  }

  /// Adds weight W of all stamps, times numbers of their particles, to pixels. Rows are shared out
  /// among threads, and each pixel's sum has the order of the particles.
  template <class Number>
  void addTo(std::vector<double>& sums, const std::vector<Stamp>& stamps, Number&& numberOf) const {
    const int height = plane_.height();
    constexpr int band = 16;  // rows
#pragma omp parallel for schedule(dynamic, 1)
    for (int first = 0; first < height; first += band) {
      const int end = std::min(height, first + band);
      for (const Stamp& stamp : stamps) {
        if (stamp.y + stamp.radius < first || stamp.y - stamp.radius > end) continue;
        add(sums, stamp, first, end, stamp.weight * numberOf(stamp.particle));
      }
    }
  }

 private:
  double lengthOf(std::size_t i) const {
    return particles_.has(field::smoothingLength) ? particles_[field::smoothingLength][i]
                                                  : kernel_.smoothingLength;
  }

  void addImages(std::vector<Stamp>& found, std::size_t i, double weight) const {
    const Vec<Dim>& position = particles_[field::position][i];
    const double h = lengthOf(i);
    double offset = 0;
    if constexpr (Dim == 3)
      if (plane_.cut) offset = power<2>(distanceFromCut(position) / h);
    if (!(offset < 4) || !(h > 0)) return;
    const int axes[] = {plane_.horizontal, plane_.vertical};
    const double lower[] = {plane_.view.left, plane_.view.bottom};
    const double size[] = {plane_.view.width(), plane_.view.height()};
    const double reach = h * std::sqrt(4 - offset);
    double places[2][3];
    int counts[2] = {0, 0};
    for (int a = 0; a < 2; ++a)
      for (int shift = -1; shift <= 1; ++shift) {
        if (shift != 0 && !kernel_.domain.isPeriodic(axes[a])) continue;
        const double period = kernel_.domain.upper[axes[a]] - kernel_.domain.lower[axes[a]];
        const double x = position[axes[a]] + shift * (shift == 0 ? 0 : period) - lower[a];
        if (x + reach > 0 && x - reach < size[a]) places[a][counts[a]++] = x;
      }
    const double scale = weight / (isColumn_ ? h * h : power<Dim>(h));
    for (int k = 0; k < counts[0]; ++k)
      for (int l = 0; l < counts[1]; ++l) {
        Stamp stamp{places[0][k] * perMetre_,
                    places[1][l] * perMetre_,
                    reach * perMetre_,
                    1 / power<2>(h * perMetre_),
                    offset,
                    scale,
                    static_cast<std::uint32_t>(i)};
        if (isColumn_) stamp.weight = normalized(stamp, weight);
        found.push_back(stamp);
      }
  }

  double distanceFromCut(const Vec<Dim>& position) const {
    const int axis = 3 - plane_.horizontal - plane_.vertical;
    Vec<Dim> difference{};
    difference[axis] = position[axis] - *plane_.cut;
    return kernel_.domain.nearestImage(difference)[axis];
  }

  /// The weight with which the stamp's pixels, also those outside of the picture, have all of the
  /// particle's mass.
  double normalized(Stamp& stamp, double weight) const {
    constexpr double manyPixels = 12;  // of radius: the sum over pixels is right to 1e-4
    if (stamp.radius > manyPixels) return stamp.weight;
    double sum = 0;
    forEachPixel(stamp, std::numeric_limits<int>::min() / 2, std::numeric_limits<int>::max() / 2,
                 false, [&](int, int, double value) { sum += value; });
    if (sum > 0) return weight * perMetre_ * perMetre_ / sum;
    // Between the pixels' centres: the pixel that it stands on has it all.
    stamp.x = std::floor(stamp.x) + 0.5;
    stamp.y = std::floor(stamp.y) + 0.5;
    return weight * perMetre_ * perMetre_ / table_(0);
  }

  /// body(column, row, kernel) for pixels whose centres the stamp reaches, of rows [first, end).
  template <class Body>
  void forEachPixel(const Stamp& stamp, int first, int end, bool clips, Body&& body) const {
    const int bottom = std::max(first, static_cast<int>(std::floor(stamp.y - stamp.radius - 0.5)));
    const int top = std::min(end - 1, static_cast<int>(std::ceil(stamp.y + stamp.radius)));
    for (int row = bottom; row <= top; ++row) {
      const double dy = row + 0.5 - stamp.y;
      const double rest = (4 - stamp.offset) / stamp.inverseSquared - dy * dy;
      if (!(rest > 0)) continue;
      const double half = std::sqrt(rest);
      int left = static_cast<int>(std::ceil(stamp.x - half - 0.5));
      int right = static_cast<int>(std::floor(stamp.x + half - 0.5));
      if (clips) {
        left = std::max(left, 0);
        right = std::min(right, plane_.width - 1);
      }
      for (int column = left; column <= right; ++column) {
        const double dx = column + 0.5 - stamp.x;
        const double squared = (dx * dx + dy * dy) * stamp.inverseSquared + stamp.offset;
        if (squared < 4) body(column, row, table_(squared));
      }
    }
  }

  void add(std::vector<double>& sums, const Stamp& stamp, int first, int end, double weight) const {
    forEachPixel(stamp, first, end, true, [&](int column, int row, double value) {
      sums[static_cast<std::size_t>(row) * static_cast<std::size_t>(plane_.width) +
           static_cast<std::size_t>(column)] += weight * value;
    });
  }

  const ParticleSet<Dim>& particles_;
  const MapPlane<Dim>& plane_;
  const MapKernel<Dim>& kernel_;
  bool isColumn_;
  KernelTable table_;
  double perMetre_;
};

template <int Dim>
PixelMap emptyMap(const MapPlane<Dim>& plane) {
  PixelMap map{plane.width, plane.height(), {}};
  map.values.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height), 0);
  return map;
}

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

}  // namespace

template <int Dim>
int MapPlane<Dim>::height() const {
  return std::max(1, static_cast<int>(std::lround(width * view.height() / view.width())));
}

template <int Dim>
PixelMap densityMap(const ParticleSet<Dim>& particles, const MapPlane<Dim>& plane,
                    const MapKernel<Dim>& kernel) {
  const Stamper<Dim> stamper(particles, plane, kernel);
  const auto mass = particles[field::mass];
  PixelMap map = emptyMap(plane);
  stamper.addTo(map.values, stamper.stamps([&](std::size_t i) { return mass[i]; }),
                [](std::uint32_t) { return 1.0; });
  for (double& value : map.values)
    if (value == 0) value = nowhere;
  return map;
}

template <int Dim>
PixelMap meanMap(const ParticleSet<Dim>& particles, std::span<const double> numbers,
                 const MapPlane<Dim>& plane, const MapKernel<Dim>& kernel) {
  const Stamper<Dim> stamper(particles, plane, kernel);
  const auto mass = particles[field::mass], density = particles[field::density];
  const bool byMass = Dim == 3 && !plane.cut;
  const auto stamps =
      stamper.stamps([&](std::size_t i) { return byMass ? mass[i] : mass[i] / density[i]; });
  PixelMap map = emptyMap(plane);
  std::vector<double> weights(map.values.size(), 0);
  stamper.addTo(map.values, stamps, [&](std::uint32_t i) { return numbers[i]; });
  stamper.addTo(weights, stamps, [](std::uint32_t) { return 1.0; });
  for (std::size_t k = 0; k < weights.size(); ++k)
    map.values[k] = weights[k] > 0 ? map.values[k] / weights[k] : nowhere;
  return map;
}

#define PLENUM_INSTANTIATE(Dim)                                               \
  template struct MapPlane<Dim>;                                              \
  template PixelMap densityMap(const ParticleSet<Dim>&, const MapPlane<Dim>&, \
                               const MapKernel<Dim>&);                        \
  template PixelMap meanMap(const ParticleSet<Dim>&, std::span<const double>, \
                            const MapPlane<Dim>&, const MapKernel<Dim>&);
PLENUM_INSTANTIATE(2)
PLENUM_INSTANTIATE(3)
#undef PLENUM_INSTANTIATE

}  // namespace plenum
