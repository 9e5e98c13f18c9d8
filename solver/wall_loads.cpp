// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/wall_loads.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plenum {

namespace {

/// Loads of all walls that share a block of particles.
struct Block {
  std::vector<WallLoad> loads;

  Block& operator+=(const Block& other) {
    loads.resize(std::max(loads.size(), other.loads.size()));
    for (std::size_t w = 0; w < other.loads.size(); ++w) loads[w] += other.loads[w];
    return *this;
  }
};

/// A force [N] at the end of an arm [m].
WallLoad loadOf(const std::array<double, 3>& force, const std::array<double, 3>& arm) {
  WallLoad load{force, {}};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
    load.torque[a] = arm[b] * force[c] - arm[c] * force[b];
  }
  return load;
}

/// What a pass summed for the particles of each wall.
template <int Dim>
std::vector<WallLoad> sumsOnWalls(const Engine<Dim>& engine, Field<Rank::vector> field,
                                  const ParticleSet<Dim>& particles,
                                  std::span<const Vec<Dim>> centers) {
  const std::size_t nFluid = particles.nFluid();
  const auto positions = particles[field::position];
  const auto wallOf = particles[field::wall];
  Block total{std::vector<WallLoad>(centers.size())};
  engine.withSums(field, [&](const auto& sums) {
    const std::size_t first = sums.nClusters(false), n = sums.nClusters(true) - first;
    constexpr std::size_t blockSize = 256;
    std::vector<Block> blocks((n + blockSize - 1) / blockSize);
    forEachIndex(blocks.size(), [&](std::size_t b) {
      blocks[b].loads.resize(centers.size());
      for (std::size_t k = b * blockSize; k < std::min(n, (b + 1) * blockSize); ++k)
        sums.forEach(first + k, [&](std::size_t i, const Vec<Dim>& sum) {
          const auto w = static_cast<std::size_t>(wallOf[i - nFluid]);
          blocks[b].loads[w] += loadOf(toThree(sum), toThree(positions[i] - centers[w]));
        });
    });
    for (const Block& block : blocks) total += block;
  });
  return total.loads;
}

}  // namespace

WallLoad& WallLoad::operator+=(const WallLoad& other) {
  for (std::size_t a = 0; a < 3; ++a) {
    force[a] += other.force[a];
    torque[a] += other.torque[a];
  }
  return *this;
}

WallLoad operator*(double factor, WallLoad load) {
  for (std::size_t a = 0; a < 3; ++a) {
    load.force[a] *= factor;
    load.torque[a] *= factor;
  }
  return load;
}

template <int Dim>
void WallLoads<Dim>::setForces(const Engine<Dim>& engine, const ParticleSet<Dim>& particles,
                               std::span<const Vec<Dim>> centers) {
  now_ = sumsOnWalls(engine, field::force, particles, centers);
}

template <int Dim>
void WallLoads<Dim>::act(double duration) {
  for (std::size_t w = 0; w < now_.size(); ++w) impulses_[w] += duration * now_[w];
}

template <int Dim>
void WallLoads<Dim>::addImpulses(const Engine<Dim>& engine, const ParticleSet<Dim>& particles,
                                 std::span<const Vec<Dim>> centers) {
  const auto impulses = sumsOnWalls(engine, field::impulse, particles, centers);
  for (std::size_t w = 0; w < impulses.size(); ++w) impulses_[w] += impulses[w];
}

template <int Dim>
std::vector<WallLoad> WallLoads<Dim>::means() const {
  std::vector<WallLoad> means;
  for (const WallLoad& impulse : impulses_)
    means.push_back(elapsed_ > 0 ? (1 / elapsed_) * impulse : WallLoad{});
  return means;
}

template <int Dim>
void WallLoads<Dim>::restart() {
  std::ranges::fill(impulses_, WallLoad{});
  elapsed_ = 0;
}

template <int Dim>
std::vector<std::pair<std::string, double>> WallLoads<Dim>::progress() const {
  std::vector<std::pair<std::string, double>> figures{{"loads_elapsed", elapsed_}};
  const auto add = [&](const char* what, const std::vector<WallLoad>& loads) {
    for (std::size_t w = 0; w < loads.size(); ++w)
      for (std::size_t a = 0; a < 3; ++a) {
        figures.emplace_back(fmt::format("wall_{}_{}_{}", w, what, "xyz"[a]), loads[w].force[a]);
        figures.emplace_back(fmt::format("wall_{}_angular_{}_{}", w, what, "xyz"[a]),
                             loads[w].torque[a]);
      }
  };
  add("force", now_);
  add("impulse", impulses_);
  return figures;
}

template <int Dim>
void WallLoads<Dim>::restore(const std::vector<std::pair<std::string, double>>& progress) {
  // Written by `progress` above, in its order.
  const auto mine = this->progress();
  const auto found = std::ranges::search(
      progress, mine, [](const auto& a, const auto& b) { return a.first == b.first; });
  if (found.empty()) return;
  auto value = found.begin();
  elapsed_ = (value++)->second;
  for (std::vector<WallLoad>* loads : {&now_, &impulses_})
    for (WallLoad& load : *loads)
      for (std::size_t a = 0; a < 3; ++a) {
        load.force[a] = (value++)->second;
        load.torque[a] = (value++)->second;
      }
}

template class WallLoads<1>;
template class WallLoads<2>;
template class WallLoads<3>;

}  // namespace plenum
