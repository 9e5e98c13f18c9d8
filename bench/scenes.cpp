// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace plenum::bench {

namespace {

constexpr double soundSpeed = 100, density = 1000;

/// Points of a hexagonal (2-D) or hcp (3-D) lattice with distance 1 in [lower, upper).
template <int Dim>
std::vector<Vec<Dim>> lattice(const Vec<Dim>& lower, const Vec<Dim>& upper) {
  const double dy = std::sqrt(0.75), dz = std::sqrt(2.0 / 3);
  std::vector<Vec<Dim>> points;
  const auto count = [](double length, double step) {
    return std::max(1L, std::lround(length / step));
  };
  const long nx = count(upper[0] - lower[0], 1), ny = count(upper[1] - lower[1], dy);
  const long nz = Dim == 3 ? count(upper[Dim - 1] - lower[Dim - 1], dz) : 1;
  for (long k = 0; k < nz; ++k)
    for (long j = 0; j < ny; ++j)
      for (long i = 0; i < nx; ++i) {
        Vec<Dim> x = lower;
        x[0] += static_cast<double>(i) + 0.5 * static_cast<double>((j + k) & 1) + 0.25;
        x[1] += (static_cast<double>(j) + static_cast<double>(k & 1) / 3 + 0.25) * dy;
        if constexpr (Dim == 3) x[2] += (static_cast<double>(k) + 0.5) * dz;
        points.push_back(x);
      }
  return points;
}

template <int Dim>
double particleVolume() {
  return Dim == 2 ? std::sqrt(0.75) : std::sqrt(0.5);
}

template <int Dim>
Scene<Dim> sceneOf(const std::vector<Vec<Dim>>& fluid, const std::vector<Vec<Dim>>& walls) {
  Scene<Dim> scene;
  FieldSet fields{field::position, field::velocity, field::mass,    field::density,
                  field::pressure, field::id,       field::material};
  if (!walls.empty()) fields |= {field::wall, field::normal, field::wallDistance};
  scene.particles = ParticleSet<Dim>(fields, fluid.size(), walls.size());
  ParticleSet<Dim>& p = scene.particles;
  const auto position = p[field::position];
  std::ranges::copy(fluid, position.begin());
  std::ranges::copy(walls, position.begin() + static_cast<std::ptrdiff_t>(fluid.size()));
  for (std::size_t i = 0; i < p.size(); ++i) {
    p[field::mass][i] = density * particleVolume<Dim>();
    p[field::density][i] = density;
    p[field::id][i] = i < fluid.size() ? walls.size() + i : i - fluid.size();
  }
  scene.info.spacing = 1;
  scene.info.materials.push_back({"fluid", density});
  return scene;
}

template <int Dim>
SolverSettings commonSettings() {
  SolverSettings s;
  s.kernel = "wendland_c2";
  s.smoothingLength = Dim == 2 ? 1.5 : 1.28;  // 33 and about 97 neighbours
  s.soundSpeed = soundSpeed;
  s.viscosity = ViscositySettings{MonaghanSettings{0.1, 0}};
  return s;
}

/// Edges of the water: twice as high as wide in 2-D, a cube in 3-D.
template <int Dim>
Vec<Dim> columnOf(std::size_t n) {
  const double volume = static_cast<double>(n) * particleVolume<Dim>();
  if constexpr (Dim == 2)
    return {{std::sqrt(volume / 2), std::sqrt(2 * volume)}};
  else
    return Vec<Dim>::filled(std::cbrt(volume));
}

/// In lengths of the column: the front does not meet the far wall before sqrt(H/g). Where it does,
/// a jet shoots up the wall, and how it breaks is a matter of the last digits.
template <int Dim>
constexpr double tankLength = Dim == 2 ? 3 : 2;

/// Water on its lattice and the floor and sides of the tank.
template <int Dim>
Scene<Dim> tank(const Vec<Dim>& size, double layers) {
  constexpr int up = Dim - 1;
  Vec<Dim> upper = size, outerLower, outerUpper;
  upper[0] = tankLength<Dim> * size[0];
  for (int a = 0; a < Dim; ++a) {
    outerLower[a] = -layers;
    outerUpper[a] = upper[a] + layers;
  }
  std::vector<Vec<Dim>> fluid, walls;
  for (const Vec<Dim>& x : lattice<Dim>(outerLower, outerUpper)) {
    bool inTank = x[up] >= 0, inWater = true;
    for (int a = 0; a < Dim; ++a) {
      if (a != up) inTank &= x[a] >= 0 && x[a] < upper[a];
      inWater &= x[a] >= 0 && x[a] < size[a];
    }
    if (!inTank) walls.push_back(x);
    if (inWater) fluid.push_back(x);
  }
  Scene<Dim> scene = sceneOf<Dim>(fluid, walls);
  scene.info.domain.lower = outerLower;
  scene.info.domain.upper = outerUpper;
  Wall wall;
  wall.name = "tank";
  wall.thickness = layers;
  wall.density = density;
  scene.info.walls.push_back(wall);
  return scene;
}

}  // namespace

template <int Dim>
Setup<Dim> damBreakAtRest(std::size_t n) {
  constexpr int up = Dim - 1;
  Setup<Dim> made;
  SolverSettings& s = made.settings;
  s = commonSettings<Dim>();
  const Vec<Dim> size = columnOf<Dim>(n);
  made.height = size[up];
  s.density = "continuity";
  s.wallPressure = "equation_of_state";
  const double gravity = soundSpeed * soundSpeed / (200 * made.height);
  s.gravity.assign(Dim, 0.0);
  s.gravity.back() = -gravity;
  made.scene = tank<Dim>(size, std::ceil(2 * s.smoothingLength) + 1);
  ParticleSet<Dim>& p = made.scene.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double depth = std::max(0.0, made.height - p[field::position][i][up]);
    const bool underWater = p[field::position][i][0] < size[0];
    if (underWater)
      p[field::density][i] = density * (1 + gravity * depth / (soundSpeed * soundSpeed));
  }
  return made;
}

template <int Dim>
Setup<Dim> damBreakMade(std::size_t n) {
  constexpr int up = Dim - 1;
  Setup<Dim> made = damBreakAtRest<Dim>(n);
  const Vec<Dim> size = columnOf<Dim>(n);
  ParticleSet<Dim>& p = made.scene.particles;
  const auto velocity = p[field::velocity];
  const auto position = p[field::position];
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  // As often as the running one is it sorted anew with these (docs/benchmarks.md).
  const double fastest = (Dim == 2 ? 0.085 : 0.06) * soundSpeed;
  for (std::size_t i = 0; i < p.nFluid(); ++i) {
    // The flow of a collapse: down and out, fastest at the foot of the front; and some disorder.
    velocity[i][0] = fastest * position[i][0] / size[0] * (1 - 0.5 * position[i][up] / size[up]);
    velocity[i][up] = -0.75 * fastest * position[i][up] / size[up];
    for (int a = 0; a < Dim; ++a) {
      position[i][a] += jitter(random);
      velocity[i][a] += 0.4 * fastest * jitter(random);
    }
  }
  return made;
}

namespace {

/// About `n` particles of a lattice that fits a periodic box.
template <int Dim>
Scene<Dim> periodicBox(std::size_t n) {
  const double edge = std::pow(static_cast<double>(n) * particleVolume<Dim>(), 1.0 / Dim);
  // Even numbers of rows, so that the lattice fits the periods.
  Vec<Dim> size;
  const double steps[] = {1, std::sqrt(0.75), std::sqrt(2.0 / 3)};
  for (int a = 0; a < Dim; ++a) size[a] = 2 * std::round(edge / steps[a] / 2) * steps[a];
  Scene<Dim> scene = sceneOf<Dim>(lattice<Dim>({}, size), {});
  scene.info.domain.upper = size;
  scene.info.domain.periodic.fill(true);
  return scene;
}

/// Sets v_a = amplitude sin(2 pi x_b/L_b), b the axis `shift` after a, of `axes` components.
template <int Dim>
void setWaves(Scene<Dim>& scene, double amplitude, int axes, int shift) {
  const auto velocity = scene.particles[field::velocity];
  const auto position = std::as_const(scene.particles)[field::position];
  for (std::size_t i = 0; i < velocity.size(); ++i)
    for (int a = 0; a < axes; ++a) {
      const int b = (a + shift) % Dim;
      velocity[i][a] =
          amplitude * std::sin(2 * std::numbers::pi * position[i][b] / scene.info.domain.upper[b]);
    }
}

}  // namespace

template <int Dim>
Setup<Dim> quietGas(std::size_t n) {
  Setup<Dim> made;
  made.settings = commonSettings<Dim>();
  made.settings.density = "summation";
  made.settings.backgroundPressure = density * soundSpeed * soundSpeed / 7;
  made.scene = periodicBox<Dim>(n);
  setWaves(made.scene, 0.01 * soundSpeed, 1, 0);
  return made;
}

template <int Dim>
Setup<Dim> idealGas(std::size_t n) {
  Setup<Dim> made;
  SolverSettings& s = made.settings;
  s = commonSettings<Dim>();
  s.smoothingLength = Dim == 2 ? 1.35 : 1.194;  // 23 and 57 neighbours
  s.density = "summation";
  s.equationOfState = "ideal_gas";
  s.adaptive = AdaptiveSettings{};
  s.viscosity = ViscositySettings{MonaghanSettings{1, 2}};
  s.integrator = "kick_drift_kick";
  made.scene = periodicBox<Dim>(n);
  setWaves(made.scene, 0.3 * soundSpeed, Dim, 1);
  ParticleSet<Dim>& particles = made.scene.particles;
  particles.add(FieldSet{field::internalEnergy});
  const double gamma = s.adiabaticIndex;
  std::ranges::fill(particles[field::internalEnergy],
                    soundSpeed * soundSpeed / (gamma * (gamma - 1)));
  return made;
}

template Setup<2> damBreakAtRest<2>(std::size_t);
template Setup<3> damBreakAtRest<3>(std::size_t);
template Setup<2> damBreakMade<2>(std::size_t);
template Setup<3> damBreakMade<3>(std::size_t);
template Setup<2> quietGas<2>(std::size_t);
template Setup<3> quietGas<3>(std::size_t);
template Setup<2> idealGas<2>(std::size_t);
template Setup<3> idealGas<3>(std::size_t);

}  // namespace plenum::bench
