// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/tile_list.hpp"

#include "engine/tile_search.hpp"
#include "particles/errors.hpp"
#include "particles/parallel.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>

namespace plenum {

template <int Dim>
void Clusters<Dim>::clear() {
  nParticles = nFluid = nFluidClusters = nClusters = 0;
  first.assign(1, 0);
}

template <int Dim>
void Clusters<Dim>::append(std::span<const std::size_t> cellEnds, bool areFluid) {
  const std::size_t before = nParticles;
  first.pop_back();
  std::size_t begin = 0;
  for (const std::size_t end : cellEnds)
    for (; begin < end; begin = std::min(end, begin + clusterSize))
      first.push_back(static_cast<std::uint32_t>(before + begin));
  nParticles = before + begin;
  nClusters = first.size();
  first.push_back(static_cast<std::uint32_t>(nParticles));
  if (!areFluid) return;
  nFluid = nParticles;
  nFluidClusters = nClusters;
}

template <int Dim>
void Clusters<Dim>::placeOne(std::size_t c, std::span<const Vec<Dim>> positions,
                             const Box<Dim>& domain) {
  const std::size_t begin = firstOf(c), n = endOf(c) - begin;
  for (int a = 0; a < Dim; ++a) {
    std::array<double, clusterSize> x{};
    for (std::size_t k = 0; k < n; ++k) x[k] = positions[begin + k][a];
    for (std::size_t k = 1; k < n; ++k)  // by insertion: eight are few
      for (std::size_t q = k; q > 0 && x[q] < x[q - 1]; --q) std::swap(x[q], x[q - 1]);
    origin[c][a] = domain.isPeriodic(a) ? 0.5 * (x[0] + x[n - 1]) : x[n / 2];
    // To float, and never smaller.
    constexpr double outwards = 1 + 1e-6;
    boxes[c].lower[a] = static_cast<float>(outwards * (x[0] - origin[c][a]));
    boxes[c].upper[a] = static_cast<float>(outwards * (x[n - 1] - origin[c][a]));
  }
}

template <int Dim>
struct TileList<Dim>::Work {
  std::vector<TileSearch<Dim>> searches;  // one a thread
  std::vector<ClusterGroup<Dim>> groups;
  std::vector<std::size_t> nextAddition;
};

template <int Dim>
TileList<Dim>::TileList() : work_(std::make_unique<Work>()) {}
template <int Dim>
TileList<Dim>::~TileList() = default;
template <int Dim>
TileList<Dim>::TileList(TileList&&) noexcept = default;
template <int Dim>
TileList<Dim>& TileList<Dim>::operator=(TileList&&) noexcept = default;

template <int Dim>
void TileList<Dim>::divide(const Clusters<Dim>& clusters, bool wallsReceive) {
  nFluidClusters_ = clusters.nFluidClusters;
  const auto count = [&](std::size_t n) { return (n + chunkSize_ - 1) / chunkSize_; };
  nFluidChunks_ = count(clusters.nFluidClusters);
  nChunks_ = nFluidChunks_;
  if (wallsReceive) nChunks_ += count(clusters.nClusters - clusters.nFluidClusters);
  if (chunks_.size() < nChunks_) chunks_.resize(nChunks_);
  for (std::size_t c = 0; c < nChunks_; ++c) {
    const bool isFluid = c < nFluidChunks_;
    const std::size_t first =
        isFluid ? c * chunkSize_ : nFluidClusters_ + (c - nFluidChunks_) * chunkSize_;
    const std::size_t end =
        std::min(first + chunkSize_, isFluid ? nFluidClusters_ : clusters.nClusters);
    chunks_[c].firstCluster = static_cast<std::uint32_t>(first);
    chunks_[c].nClusters = static_cast<std::uint32_t>(end - first);
  }
}

/// Runs of clusters as long as chunks, of walls that do not receive, too.
template <int Dim>
void TileList<Dim>::group(const Clusters<Dim>& clusters) {
  auto& groups = work_->groups;
  groups.clear();
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (std::size_t first = begin; first < end; first += chunkSize_)
      groups.push_back({static_cast<std::uint32_t>(first),
                        static_cast<std::uint32_t>(std::min(end, first + chunkSize_)),
                        Box<Dim>::nothing(), 0});
  };
  add(0, clusters.nFluidClusters);
  add(clusters.nFluidClusters, clusters.nClusters);
  forEachIndex(groups.size(), [&](std::size_t g) {
    for (std::size_t c = groups[g].first; c < groups[g].last; ++c) {
      groups[g].box.extend(boxOf(clusters, c));
      groups[g].reach = std::max(groups[g].reach, static_cast<double>(clusters.boxes[c].reach));
    }
  });
}

template <int Dim>
std::size_t TileList<Dim>::chunkOf(std::size_t cluster) const {
  return cluster < nFluidClusters_ ? cluster / chunkSize_
                                   : nFluidChunks_ + (cluster - nFluidClusters_) / chunkSize_;
}

template <int Dim>
void TileList<Dim>::build(std::span<const Vec<Dim>> positions, const Clusters<Dim>& clusters,
                          const Box<Dim>& domain, double unitLength, bool wallsReceive) {
  const auto nThreads = static_cast<std::size_t>(omp_get_max_threads());
  if (work_->searches.size() < nThreads) work_->searches.resize(nThreads);
  // Chunks of equal numbers of clusters: large enough that few clusters lie outside of the chunk
  // whose tiles they are in, small enough that threads share the work evenly. Their number does not
  // depend on the number of threads, so that sums do not, either.
  constexpr std::size_t smallest = Dim == 3 ? 512 : 256, largest = 2048, wanted = 64;
  chunkSize_ = std::clamp(clusters.nClusters / wanted, smallest, largest);
  while (!tryBuild(positions, clusters, domain, unitLength, wallsReceive)) {
    // So many neighbours that the numbers of a chunk do not suffice: smaller chunks see fewer.
    if (chunkSize_ == 1)
      throw RunError(fmt::format(
          "one particle has more than {} neighbours: sums over neighbours are not made for so "
          "many; "
          "use a smaller smoothing_length, or look whether particles were drawn together",
          maxLocals * clusterSize / 2));
    chunkSize_ /= 2;
  }
  linkHalos(clusters);
}

template <int Dim>
bool TileList<Dim>::tryBuild(std::span<const Vec<Dim>> positions, const Clusters<Dim>& clusters,
                             const Box<Dim>& domain, double unitLength, bool wallsReceive) {
  divide(clusters, wallsReceive);
  group(clusters);
  std::atomic<bool> fits = true;  // if one chunk does not, the others are of no use
  FirstFailure failure;
  // Not dynamic: the space of each search grows in the first steps, and then no more.
#pragma omp parallel for schedule(static, 1)
  for (std::size_t c = 0; c < nChunks_; ++c)
    failure.watch(c, [&] {
      if (!fits) return;
      TileSearch<Dim>& search = work_->searches[static_cast<std::size_t>(omp_get_thread_num())];
      if (!search.run(positions, clusters, work_->groups, domain, unitLength, wallsReceive,
                      chunks_[c]))
        fits = false;
    });
  failure.rethrow();
  return fits;
}

/// Gives every halo its place among the sums, and every chunk the list of sums to fetch.
template <int Dim>
void TileList<Dim>::linkHalos(const Clusters<Dim>& clusters) {
  std::size_t place = clusters.nClusters;
  firstAddition_.assign(nChunks_ + 1, 0);
  for (std::size_t c = 0; c < nChunks_; ++c) {
    chunks_[c].firstHalo = static_cast<std::uint32_t>(place);
    place += chunks_[c].halo.size();
    for (const std::uint32_t cluster : chunks_[c].halo) ++firstAddition_[chunkOf(cluster) + 1];
  }
  if (place > std::numeric_limits<std::uint32_t>::max())
    throw RunError(
        fmt::format("{} places for sums are more than can be numbered: too many particles "
                    "for one process; use a larger spacing",
                    place));
  nSumPlaces_ = place;
  for (std::size_t c = 0; c < nChunks_; ++c) firstAddition_[c + 1] += firstAddition_[c];
  const std::size_t nAdditions = place - clusters.nClusters;
  if (additions_.capacity() < nAdditions) additions_.reserve(nAdditions + nAdditions / 8 + 64);
  additions_.resize(nAdditions);
  std::vector<std::size_t>& next = work_->nextAddition;
  next.assign(firstAddition_.begin(), firstAddition_.end() - 1);
  for (std::size_t c = 0; c < nChunks_; ++c) {
    std::uint32_t from = chunks_[c].firstHalo;
    for (const std::uint32_t cluster : chunks_[c].halo)
      additions_[next[chunkOf(cluster)]++] = {cluster, from++};
    for (LocalCluster<Dim>& local : chunks_[c].locals)
      if (local.sums >= inHalo) local.sums = chunks_[c].firstHalo + (local.sums - inHalo);
  }
}

template <int Dim>
std::size_t TileList<Dim>::nTiles() const {
  std::size_t n = 0;
  for (const auto& chunk : chunks()) n += chunk.tiles.size();
  return n;
}

template <int Dim>
std::size_t TileList<Dim>::nTests() const {
  std::size_t n = 0;
  for (const auto& search : work_->searches) n += search.nTests();
  return n;
}

template <int Dim>
std::size_t TileList<Dim>::bytes() const {
  std::size_t sum = additions_.capacity() * sizeof(Addition);
  for (const auto& chunk : chunks_)
    sum += chunk.counts.capacity() * sizeof(TileCounts) + chunk.tiles.capacity() * 2 +
           chunk.locals.capacity() * sizeof(LocalCluster<Dim>) + chunk.halo.capacity() * 4;
  return sum;
}

template struct Clusters<1>;
template struct Clusters<2>;
template struct Clusters<3>;
template class TileList<1>;
template class TileList<2>;
template class TileList<3>;

}  // namespace plenum
