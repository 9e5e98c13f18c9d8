// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/engine.hpp"

#include "engine/instruction_set.hpp"
#include "particles/errors.hpp"
#include "particles/parallel.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace plenum {

template <int Dim>
Engine<Dim>::Engine(const Box<Dim>& domain, const Options& options)
    : domain_(domain), options_(options), periodicity_(domain) {
  skin_ = options.skin * options.support;
  for (int a = 0; a < Dim; ++a) {
    if (!domain.isPeriodic(a)) continue;
    const double length = domain.upper[a] - domain.lower[a];
    // Each pair must have one nearest image only.
    if (length < 2 * options.support)
      throw InputError(
          fmt::format("periodic axis {}: length {:g} m is shorter than twice the kernel's support "
                      "{:g} m; use a "
                      "longer box, a smaller smoothing_length or a smaller spacing",
                      "xyz"[a], length, options.support));
  }
}

template <int Dim>
bool Engine<Dim>::update(ParticleSet<Dim>& particles) {
  const bool isNew = clusters_.nParticles != particles.size() || nRebuilds_ == 0;
  const bool old = isNew || !(travelled_ < 0.5 * usableSkin_);
  if (old) {
    sort(particles);
    search(particles);
  }
  if (options_.precision == Precision::mixed) {
    loadPositions(inFloat_, particles);
    findNear(inFloat_);
  } else {
    loadPositions(inDouble_, particles);
    findNear(inDouble_);
  }
  return old;
}

template <int Dim>
void Engine<Dim>::sort(ParticleSet<Dim>& particles) {
  const auto sorting = watch_.lap(Part::sort);
  const auto positions = particles[field::position];
  const std::size_t n = positions.size(), nFluid = particles.nFluid();
  forEachIndex(n, [&](std::size_t i) { positions[i] = domain_.wrap(positions[i]); });
  fluidOrder_.sort(positions.first(nFluid));
  wallOrder_.sort(positions.subspan(nFluid));
  order_.resize(n);
  std::ranges::copy(fluidOrder_.order(), order_.begin());
  std::ranges::transform(
      wallOrder_.order(), order_.begin() + static_cast<std::ptrdiff_t>(nFluid),
      [nFluid](std::uint32_t k) { return static_cast<std::uint32_t>(nFluid + k); });
  particles.permute(order_);
}

template <int Dim>
void Engine<Dim>::search(const ParticleSet<Dim>& particles) {
  const auto searching = watch_.lap(Part::search);
  const std::size_t nFluid = particles.nFluid();
  const auto sorted = particles[field::position];
  clusters_.build(sorted, nFluid);
  list_.build(sorted, clusters_, domain_, options_.support + skin_, options_.wallsReceive);
  travelled_ = 0;
  ++nRebuilds_;

  // A position is read as the image nearest to the origin of its cluster. Where that is unsure,
  // because a cluster spans the whole period, every step searches anew.
  usableSkin_ = skin_;
  for (int a = 0; a < Dim; ++a)
    if (domain_.isPeriodic(a))
      for (const Vec<Dim, float>& half : clusters_.halfSize)
        if (2 * static_cast<double>(half[a]) + skin_ > domain_.upper[a] - domain_.lower[a])
          usableSkin_ = 0;
}

template <int Dim>
template <class T>
void Engine<Dim>::loadPositions(Numbers<T>& numbers, const ParticleSet<Dim>& particles) {
  const auto positions = particles[field::position];
  const auto loading = watch_.lap(Part::load);
  numbers.positions.resize(clusters_.nClusters * Dim * clusterSize);
  // Places without a particle lie so far away that no kernel reaches them.
  const double away = 1e4 * options_.support;
  forEachIndex(clusters_.nClusters, [&](std::size_t c) {
    T* block = numbers.positions.data() + c * Dim * clusterSize;
    const std::size_t first = clusters_.firstOf(c), count = clusters_.endOf(c) - first;
    const Vec<Dim> origin = clusters_.origin[c];
    for (std::size_t k = 0; k < count; ++k) {
      const Vec<Dim> x = periodicity_.nearestImage(positions[first + k] - origin);
      for (std::size_t a = 0; a < Dim; ++a)
        block[a * clusterSize + k] = static_cast<T>(x[static_cast<int>(a)]);
    }
    for (std::size_t k = count; k < clusterSize; ++k)
      for (std::size_t a = 0; a < Dim; ++a)
        block[a * clusterSize + k] = static_cast<T>(away * static_cast<double>(k + 1));
  });
}

template <int Dim>
template <class T>
void Engine<Dim>::loadFields(Numbers<T>& numbers, FieldSet reads,
                             const ParticleSet<Dim>& particles) {
  const auto loading = watch_.lap(Part::load);
  const std::size_t block = static_cast<std::size_t>(componentsOf<Dim>(reads)) * clusterSize;
  numbers.fields.resize(clusters_.nClusters * block);
  std::size_t first = 0;
  particles.forEachField([&](const FieldInfo& info, auto values) {
    if (!reads.has(info.id)) return;
    using Value = typename decltype(values)::value_type;
    if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, Vec<Dim>>) {
      forEachIndex(clusters_.nClusters, [&, first](std::size_t c) {
        T* row = numbers.fields.data() + c * block + first * clusterSize;
        const std::size_t begin = clusters_.firstOf(c), end = clusters_.endOf(c);
        for (std::size_t k = 0; k < clusterSize; ++k) {
          const Value& value = values[std::min(begin + k, end - 1)];
          if constexpr (std::is_same_v<Value, double>)
            row[k] = static_cast<T>(value);
          else
            for (std::size_t a = 0; a < Dim; ++a)
              row[a * clusterSize + k] = static_cast<T>(value[static_cast<int>(a)]);
        }
      });
      first += static_cast<std::size_t>(componentsOf<Dim>(info.id));
    }
  });
}

template <int Dim>
template <class T>
TileWork<Dim, T> Engine<Dim>::workOf(Numbers<T>& numbers, TileChunk<Dim>& chunk) {
  TileWork<Dim, T> work{};
  work.counts = chunk.counts.data();
  work.tiles = chunk.tiles.data();
  work.locals = chunk.locals.data();
  work.firstCluster = chunk.firstCluster;
  work.nClusters = chunk.nClusters;
  work.positions = numbers.positions.data();
  work.fields = numbers.fields.data();
  work.sums = numbers.sums.data();
  return work;
}

template <int Dim>
template <class T>
void Engine<Dim>::findNear(Numbers<T>& numbers) {
  const auto searching = watch_.lap(Part::search);
  const auto find = withInstructionSet(
      instructionSet(), [](auto isa) { return &findNearTiles<decltype(isa), T, Dim>; });
  const auto chunks = list_.chunks();
  // Numbers relative to clusters round positions by less than this.
  const double radius = options_.support * (1 + 1e-5);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t c = 0; c < chunks.size(); ++c) find(workOf(numbers, chunks[c]), radius);
}

template <int Dim>
void Engine<Dim>::run(const PairPass<Dim>& pass, const ParticleSet<Dim>& particles) {
  assert(clusters_.nParticles == particles.size());
  assert(pass.receivers == Group::fluids || options_.wallsReceive);
  written_ = pass.writes;
  if (options_.precision == Precision::mixed)
    run(inFloat_, pass, pass.inFloat, particles);
  else
    run(inDouble_, pass, pass.inDouble, particles);
}

template <int Dim>
template <class T>
void Engine<Dim>::run(Numbers<T>& numbers, const PairPass<Dim>& pass, TileFunction<Dim, T> function,
                      const ParticleSet<Dim>& particles) {
  loadFields(numbers, pass.reads, particles);
  const auto summing = watch_.lap(Part::pairs);
  const std::size_t block = static_cast<std::size_t>(componentsOf<Dim>(pass.writes)) * clusterSize;
  numbers.sums.resize(list_.nSumPlaces() * block);
  const auto chunks = list_.chunks();
  const std::size_t nFluidChunks = list_.nFluidChunks();
  const auto isPartOf = [&](std::size_t c) { return c < nFluidChunks || hasWalls(pass.receivers); };

#pragma omp parallel
  {
#pragma omp for schedule(dynamic, 1)
    for (std::size_t c = 0; c < chunks.size(); ++c) {
      if (!isPartOf(c)) continue;
      TileChunk<Dim>& chunk = chunks[c];
      TileWork<Dim, T> work = workOf(numbers, chunk);
      const bool isFluid = c < nFluidChunks;
      const bool ownSources = isFluid ? hasFluids(pass.sources) : hasWalls(pass.sources);
      work.fluidTiles = ownSources && (isFluid ? hasFluids(pass.receivers) : true);
      work.fromWalls = hasWalls(pass.sources) && (isFluid ? hasFluids(pass.receivers) : true);
      work.toWalls = hasWalls(pass.receivers) && (isFluid ? hasFluids(pass.sources) : ownSources);
      work.wallTiles = work.fromWalls || work.toWalls;
      std::fill_n(work.sums + chunk.firstCluster * block, chunk.nClusters * block, T(0));
      std::fill_n(work.sums + chunk.firstHalo * block, chunk.halo.size() * block, T(0));
      function(work, pass.parameters.get());
    }
#pragma omp for schedule(static)
    for (std::size_t c = 0; c < chunks.size(); ++c) {
      if (!isPartOf(c)) continue;
      for (const auto& addition : list_.additionsTo(c)) {
        T* to = numbers.sums.data() + addition.to * block;
        const T* from = numbers.sums.data() + addition.from * block;
        for (std::size_t k = 0; k < block; ++k) to[k] += from[k];
      }
    }
  }
}

template <int Dim>
std::size_t Engine<Dim>::bytes() const {
  const auto bytesOf = [](const auto& numbers) {
    return (numbers.positions.capacity() + numbers.fields.capacity() + numbers.sums.capacity()) *
           sizeof(numbers.sums[0]);
  };
  return clusters_.bytes() + list_.bytes() + fluidOrder_.bytes() + wallOrder_.bytes() +
         order_.capacity() * sizeof(order_[0]) + bytesOf(inFloat_) + bytesOf(inDouble_);
}

template class Engine<1>;
template class Engine<2>;
template class Engine<3>;

}  // namespace plenum
