// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/wall_motion.hpp"

#include "particles/errors.hpp"
#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

using Three = std::array<double, 3>;

Three centerAt(const RigidMotion& motion, double time) {
  Three center = motion.center;
  for (std::size_t a = 0; a < 3; ++a) center[a] += motion.velocity[a] * time;
  return center;
}

Three cross(const Three& a, const Three& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

Displacement::Displacement(const RigidMotion& motion, double before, double after)
    : centerBefore(centerAt(motion, before)), centerAfter(centerAt(motion, after)) {
  const Three& w = motion.angularVelocity;
  const double rate = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
  const double angle = rate * (after - before);
  const double c = std::cos(angle), s = std::sin(angle);
  const Three axis = rate > 0 ? Three{w[0] / rate, w[1] / rate, w[2] / rate} : Three{0, 0, 1};
  // Rodrigues' formula, column by column.
  for (std::size_t k = 0; k < 3; ++k) {
    Three unit{};
    unit[k] = 1;
    const Three across = cross(axis, unit);
    for (std::size_t a = 0; a < 3; ++a)
      turn[a][k] = c * unit[a] + s * across[a] + (1 - c) * axis[k] * axis[a];
  }
}

template <int Dim>
Vec<Dim> Displacement::turned(const Vec<Dim>& direction) const {
  Vec<Dim> result;
  for (int a = 0; a < Dim; ++a)
    for (int b = 0; b < Dim; ++b)
      result[a] += turn[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] * direction[b];
  return result;
}

template <int Dim>
Vec<Dim> velocityAt(const RigidMotion& motion, const Vec<Dim>& x, const Vec<Dim>& center) {
  return fromThree<Dim>(motion.velocity) +
         fromThree<Dim>(cross(motion.angularVelocity, toThree(x - center)));
}

template <int Dim>
WallMotion<Dim>::WallMotion(std::vector<Wall> walls, const ParticleSet<Dim>& particles,
                            const Box<Dim>& domain, double startTime)
    : walls_(std::move(walls)), domain_(domain), startTime_(startTime) {
  const bool anyMoves =
      std::ranges::any_of(walls_, [](const Wall& w) { return !w.motion.isStill(); });
  if (!anyMoves || particles.nWalls() == 0) return;
  const auto ids = particles[field::id].subspan(particles.nFluid());
  const auto [low, high] = std::ranges::minmax(ids);
  if (high - low + 1 != ids.size())
    throw InputError(
        "the ids of the wall particles are not consecutive; generate the particle "
        "file anew with plenum-ic");
  firstId_ = low;
  start_.resize(ids.size());
  const auto positions = particles[field::position].subspan(particles.nFluid());
  const auto normals = particles[field::normal];
  for (std::size_t k = 0; k < ids.size(); ++k)
    start_[ids[k] - firstId_] = {positions[k], normals[k]};
  displacements_.reserve(walls_.size());
}

template <int Dim>
double WallMotion<Dim>::moveTo(double time, ParticleSet<Dim>& particles) {
  if (start_.empty()) return 0;
  displacements_.clear();
  for (const Wall& wall : walls_) displacements_.emplace_back(wall.motion, startTime_, time);

  const std::size_t nFluid = particles.nFluid();
  const auto positions = particles[field::position].subspan(nFluid);
  const auto velocities = particles[field::velocity].subspan(nFluid);
  const auto ids = particles[field::id].subspan(nFluid);
  const auto normals = particles[field::normal];
  const auto wallOf = particles[field::wall];
  double longest = 0;
  const std::size_t n = positions.size();
#pragma omp parallel for schedule(static) reduction(max : longest) if (n >= worthThreads)
  for (std::size_t k = 0; k < n; ++k) {
    const auto w = static_cast<std::size_t>(wallOf[k]);
    const RigidMotion& motion = walls_[w].motion;
    if (motion.isStill()) continue;
    const Displacement& displacement = displacements_[w];
    const Start& start = start_[ids[k] - firstId_];
    const Vec<Dim> position = displacement.moved(start.position);
    longest = std::max(longest, normSquared(domain_.nearestImage(position - positions[k])));
    positions[k] = domain_.wrap(position);
    normals[k] = displacement.turned(start.normal);
    velocities[k] = velocityAt(motion, position, fromThree<Dim>(displacement.centerAfter));
  }
  return std::sqrt(longest);
}

template <int Dim>
Vec<Dim> WallMotion<Dim>::acceleration(std::int32_t wall, const Vec<Dim>& x, double time) const {
  const RigidMotion& motion = walls_[static_cast<std::size_t>(wall)].motion;
  if (motion.isStill()) return {};
  const Three& w = motion.angularVelocity;
  return fromThree<Dim>(cross(w, cross(w, toThree(x - fromThree<Dim>(centerAt(motion, time))))));
}

template <int Dim>
std::vector<Vec<Dim>> WallMotion<Dim>::centers(double time) const {
  std::vector<Vec<Dim>> centers;
  for (const Wall& wall : walls_) centers.push_back(fromThree<Dim>(centerAt(wall.motion, time)));
  return centers;
}

template Vec<1> velocityAt<1>(const RigidMotion&, const Vec<1>&, const Vec<1>&);
template Vec<2> velocityAt<2>(const RigidMotion&, const Vec<2>&, const Vec<2>&);
template Vec<3> velocityAt<3>(const RigidMotion&, const Vec<3>&, const Vec<3>&);
template class WallMotion<1>;
template class WallMotion<2>;
template class WallMotion<3>;

}  // namespace plenum
