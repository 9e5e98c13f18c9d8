// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/assemble.hpp"

#include "engine/ordered_sum.hpp"
#include "ictools/energy_deposit.hpp"
#include "ictools/formula.hpp"
#include "ictools/initial_states.hpp"
#include "ictools/number_density.hpp"
#include "ictools/point_grid.hpp"
#include "particles/number.hpp"
#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

constexpr std::size_t batchLength = 4096;

constexpr FieldSet sceneFields{field::position, field::velocity, field::mass,
                               field::density,  field::pressure, field::smoothingLength,
                               field::id,       field::material};
constexpr FieldSet wallFields{field::wall, field::normal, field::wallDistance};

/// Volume of a particle where nothing is refined [m^d]; with exact masses such that all volumes add
/// up to that of the region.
template <int Dim>
double plainVolumeOf(const FluidFill<Dim>& fluid, const std::vector<double>& ratios) {
  if (ratios.empty() || fluid.settings.mass != "exact") return fluid.particleVolume;
  return fluid.volume.value /
         orderedSum<double>(ratios.size(), [&](std::size_t k) { return power<Dim>(ratios[k]); });
}

/// Velocities that formulas give, a component each; `velocity` without them.
template <int Dim>
void setVelocities(const FluidSettings& settings, std::span<const Vec<Dim>> positions,
                   std::span<Vec<Dim>> velocities) {
  Vec<Dim> velocity;
  for (std::size_t a = 0; a < settings.velocity.size(); ++a)
    velocity[static_cast<int>(a)] = settings.velocity[a];
  forEachIndex(velocities.size(), [&](std::size_t k) { velocities[k] = velocity; });
  const CaseNode& node = at(settings.node, "velocity_formula");
  for (std::size_t a = 0; a < settings.velocityFormula.size(); ++a) {
    const auto values =
        finiteValuesAt(Formula<Dim>(settings.velocityFormula[a], node), positions, node);
    forEachIndex(values.size(),
                 [&](std::size_t k) { velocities[k][static_cast<int>(a)] = values[k]; });
  }
}

/// The arrays of `n` particles from `first` on.
template <int Dim>
StateArrays statesOf(ParticleSet<Dim>& particles, std::size_t first, std::size_t n) {
  StateArrays states{particles[field::density].subspan(first, n),
                     particles[field::pressure].subspan(first, n),
                     {}};
  if (particles.has(field::internalEnergy))
    states.internalEnergy = particles[field::internalEnergy].subspan(first, n);
  return states;
}

/// Masses and smoothing lengths of the particles of a fluid; their densities are there.
template <int Dim>
void setSizes(const FluidFill<Dim>& fluid, std::size_t first, const SceneFrame<Dim>& frame,
              ParticleSet<Dim>& particles) {
  const std::size_t n = fluid.nParticles;
  const auto positions = particles[field::position].subspan(first, n);
  const auto densities = particles[field::density].subspan(first, n);
  const auto masses = particles[field::mass].subspan(first, n);
  const auto lengths = particles[field::smoothingLength].subspan(first, n);
  const bool hasEqualMasses = fluid.settings.spacingFollowsDensity();
  std::vector<double> volumes;  // meant for particles there; they do not jump where densities do
  if (hasEqualMasses) volumes = targetVolumes<Dim>(fluid, positions, frame.domain);
  std::vector<double> ratios;  // of spacings to that of the fluid
  if (fluid.resolution) ratios = ratiosAt<Dim>(*fluid.resolution, positions);
  const double plainVolume = plainVolumeOf<Dim>(fluid, ratios);
  forEachIndex(n, [&](std::size_t k) {
    const double ratio = ratios.empty() ? 1 : ratios[k];
    masses[k] =
        hasEqualMasses ? fluid.particleMass : densities[k] * (plainVolume * power<Dim>(ratio));
    if (frame.solver.lengthsFollow()) {
      lengths[k] = frame.lengthOfVolume(masses[k] / densities[k]);
      return;
    }
    lengths[k] = frame.smoothingLength() * fluid.lengthScale * ratio;
    if (hasEqualMasses) lengths[k] *= std::pow(volumes[k] / fluid.lattice.cellVolume(), 1.0 / Dim);
  });
}

/// State of the particles of fluid `material`, from `first` on; their positions are there.
template <int Dim>
void addFluid(const FluidFill<Dim>& fluid, int material, std::size_t first,
              const SceneFrame<Dim>& frame, ParticleSet<Dim>& particles) {
  const std::size_t n = fluid.nParticles;
  const auto positions = particles[field::position].subspan(first, n);
  setVelocities<Dim>(fluid.settings, positions, particles[field::velocity].subspan(first, n));
  const StateArrays states = statesOf(particles, first, n);
  initialStates<Dim>(fluid, frame.solver)->at(positions, states);
  setSizes(fluid, first, frame, particles);
  if (fluid.settings.energyDeposit)
    depositEnergy<Dim>(fluid.settings, frame, positions, particles[field::mass].subspan(first, n),
                       states);
  std::ranges::fill(particles[field::material].subspan(first, n), material);
}

template <int Dim>
void addWall(const WallFill<Dim>& wall, int row, std::size_t first, const SceneFrame<Dim>& frame,
             const InitialStates<Dim>& state, ParticleSet<Dim>& particles) {
  const MotionState motion(wall.motion, 0);
  const std::size_t begin = particles.nFluid() + first, n = wall.points.size();
  for (std::size_t k = 0; k < n; ++k) {
    const WallPoint<Dim>& point = wall.points[k];
    const std::size_t i = begin + k;
    particles[field::position][i] = point.position;
    particles[field::velocity][i] = motion.velocityAt(point.position);
    particles[field::smoothingLength][i] = frame.solver.lengthsFollow()
                                               ? frame.lengthOfVolume(point.volume)
                                               : frame.solver.smoothingLength * wall.spacing;
    particles[field::wall][first + k] = row;
    particles[field::normal][first + k] = point.normal;
    particles[field::wallDistance][first + k] = point.depth;
  }
  state.at(particles[field::position].subspan(begin, n), statesOf(particles, begin, n));
  for (std::size_t k = 0; k < n; ++k)
    particles[field::mass][begin + k] =
        particles[field::density][begin + k] * wall.points[k].volume;
}

/// Smallest distance of two particles [m]; `finest` is that which is expected.
template <int Dim>
double minDistance(std::span<const Vec<Dim>> points, const Box<Dim>& domain, double spacing,
                   double finest) {
  Box<Dim> box = domain;
  for (int a = 0; a < Dim; ++a)
    if (!box.isPeriodic(a)) {
      box.lower[a] -= spacing;
      box.upper[a] += spacing;
    }
  if (points.empty()) return 0;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  // Of particles at their spacing small cells find the pair; larger ones are made only if need be.
  for (const double reach : {1.05 * finest, 1.5 * finest, 1.5 * spacing}) {
    const PointGrid<Dim> grid(box, reach, points);
    std::vector<double> smallest((points.size() + batchLength - 1) / batchLength, infinity);
    parallelFor(smallest.size(), [&](std::size_t b) {
      for (std::size_t k = b * batchLength; k < std::min(points.size(), (b + 1) * batchLength); ++k)
        smallest[b] = std::min(smallest[b], grid.nearest(points[k], k));
    });
    const double found = *std::ranges::min_element(smallest);
    if (found < infinity) return found;
  }
  return infinity;
}

}  // namespace

template <int Dim>
ParticleSet<Dim> assemble(std::vector<FluidFill<Dim>>& fluids,
                          const std::vector<WallFill<Dim>>& walls, const SceneFrame<Dim>& frame) {
  std::size_t nFluid = 0, nWalls = 0;
  for (const auto& fluid : fluids) nFluid += fluid.points.size();
  for (const auto& wall : walls) nWalls += wall.points.size();
  // Positions first, and their source is freed, before there are other fields.
  ParticleSet<Dim> particles(FieldSet{field::position}, nFluid, nWalls);
  std::size_t first = 0;
  for (FluidFill<Dim>& fluid : fluids) {
    std::ranges::copy(fluid.points,
                      particles[field::position].begin() + static_cast<std::ptrdiff_t>(first));
    fluid.nParticles = fluid.points.size();
    first += fluid.nParticles;
    std::vector<Vec<Dim>>().swap(fluid.points);  // assigning {} would keep the memory
  }
  particles.add(walls.empty() ? sceneFields : sceneFields | wallFields);
  if (frame.solver.isIdealGas()) particles.add(FieldSet{field::internalEnergy});
  first = 0;
  for (std::size_t k = 0; k < fluids.size(); ++k) {
    addFluid(fluids[k], static_cast<int>(k), first, frame, particles);
    first += fluids[k].nParticles;
  }
  first = 0;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    addWall(walls[k], static_cast<int>(k), first, frame,
            *initialStates<Dim>(walls[k], fluids, frame.solver), particles);
    first += walls[k].points.size();
  }
  const auto ids = particles[field::id];
  forEachIndex(particles.size(),
               [&](std::size_t i) { ids[i] = i < nFluid ? nWalls + i + 1 : i - nFluid + 1; });
  return particles;
}

template <int Dim>
std::vector<std::pair<std::string, double>> qualityFigures(
    const std::vector<FluidFill<Dim>>& fluids, const std::vector<WallFill<Dim>>& walls,
    const ParticleSet<Dim>& particles, const Box<Dim>& domain, double spacing) {
  static const char* axes[] = {"x", "y", "z"};
  std::vector<std::pair<std::string, double>> figures;
  figures.emplace_back("fluid particles", particles.nFluid());
  figures.emplace_back("wall particles", particles.nWalls());
  const auto [least, most] = std::ranges::minmax(particles[field::smoothingLength]);
  figures.emplace_back(
      "smallest distance / d_ref",
      minDistance<Dim>(particles[field::position], domain, spacing, spacing * least / most) /
          spacing);
  std::size_t first = 0;
  for (const auto& fluid : fluids) {
    const std::string& name = fluid.settings.name;
    const auto masses = particles[field::mass].subspan(first, fluid.nParticles);
    const auto [lightest, densest] =
        std::ranges::minmax(particles[field::density].subspan(first, fluid.nParticles));
    first += fluid.nParticles;
    const double mass = orderedSum<double>(masses.size(), [&](std::size_t k) { return masses[k]; });
    figures.emplace_back(name + ": particles", fluid.nParticles);
    figures.emplace_back(name + ": mass", mass);
    if (fluid.nCovered == 0 && lightest == densest)
      figures.emplace_back(name + ": density x volume", densest * fluid.volume.value);
    figures.emplace_back(name + ": left to earlier fluids", fluid.nCovered);
    for (int a = 0; a < Dim; ++a)
      if (domain.isPeriodic(a) && fluid.settings.hasLattice())
        figures.emplace_back(name + ": spacing along " + axes[a] + " / asked for - 1",
                             fluid.lattice.deviation(a));
  }
  for (const auto& wall : walls) {
    figures.emplace_back(wall.settings.name + ": particles", wall.points.size());
    figures.emplace_back(wall.settings.name + ": layers", wall.layers);
  }
  return figures;
}

template ParticleSet<1> assemble(std::vector<FluidFill<1>>&, const std::vector<WallFill<1>>&,
                                 const SceneFrame<1>&);
template std::vector<std::pair<std::string, double>> qualityFigures(
    const std::vector<FluidFill<1>>&, const std::vector<WallFill<1>>&, const ParticleSet<1>&,
    const Box<1>&, double);
template ParticleSet<2> assemble(std::vector<FluidFill<2>>&, const std::vector<WallFill<2>>&,
                                 const SceneFrame<2>&);
template std::vector<std::pair<std::string, double>> qualityFigures(
    const std::vector<FluidFill<2>>&, const std::vector<WallFill<2>>&, const ParticleSet<2>&,
    const Box<2>&, double);
template ParticleSet<3> assemble(std::vector<FluidFill<3>>&, const std::vector<WallFill<3>>&,
                                 const SceneFrame<3>&);
template std::vector<std::pair<std::string, double>> qualityFigures(
    const std::vector<FluidFill<3>>&, const std::vector<WallFill<3>>&, const ParticleSet<3>&,
    const Box<3>&, double);

}  // namespace plenum
