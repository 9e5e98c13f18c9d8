// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/arrangement.hpp"

#include "engine/ordered_sum.hpp"
#include "ictools/number_density.hpp"
#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

constexpr FieldSet arranged{field::position, field::velocity, field::mass,     field::density,
                            field::pressure, field::id,       field::material, field::clearance};

/// Particles are kept this far from surfaces, in d_ref: walls hold them at about half a spacing, so
/// that this is for those that were thrown there.
constexpr double margin = 0.1;

/// Volumes follow the density at a particle's place by this power in an iteration: where the
/// density jumps, particles that swing from one side to the other find a volume between.
constexpr double adaptation = 0.2;

/// The list of neighbours lives for some steps at the end, when moves are small.
constexpr double skin = 0.2;

/// Sums of a number and of its square.
struct Moments {
  double sum = 0, squares = 0;
  Moments& operator+=(const Moments& other) {
    sum += other.sum;
    squares += other.squares;
    return *this;
  }
};

}  // namespace

template <int Dim>
Arrangement<Dim>::Arrangement(const std::vector<FluidFill<Dim>>& fluids,
                              const std::vector<WallFill<Dim>>& walls, const SceneFrame<Dim>& frame,
                              bool adaptive)
    : fluids_(fluids),
      smoothing_{KernelId::named(frame.solver.kernel), frame.smoothingLength(), adaptive},
      lengthOverSpacing_(frame.smoothingLength() * fluids.front().lengthScale /
                         spacingOf<Dim>(fluids.front().lattice.cellVolume())) {
  const auto fixed = surroundings(fluids, walls, frame, lengthOverSpacing_);
  std::size_t nFluid = 0;
  for (const auto& fluid : fluids) nFluid += fluid.points.size();
  particles_ = ParticleSet<Dim>(adaptive ? arranged | FieldSet{field::smoothingLength} : arranged,
                                nFluid, fixed.size());
  domain_ = frame.domain;
  addFluids();
  for (std::size_t k = 0; k < fixed.size(); ++k) {
    particles_[field::position][nFluid + k] = fixed[k].position;
    particles_[field::mass][nFluid + k] = fixed[k].volume;
  }
  Box<Dim> box = Box<Dim>::nothing();
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    particles_[field::density][i] = 1;
    particles_[field::pressure][i] = 1;
    particles_[field::id][i] = i;
    box.extend(particles_[field::position][i]);
  }
  domain_ = frame.clipped(box);
  if (adaptive) setSmoothingLengths();
  for (std::size_t k = 0; k < fluids.size(); ++k)
    containments_.emplace_back(
        fluids, k, frame.domain,
        margin * frame.spacing * (fluids[k].resolution ? fluids[k].resolution->finest() : 1));

  typename Engine<Dim>::Options options;
  options.support = frame.support();
  options.skin = skin;
  options.units = Units::near(frame.smoothingLength(), particles_[field::mass][0], 1);
  options.adaptive = adaptive;
  engine_ = std::make_unique<Engine<Dim>>(domain_, options);
}

template <int Dim>
void Arrangement<Dim>::addFluids() {
  std::size_t i = 0;
  for (std::size_t k = 0; k < fluids_.size(); ++k) {
    const std::vector<double> volumes = targetVolumes<Dim>(fluids_[k], fluids_[k].points, domain_);
    for (std::size_t p = 0; p < volumes.size(); ++p, ++i) {
      particles_[field::position][i] = fluids_[k].points[p];
      particles_[field::mass][i] = volumes[p];
      particles_[field::material][i] = static_cast<std::int32_t>(k);
    }
  }
}

template <int Dim>
void Arrangement<Dim>::retarget() {
  const auto position = particles_[field::position];
  const auto volume = particles_[field::mass];
  double growth = 1;
  bool changed = false;
  for (std::size_t k = 0; k < fluids_.size(); ++k) {
    if (!fluids_[k].spacingVaries()) continue;
    std::vector<std::size_t> who;
    std::vector<Vec<Dim>> points;
    for (std::size_t i = 0; i < nFluid(); ++i)
      if (particles_[field::material][i] == static_cast<std::int32_t>(k)) {
        who.push_back(i);
        points.push_back(domain_.wrap(position[i]));
      }
    const std::vector<double> volumes = targetVolumes<Dim>(fluids_[k], points, domain_);
    for (std::size_t p = 0; p < who.size(); ++p) {
      const double factor = std::pow(volumes[p] / volume[who[p]], adaptation);
      growth = std::max(growth, factor);
      changed |= factor != 1;
      volume[who[p]] *= factor;
    }
  }
  if (!changed) return;
  setSmoothingLengths();
  engine_->grew(spacingOf<Dim>(growth));
}

template <int Dim>
void Arrangement<Dim>::setSmoothingLengths() {
  const auto volume = particles_[field::mass];
  const auto length = particles_[field::smoothingLength];
  forEachIndex(particles_.size(),
               [&](std::size_t i) { length[i] = lengthOverSpacing_ * spacingOf<Dim>(volume[i]); });
}

template <int Dim>
const PairPass<Dim>& Arrangement<Dim>::passOf(NeighbourSum sum) {
  PairPass<Dim>& pass = sum == NeighbourSum::kernelSum  ? kernelSum_
                        : sum == NeighbourSum::pressure ? pressure_
                                                        : voronoi_;
  if (!pass) pass = neighbourPass<Dim>(sum, smoothing_, engine_->units());
  return pass;
}

template <int Dim>
RelaxationState Arrangement<Dim>::sumKernels() {
  engine_->update(particles_);
  const auto ratio = particles_[field::pressure];
  forEachSum(NeighbourSum::kernelSum, field::kernelSum,
             [&](std::size_t i, double sum) { ratio[i] = sum; });
  const double n = static_cast<double>(nFluid());
  const auto moments = orderedSum<Moments>(nFluid(), [&](std::size_t i) {
    return Moments{ratio[i], ratio[i] * ratio[i]};
  });
  RelaxationState state;
  state.mean = moments.sum / n;
  forEachIndex(nFluid(), [&](std::size_t i) { ratio[i] /= state.mean; });
  const auto deviations = orderedSum<Moments>(nFluid(), [&](std::size_t i) {
    return Moments{0, (ratio[i] - 1) * (ratio[i] - 1)};
  });
  state.scatter = std::sqrt(deviations.squares / n);
  for (std::size_t i = 0; i < nFluid(); ++i)
    state.worst = std::max(state.worst, std::abs(ratio[i] - 1));
  return state;
}

template <int Dim>
double Arrangement<Dim>::move() {
  const auto position = particles_[field::position];
  const auto step = particles_[field::velocity];
  const auto clearance = particles_[field::clearance];
  std::vector<Vec<Dim>> before(position.begin(),
                               position.begin() + static_cast<std::ptrdiff_t>(nFluid()));
  forEachIndex(nFluid(), [&](std::size_t i) {
    position[i] += step[i];
    clearance[i] -= norm(step[i]);
  });
  keepAll(before);
  const auto volume = particles_[field::mass];
  double furthest = 0;
  const double squares = orderedSum<double>(nFluid(), [&](std::size_t i) {
    return normSquared(step[i]) / std::pow(spacingOf<Dim>(volume[i]), 2);
  });
  for (std::size_t i = 0; i < nFluid(); ++i) furthest = std::max(furthest, normSquared(step[i]));
  engine_->moved(std::sqrt(furthest));
  return std::sqrt(squares / static_cast<double>(nFluid()));
}

/// Asks for those that may have met a surface.
template <int Dim>
void Arrangement<Dim>::keepAll(std::span<const Vec<Dim>> before) {
  const auto position = particles_[field::position];
  const auto step = particles_[field::velocity];
  const auto clearance = particles_[field::clearance];
  for (std::size_t k = 0; k < containments_.size(); ++k) {
    std::vector<std::size_t> asked;
    std::vector<Vec<Dim>> points, origins;
    for (std::size_t i = 0; i < nFluid(); ++i) {
      if (clearance[i] > 0 || particles_[field::material][i] != static_cast<std::int32_t>(k))
        continue;
      asked.push_back(i);
      points.push_back(position[i]);
      origins.push_back(before[i]);
    }
    std::vector<Kept<Dim>> kept(asked.size());
    containments_[k].keep(points, origins, kept);
    for (std::size_t a = 0; a < asked.size(); ++a) {
      const std::size_t i = asked[a];
      position[i] = kept[a].position;
      clearance[i] = kept[a].clearance;
      step[i] = domain_.nearestImage(position[i] - before[i]);
    }
  }
}

template <int Dim>
std::vector<Vec<Dim>> Arrangement<Dim>::positions() const {
  std::vector<Vec<Dim>> result(particles_.nFluid());
  const auto position = particles_[field::position];
  const auto id = particles_[field::id];
  for (std::size_t i = 0; i < result.size(); ++i) result[id[i]] = domain_.wrap(position[i]);
  return result;
}

template class Arrangement<1>;
template class Arrangement<2>;
template class Arrangement<3>;

}  // namespace plenum
