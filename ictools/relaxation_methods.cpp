// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/relaxation_methods.hpp"

#include "geometry/voronoi.hpp"
#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace plenum {

namespace {

/// No particle moves further than that in an iteration, in spacings.
constexpr double furthestMove = 0.15;

template <int Dim>
Vec<Dim> limited(const Vec<Dim>& move, double largest) {
  const double length = norm(move);
  return length > largest ? move * (largest / length) : move;
}

/// A stiff gas with friction: p = 1 + K (sum_j V_j W_ij/mean - 1). With spacing d = V^(1/Dim) the
/// acceleration in spacings is -d sum_j V_j (p_i + p_j) grad_i W_ij. Waves then cross about a
/// spacing in an iteration: the most that an explicit step can carry at usual h/d. The part that is
/// the same for all orders particles, K evens out their densities: where spacings jump (a blob in a
/// wind), K = 1 leaves pairs along the jump, 10 hardly any. Friction is a compromise: more of it
/// delays the long waves, less lets the short ones ring.
template <int Dim>
class Packing final : public RelaxationMethod<Dim> {
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
class VoronoiMoves final : public RelaxationMethod<Dim> {
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

/// Moves towards the centroids of the Voronoi cells: Lloyd 1982, doi 10.1109/TIT.1982.1056489; in
/// any dimension and with weights Du, Faber, Gunzburger 1999, doi 10.1137/S0036144599352836.
/// A centroid follows its neighbours by less than they move, so that each move may be longer than
/// the way to the centroid; past twice the way it would swing (docs/relaxation.md has what was
/// measured).
template <int Dim>
class Lloyd final : public RelaxationMethod<Dim> {
 public:
  void plan(Arrangement<Dim>& arrangement, const RelaxationState&) override {
    gather(arrangement);
    const auto cells = voronoiCells<Dim>({points_, arrangement.nFluid(), logWeights_},
                                         arrangement.domain(), margin_);
    auto& particles = arrangement.particles();
    const auto velocity = particles[field::velocity];
    const auto volume = particles[field::mass];
    forEachIndex(cells.size(), [&](std::size_t i) {
      const Vec<Dim> toCentroid = cells[i].centroid - points_[i];
      velocity[i] = limited(overRelaxation * toCentroid, furthestMove * spacingOf<Dim>(volume[i]));
    });
  }

 private:
  static constexpr double overRelaxation = 1.8;

  /// The generators: fluids first, what is fixed after them, and frame_.
  void gather(Arrangement<Dim>& arrangement) {
    const Box<Dim>& domain = arrangement.domain();
    const auto& particles = arrangement.particles();
    const auto position = particles[field::position];
    const auto volume = particles[field::mass];
    points_.resize(particles.size());
    logWeights_.resize(particles.size());
    forEachIndex(particles.size(), [&](std::size_t i) {
      points_[i] = domain.wrap(position[i]);
      // Density is 1 / volume, and the weight that leads to it density^((d + 2)/d).
      logWeights_[i] = -(Dim + 2.0) / Dim * std::log(volume[i]);
    });
    double largest = 0;
    for (std::size_t i = 0; i < arrangement.nFluid(); ++i) largest = std::max(largest, volume[i]);
    margin_ = 3 * spacingOf<Dim>(largest);
    addFrame(domain);
  }

  /// Points far out along open axes, so that no cell is without an end should a particle have
  /// strayed past all that is fixed: it is held by its region then, and its move is limited.
  void addFrame(const Box<Dim>& domain) {
    Box<Dim> box = Box<Dim>::nothing();
    for (const Vec<Dim>& x : points_) box.extend(x);
    const double far = 10 * norm(box.extent()) + margin_;
    for (int axis = 0; axis < Dim; ++axis)
      for (const double side : {-far, far}) {
        if (domain.isPeriodic(axis)) continue;
        Vec<Dim> x = box.center();
        x[axis] += side;
        points_.push_back(x);
        logWeights_.push_back(logWeights_.front());
      }
  }

  std::vector<Vec<Dim>> points_;
  std::vector<double> logWeights_;
  double margin_ = 0;
};

}  // namespace

template <int Dim>
std::unique_ptr<RelaxationMethod<Dim>> relaxationMethod(const std::string& name) {
  if (name == "packing") return std::make_unique<Packing<Dim>>();
  if (name == "wvt") return std::make_unique<VoronoiMoves<Dim>>();
  if (name == "lloyd") return std::make_unique<Lloyd<Dim>>();
  throw std::invalid_argument("relaxation method \"" + name + "\" is none of packing, wvt, lloyd");
}

template std::unique_ptr<RelaxationMethod<1>> relaxationMethod(const std::string&);
template std::unique_ptr<RelaxationMethod<2>> relaxationMethod(const std::string&);
template std::unique_ptr<RelaxationMethod<3>> relaxationMethod(const std::string&);

}  // namespace plenum
