// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/walls.hpp"

#include <functional>
#include <string>
#include <vector>

namespace plenum {

/// How far an arrangement has come.
struct RelaxationState {
  int iteration = 0;
  double mean = 0;     ///< of sum_j V_j W_ij over fluid particles; what it exceeds 1 by is the bias
  double scatter = 0;  ///< its standard deviation over its mean
  double worst = 0;    ///< largest deviation from its mean, over its mean
  double move = 0;     ///< root mean square of the last moves, in spacings
};

struct RelaxationResult {
  RelaxationState best;                  ///< that the particles were left in
  std::vector<RelaxationState> history;  ///< of every iteration
  bool settled = false;                  ///< reached its tolerance, or what can be reached
  std::string reason;                    ///< why it ended: "scatter 0.0021 <= 0.005"
};

/// Called after each iteration.
using RelaxationWatch = std::function<void(const RelaxationState&)>;

/// Moves the particles of all fluids until the kernel sums over their neighbours are the same
/// everywhere. V_j are the volumes that particles are meant to have: mass over target density.
/// Particles stay within their fluid (containment.hpp), walls where they are. Free surfaces are
/// held (surroundings.hpp). Keeps the state of least scatter. The same for any number of threads.
///
/// Methods, all behind this function:
///   packing   particles of a stiff gas with friction: forces
///             -sum_j V_i V_j (p_i + p_j) grad_i W_ij vanish where particles stand evenly
///             (Colagrossi et al. 2012, doi 10.1016/j.cpc.2012.02.032) and inertia carries errors
///             over long ways.
///   wvt       weighted Voronoi tessellation moves: Diehl et al. 2015, Arth et al. 2019.
///   lloyd     to the centres of the Voronoi cells (CGAL).
template <int Dim>
RelaxationResult relax(std::vector<FluidFill<Dim>>& fluids, const std::vector<WallFill<Dim>>& walls,
                       const SceneFrame<Dim>& frame, const RelaxSettings& settings,
                       const RelaxationWatch& watch = {});

}  // namespace plenum
