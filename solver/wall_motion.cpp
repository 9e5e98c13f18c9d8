// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/wall_motion.hpp"

#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

template <int Dim>
WallMotion<Dim>::WallMotion(Scene<Dim>& scene)
    : walls_(scene.info.walls), domain_(scene.info.domain) {
  ParticleSet<Dim>& particles = scene.particles;
  anyMoves_ = particles.nWalls() > 0 &&
              std::ranges::any_of(walls_, [](const Wall& w) { return !w.motion.isStill(); });
  const bool hasReference =
      particles.has(field::referencePosition) && particles.has(field::referenceNormal);
  if (anyMoves_ && !hasReference) {
    particles.add({field::referencePosition, field::referenceNormal});
    std::ranges::copy(particles[field::position].subspan(particles.nFluid()),
                      particles[field::referencePosition].begin());
    std::ranges::copy(particles[field::normal], particles[field::referenceNormal].begin());
    scene.info.startTime = scene.info.time;
  }
  startTime_ = scene.info.startTime;
  poses_.reserve(walls_.size());
}

template <int Dim>
void WallMotion<Dim>::setPoses(double time) {
  poses_.clear();  // keeps its memory: a step allocates nothing
  for (const Wall& wall : walls_)
    poses_.push_back({{wall.motion, startTime_, time}, {wall.motion, time}});
}

template <int Dim>
double WallMotion<Dim>::moveTo(double time, ParticleSet<Dim>& particles) {
  if (!anyMoves_) return 0;
  setPoses(time);
  const std::size_t nFluid = particles.nFluid(), n = particles.nWalls();
  const auto positions = particles[field::position].subspan(nFluid);
  const auto velocities = particles[field::velocity].subspan(nFluid);
  const auto normals = particles[field::normal];
  const auto wallOf = std::as_const(particles)[field::wall];
  const auto startPositions = std::as_const(particles)[field::referencePosition];
  const auto startNormals = std::as_const(particles)[field::referenceNormal];
  double longest = 0;
#pragma omp parallel for schedule(static) reduction(max : longest) if (n >= worthThreads)
  for (std::size_t k = 0; k < n; ++k) {
    const auto w = static_cast<std::size_t>(wallOf[k]);
    if (walls_[w].motion.isStill()) continue;
    const Displacement& displacement = poses_[w].displacement;
    const Vec<Dim> position = displacement.moved(startPositions[k]);
    longest = std::max(longest, normSquared(domain_.nearestImage(position - positions[k])));
    positions[k] = domain_.wrap(position);
    normals[k] = displacement.turned(startNormals[k]);
    velocities[k] = poses_[w].state.velocityAt(position);
  }
  return std::sqrt(longest);
}

template <int Dim>
Vec<Dim> WallMotion<Dim>::acceleration(std::size_t wall, const Vec<Dim>& point, double time) const {
  return MotionState(walls_[wall].motion, time).accelerationAt(point);
}

template <int Dim>
void WallMotion<Dim>::accelerations(double time, const ParticleSet<Dim>& particles,
                                    std::span<Vec<Dim>> result) {
  std::ranges::fill(result, Vec<Dim>{});
  if (!anyMoves_) return;
  setPoses(time);
  const auto wallOf = particles[field::wall];
  const auto startPositions = particles[field::referencePosition];
  forEachIndex(result.size(), [&](std::size_t k) {
    const auto w = static_cast<std::size_t>(wallOf[k]);
    if (walls_[w].motion.isStill()) return;
    const Pose& pose = poses_[w];
    result[k] = pose.state.accelerationAt(pose.displacement.moved(startPositions[k]));
  });
}

template <int Dim>
void WallMotion<Dim>::towardsSurface(double time, const ParticleSet<Dim>& particles,
                                     std::span<Vec<Dim>> result) {
  std::ranges::fill(result, Vec<Dim>{});
  if (!anyMoves_) return;
  setPoses(time);
  const auto wallOf = particles[field::wall];
  const auto normals = particles[field::normal];
  const auto depths = particles[field::wallDistance];
  forEachIndex(result.size(), [&](std::size_t k) {
    const auto w = static_cast<std::size_t>(wallOf[k]);
    if (walls_[w].motion.isStill()) return;
    const MotionState& state = poses_[w].state;
    const Vec<Dim> center = fromThree<Dim>(state.center);
    result[k] = state.velocityAt(center + depths[k] * normals[k]) - state.velocityAt(center);
  });
}

template <int Dim>
std::vector<Vec<Dim>> WallMotion<Dim>::centers(double time) const {
  std::vector<Vec<Dim>> centers;
  for (const Wall& wall : walls_)
    centers.push_back(fromThree<Dim>(MotionState(wall.motion, time).center));
  return centers;
}

template class WallMotion<1>;
template class WallMotion<2>;
template class WallMotion<3>;

}  // namespace plenum
