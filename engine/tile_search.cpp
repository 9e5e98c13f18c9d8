// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/tile_search.hpp"

#include "engine/instruction_set.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

/// Calls visit(shift, isShifted) for the domain itself and each periodic image of it.
template <int Dim, class Visit>
void forEachImage(const Box<Dim>& domain, Visit&& visit) {
  int n = 1;
  for (int a = 0; a < Dim; ++a) n *= domain.isPeriodic(a) ? 3 : 1;
  for (int k = 0; k < n; ++k) {
    Vec<Dim> shift;
    int rest = k;
    for (int a = 0; a < Dim; ++a) {
      if (!domain.isPeriodic(a)) continue;
      const int step = (rest % 3 + 1) % 3 - 1;  // 0, 1, -1
      rest /= 3;
      shift[a] = step * (domain.upper[a] - domain.lower[a]);
    }
    visit(shift, k != 0);
  }
}

/// A far-away box at the end of arrays of boxes, as often as a pack may read past the last.
constexpr float farAway = 1e18f;

/// Copies with room for a part more, so that later searches seldom have to allocate.
template <class Value>
void copyWithRoom(const std::vector<Value>& from, std::vector<Value>& to, double part) {
  if (to.capacity() < from.size()) {
    to = std::vector<Value>();  // frees the old one before
    to.reserve(from.size() + static_cast<std::size_t>(part * static_cast<double>(from.size())) +
               32);
  }
  to.assign(from.begin(), from.end());
}

/// Room for n values and some more, so that only the first searches allocate.
template <class Value>
void keepRoom(std::vector<Value>& values, std::size_t n) {
  if (values.capacity() < n + n / 8) values.reserve(3 * n);
}

}  // namespace

template <int Dim>
void BoxArrays<Dim>::resize(std::size_t n) {
  const auto grow = [n](std::vector<float>& values) {
    keepRoom(values, n);
    values.resize(n);
  };
  for (std::size_t a = 0; a < Dim; ++a) {
    grow(center[a]);
    grow(half[a]);
  }
  grow(reach);
}

template <int Dim>
void BoxArrays<Dim>::set(std::size_t k, const FloatBox<Dim>& box) {
  for (std::size_t a = 0; a < Dim; ++a) {
    center[a][k] = box.center.components[a];
    half[a][k] = box.half.components[a];
  }
  reach[k] = box.reach;
}

template <int Dim>
FloatBox<Dim> BoxArrays<Dim>::at(std::size_t k) const {
  FloatBox<Dim> box;
  for (std::size_t a = 0; a < Dim; ++a) {
    box.center.components[a] = center[a][k];
    box.half.components[a] = half[a][k];
  }
  box.reach = reach[k];
  return box;
}

template <int Dim>
void BoxArrays<Dim>::pad(std::size_t k) {
  const FloatBox<Dim> far{Vec<Dim, float>::filled(farAway), {}, 0};
  for (std::size_t last = k + boxPadding; k < last; ++k) set(k, far);
}

template <int Dim>
BoxRows<Dim> BoxArrays<Dim>::rows() const {
  BoxRows<Dim> rows;
  for (std::size_t a = 0; a < Dim; ++a) {
    rows.center[a] = center[a].data();
    rows.half[a] = half[a].data();
  }
  rows.reach = reach.data();
  return rows;
}

template <int Dim>
bool TileSearch<Dim>::run(std::span<const Vec<Dim>> positions, const Clusters<Dim>& clusters,
                          std::span<const ClusterGroup<Dim>> groups, const Box<Dim>& domain,
                          double unitLength, bool wallsReceive, TileChunk<Dim>& chunk) {
  clusters_ = &clusters;
  positions_ = positions;
  wallsReceive_ = wallsReceive;
  perUnit_ = 1 / unitLength;
  begin(chunk);
  const std::uint32_t firstOwn = chunk.firstCluster, lastOwn = firstOwn + chunk.nClusters;
  for (std::uint32_t c = firstOwn; c < lastOwn; ++c) addCandidate(c, Vec<Dim>{});
  const std::size_t nOwn = candidates_.size();
  for (const ClusterGroup<Dim>& group : groups) {
    // A tile belongs to the cluster with the smaller number.
    if (group.last <= firstOwn) continue;
    forEachImage(domain, [&](const Vec<Dim>& shift, bool isShifted) {
      if (isShifted || group.first != firstOwn) addNear(group, shift);
    });
  }
  finishBoxes();
  for (std::size_t c = 0; c < nOwn; ++c) {
    const Candidate& own = candidates_[c];
    found_.locals.push_back({perUnit_ * own.origin, own.cluster, own.cluster});
    candidates_[c].local = static_cast<std::uint32_t>(c);
  }
  // What is found beyond the limit would be thrown away, and could be far more than fits memory.
  for (std::size_t c = 0; c < nOwn && found_.locals.size() <= maxLocals; ++c)
    findTilesOf(c, found_);
  if (found_.locals.size() > maxLocals) return false;
  // The number of clusters hardly changes, that of tiles does as a lattice loses its order.
  copyWithRoom(found_.counts, chunk.counts, 0.02);
  copyWithRoom(found_.tiles, chunk.tiles, 0.2);
  copyWithRoom(found_.locals, chunk.locals, 0.1);
  copyWithRoom(found_.halo, chunk.halo, 0.2);
  keepRoomForMore();
  return true;
}

template <int Dim>
void TileSearch<Dim>::keepRoomForMore() {
  const auto keep = [](auto& values) { keepRoom(values, values.size()); };
  keep(candidates_);
  keep(points_);
  keep(found_.counts);
  keep(found_.tiles);
  keep(found_.locals);
  keep(found_.halo);
}

/// The boxes of all candidates, and of blocks of them.
template <int Dim>
void TileSearch<Dim>::finishBoxes() {
  const std::size_t n = candidates_.size(), nBlocks = (n + blockSize - 1) / blockSize;
  boxes_.resize(n + boxPadding);
  boxes_.pad(n);
  blocks_.resize(nBlocks + boxPadding);
  blocks_.pad(nBlocks);
  for (std::size_t b = 0; b < nBlocks; ++b) {
    FloatBox<Dim> block;
    const std::size_t first = b * blockSize, last = std::min(n, first + blockSize);
    for (std::size_t a = 0; a < Dim; ++a) {
      float lower = farAway, upper = -farAway;
      for (std::size_t k = first; k < last; ++k) {
        lower = std::min(lower, boxes_.center[a][k] - boxes_.half[a][k]);
        upper = std::max(upper, boxes_.center[a][k] + boxes_.half[a][k]);
      }
      block.center.components[a] = 0.5f * (lower + upper);
      block.half.components[a] = 0.5f * (1 + 1e-6f) * (upper - lower);
    }
    block.reach = *std::max_element(boxes_.reach.begin() + static_cast<std::ptrdiff_t>(first),
                                    boxes_.reach.begin() + static_cast<std::ptrdiff_t>(last));
    blocks_.set(b, block);
  }
  const auto grow = [](std::vector<std::uint32_t>& places, std::size_t size) {
    keepRoom(places, size);
    places.resize(size);
  };
  grow(nearBlock_, nBlocks + boxPadding);
  grow(nearCluster_, nBlocks * blockSize + boxPadding);
  grow(nearHalf_, nBlocks * blockSize + boxPadding);
}

template <int Dim>
void TileSearch<Dim>::begin(const TileChunk<Dim>& chunk) {
  found_.firstCluster = chunk.firstCluster;
  found_.nClusters = chunk.nClusters;
  found_.counts.clear();
  found_.tiles.clear();
  found_.locals.clear();
  found_.halo.clear();
  candidates_.clear();
  points_.clear();
  const std::span own = std::span(clusters_->origin).subspan(chunk.firstCluster, chunk.nClusters);
  box_ = Box<Dim>::nothing();
  reach_ = 0;
  for (std::size_t c = chunk.firstCluster; c < chunk.firstCluster + chunk.nClusters; ++c) {
    box_.extend(boxOf(*clusters_, c));
    reach_ = std::max(reach_, static_cast<double>(clusters_->boxes[c].reach));
  }
  // The median, not the middle: a stray must not take the digits of the others.
  for (int a = 0; a < Dim; ++a) {
    coordinates_.clear();
    keepRoom(coordinates_, own.size());
    for (const Vec<Dim>& origin : own) coordinates_.push_back(origin[a]);
    const auto middle = coordinates_.begin() + static_cast<std::ptrdiff_t>(own.size() / 2);
    std::ranges::nth_element(coordinates_, middle);
    origin_[a] = *middle;
  }
}

template <int Dim>
void TileSearch<Dim>::addNear(const ClusterGroup<Dim>& group, const Vec<Dim>& shift) {
  ++nTests_;
  if (!isNear(group.box, group.reach, shift)) return;
  nTests_ += group.last - group.first;
  for (std::uint32_t c = group.first; c < group.last; ++c)
    if (isNear(boxOf(*clusters_, c), static_cast<double>(clusters_->boxes[c].reach), shift))
      addCandidate(c, shift);
}

template <int Dim>
bool TileSearch<Dim>::isNear(const Box<Dim>& box, double reach, const Vec<Dim>& shift) const {
  double distanceSquared = 0;
  for (int a = 0; a < Dim; ++a) {
    const double gap = std::max(
        {box_.lower[a] - box.upper[a] - shift[a], box.lower[a] + shift[a] - box_.upper[a], 0.0});
    distanceSquared += gap * gap;
  }
  const double limit = std::max(reach, reach_);
  return distanceSquared < limit * limit;
}

template <int Dim>
void TileSearch<Dim>::addCandidate(std::uint32_t cluster, const Vec<Dim>& shift) {
  const Vec<Dim> origin = clusters_->origin[cluster] + shift - origin_;
  candidates_.push_back({origin, cluster, notLocal});
  const ClusterBox<Dim>& cornered = clusters_->boxes[cluster];
  // The search rounds to float, by 6e-8 of the coordinates of a cluster and of those that it sees.
  double size = 0;
  FloatBox<Dim> box;
  for (int a = 0; a < Dim; ++a) {
    const double lower = static_cast<double>(cornered.lower[a]),
                 upper = static_cast<double>(cornered.upper[a]);
    box.center[a] = static_cast<float>(perUnit_ * (origin[a] + 0.5 * (lower + upper)));
    box.half[a] = static_cast<float>(perUnit_ * 0.5 * (1 + 1e-6) * (upper - lower));
    size += std::abs(origin[a]) + (upper - lower) + static_cast<double>(cornered.reach);
  }
  box.reach = static_cast<float>(perUnit_ * (static_cast<double>(cornered.reach) + 1e-6 * size));
  if (boxes_.size() < candidates_.size()) boxes_.resize(2 * candidates_.size());
  boxes_.set(candidates_.size() - 1, box);
  // Where there are fewer than eight particles, the last one again.
  const std::size_t first = clusters_->firstOf(cluster), end = clusters_->endOf(cluster);
  const Vec<Dim> toChunk = shift - origin_;
  const std::size_t before = points_.size();
  points_.resize(before + clusterSize * Dim);
  float* x = points_.data() + before;
  for (int a = 0; a < Dim; ++a)
    for (std::size_t k = 0; k < clusterSize; ++k)
      *x++ =
          static_cast<float>(perUnit_ * (positions_[std::min(first + k, end - 1)][a] + toChunk[a]));
}

/// The box around particles [first, last) of a candidate.
template <int Dim>
FloatBox<Dim> TileSearch<Dim>::boxOfPoints(std::size_t candidate, std::size_t first,
                                           std::size_t last) const {
  FloatBox<Dim> box;
  box.reach = boxes_.reach[candidate];
  const float* x = points_.data() + candidate * clusterSize * Dim;
  for (int a = 0; a < Dim; ++a, x += clusterSize) {
    const auto [lower, upper] = std::minmax_element(x + first, x + last);
    box.center[a] = 0.5f * (*lower + *upper);
    box.half[a] = 0.5f * (*upper - *lower) * (1 + 1e-6f);
  }
  return box;
}

/// Notes the candidates near one of the chunk's clusters, and their boxes side by side.
template <int Dim>
std::size_t TileSearch<Dim>::findNear(std::size_t own) {
  const auto [select, selectInBlocks] = withInstructionSet(instructionSet(), []<class Isa>(Isa) {
    return std::pair(&selectBoxes<Isa, Dim>, &plenum::selectInBlocks<Isa, Dim>);
  });
  const FloatBox<Dim> box = boxOfPoints(own, 0, clusterSize);
  const std::size_t nBlocks =
      select(blocks_.rows(), blocks_.size() - boxPadding, box, nearBlock_.data());
  // A tile belongs to the cluster with the smaller number.
  const auto blocks = std::span<const std::uint32_t>(nearBlock_).first(nBlocks);
  const auto firstBlock = std::ranges::lower_bound(blocks, own / blockSize);
  const std::size_t n =
      selectInBlocks(boxes_.rows(), std::to_address(firstBlock),
                     static_cast<std::size_t>(blocks.end() - firstBlock), box, nearCluster_.data());
  nTests_ += blocks_.size() + static_cast<std::size_t>(blocks.end() - firstBlock) * blockSize;
  nearBoxes_.resize(n + boxPadding);
  for (std::size_t k = 0; k < n; ++k) nearBoxes_.set(k, boxes_.at(nearCluster_[k]));
  nearBoxes_.pad(n);
  return n;
}

/// The tiles of both halves of one of the chunk's clusters.
template <int Dim>
void TileSearch<Dim>::findTilesOf(std::size_t own, TileChunk<Dim>& chunk) {
  const auto [select, selectClusters] = withInstructionSet(instructionSet(), []<class Isa>(Isa) {
    return std::pair(&selectBoxes<Isa, Dim>, &plenum::selectClusters<Isa, Dim>);
  });
  const std::size_t nNear = findNear(own);
  const std::uint32_t cluster = candidates_[own].cluster;
  for (std::size_t part = 0; part < 2; ++part) {
    const FloatBox<Dim> box =
        boxOfPoints(own, part * clusterSize / 2, (part + 1) * clusterSize / 2);
    std::size_t count = select(nearBoxes_.rows(), nNear, box, nearHalf_.data());
    nTests_ += nNear + count;
    count = selectClusters(points_.data(), boxes_.reach.data(), nearCluster_.data(),
                           nearHalf_.data(), count, box, nearHalf_.data());
    // Tiles of one kind are consecutive: candidates of fluids come before those of walls, and only
    // the cluster itself and its images must be picked out.
    std::array<std::size_t, 3> counts{};
    for (const bool wantSelf : {true, false})
      for (std::size_t k = 0; k < count; ++k) {
        Candidate& other = candidates_[nearHalf_[k]];
        if (other.cluster < cluster || (other.cluster == cluster) != wantSelf) continue;
        chunk.tiles.push_back(static_cast<std::uint16_t>(localOf(other, chunk)));
        ++counts[wantSelf ? 0 : other.cluster < clusters_->nFluidClusters ? 1 : 2];
      }
    chunk.counts.push_back({static_cast<std::uint16_t>(counts[0]),
                            static_cast<std::uint16_t>(counts[1]),
                            static_cast<std::uint16_t>(counts[2])});
  }
}

template <int Dim>
std::uint32_t TileSearch<Dim>::localOf(Candidate& candidate, TileChunk<Dim>& chunk) {
  if (candidate.local != notLocal) return candidate.local;
  candidate.local = static_cast<std::uint32_t>(chunk.locals.size());
  std::uint32_t sums = candidate.cluster;
  const bool isOwn = candidate.cluster - chunk.firstCluster < chunk.nClusters;
  const bool receives = wallsReceive_ || candidate.cluster < clusters_->nFluidClusters;
  if (!isOwn && receives) {
    sums = inHalo + static_cast<std::uint32_t>(chunk.halo.size());
    chunk.halo.push_back(candidate.cluster);
  }
  chunk.locals.push_back({perUnit_ * candidate.origin, candidate.cluster, sums});
  return candidate.local;
}

template class TileSearch<1>;
template class TileSearch<2>;
template class TileSearch<3>;

}  // namespace plenum
