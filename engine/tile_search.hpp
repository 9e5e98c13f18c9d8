// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for the tiles of one chunk, from the large to the small: which groups of clusters can
// be near the chunk, which of their clusters, which of these near eight clusters of the chunk, and
// which have a particle near half a cluster.
#pragma once

#include <algorithm>
#include "engine/tile_list.hpp"

#include <cmath>
#include <limits>

namespace plenum {

inline constexpr std::uint32_t inHalo =
    1u << 31;  ///< added to LocalCluster::sums until places are known

template <int Dim>
Box<Dim> boxOf(std::span<const Vec<Dim>> points) {
  Box<Dim> box = Box<Dim>::nothing();
  for (const Vec<Dim>& x : points)
    for (int a = 0; a < Dim; ++a) {
      box.lower[a] = std::min(box.lower[a], x[a]);
      box.upper[a] = std::max(box.upper[a], x[a]);
    }
  return box;
}

/// A float that is not smaller than `length`.
inline float roundedUp(double length) { return static_cast<float>(length * (1 + 1e-6)); }

/// Boxes of runs of clusters.
template <int Dim>
struct SearchGroups {
  struct Group {
    std::uint32_t first, last;  ///< clusters
    Box<Dim> box;
  };
  std::vector<Group> groups;

  SearchGroups(const Clusters<Dim>& clusters, std::size_t size) {
    const auto add = [&](std::size_t begin, std::size_t end) {
      for (std::size_t first = begin; first < end; first += size) {
        Group group{static_cast<std::uint32_t>(first),
                    static_cast<std::uint32_t>(std::min(end, first + size)), Box<Dim>::nothing()};
        for (std::size_t c = group.first; c < group.last; ++c)
          for (int a = 0; a < Dim; ++a) {
            const double half = static_cast<double>(clusters.halfSize[c][a]);
            group.box.lower[a] = std::min(group.box.lower[a], clusters.origin[c][a] - half);
            group.box.upper[a] = std::max(group.box.upper[a], clusters.origin[c][a] + half);
          }
        groups.push_back(group);
      }
    };
    add(0, clusters.nFluidClusters);
    add(clusters.nFluidClusters, clusters.nClusters);
  }
};

/// Boxes relative to the chunk, as arrays that a loop tests many at a time.
template <int Dim>
struct BoxArrays {
  std::array<std::vector<float>, Dim> center, half;
  std::vector<std::uint32_t> who;

  std::size_t size() const { return who.size(); }
  void clear() {
    who.clear();
    for (int a = 0; a < Dim; ++a) {
      center[static_cast<std::size_t>(a)].clear();
      half[static_cast<std::size_t>(a)].clear();
    }
  }
  void push(const Vec<Dim, float>& c, const Vec<Dim, float>& h, std::uint32_t index) {
    for (int a = 0; a < Dim; ++a) {
      center[static_cast<std::size_t>(a)].push_back(c[a]);
      half[static_cast<std::size_t>(a)].push_back(h[a]);
    }
    who.push_back(index);
  }

  /// Appends to `near` the places in [first, size()) whose boxes are closer than `radius` to a box.
  void findNear(const Vec<Dim, float>& c, const Vec<Dim, float>& h, float radius, std::size_t first,
                std::vector<std::uint32_t>& near) {
    const std::size_t n = size();
    distance_.resize(n);
    float* const distance = distance_.data();
    for (int a = 0; a < Dim; ++a) {
      const float* const cj = center[static_cast<std::size_t>(a)].data();
      const float* const hj = half[static_cast<std::size_t>(a)].data();
      const float ci = c[a], hi = h[a];
      for (std::size_t k = first; k < n; ++k) {
        const float gap = std::max(std::abs(cj[k] - ci) - (hj[k] + hi), 0.0f);
        distance[k] = (a == 0 ? 0.0f : distance[k]) + gap * gap;
      }
    }
    const float limit = radius * radius;
    const std::size_t before = near.size();
    near.resize(before + n - first);
    std::uint32_t* next = near.data() + before;
    for (std::size_t k = first; k < n; ++k) {
      *next = static_cast<std::uint32_t>(k);
      next += distance[k] < limit;
    }
    near.resize(static_cast<std::size_t>(next - near.data()));
  }

 private:
  std::vector<float> distance_;
};

template <int Dim>
class TileSearch {
 public:
  void run(std::span<const Vec<Dim>> positions, const Clusters<Dim>& clusters,
           const SearchGroups<Dim>& groups, const Box<Dim>& domain, double radius,
           bool wallsReceive, TileChunk<Dim>& chunk) {
    clusters_ = &clusters;
    positions_ = positions;
    begin(chunk, radius);
    for (std::uint32_t c = chunk.firstCluster; c < chunk.firstCluster + chunk.nClusters; ++c)
      addCandidate(c, Vec<Dim>{});
    nOwn_ = candidates_.size();
    const bool chunkIsFluid = chunk.firstCluster < clusters.nFluidClusters;
    for (const auto& group : groups.groups) {
      // Pairs belong to the cluster with the smaller number; walls see fluids from there.
      if (group.last <= chunk.firstCluster) continue;
      forEachImage(domain, [&](const Vec<Dim>& shift, bool isShifted) {
        addNear(group, shift, isShifted, chunk);
      });
    }
    (void)chunkIsFluid;
    findTiles(chunk, wallsReceive);
  }

 private:
  struct Candidate {
    Vec<Dim> origin;  // relative to the chunk
    std::uint32_t cluster;
    std::uint32_t local;
  };
  static constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t bundle = 8;  // clusters that share a first selection

  void begin(TileChunk<Dim>& chunk, double radius) {
    chunk.counts.clear();
    chunk.tiles.clear();
    chunk.locals.clear();
    chunk.halo.clear();
    candidates_.clear();
    boxes_.clear();
    points_.clear();
    box_ = Box<Dim>::nothing();
    for (std::uint32_t c = chunk.firstCluster; c < chunk.firstCluster + chunk.nClusters; ++c)
      for (int a = 0; a < Dim; ++a) {
        const double half = static_cast<double>(clusters_->halfSize[c][a]);
        box_.lower[a] = std::min(box_.lower[a], clusters_->origin[c][a] - half);
        box_.upper[a] = std::max(box_.upper[a], clusters_->origin[c][a] + half);
      }
    origin_ = box_.center();
    double extent = radius;
    for (int a = 0; a < Dim; ++a) extent += box_.upper[a] - box_.lower[a];
    radius_ = radius + 1e-6 * extent;  // the search rounds to float
  }

  /// Calls visit(shift, isShifted) for each periodic image that can matter.
  template <class Visit>
  static void forEachImage(const Box<Dim>& domain, Visit&& visit) {
    int n = 1;
    for (int a = 0; a < Dim; ++a) n *= domain.isPeriodic(a) ? 3 : 1;
    for (int k = 0; k < n; ++k) {
      Vec<Dim> shift;
      bool isShifted = false;
      int rest = k;
      for (int a = 0; a < Dim; ++a) {
        if (!domain.isPeriodic(a)) continue;
        const int step = (rest % 3 + 1) % 3 - 1;  // 0, 1, -1
        rest /= 3;
        shift[a] = step * (domain.upper[a] - domain.lower[a]);
        isShifted |= step != 0;
      }
      visit(shift, isShifted);
    }
  }

  void addNear(const typename SearchGroups<Dim>::Group& group, const Vec<Dim>& shift,
               bool isShifted, const TileChunk<Dim>& chunk) {
    const bool isOwn = group.first == chunk.firstCluster;
    if (isOwn && !isShifted) return;
    if (!isNear(group.box.center() + shift, 0.5 * group.box.extent())) return;
    for (std::uint32_t c = group.first; c < group.last; ++c) {
      Vec<Dim> half;
      for (int a = 0; a < Dim; ++a) half[a] = static_cast<double>(clusters_->halfSize[c][a]);
      if (isNear(clusters_->origin[c] + shift, half)) addCandidate(c, shift);
    }
  }

  bool isNear(const Vec<Dim>& center, const Vec<Dim>& half) const {
    double distanceSquared = 0;
    for (int a = 0; a < Dim; ++a) {
      const double gap =
          std::max({box_.lower[a] - center[a] - half[a], center[a] - half[a] - box_.upper[a], 0.0});
      distanceSquared += gap * gap;
    }
    return distanceSquared < radius_ * radius_;
  }

  void addCandidate(std::uint32_t cluster, const Vec<Dim>& shift) {
    const Vec<Dim> origin = clusters_->origin[cluster] + shift - origin_;
    Vec<Dim, float> center;
    for (int a = 0; a < Dim; ++a) center[a] = static_cast<float>(origin[a]);
    boxes_.push(center, clusters_->halfSize[cluster], cluster);
    candidates_.push_back({origin, cluster, unused});
    // Positions of the cluster's particles; the last one again where there are fewer than eight.
    const std::size_t first = clusters_->firstOf(cluster), end = clusters_->endOf(cluster);
    const Vec<Dim> toChunk = shift - origin_;
    for (int a = 0; a < Dim; ++a)
      for (std::size_t k = 0; k < clusterSize; ++k)
        points_.push_back(
            static_cast<float>(positions_[std::min(first + k, end - 1)][a] + toChunk[a]));
  }

  /// The box around particles [first, last) of a candidate.
  void boxOfPoints(std::size_t candidate, std::size_t first, std::size_t last,
                   Vec<Dim, float>& center, Vec<Dim, float>& half) const {
    const float* x = points_.data() + candidate * clusterSize * Dim;
    for (int a = 0; a < Dim; ++a, x += clusterSize) {
      float lower = x[first], upper = x[first];
      for (std::size_t k = first + 1; k < last; ++k) {
        lower = std::min(lower, x[k]);
        upper = std::max(upper, x[k]);
      }
      center[a] = 0.5f * (lower + upper);
      half[a] = 0.5f * (upper - lower) * (1 + 1e-6f);
    }
  }

  /// Whether some particle of the candidate is near the box.
  bool hasPointNear(std::size_t candidate, const Vec<Dim, float>& center,
                    const Vec<Dim, float>& half, float radiusSquared) const {
    const float* x = points_.data() + candidate * clusterSize * Dim;
    std::array<float, clusterSize> distance{};
    for (int a = 0; a < Dim; ++a, x += clusterSize)
      for (std::size_t k = 0; k < clusterSize; ++k) {
        const float gap = std::max(std::abs(x[k] - center[a]) - half[a], 0.0f);
        distance[k] += gap * gap;
      }
    float least = distance[0];
    for (std::size_t k = 1; k < clusterSize; ++k) least = std::min(least, distance[k]);
    return least < radiusSquared;
  }

  void findTiles(TileChunk<Dim>& chunk, bool wallsReceive) {
    const auto radius = static_cast<float>(radius_);
    for (std::size_t c = 0; c < nOwn_; ++c) {
      chunk.locals.push_back(
          {candidates_[c].origin, candidates_[c].cluster, candidates_[c].cluster});
      candidates_[c].local = static_cast<std::uint32_t>(c);
    }
    for (std::size_t first = 0; first < nOwn_; first += bundle) {
      const std::size_t last = std::min(nOwn_, first + bundle);
      // One box around the bundle.
      Vec<Dim, float> center, half;
      for (int a = 0; a < Dim; ++a) {
        const auto axis = static_cast<std::size_t>(a);
        float lower = std::numeric_limits<float>::max(), upper = -lower;
        for (std::size_t c = first; c < last; ++c) {
          lower = std::min(lower, boxes_.center[axis][c] - boxes_.half[axis][c]);
          upper = std::max(upper, boxes_.center[axis][c] + boxes_.half[axis][c]);
        }
        center[a] = 0.5f * (lower + upper);
        half[a] = 0.5f * (upper - lower) * (1 + 1e-6f);
      }
      nearBundle_.clear();
      boxes_.findNear(center, half, radius, first, nearBundle_);
      bundleBoxes_.clear();
      for (const std::uint32_t k : nearBundle_) {
        Vec<Dim, float> cj, hj;
        for (int a = 0; a < Dim; ++a) {
          cj[a] = boxes_.center[static_cast<std::size_t>(a)][k];
          hj[a] = boxes_.half[static_cast<std::size_t>(a)][k];
        }
        bundleBoxes_.push(cj, hj, k);
      }
      for (std::size_t c = first; c < last; ++c)
        for (std::size_t part = 0; part < 2; ++part) findTilesOf(c, part, chunk, wallsReceive);
    }
  }

  /// The tiles of half a cluster.
  void findTilesOf(std::size_t own, std::size_t part, TileChunk<Dim>& chunk, bool wallsReceive) {
    Vec<Dim, float> center, half;
    boxOfPoints(own, part * clusterSize / 2, (part + 1) * clusterSize / 2, center, half);
    const auto radius = static_cast<float>(radius_);
    nearHalf_.clear();
    bundleBoxes_.findNear(center, half, radius, 0, nearHalf_);
    const std::uint32_t cluster = candidates_[own].cluster;
    TileCounts counts;
    // Candidates come in the order own chunk, its images, other fluids, walls; the tiles of one
    // kind must be consecutive.
    for (int kind = 0; kind < 2; ++kind)
      for (const std::uint32_t n : nearHalf_) {
        const std::uint32_t k = bundleBoxes_.who[n];
        const std::uint32_t other = candidates_[k].cluster;
        if (other < cluster || (other == cluster) != (kind == 0)) continue;
        if (!hasPointNear(k, center, half, radius * radius)) continue;
        const bool isWall = other >= clusters_->nFluidClusters;
        chunk.tiles.push_back(localOf(k, chunk, wallsReceive));
        ++(kind == 0 ? counts.self : isWall ? counts.wall : counts.fluid);
      }
    chunk.counts.push_back(counts);
  }

  std::uint32_t localOf(std::uint32_t k, TileChunk<Dim>& chunk, bool wallsReceive) {
    Candidate& candidate = candidates_[k];
    if (candidate.local != unused) return candidate.local;
    candidate.local = static_cast<std::uint32_t>(chunk.locals.size());
    std::uint32_t sums = candidate.cluster;
    const bool isOwn = candidate.cluster - chunk.firstCluster < chunk.nClusters;
    const bool receives = wallsReceive || candidate.cluster < clusters_->nFluidClusters;
    if (!isOwn && receives) {
      sums = inHalo + static_cast<std::uint32_t>(chunk.halo.size());
      chunk.halo.push_back(candidate.cluster);
    }
    chunk.locals.push_back({candidate.origin, candidate.cluster, sums});
    return candidate.local;
  }

  const Clusters<Dim>* clusters_ = nullptr;
  std::span<const Vec<Dim>> positions_;
  Box<Dim> box_;
  Vec<Dim> origin_;
  double radius_ = 0;
  std::size_t nOwn_ = 0;
  std::vector<Candidate> candidates_;
  BoxArrays<Dim> boxes_, bundleBoxes_;  // of the candidates; of those near a bundle
  std::vector<float> points_;           // [candidate][axis][particle]
  std::vector<std::uint32_t> nearBundle_, nearHalf_;
};

}  // namespace plenum
