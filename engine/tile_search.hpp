// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/box_selection.hpp"
#include "engine/tile_list.hpp"

#include <array>
#include <limits>

namespace plenum {

/// Added to LocalCluster::sums of clusters in the halo until their places are known.
inline constexpr std::uint32_t inHalo = 1u << 31;

/// Clusters that a chunk's tiles can tell apart.
inline constexpr std::size_t maxLocals = std::numeric_limits<std::uint16_t>::max();

/// The box around a cluster [m].
template <int Dim>
Box<Dim> boxOf(const Clusters<Dim>& clusters, std::size_t cluster) {
  Box<Dim> box;
  for (int a = 0; a < Dim; ++a) {
    const double origin = clusters.origin[cluster][a];
    box.lower[a] = origin + static_cast<double>(clusters.boxes[cluster].lower[a]);
    box.upper[a] = origin + static_cast<double>(clusters.boxes[cluster].upper[a]);
  }
  return box;
}

/// A run of clusters and the box around them: where a chunk's search begins.
template <int Dim>
struct ClusterGroup {
  std::uint32_t first = 0, last = 0;
  Box<Dim> box;
  double reach = 0;  ///< the largest of its clusters [m]
};

/// Boxes as arrays, as the loops of box_selection want them.
template <int Dim>
struct BoxArrays {
  std::array<std::vector<float>, Dim> center, half;
  std::vector<float> reach;

  void resize(std::size_t n);
  std::size_t size() const { return reach.size(); }
  void set(std::size_t k, const FloatBox<Dim>& box);
  FloatBox<Dim> at(std::size_t k) const;
  /// Sets the boxes from k to k + boxPadding to some that are far from all others.
  void pad(std::size_t k);
  BoxRows<Dim> rows() const;
};

/// The search for the tiles of one chunk, from the large to the small: which groups of clusters can
/// be near the chunk, which of their clusters, which of these near one cluster of the chunk, and
/// which have a particle near half of it.
template <int Dim>
class TileSearch {
 public:
  /// Fills `chunk`. Returns whether its numbers suffice: false if it sees more than maxLocals
  /// clusters, and the chunk is of no use then. The work space stays for the next call.
  bool run(std::span<const Vec<Dim>> positions, const Clusters<Dim>& clusters,
           std::span<const ClusterGroup<Dim>> groups, const Box<Dim>& domain, double unitLength,
           bool wallsReceive, TileChunk<Dim>& chunk);

  /// Boxes and clusters that all calls have compared: what a search costs.
  std::size_t nTests() const { return nTests_; }

 private:
  struct Candidate {
    Vec<Dim> origin;  // relative to the chunk [m]
    std::uint32_t cluster;
    std::uint32_t local;  // its place in the chunk's `locals`
  };
  static constexpr std::uint32_t notLocal = std::numeric_limits<std::uint32_t>::max();

  void keepRoomForMore();
  void begin(const TileChunk<Dim>& chunk);
  void finishBoxes();
  void addNear(const ClusterGroup<Dim>& group, const Vec<Dim>& shift);
  bool isNear(const Box<Dim>& box, double reach, const Vec<Dim>& shift) const;
  void addCandidate(std::uint32_t cluster, const Vec<Dim>& shift);
  std::size_t findNear(std::size_t own);
  FloatBox<Dim> boxOfPoints(std::size_t candidate, std::size_t first, std::size_t last) const;
  void findTilesOf(std::size_t own, TileChunk<Dim>& chunk);
  std::uint32_t localOf(Candidate& candidate, TileChunk<Dim>& chunk);

  const Clusters<Dim>* clusters_ = nullptr;
  std::span<const Vec<Dim>> positions_;
  bool wallsReceive_ = false;
  double perUnit_ = 1;  // units of length in a metre
  Box<Dim> box_;        // of the chunk
  Vec<Dim> origin_;     // what its positions are relative to
  double reach_ = 0;    // the largest of its clusters [m]
  std::vector<double> coordinates_;
  // Clusters that may be in a tile: the chunk's own, their images, those of other fluids, of walls.
  std::vector<Candidate> candidates_;
  // Their boxes, those of blocks of them, and particles ([candidate][axis][particle]); relative to
  // `origin_` [unit of length].
  BoxArrays<Dim> boxes_, blocks_;
  std::vector<float> points_;
  BoxArrays<Dim> nearBoxes_;  // of those near one cluster
  std::vector<std::uint32_t> nearBlock_, nearCluster_, nearHalf_;
  TileChunk<Dim> found_;
  std::size_t nTests_ = 0;
};

extern template class TileSearch<1>;
extern template class TileSearch<2>;
extern template class TileSearch<3>;

}  // namespace plenum
