// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/preflight_plane.hpp"

#include "engine/point_search.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace plenum {

namespace {

/// Checks of one plane of a scene.
template <int Dim>
class PlaneCheck {
 public:
  PlaneCheck(const SceneInfo<Dim>& info, const ParticleSet<Dim>& particles,
             const SolverSettings& settings, const StreamPlane<Dim>& plane)
      : info_(info), particles_(particles), settings_(settings), plane_(plane) {}

  /// A state that has run is asked for less: waves may have reached the buffer, and gas of any
  /// density the outflow.
  void operator()() const {
    const bool hasRun = info_.time > 0, isAsGiven = !hasRun || plane_.isInflow;
    if (isAsGiven) checkLength();
    checkFluid();
    if (isAsGiven) checkReach();
    checkDirection();
    if (isAsGiven) checkWalls();
    if (plane_.isInflow && !hasRun) {
      checkPeriods();
      checkJoint();
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(
        fmt::format("{}: [[solver.{}]] with axis = \"{}\", at = {:g}, side = \"{}\" {}",
                    info_.caseName, plane_.isInflow ? "inflow" : "outflow", "xyz"[plane_.axis],
                    plane_.at, plane_.outward < 0 ? "lower" : "upper", what));
  }

  double depthOf(std::size_t i) const { return plane_.depth(particles_[field::position][i]); }
  double volumeOf(std::size_t i) const {
    return particles_[field::mass][i] / particles_[field::density][i];
  }
  double spacingOf(std::size_t i) const { return std::pow(volumeOf(i), 1.0 / Dim); }

  /// Of the fluid beyond the plane [m]; beyond an outflow gas from anywhere comes.
  double support() const {
    const double eta = settings_.smoothingLength;
    if (!settings_.lengthsFollow()) return 2 * eta * info_.spacing;
    double largest = 0;
    for (std::size_t i = 0; i < particles_.nFluid(); ++i)
      if (!plane_.isInflow || depthOf(i) > 0) largest = std::max(largest, spacingOf(i));
    return 2 * eta * largest;
  }

  void checkLength() const {
    const double least = 2 * support();
    if (plane_.length >= least * (1 - 1e-9)) return;
    refuse(
        fmt::format("has length = {:g} m, less than twice the kernel's support, {:.6g} m: gas at "
                    "the plane would feel that there is nothing behind; set length to that or "
                    "more, and let the fluid's region reach as far",
                    plane_.length, least));
  }

  std::size_t deepestParticle() const {
    std::size_t deepest = 0;
    for (std::size_t i = 1; i < particles_.nFluid(); ++i)
      if (depthOf(i) > depthOf(deepest)) deepest = i;
    return deepest;
  }

  /// Fluid must stand on both sides of the plane, and no further beyond than it is held.
  void checkFluid() const {
    const std::size_t last = deepestParticle();
    const double deepest = depthOf(last);
    double highest = -deepest;
    for (std::size_t i = 0; i < particles_.nFluid(); ++i) highest = std::max(highest, -depthOf(i));
    if (!(deepest > 0 && highest > 0))
      refuse(
          fmt::format("lies outside of the fluid, which reaches from {:.6g} to {:.6g} m there; "
                      "move the plane to where fluid stands on both sides of it, or the "
                      "fluid's region",
                      plane_.at + plane_.outward * (plane_.outward < 0 ? deepest : -highest),
                      plane_.at + plane_.outward * (plane_.outward < 0 ? -highest : deepest)));
    if (deepest > plane_.length * (1 + 1e-9))
      refuse(
          fmt::format("has length = {:g} m, and particle {} stands {:.6g} m beyond the plane; "
                      "make length as long as the fluid reaches, or the fluid's region shorter",
                      plane_.length, particles_[field::id][last], deepest));
  }

  void checkReach() const {
    const std::size_t last = deepestParticle();
    const double deepest = depthOf(last);
    if (deepest < plane_.length - 1.5 * spacingOf(last))
      refuse(
          fmt::format("has length = {:g} m, and fluid reaches only {:.6g} m beyond the plane; "
                      "let its region reach to {:g} m, or make length shorter",
                      plane_.length, deepest, plane_.end()));
  }

  void checkDirection() const {
    for (std::size_t i = 0; i < particles_.nFluid(); ++i) {
      if (!(depthOf(i) > 0)) continue;
      const double speed = plane_.along(particles_[field::velocity][i]);
      if (speed > 0) continue;
      refuse(
          fmt::format("has fluid beyond it that does not come {}: particle {} has {:g} m/s into "
                      "that direction; "
                      "give the [[fluid]] there a velocity through the plane, or leave the {} out",
                      plane_.isInflow ? "in" : "to it and leave", particles_[field::id][i], speed,
                      plane_.isInflow ? "inflow" : "outflow"));
    }
  }

  /// The buffer repeats with the plane's length, so this must be whole periods of the lattice.
  /// Where the other axes are periodic, the volume of the particles tells.
  void checkPeriods() const {
    double area = 1, volume = 0;
    for (int a = 0; a < Dim; ++a) {
      if (a == plane_.axis) continue;
      if (!info_.domain.isPeriodic(a)) return;
      area *= info_.domain.upper[a] - info_.domain.lower[a];
    }
    double spacing = 0;
    for (std::size_t i = 0; i < particles_.nFluid(); ++i) {
      if (!(depthOf(i) > 0)) continue;
      volume += volumeOf(i);
      spacing = std::max(spacing, spacingOf(i));
    }
    const double filled = volume / area;
    if (std::abs(filled - plane_.length) <= 0.1 * spacing) return;
    refuse(fmt::format(
        "has length = {:g} m, and the particles beyond it fill {:.6g} m: length must be whole "
        "periods of their lattice, for they come in again and again; set length = {:.6g} and let "
        "the fluid's region end there",
        plane_.length, filled, filled));
  }

  /// Nor may particles come nearer to those that follow them by the plane's length than they stand
  /// inside of the buffer: half a period of a hexagonal lattice has the volume of a whole number of
  /// rows.
  void checkJoint() const {
    std::vector<Vec<Dim>> buffer;
    double spacing = 0;
    for (std::size_t i = 0; i < particles_.nFluid(); ++i) {
      if (!(depthOf(i) > 0)) continue;
      buffer.push_back(particles_[field::position][i]);
      spacing = std::max(spacing, spacingOf(i));
    }
    const int axis = plane_.axis;
    Box<Dim> domain = info_.domain;
    domain.lower[axis] = std::min(plane_.at, plane_.end());
    domain.upper[axis] = std::max(plane_.at, plane_.end());
    domain.periodic[static_cast<std::size_t>(axis)] = true;
    const PointSearch<Dim> search(buffer, domain, 1.5 * spacing);
    double inside = std::numeric_limits<double>::infinity(), across = inside;  // squared
    for (std::size_t i = 0; i < buffer.size(); ++i)
      search.around(buffer[i], [&](std::uint32_t j, const Vec<Dim>& d, double distanceSquared) {
        if (j == i) return;
        const bool isFollower =
            std::abs(buffer[j][axis] - buffer[i][axis] - d[axis]) > 0.5 * plane_.length;
        double& nearest = isFollower ? across : inside;
        nearest = std::min(nearest, distanceSquared);
      });
    constexpr double part = 0.9;  // a relaxed set repeats with some scatter
    if (across >= part * part * inside) return;
    refuse(fmt::format(
        "has length = {:g} m, and particles that follow each other by it stand {:.4g} m apart, "
        "inside of the buffer {:.4g} m: length must be whole periods of their lattice, for they "
        "come "
        "in again and again; set length to a multiple of the distance of equal rows along {}, and "
        "let the fluid's region end there",
        plane_.length, std::sqrt(across), std::sqrt(inside), "xyz"[axis]));
  }

  /// Held fluid does not feel walls, and fluid just before the plane could not go round them.
  void checkWalls() const {
    const double clear = 2 * support();
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t met = 0;
    for (std::size_t w = 0; w < particles_.nWalls(); ++w) {
      const double distance = -depthOf(particles_.nFluid() + w);
      if (distance > nearest || distance < -plane_.length - 0.5 * clear) continue;
      nearest = distance;
      met = w;
    }
    if (!(nearest < clear)) return;
    const auto wall = static_cast<std::size_t>(particles_[field::wall][met]);
    const std::string name =
        wall < info_.walls.size() ? info_.walls[wall].name : std::to_string(wall);
    refuse(fmt::format(
        "meets wall \"{}\": it stands {}, and the gas that is held there goes straight through "
        "walls; keep walls {:.4g} m (two supports of the kernel) or more away from the plane, on "
        "the side of the scene, or make axes across the stream periodic instead of walled",
        name,
        nearest > 0 ? fmt::format("{:.4g} m from the plane", nearest)
                    : fmt::format("up to {:.4g} m beyond the plane", -nearest),
        clear));
  }

  const SceneInfo<Dim>& info_;
  const ParticleSet<Dim>& particles_;
  const SolverSettings& settings_;
  const StreamPlane<Dim>& plane_;
};

}  // namespace

template <int Dim>
void checkPlane(const SceneInfo<Dim>& info, const ParticleSet<Dim>& particles,
                const SolverSettings& settings, const StreamPlane<Dim>& plane) {
  PlaneCheck<Dim>(info, particles, settings, plane)();
}

template void checkPlane<1>(const SceneInfo<1>&, const ParticleSet<1>&, const SolverSettings&,
                            const StreamPlane<1>&);
template void checkPlane<2>(const SceneInfo<2>&, const ParticleSet<2>&, const SolverSettings&,
                            const StreamPlane<2>&);
template void checkPlane<3>(const SceneInfo<3>&, const ParticleSet<3>&, const SolverSettings&,
                            const StreamPlane<3>&);

}  // namespace plenum
