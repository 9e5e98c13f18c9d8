// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/relaxation.hpp"

#include "ictools/arrangement.hpp"
#include "ictools/relaxation_methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace plenum {

namespace {

/// Scatter of sums in float: a perfect lattice is left alone.
constexpr double noise = 1e-6;

/// Whether more iterations are worth it, and why not.
class Ending {
 public:
  explicit Ending(const RelaxSettings& settings) : settings_(settings) {}

  /// Sets the result's reason when it is time to end.
  bool isReached(RelaxationResult& result) const {
    const RelaxationState& now = result.history.back();
    if (settings_.tolerance && now.scatter <= *settings_.tolerance && now.move <= calm)
      return end(result, true,
                 fmt::format("scatter {:.4g} <= {:g}", now.scatter, *settings_.tolerance));
    if (now.scatter <= negligible && now.move <= calm)
      return end(result, true, fmt::format("scatter below {:g}", negligible));
    if (hasStalled(result.history))
      return end(result, !settings_.tolerance, "the scatter falls no longer");
    if (now.iteration < settings_.maxIterations) return false;
    return end(result, !settings_.tolerance, fmt::format("{} iterations", now.iteration));
  }

 private:
  static constexpr double calm = 0.02;  // moves [spacings] below which an arrangement is at rest
  /// A set that crystallises goes on falling; the sums of any lattice are off by a hundred times.
  static constexpr double negligible = 1e-5;
  static constexpr int patience = 40;    // iterations in which the scatter must fall ...
  static constexpr double worth = 0.05;  // ... by that part

  static bool end(RelaxationResult& result, bool settled, std::string reason) {
    result.settled = settled;
    result.reason = std::move(reason);
    return true;
  }

  bool hasStalled(const std::vector<RelaxationState>& history) const {
    // Particles that still move far get twice as long.
    const int patient = history.back().move > calm ? 2 * patience : patience;
    if (history.size() <= static_cast<std::size_t>(patient)) return false;
    const auto best = [](auto first, auto last) {
      return std::min_element(first, last,
                              [](const auto& a, const auto& b) { return a.scatter < b.scatter; })
          ->scatter;
    };
    return best(history.end() - patient, history.end()) >
           (1 - worth) * best(history.begin(), history.end() - patient);
  }

  RelaxSettings settings_;
};

/// Puts the points back into their fluids.
template <int Dim>
void distribute(const std::vector<Vec<Dim>>& points, std::vector<FluidFill<Dim>>& fluids) {
  std::size_t first = 0;
  for (auto& fluid : fluids) {
    std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(first), fluid.points.size(),
                fluid.points.begin());
    first += fluid.points.size();
  }
}

}  // namespace

template <int Dim>
RelaxationResult relax(std::vector<FluidFill<Dim>>& fluids, const std::vector<WallFill<Dim>>& walls,
                       const SceneFrame<Dim>& frame, const RelaxSettings& settings,
                       const RelaxationWatch& watch) {
  const auto method = relaxationMethod<Dim>(settings.method);
  const bool adaptive =
      settings.method == "wvt" || std::ranges::any_of(fluids, [](const auto& fluid) {
        return fluid.spacingVaries() || fluid.lengthScale != 1;
      });
  Arrangement<Dim> arrangement(fluids, walls, frame, adaptive);
  const Ending ending(settings);
  RelaxationResult result;
  std::vector<Vec<Dim>> best;
  double move = std::numeric_limits<double>::infinity();
  for (int iteration = 0;; ++iteration) {
    RelaxationState state = arrangement.sumKernels();
    state.iteration = iteration;
    state.move = move;
    if (iteration == 0 || state.scatter < result.best.scatter - noise) {
      result.best = state;
      best = arrangement.positions();
    }
    result.history.push_back(state);
    if (watch) watch(state);
    if (ending.isReached(result)) break;
    method->plan(arrangement, state);
    move = arrangement.move();
    arrangement.retarget();
  }
  distribute(best, fluids);
  return result;
}

template RelaxationResult relax(std::vector<FluidFill<1>>&, const std::vector<WallFill<1>>&,
                                const SceneFrame<1>&, const RelaxSettings&, const RelaxationWatch&);
template RelaxationResult relax(std::vector<FluidFill<2>>&, const std::vector<WallFill<2>>&,
                                const SceneFrame<2>&, const RelaxSettings&, const RelaxationWatch&);
template RelaxationResult relax(std::vector<FluidFill<3>>&, const std::vector<WallFill<3>>&,
                                const SceneFrame<3>&, const RelaxSettings&, const RelaxationWatch&);

}  // namespace plenum
