// SPDX-License-Identifier: GPL-3.0-or-later
//
// Who is near whom, in units of clusters: eight consecutive particles each, in the order of
// SpatialOrder. A tile is half a cluster of receivers against a whole cluster of neighbours.
#pragma once

#include "engine/spatial_order.hpp"
#include "particles/box.hpp"
#include "particles/parallel.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace plenum {

template <int Dim>
struct ClusterBox {
  Vec<Dim, float> lower, upper;
  float reach;          ///< largest distance at which one of its particles sees others [m]
  float smallestReach;  ///< and the smallest [m]
};

/// Runs of at most eight particles that lie near each other: those of fluids first, then those of
/// walls.
template <int Dim>
struct Clusters {
  std::size_t nParticles = 0, nFluid = 0;
  std::size_t nFluidClusters = 0, nClusters = 0;
  std::vector<std::uint32_t> first{0};  ///< particle of each cluster; length nClusters + 1
  /// What positions are relative to [m], length nClusters: along open axes the median of the
  /// coordinates, so that one particle far away does not take the digits of the others; along
  /// periodic axes the middle, which is never further than half a period from a particle.
  std::vector<Vec<Dim>> origin;
  /// The boxes around the particles, relative to the origins, rounded outwards [m]. length
  /// nClusters; there only for the search.
  std::span<ClusterBox<Dim>> boxes;

  std::size_t firstOf(std::size_t cluster) const { return first[cluster]; }
  std::size_t endOf(std::size_t cluster) const { return first[cluster + 1]; }

  void clear();
  /// Cuts cells of particles that follow those there are into clusters: no cluster has particles of
  /// two cells. cellEnds: as SpatialOrder::cellEnds().
  void append(std::span<const std::size_t> cellEnds, bool areFluid);
  /// Sets origins and boxes. reach(i) [m]: the distance at which particle i sees others.
  template <class Reach>
  void place(std::span<const Vec<Dim>> positions, const Box<Dim>& domain, Reach&& reach,
             std::span<ClusterBox<Dim>> roomForBoxes);

  std::size_t bytes() const {
    return origin.capacity() * sizeof(Vec<Dim>) + first.capacity() * sizeof(first[0]);
  }

 private:
  void placeOne(std::size_t cluster, std::span<const Vec<Dim>> positions, const Box<Dim>& domain);
};

template <int Dim>
template <class Reach>
void Clusters<Dim>::place(std::span<const Vec<Dim>> positions, const Box<Dim>& domain,
                          Reach&& reach, std::span<ClusterBox<Dim>> roomForBoxes) {
  origin.resize(nClusters);
  boxes = roomForBoxes;
  forEachIndex(nClusters, [&](std::size_t c) {
    placeOne(c, positions, domain);
    double largest = 0, smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = firstOf(c); i < endOf(c); ++i) {
      largest = std::max(largest, reach(i));
      smallest = std::min(smallest, reach(i));
    }
    boxes[c].reach = static_cast<float>(largest * (1 + 1e-6));  // never smaller
    boxes[c].smallestReach = static_cast<float>(smallest);
  });
}

/// A cluster as a chunk sees it.
template <int Dim>
struct LocalCluster {
  Vec<Dim> origin;        ///< relative to the chunk, periodic image included [unit of length]
  std::uint32_t cluster;  ///< whose fields
  std::uint32_t sums;     ///< place of its sums: the cluster itself, or one of the chunk's halo
};

/// How many tiles half a cluster has, in the order of the list, and how many of each kind come
/// first because they hold a pair within the support now. A neighbour cluster with a larger number
/// than the receivers' gets the sums of the same tile, so that each pair is computed once.
struct TileCounts {
  std::uint16_t self = 0;   ///< with its own cluster: only the receivers get sums
  std::uint16_t fluid = 0;  ///< with clusters of fluid
  std::uint16_t wall = 0;   ///< with clusters of walls
  std::uint16_t nearSelf = 0, nearFluid = 0, nearWall = 0;

  std::uint32_t all() const { return std::uint32_t{self} + fluid + wall; }
};

/// The tiles of consecutive clusters: the unit of work of a thread.
template <int Dim>
struct TileChunk {
  std::uint32_t firstCluster = 0, nClusters = 0;
  std::vector<TileCounts> counts;         ///< two a cluster
  std::vector<std::uint16_t> tiles;       ///< places in `locals`
  std::vector<LocalCluster<Dim>> locals;  ///< the chunk's own clusters first
  std::vector<std::uint32_t> halo;        ///< clusters of other chunks that get sums from this one
  std::uint32_t firstHalo = 0;            ///< place of the first of them among all sums
};

template <int Dim>
class TileList {
 public:
  TileList();
  ~TileList();
  TileList(TileList&&) noexcept;
  TileList& operator=(TileList&&) noexcept;

  /// All tiles with a pair closer than the larger reach of the two clusters; `unitLength` [m] is
  /// that of LocalCluster.
  void build(std::span<const Vec<Dim>> positions, const Clusters<Dim>& clusters,
             const Box<Dim>& domain, double unitLength, bool wallsReceive);

  std::span<const TileChunk<Dim>> chunks() const { return {chunks_.data(), nChunks_}; }
  std::span<TileChunk<Dim>> chunks() { return {chunks_.data(), nChunks_}; }
  std::size_t nFluidChunks() const { return nFluidChunks_; }

  /// Places that sums need: one a cluster, then the halos of the chunks.
  std::size_t nSumPlaces() const { return nSumPlaces_; }

  /// Sums of `from` that other chunks hold: to be added to those of `to`, in this order.
  struct Addition {
    std::uint32_t to, from;
  };
  std::span<const Addition> additionsTo(std::size_t chunk) const {
    return {additions_.data() + firstAddition_[chunk],
            firstAddition_[chunk + 1] - firstAddition_[chunk]};
  }

  std::size_t nTiles() const;
  /// Boxes and clusters that all searches have compared so far: what they cost.
  std::size_t nTests() const;
  std::size_t bytes() const;

 private:
  struct Work;

  bool tryBuild(std::span<const Vec<Dim>> positions, const Clusters<Dim>& clusters,
                const Box<Dim>& domain, double unitLength, bool wallsReceive);
  void divide(const Clusters<Dim>& clusters, bool wallsReceive);
  void group(const Clusters<Dim>& clusters);
  void linkHalos(const Clusters<Dim>& clusters);
  std::size_t chunkOf(std::size_t cluster) const;

  std::vector<TileChunk<Dim>> chunks_;
  std::size_t nChunks_ = 0, nFluidChunks_ = 0, nFluidClusters_ = 0;
  std::size_t chunkSize_ = 1;  // clusters
  std::size_t nSumPlaces_ = 0;
  std::vector<Addition> additions_;
  std::vector<std::size_t> firstAddition_;
  std::unique_ptr<Work> work_;  // space of the search
};

extern template class TileList<1>;
extern template class TileList<2>;
extern template class TileList<3>;
extern template struct Clusters<1>;
extern template struct Clusters<2>;
extern template struct Clusters<3>;

}  // namespace plenum
