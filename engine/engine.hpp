// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/aligned.hpp"
#include "engine/layout.hpp"
#include "engine/pair_pass.hpp"
#include "engine/periodicity.hpp"
#include "engine/spatial_order.hpp"
#include "engine/stopwatch.hpp"
#include "engine/tile_list.hpp"
#include "engine/units.hpp"
#include "particles/parallel.hpp"
#include "particles/particle_set.hpp"

#include <limits>
#include <tuple>

namespace plenum {

/// Numbers in which pairs are computed; the state of particles is always in double.
enum class Precision {
  mixed,   ///< float, positions relative to clusters of eight
  doubled  ///< double
};

/// Throws RunError if a process cannot number so many particles: places of particles and of sums
/// are 32-bit numbers, one bit of which marks halos in the search.
void requireIndices(std::size_t nParticles);

/// Particles may be at most so many supports away from the origin: coordinates are rounded to a
/// ten-thousandth of the support there.
inline constexpr double mostSupportsAway = 1e12;

/// The sums of a field in the last pass, cluster by cluster. `T` is what they were computed in.
template <Rank R, int Dim, class T>
class SumView {
 public:
  using Value = ValueOf<R, Dim>;

  SumView(const Clusters<Dim>& clusters, const T* sums, double unit, int nOut, int first)
      : clusters_(&clusters),
        sums_(sums + static_cast<std::size_t>(first) * clusterSize),
        block_(static_cast<std::size_t>(nOut) * clusterSize),
        unit_(unit) {}

  /// Clusters of the fluids, or of all particles.
  std::size_t nClusters(bool wallsToo) const {
    return wallsToo ? clusters_->nClusters : clusters_->nFluidClusters;
  }

  /// The sum of the particle at a place of a cluster, a double or Vec<Dim>, in SI.
  Value at(std::size_t cluster, std::size_t place) const {
    const T* value = sums_ + cluster * block_ + place;
    if constexpr (R == Rank::vector) {
      Vec<Dim> v;
      for (int a = 0; a < Dim; ++a)
        v[a] = unit_ * static_cast<double>(value[static_cast<std::size_t>(a) * clusterSize]);
      return v;
    } else {
      return unit_ * static_cast<double>(*value);
    }
  }

  /// Calls body(i, place) for each particle of a cluster.
  template <class Body>
  void forEachPlace(std::size_t cluster, Body&& body) const {
    const std::size_t first = clusters_->firstOf(cluster), end = clusters_->endOf(cluster);
    for (std::size_t i = first; i < end; ++i) body(i, i - first);
  }

  /// Calls body(i, sum) for each particle of a cluster.
  template <class Body>
  void forEach(std::size_t cluster, Body&& body) const {
    forEachPlace(cluster, [&](std::size_t i, std::size_t place) { body(i, at(cluster, place)); });
  }

 private:
  const Clusters<Dim>* clusters_;
  const T* sums_;
  std::size_t block_;
  double unit_;
};

/// Keeps particles sorted in clusters and knows who is near whom. The solver, relaxation and report
/// card see neighbours only through the passes that an engine runs.
template <int Dim>
class Engine {
 public:
  struct Options {
    double support = 0;         ///< largest distance at which particles interact [m]
    double skin = 0.2;          ///< extra list radius, in units of the support
    bool wallsReceive = false;  ///< some pass has walls among its receivers
    Precision precision = Precision::mixed;
    Units units = {};       ///< that passes were made for
    bool adaptive = false;  ///< supports are twice field::smoothingLength, not `support`
    double lengthSkin = 0;  ///< part of itself by which a length may grow between two updates
  };

  /// Throws InputError if a periodic axis of `domain` is shorter than twice the support (adaptive
  /// ones: `update` does, for the largest).
  Engine(const Box<Dim>& domain, const Options& options);

  /// To be called before the passes of a step. Where particles may have moved by half the skin
  /// since the last search, wraps them into the domain, reorders and searches anew; returns whether
  /// it did. Throws RunError for particles that cannot be sorted or searched.
  bool update(ParticleSet<Dim>& particles);

  /// Whether the next update will search anew, wherever particles go until then.
  bool isOld() const;

  /// To be called when particles have moved: no one further than `distance` [m].
  void moved(double distance) { travelled_ += distance; }
  /// To be called when smoothing lengths have changed: none by a larger factor. Passes see no pair
  /// too few if that is at most `Options::lengthSkin`, or after an update.
  void grew(double factor) { growth_ *= std::max(1.0, factor); }
  double lengthSkin() const { return options_.lengthSkin; }
  /// Search anew at the next update.
  void forget() { travelled_ = std::numeric_limits<double>::infinity(); }

  /// Computes the sums of a pass for all its receivers, from the fields as they are now. `update`
  /// must have been called for these positions. Each sum is added up in an order that does not
  /// depend on the number of threads.
  void run(const PairPass<Dim>& pass, const ParticleSet<Dim>& particles);

  /// Calls visit(sums) with a SumView of what the last pass wrote for a field.
  template <Rank R, class Visit>
  void withSums(Field<R> field, Visit&& visit) const {
    const int nOut = componentsOf<Dim>(written_), first = offsetOf<Dim>(written_, field.id);
    const double unit = options_.units.of(field.id, Dim);
    if (precision_ == Precision::mixed)
      visit(SumView<R, Dim, float>(clusters_, inFloat_.sums.data(), unit, nOut, first));
    else
      visit(SumView<R, Dim, double>(clusters_, inDouble_.sums.data(), unit, nOut, first));
  }

  /// Calls body(i, sums...) for each particle of a group, in parallel: what the last pass wrote for
  /// these fields.
  template <class Body, Rank... R>
  void forEachSum(Group group, Body&& body, Field<R>... fields) const {
    const int nOut = componentsOf<Dim>(written_);
    const auto visit = [&]<class T>(const Numbers<T>& numbers) {
      const std::tuple views(SumView<R, Dim, T>(clusters_, numbers.sums.data(),
                                                options_.units.of(fields.id, Dim), nOut,
                                                offsetOf<Dim>(written_, fields.id))...);
      const std::size_t begin = hasFluids(group) ? 0 : clusters_.nFluidClusters;
      const std::size_t end = hasWalls(group) ? clusters_.nClusters : clusters_.nFluidClusters;
      forEachIndex(end - begin, [&](std::size_t k) {
        const std::size_t c = begin + k, first = clusters_.firstOf(c);
        for (std::size_t i = first; i < clusters_.endOf(c); ++i)
          std::apply([&](const auto&... view) { body(i, view.at(c, i - first)...); }, views);
      });
    };
    precision_ == Precision::mixed ? visit(inFloat_) : visit(inDouble_);
  }

  /// A copy of them: for tests and tools.
  template <Rank R>
  std::vector<ValueOf<R, Dim>> sums(Field<R> field) const {
    std::vector<ValueOf<R, Dim>> copy(options_.wallsReceive ? clusters_.nParticles
                                                            : clusters_.nFluid);
    withSums(field, [&](const auto& view) {
      for (std::size_t c = 0; c < view.nClusters(options_.wallsReceive); ++c)
        view.forEach(c, [&](std::size_t i, const auto& sum) { copy[i] = sum; });
    });
    return copy;
  }

  /// The largest support of a particle [m].
  double support() const { return largestSupport_; }
  const Units& units() const { return options_.units; }
  /// What the present list is computed in; double where float would not do.
  Precision precision() const { return precision_; }
  std::size_t nRebuilds() const { return nRebuilds_; }
  const TileList<Dim>& tiles() const { return list_; }
  std::size_t bytes() const;

  /// Where the time of the steps went; whoever moves the particles counts its part, too.
  Stopwatch& stopwatch() { return watch_; }
  const Stopwatch& stopwatch() const { return watch_; }

 private:
  /// What pairs are computed from and to, in clusters.
  template <class T>
  struct Numbers {
    AlignedVector<T> positions;         ///< relative to the origin of the cluster
    AlignedVector<T> smoothingLengths;  ///< empty if all have the same
    std::span<T> fields, sums;          ///< of the last pass, in the arena
  };

  void requireSortable(const ParticleSet<Dim>& particles) const;
  void sort(ParticleSet<Dim>& particles);
  void search(const ParticleSet<Dim>& particles);
  void setSupports(const ParticleSet<Dim>& particles);
  void requireRoomForSupport() const;
  template <class T>
  void loadPositions(Numbers<T>& numbers, const ParticleSet<Dim>& particles);
  template <class T>
  void loadFields(Numbers<T>& numbers, FieldSet reads, const ParticleSet<Dim>& particles);
  template <class Body>
  void forEachRun(Body&& body) const;
  template <class T>
  void findNear(Numbers<T>& numbers);
  template <class T>
  void run(Numbers<T>& numbers, const PairPass<Dim>& pass, TileFunction<Dim, T> function,
           const ParticleSet<Dim>& particles);
  template <class T>
  TileWork<Dim, T> workOf(Numbers<T>& numbers, std::size_t chunk);
  template <class T>
  TileWork<Dim, T> workOf(Numbers<T>& numbers, std::size_t chunk, const PairPass<Dim>& pass);

  Box<Dim> domain_;
  Options options_;
  Periodicity<Dim> periodicity_;
  double largestSupport_, smallestSupport_;  // when the list was made [m]
  bool skinIsUsable_ = true;                 // by the present list
  double travelled_ = 0, growth_ = 1;        // since the last search [m], []
  SpatialOrder<Dim> spatialOrder_;
  Arena arena_;                             // of a sort, then of each pass
  Precision precision_ = Precision::mixed;  // of the present list
  Clusters<Dim> clusters_;
  TileList<Dim> list_;
  Numbers<float> inFloat_;
  Numbers<double> inDouble_;
  FieldSet written_;
  std::size_t nRebuilds_ = 0;
  Stopwatch watch_;
};

extern template class Engine<1>;
extern template class Engine<2>;
extern template class Engine<3>;

}  // namespace plenum
