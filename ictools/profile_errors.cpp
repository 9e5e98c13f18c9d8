// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/profile_errors.hpp"

#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

/// Places within a kernel of h = 1 and their weights, which add up to one.
template <int Dim>
struct KernelNodes {
  std::vector<Vec<Dim>> place;
  std::vector<double> weight;

  explicit KernelNodes(KernelId id) {
    constexpr int perLength = Dim == 3 ? 4 : 10;  // nodes in a smoothing length
    constexpr int last = 2 * perLength;
    const kernel::Any profile{id};
    int cells = 1;
    for (int a = 0; a < Dim; ++a) cells *= 2 * last;
    double sum = 0;
    for (int cell = 0; cell < cells; ++cell) {
      Vec<Dim> x;
      for (int a = 0, rest = cell; a < Dim; ++a, rest /= 2 * last)
        x[a] = (rest % (2 * last) - last + 0.5) / perLength;
      const double w = profile.f(norm(x));
      if (!(w > 0)) continue;
      place.push_back(x);
      weight.push_back(w);
      sum += w;
    }
    for (double& w : weight) w /= sum;
  }
};

/// The profile smoothed at x with smoothing length h.
template <int Dim>
double smoothed(const DensityProfile<Dim>& profile, const KernelNodes<Dim>& nodes,
                const Vec<Dim>& x, double h, const Box<Dim>& domain, std::vector<Vec<Dim>>& places,
                std::vector<double>& values) {
  places.resize(nodes.place.size());
  values.resize(nodes.place.size());
  for (std::size_t k = 0; k < places.size(); ++k) places[k] = domain.wrap(x + h * nodes.place[k]);
  profile.at(places, values);
  double sum = 0;
  for (std::size_t k = 0; k < places.size(); ++k) sum += nodes.weight[k] * values[k];
  return sum;
}

}  // namespace

template <int Dim>
ProfileErrors profileErrors(KernelId kernel, const ParticleSet<Dim>& particles,
                            const Box<Dim>& domain, std::span<const double> density,
                            std::span<const std::uint8_t> inside,
                            const std::vector<DensityProfilePtr<Dim>>& profiles) {
  if (std::ranges::none_of(profiles, [](const auto& p) { return p != nullptr; })) return {};
  std::vector<std::size_t> who;
  const auto profileOfParticle = [&](std::size_t i) {
    const auto m = particles.has(field::material)
                       ? static_cast<std::size_t>(particles[field::material][i])
                       : 0;
    return m < profiles.size() ? profiles[m].get() : nullptr;
  };
  for (std::size_t i = 0; i < particles.nFluid(); ++i)
    if (inside[i] != 0 && profileOfParticle(i) != nullptr) who.push_back(i);
  constexpr std::size_t most = 20000;
  const std::size_t stride = who.size() / most + 1;
  const std::size_t n = (who.size() + stride - 1) / stride;
  std::vector<double> smooth(n), sharp(n);
  const KernelNodes<Dim> nodes(kernel);
  constexpr std::size_t batch = 64;
  parallelFor((n + batch - 1) / batch, [&](std::size_t b) {
    std::vector<Vec<Dim>> places;
    std::vector<double> values;
    for (std::size_t k = b * batch; k < std::min(n, (b + 1) * batch); ++k) {
      const std::size_t i = who[k * stride];
      const Vec<Dim>& x = particles[field::position][i];
      smooth[k] = smoothed(*profileOfParticle(i), nodes, x, particles[field::smoothingLength][i],
                           domain, places, values);
      sharp[k] = profileOfParticle(i)->at(x);
    }
  });
  ProfileErrors errors;
  double square = 0, toSmooth = 0, toSharp = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (!std::isfinite(smooth[k])) continue;  // the kernel reaches beyond a table
    const double rho = density[who[k * stride]];
    ++errors.n;
    square += smooth[k] * smooth[k];
    toSmooth += (rho - smooth[k]) * (rho - smooth[k]);
    toSharp += (rho - sharp[k]) * (rho - sharp[k]);
  }
  if (errors.n == 0) return errors;
  errors.smoothed = std::sqrt(toSmooth / square);
  errors.sharp = std::sqrt(toSharp / square);
  return errors;
}

template ProfileErrors profileErrors(KernelId, const ParticleSet<1>&, const Box<1>&,
                                     std::span<const double>, std::span<const std::uint8_t>,
                                     const std::vector<DensityProfilePtr<1>>&);
template ProfileErrors profileErrors(KernelId, const ParticleSet<2>&, const Box<2>&,
                                     std::span<const double>, std::span<const std::uint8_t>,
                                     const std::vector<DensityProfilePtr<2>>&);
template ProfileErrors profileErrors(KernelId, const ParticleSet<3>&, const Box<3>&,
                                     std::span<const double>, std::span<const std::uint8_t>,
                                     const std::vector<DensityProfilePtr<3>>&);

}  // namespace plenum
