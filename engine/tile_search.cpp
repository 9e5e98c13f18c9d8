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

/// Copies with a little room to grow, so that later searches seldom have to allocate.
template <class Value>
void copyWithRoom(const std::vector<Value>& from, std::vector<Value>& to) {
  if (to.capacity() < from.size()) {
    to = {};
    to.reserve(from.size() + from.size() / 4 + 256);
  }
  to.assign(from.begin(), from.end());
}

template <int Dim>
BoxRows<Dim> rowsOf(const std::array<std::vector<float>, Dim>& centers,
                    const std::array<std::vector<float>, Dim>& halves,
                    const std::vector<float>& reaches) {
  BoxRows<Dim> rows;
  for (std::size_t a = 0; a < Dim; ++a) {
    rows.center[a] = centers[a].data();
    rows.half[a] = halves[a].data();
  }
  rows.reach = reaches.data();
  return rows;
}

}  // namespace

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
  for (std::size_t a = 0; a < Dim; ++a) {
    centers_[a].insert(centers_[a].end(), boxPadding, farAway);
    halves_[a].insert(halves_[a].end(), boxPadding, 0.0f);
    nearCenters_[a].resize(centers_[a].size());
    nearHalves_[a].resize(centers_[a].size());
  }
  reaches_.insert(reaches_.end(), boxPadding, 0.0f);
  nearReaches_.resize(reaches_.size());
  nearCluster_.resize(candidates_.size() + boxPadding);
  nearHalf_.resize(candidates_.size() + boxPadding);
  for (std::size_t c = 0; c < nOwn; ++c) {
    const Candidate& own = candidates_[c];
    found_.locals.push_back({perUnit_ * own.origin, own.cluster, own.cluster});
    candidates_[c].local = static_cast<std::uint32_t>(c);
  }
  // What is found beyond the limit would be thrown away, and could be far more than fits memory.
  for (std::size_t c = 0; c < nOwn && found_.locals.size() <= maxLocals; ++c)
    findTilesOf(c, found_);
  if (found_.locals.size() > maxLocals) return false;
  copyWithRoom(found_.counts, chunk.counts);
  copyWithRoom(found_.tiles, chunk.tiles);
  copyWithRoom(found_.locals, chunk.locals);
  copyWithRoom(found_.halo, chunk.halo);
  keepRoom();
  return true;
}

/// Work space for three times as much, so that only the first searches allocate.
template <int Dim>
void TileSearch<Dim>::keepRoom() {
  const auto keep = [](auto& values) {
    if (values.capacity() < values.size() + values.size() / 8) values.reserve(3 * values.size());
  };
  keep(candidates_);
  keep(points_);
  keep(nearCluster_);
  keep(nearHalf_);
  keep(reaches_);
  keep(nearReaches_);
  keep(found_.counts);
  keep(found_.tiles);
  keep(found_.locals);
  keep(found_.halo);
  for (std::size_t a = 0; a < Dim; ++a) {
    keep(centers_[a]);
    keep(halves_[a]);
    keep(nearCenters_[a]);
    keep(nearHalves_[a]);
  }
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
  reaches_.clear();
  for (std::size_t a = 0; a < Dim; ++a) {
    centers_[a].clear();
    halves_[a].clear();
  }
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
  const ClusterBox<Dim>& box = clusters_->boxes[cluster];
  // The search rounds to float, by 6e-8 of the coordinates of a cluster and of those that it sees.
  double size = 0;
  for (int a = 0; a < Dim; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const double lower = static_cast<double>(box.lower[a]),
                 upper = static_cast<double>(box.upper[a]);
    centers_[axis].push_back(static_cast<float>(perUnit_ * (origin[a] + 0.5 * (lower + upper))));
    halves_[axis].push_back(static_cast<float>(perUnit_ * 0.5 * (1 + 1e-6) * (upper - lower)));
    size += std::abs(origin[a]) + (upper - lower) + static_cast<double>(box.reach);
  }
  reaches_.push_back(static_cast<float>(perUnit_ * (static_cast<double>(box.reach) + 1e-6 * size)));
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
  box.reach = reaches_[candidate];
  const float* x = points_.data() + candidate * clusterSize * Dim;
  for (int a = 0; a < Dim; ++a, x += clusterSize) {
    const auto [lower, upper] = std::minmax_element(x + first, x + last);
    box.center[a] = 0.5f * (*lower + *upper);
    box.half[a] = 0.5f * (*upper - *lower) * (1 + 1e-6f);
  }
  return box;
}

/// The tiles of both halves of one of the chunk's clusters.
template <int Dim>
void TileSearch<Dim>::findTilesOf(std::size_t own, TileChunk<Dim>& chunk) {
  const auto select = withInstructionSet(instructionSet(),
                                         [](auto isa) { return &selectBoxes<decltype(isa), Dim>; });
  const auto selectNear = withInstructionSet(
      instructionSet(), [](auto isa) { return &selectClusters<decltype(isa), Dim>; });

  // First those near the whole cluster; their boxes side by side.
  const std::size_t n = candidates_.size();
  const std::size_t nNear = select(rowsOf<Dim>(centers_, halves_, reaches_), own, n,
                                   boxOfPoints(own, 0, clusterSize), nearCluster_.data());
  for (std::size_t k = 0; k < nNear; ++k) nearReaches_[k] = reaches_[nearCluster_[k]];
  for (std::size_t a = 0; a < Dim; ++a) {
    for (std::size_t k = 0; k < nNear; ++k) {
      nearCenters_[a][k] = centers_[a][nearCluster_[k]];
      nearHalves_[a][k] = halves_[a][nearCluster_[k]];
    }
  }
  nTests_ += n - own + 2 * nNear;
  const std::uint32_t cluster = candidates_[own].cluster;
  for (std::size_t part = 0; part < 2; ++part) {
    const FloatBox<Dim> box =
        boxOfPoints(own, part * clusterSize / 2, (part + 1) * clusterSize / 2);
    std::size_t count = select(rowsOf<Dim>(nearCenters_, nearHalves_, nearReaches_), 0, nNear, box,
                               nearHalf_.data());
    nTests_ += count;
    count = selectNear(points_.data(), reaches_.data(), nearCluster_.data(), nearHalf_.data(),
                       count, box, nearHalf_.data());
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
