// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/relaxation.hpp"

#include "ictools/arrangement.hpp"
#include "particles/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

/// Scatter of sums in float: a perfect lattice is left alone.
constexpr double noise = 1e-6;

/// No particle moves further than that in an iteration, in spacings.
constexpr double furthestMove = 0.15;

template <int Dim>
double spacingOf(double volume) {
  return std::pow(volume, 1.0 / Dim);
}

template <int Dim>
Vec<Dim> limited(const Vec<Dim>& move, double largest) {
  const double length = norm(move);
  return length > largest ? move * (largest / length) : move;
}

/// Sets field::velocity, the next move of every particle.
template <int Dim>
class Method {
 public:
  virtual ~Method() = default;
  virtual void plan(Arrangement<Dim>& arrangement, const RelaxationState& state) = 0;
};

/// A stiff gas with friction: p = 1 + K (sum_j V_j W_ij/mean - 1). With spacing d = V^(1/Dim) the
/// acceleration in spacings is -d sum_j V_j (p_i + p_j) grad_i W_ij. Waves then cross about a
/// spacing in an iteration: the most that an explicit step can carry at usual h/d. The part that is
/// the same for all orders particles, K evens out their densities: where spacings jump (a blob in a
/// wind), K = 1 leaves pairs along the jump, 10 leaves none. Friction is a compromise: more of it
/// delays the long waves, less lets the short ones ring.
template <int Dim>
class Packing final : public Method<Dim> {
 public:
  void plan(Arrangement<Dim>& arrangement, const RelaxationState&) override {
    constexpr double kept = 0.85, stiffness = 10;
    constexpr double step = 1 / (1 + stiffness);
    auto& particles = arrangement.particles();
    const auto velocity = particles[field::velocity];
    const auto volume = particles[field::mass];
    const auto pressure = particles[field::pressure];
    forEachIndex(arrangement.nFluid(), [&](std::size_t i) {
      pressure[i] = std::max(0.0, 1 + stiffness * (pressure[i] - 1));
    });
    arrangement.forEachSum(
        NeighbourSum::pressure, field::force, [&](std::size_t i, const Vec<Dim>& force) {
          const double d = spacingOf<Dim>(volume[i]);
          velocity[i] =
              limited(kept * velocity[i] + step * d * d / volume[i] * force, furthestMove * d);
        });
  }
};

/// Moves along the push of weighted Voronoi tessellations. Steps begin at a third of a spacing for
/// a particle with all its neighbours on one side, and become shorter whenever the scatter grows.
template <int Dim>
class VoronoiMoves final : public Method<Dim> {
 public:
  void plan(Arrangement<Dim>& arrangement, const RelaxationState& state) override {
    if (state.scatter > last_) step_ *= 0.8;
    last_ = state.scatter;
    auto& particles = arrangement.particles();
    const auto velocity = particles[field::velocity];
    const auto volume = particles[field::mass];
    arrangement.forEachSum(NeighbourSum::voronoi, field::push,
                           [&](std::size_t i, const Vec<Dim>& push) {
                             const double d = spacingOf<Dim>(volume[i]);
                             velocity[i] = limited(step_ * d * push, furthestMove * d);
                           });
  }

 private:
  double step_ = 1, last_ = std::numeric_limits<double>::infinity();
};

template <int Dim>
std::unique_ptr<Method<Dim>> methodNamed(const std::string& name) {
  if (name == "wvt") return std::make_unique<VoronoiMoves<Dim>>();
  return std::make_unique<Packing<Dim>>();
}

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
    if (hasStalled(result.history))
      return end(result, !settings_.tolerance, "the scatter falls no longer");
    if (now.iteration < settings_.maxIterations) return false;
    return end(result, !settings_.tolerance, fmt::format("{} iterations", now.iteration));
  }

 private:
  static constexpr double calm = 0.02;   // moves [spacings] below which an arrangement is at rest
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
  const auto method = methodNamed<Dim>(settings.method);
  const bool adaptive =
      settings.method == "wvt" || std::ranges::any_of(fluids, [](const auto& fluid) {
        return fluid.settings.spacingFollowsDensity() || fluid.lengthScale != 1;
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
