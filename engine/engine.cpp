// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/engine.hpp"

#include "engine/derived_fields.hpp"
#include "engine/instruction_set.hpp"
#include "engine/load_clusters.hpp"
#include "particles/errors.hpp"
#include "particles/parallel.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <omp.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace plenum {

void requireIndices(std::size_t nParticles) {
  constexpr std::size_t most = std::size_t{1} << 30;
  if (nParticles > most)
    throw RunError(fmt::format(
        "{} particles: one process computes at most {}; use a larger spacing", nParticles, most));
}

template <int Dim>
Engine<Dim>::Engine(const Box<Dim>& domain, const Options& options)
    : domain_(domain),
      options_(options),
      periodicity_(domain),
      largestSupport_(options.support),
      smallestSupport_(options.support) {
  if (!options.adaptive) requireRoomForSupport();
}

/// Each pair must have one nearest image only.
template <int Dim>
void Engine<Dim>::requireRoomForSupport() const {
  for (int a = 0; a < Dim; ++a) {
    if (!domain_.isPeriodic(a)) continue;
    const double length = domain_.upper[a] - domain_.lower[a];
    if (length < 2 * largestSupport_)
      throw InputError(
          fmt::format("periodic axis {}: length {:g} m is shorter than twice the kernel's support "
                      "{:g} m; use a longer box, a smaller smoothing_length or a smaller spacing",
                      "xyz"[a], length, largestSupport_));
  }
}

/// Whether some pair may be within the support now that the list does not have: it has those closer
/// than the support, as it was then, and the skin.
template <int Dim>
bool Engine<Dim>::isOld() const {
  const double skin = (1 + options_.skin - growth_) * smallestSupport_;
  return !skinIsUsable_ || !(2 * travelled_ < skin);
}

template <int Dim>
bool Engine<Dim>::update(ParticleSet<Dim>& particles) {
  const bool isNew = clusters_.nParticles != particles.size() || nRebuilds_ == 0;
  const bool old = isNew || isOld();
  if (old) {
    sort(particles);
    search(particles);
  }
  const auto prepare = [&](auto& numbers) {
    loadPositions(numbers, particles);
    findNear(numbers);
  };
  if (precision_ == Precision::mixed)
    prepare(inFloat_);
  else
    prepare(inDouble_);
  return old;
}

/// Throws RunError for a position that no order can place, and for more particles than indices.
template <int Dim>
void Engine<Dim>::requireSortable(const ParticleSet<Dim>& particles) const {
  const auto positions = particles[field::position];
  const std::size_t n = positions.size();
  requireIndices(n);
  const double farthest = mostSupportsAway * largestSupport_;
  std::size_t bad = n;
#pragma omp parallel for schedule(static) reduction(min : bad) if (n >= worthThreads)
  for (std::size_t i = 0; i < n; ++i)
    if (!(normSquared(positions[i]) < farthest * farthest)) bad = std::min(bad, i);
  if (bad == n) return;
  throw RunError(
      fmt::format("particle {}: its position ({}) is not finite or further than {:g} m from the "
                  "origin; look at "
                  "the last good state for what drove it out",
                  particles.has(field::id) ? particles[field::id][bad] : bad,
                  fmt::join(positions[bad].components, ", "), farthest));
}

template <int Dim>
void Engine<Dim>::sort(ParticleSet<Dim>& particles) {
  const auto sorting = watch_.lap(Part::sort);
  const auto positions = particles[field::position];
  const std::size_t n = positions.size();
  forget();  // an update that fails must be tried again
  if (options_.adaptive) setSupports(particles);
  requireSortable(particles);
  forEachIndex(n, [&](std::size_t i) { positions[i] = domain_.wrap(positions[i]); });
  const std::size_t nFluid = particles.nFluid(), nWalls = n - nFluid;
  arena_.begin(3 * n * sizeof(std::uint32_t) + n * ParticleSet<Dim>::permuteBytes);
  const auto order = arena_.take<std::uint32_t>(n);
  const auto sorted = arena_.take<std::uint32_t>(n), cells = arena_.take<std::uint32_t>(n);
  clusters_.clear();
  spatialOrder_.sort(positions.first(nFluid), order.first(nFluid), sorted.first(nFluid),
                     cells.first(nFluid));
  clusters_.append(spatialOrder_.cellEnds(), true);
  spatialOrder_.sort(positions.subspan(nFluid), order.last(nWalls), sorted.last(nWalls),
                     cells.last(nWalls));
  clusters_.append(spatialOrder_.cellEnds(), false);
  for (std::uint32_t& k : order.last(nWalls)) k += static_cast<std::uint32_t>(nFluid);
  particles.permute(order, arena_.take<std::byte>(n * ParticleSet<Dim>::permuteBytes));
}

template <int Dim>
void Engine<Dim>::setSupports(const ParticleSet<Dim>& particles) {
  const auto lengths = particles[field::smoothingLength];
  double largest = 0, smallest = std::numeric_limits<double>::infinity();
  const std::size_t n = lengths.size();
  std::size_t bad = n;
#pragma omp parallel for schedule(static) reduction(max : largest) reduction(min : smallest, bad)
  for (std::size_t i = 0; i < n; ++i) {
    largest = std::max(largest, lengths[i]);
    smallest = std::min(smallest, lengths[i]);
    if (!(lengths[i] > 0 && std::isfinite(lengths[i]))) bad = std::min(bad, i);
  }
  if (bad < n)
    throw RunError(fmt::format("particle {}: its smoothing length {} is not positive and finite",
                               particles.has(field::id) ? particles[field::id][bad] : bad,
                               lengths[bad]));
  largestSupport_ = 2 * largest;
  smallestSupport_ = 2 * smallest;
  requireRoomForSupport();
}

template <int Dim>
void Engine<Dim>::search(const ParticleSet<Dim>& particles) {
  const auto searching = watch_.lap(Part::search);
  const auto positions = particles[field::position];
  arena_.begin(clusters_.nClusters * sizeof(ClusterBox<Dim>));
  const auto boxes = arena_.take<ClusterBox<Dim>>(clusters_.nClusters);
  const double withSkin = 1 + options_.skin;
  if (options_.adaptive) {
    const auto lengths = particles[field::smoothingLength];
    clusters_.place(
        positions, domain_, [&](std::size_t i) { return withSkin * 2 * lengths[i]; }, boxes);
  } else {
    clusters_.place(
        positions, domain_, [&](std::size_t) { return withSkin * options_.support; }, boxes);
  }
  list_.build(positions, clusters_, domain_, options_.units.length, options_.wallsReceive);
  travelled_ = 0;
  growth_ = 1;
  ++nRebuilds_;

  // A few particles far from their cluster (a stray, the last drops of a spray) lose digits in
  // float, by 6e-8 of their distance; where that is too much, pairs are computed in double.
  precision_ = options_.precision;
  for (const ClusterBox<Dim>& box : clusters_.boxes)
    for (int a = 0; a < Dim; ++a)
      if (std::max(-box.lower[a], box.upper[a]) > 200 * box.smallestReach)
        precision_ = Precision::doubled;

  // A position is read as the image nearest to the origin of its cluster. Where that is unsure,
  // because a cluster spans half the period, every step searches anew.
  skinIsUsable_ = true;
  for (int a = 0; a < Dim; ++a) {
    if (!domain_.isPeriodic(a)) continue;
    const double skin = options_.skin * smallestSupport_;
    const double limit = 0.5 * (domain_.upper[a] - domain_.lower[a] - skin);
    for (const ClusterBox<Dim>& box : clusters_.boxes)
      if (static_cast<double>(std::max(-box.lower[a], box.upper[a])) > limit) skinIsUsable_ = false;
  }
}

template <int Dim>
void Engine<Dim>::run(const PairPass<Dim>& pass, const ParticleSet<Dim>& particles) {
  assert(clusters_.nParticles == particles.size());
  assert((pass.receivers == Group::fluids && !pass.reactions) || options_.wallsReceive);
  written_ = pass.writes;
  if (precision_ == Precision::mixed)
    run(inFloat_, pass, pass.inFloat, particles);
  else
    run(inDouble_, pass, pass.inDouble, particles);
}

template <int Dim>
template <class T>
void Engine<Dim>::run(Numbers<T>& numbers, const PairPass<Dim>& pass, TileFunction<Dim, T> function,
                      const ParticleSet<Dim>& particles) {
  const std::size_t nIn = static_cast<std::size_t>(componentsOf<Dim>(pass.reads)) * clusterSize;
  const std::size_t nOut = static_cast<std::size_t>(componentsOf<Dim>(pass.writes)) * clusterSize;
  arena_.begin((clusters_.nClusters * nIn + list_.nSumPlaces() * nOut) * sizeof(T));
  numbers.fields = arena_.template take<T>(clusters_.nClusters * nIn);
  numbers.sums = arena_.template take<T>(list_.nSumPlaces() * nOut);
  loadFields(numbers, pass.reads, particles);

  const auto summing = watch_.lap(Part::pairs);
  const auto chunks = list_.chunks();
  const auto takesPart = [&](std::size_t c) {
    return c < list_.nFluidChunks() || hasWalls(pass.receivers) || pass.reactions;
  };
#pragma omp parallel
  {
#pragma omp for schedule(dynamic, 1)
    for (std::size_t c = 0; c < chunks.size(); ++c) {
      if (!takesPart(c)) continue;
      const TileChunk<Dim>& chunk = chunks[c];
      const TileWork<Dim, T> work = workOf(numbers, c, pass);
      std::fill_n(work.sums + chunk.firstCluster * nOut, chunk.nClusters * nOut, T(0));
      std::fill_n(work.sums + chunk.firstHalo * nOut, chunk.halo.size() * nOut, T(0));
      function(work, pass.parameters.get());
    }
#pragma omp for schedule(static)
    for (std::size_t c = 0; c < chunks.size(); ++c) {
      if (!takesPart(c)) continue;
      for (const auto& addition : list_.additionsTo(c)) {
        T* to = numbers.sums.data() + addition.to * nOut;
        const T* from = numbers.sums.data() + addition.from * nOut;
        for (std::size_t k = 0; k < nOut; ++k) to[k] += from[k];
      }
    }
  }
}

template <int Dim>
template <class T>
TileWork<Dim, T> Engine<Dim>::workOf(Numbers<T>& numbers, std::size_t c) {
  TileChunk<Dim>& chunk = list_.chunks()[c];
  TileWork<Dim, T> work{};
  work.counts = chunk.counts.data();
  work.tiles = chunk.tiles.data();
  work.locals = chunk.locals.data();
  work.nClusters = chunk.nClusters;
  work.positions = numbers.positions.data();
  work.smoothingLengths = options_.adaptive ? numbers.smoothingLengths.data() : nullptr;
  work.fields = numbers.fields.data();
  work.sums = numbers.sums.data();
  return work;
}

template <int Dim>
template <class T>
TileWork<Dim, T> Engine<Dim>::workOf(Numbers<T>& numbers, std::size_t c,
                                     const PairPass<Dim>& pass) {
  // Chunks of walls have tiles among walls only.
  const bool isFluid = c < list_.nFluidChunks();
  const bool receives = isFluid ? hasFluids(pass.receivers) : hasWalls(pass.receivers);
  const bool gives = isFluid ? hasFluids(pass.sources) : hasWalls(pass.sources);
  TileWork<Dim, T> work = workOf(numbers, c);
  work.fluidTiles = receives && gives;
  work.fromWalls = receives && hasWalls(pass.sources);
  work.toWalls = (gives && hasWalls(pass.receivers)) || (work.fromWalls && pass.reactions);
  work.wallTiles = work.fromWalls || work.toWalls;
  return work;
}

/// Calls body(run) for runs of clusters that together are all, from all threads.
template <int Dim>
template <class Body>
void Engine<Dim>::forEachRun(Body&& body) const {
  constexpr std::size_t size = 256;
  const std::size_t nRuns = (clusters_.nClusters + size - 1) / size;
#pragma omp parallel for schedule(static)
  for (std::size_t r = 0; r < nRuns; ++r)
    body(ClusterRun{r * size, std::min((r + 1) * size, clusters_.nClusters),
                    clusters_.first.data()});
}

template <int Dim>
template <class T>
void Engine<Dim>::loadPositions(Numbers<T>& numbers, const ParticleSet<Dim>& particles) {
  const auto loading = watch_.lap(Part::load);
  numbers.positions.resize(clusters_.nClusters * Dim * clusterSize);
  // Places without a particle lie where nobody gets: in float, clusters are no wider than `search`
  // lets them be; in double, not further away than `requireSortable` allows.
  const PositionSource<Dim> source{particles[field::position].data(),
                                   clusters_.origin.data(),
                                   periodicity_.period,
                                   periodicity_.half,
                                   domain_.anyPeriodic(),
                                   (std::is_same_v<T, float> ? 1e4 : 1e16) * largestSupport_,
                                   1 / options_.units.length};
  const auto load = withInstructionSet(
      instructionSet(), [](auto isa) { return &plenum::loadPositions<decltype(isa), T, Dim>; });
  forEachRun([&](const ClusterRun& run) {
    load(source, run, numbers.positions.data() + run.begin * Dim * clusterSize);
  });
  if (!options_.adaptive) return;
  numbers.smoothingLengths.resize(clusters_.nClusters * clusterSize);
  const auto loadScalar = withInstructionSet(
      instructionSet(), [](auto isa) { return &loadField<decltype(isa), T, 1>; });
  forEachRun([&](const ClusterRun& run) {
    loadScalar(particles[field::smoothingLength].data(), 1 / options_.units.length, run,
               clusterSize, numbers.smoothingLengths.data() + run.begin * clusterSize);
  });
}

namespace {

template <int Dim>
DerivedSource sourceOf(const DerivedField& derived, const ParticleSet<Dim>& particles) {
  const auto valuesOf = [&](Field<Rank::scalar> wanted, FieldSet among) -> const double* {
    return among.has(wanted) && particles.has(wanted) ? particles[wanted].data() : nullptr;
  };
  DerivedSource source{};
  for (const auto candidate : {field::mass, field::pressure})
    if (derived.numerator.has(candidate)) source.numerator = particles[candidate].data();
  source.addend = valuesOf(field::viscousPressure, derived.addend);
  source.density = particles[field::density].data();
  if (derived.power == 2)
    source.secondDensity =
        particles.has(field::omegaDensity) ? particles[field::omegaDensity].data() : source.density;
  return source;
}

}  // namespace

template <int Dim>
template <class T>
void Engine<Dim>::loadFields(Numbers<T>& numbers, FieldSet reads,
                             const ParticleSet<Dim>& particles) {
  const auto loading = watch_.lap(Part::load);
  const std::size_t stride = static_cast<std::size_t>(componentsOf<Dim>(reads)) * clusterSize;
  struct Loaders {
    decltype(&loadField<isa::Baseline, T, 1>) scalar, vector;
    decltype(&loadDerived<isa::Baseline, T>) derived;
  };
  const Loaders load = withInstructionSet(instructionSet(), []<class Isa>(Isa) {
    return Loaders{&loadField<Isa, T, 1>, &loadField<Isa, T, Dim>, &loadDerived<Isa, T>};
  });
  forEachRun([&](const ClusterRun& run) {
    const auto placeOf = [&](FieldId id) {
      return numbers.fields.data() + run.begin * stride +
             static_cast<std::size_t>(offsetOf<Dim>(reads, id)) * clusterSize;
    };
    const auto scaleOf = [&](FieldId id) { return 1 / options_.units.of(id, Dim); };
    particles.forEachField([&](const FieldInfo& info, auto values) {
      if (!reads.has(info.id)) return;
      using Value = typename decltype(values)::value_type;
      if constexpr (std::is_same_v<Value, double>)
        load.scalar(values.data(), scaleOf(info.id), run, stride, placeOf(info.id));
      else if constexpr (std::is_same_v<Value, Vec<Dim>>)
        load.vector(&values.data()->components[0], scaleOf(info.id), run, stride, placeOf(info.id));
    });
    for (const DerivedField& derived : derivedTable) {
      if (!reads.has(derived.id)) continue;
      load.derived(sourceOf(derived, particles), scaleOf(derived.id), run, stride,
                   placeOf(derived.id));
    }
  });
}

template <int Dim>
template <class T>
void Engine<Dim>::findNear(Numbers<T>& numbers) {
  const auto searching = watch_.lap(Part::search);
  const auto find = withInstructionSet(
      instructionSet(), [](auto isa) { return &findNearTiles<decltype(isa), T, Dim>; });
  // A little more: rounded distances decide here, and the kernel is zero beyond the support anyway.
  const double radius = (options_.adaptive ? 2 * (1 + options_.lengthSkin)
                                           : options_.support / options_.units.length) *
                        (1 + 1e-5);
  const std::size_t nChunks = list_.chunks().size();
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t c = 0; c < nChunks; ++c) find(workOf(numbers, c), radius);
}

template <int Dim>
std::size_t Engine<Dim>::bytes() const {
  return clusters_.bytes() + list_.bytes() + arena_.bytes() +
         (inFloat_.positions.capacity() + inFloat_.smoothingLengths.capacity()) * sizeof(float) +
         (inDouble_.positions.capacity() + inDouble_.smoothingLengths.capacity()) * sizeof(double);
}

template class Engine<1>;
template class Engine<2>;
template class Engine<3>;

}  // namespace plenum
