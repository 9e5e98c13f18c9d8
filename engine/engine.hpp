// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/cell_grid.hpp"
#include "engine/neighbour_list.hpp"
#include "particles/particle_set.hpp"

namespace plenum {

/// Groups of particles: who receives a sum, and from whom.
enum class Group { fluids, walls, all };

/// Keeps particles sorted by cell and knows who is near whom. The solver, relaxation and report
/// card see neighbours only through `runPass` (pair_loop.hpp) over an engine.
template <int Dim>
class Engine {
 public:
  struct Options {
    double support = 0;         ///< largest distance at which particles interact [m]
    double skin = 0.2;          ///< extra list radius, in units of the support
    bool wallsReceive = false;  ///< walls need neighbours of their own
  };

  /// Throws InputError if a periodic axis of `domain` is shorter than twice the support.
  Engine(const Box<Dim>& domain, const Options& options);

  /// To be called before a pass: wraps, sorts and searches anew if some particle has moved by half
  /// the skin since the last time. Reorders the particles. Returns whether it did.
  bool update(ParticleSet<Dim>& particles);

  const NeighbourList<Dim>& neighbours() const { return list_; }
  const Periodicity<Dim>& periodicity() const { return periodicity_; }
  double support() const { return options_.support; }
  std::size_t nRebuilds() const { return nRebuilds_; }
  std::size_t bytes() const;

 private:
  bool movedTooFar(const ParticleSet<Dim>& particles) const;
  void sort(ParticleSet<Dim>& particles);
  Box<Dim> boundsOf(const ParticleSet<Dim>& particles) const;

  Box<Dim> domain_;
  Options options_;
  Periodicity<Dim> periodicity_;
  double skin_ = 0;  // [m]
  CellGrid<Dim> fluidCells_, wallCells_;
  NeighbourList<Dim> list_;
  std::vector<Vec<Dim>> reference_;  // positions at the last search; length size()
  std::vector<std::uint32_t> order_;
  std::size_t nRebuilds_ = 0;
};

extern template class Engine<1>;
extern template class Engine<2>;
extern template class Engine<3>;

}  // namespace plenum
