// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/assemble.hpp"

#include "engine/ordered_sum.hpp"
#include "ictools/formula.hpp"
#include "ictools/number_density.hpp"
#include "ictools/point_grid.hpp"
#include "ictools/state.hpp"
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

/// What a fluid's formula or profile says at its places; empty where it has neither.
template <int Dim>
std::vector<double> givenAt(const FluidFill<Dim>& fluid, std::span<const Vec<Dim>> positions) {
  const FluidSettings& settings = fluid.settings;
  if (fluid.profile)
    return densitiesAt<Dim>(*fluid.profile, positions, at(settings.node, "profile"));
  if (settings.pressureFormula.empty()) return {};
  const CaseNode& node = at(settings.node, "pressure_formula");
  return finiteValuesAt(Formula<Dim>(settings.pressureFormula, node), positions, node);
}

/// State of the particles of fluid `material`, from `first` on; their positions are there.
template <int Dim>
void addFluid(const FluidFill<Dim>& fluid, int material, std::size_t first,
              const SceneFrame<Dim>& frame, ParticleSet<Dim>& particles) {
  const FluidSettings& settings = fluid.settings;
  const std::size_t n = fluid.nParticles;
  const InitialState state(settings.ownSolver(frame.solver), settings.density, settings.pressure,
                           settings.hydrostatic, settings.node);
  const auto positions = particles[field::position].subspan(first, n);
  const auto densities = particles[field::density].subspan(first, n);
  const auto pressures = particles[field::pressure].subspan(first, n);
  const auto masses = particles[field::mass].subspan(first, n);
  const auto lengths = particles[field::smoothingLength].subspan(first, n);
  const auto materials = particles[field::material].subspan(first, n);
  const bool hasEqualMasses = settings.spacingFollowsDensity();
  std::vector<double> volumes;  // meant for particles there; they do not jump where densities do
  if (hasEqualMasses) volumes = targetVolumes<Dim>(fluid, positions, frame.domain);
  std::vector<double> ratios;  // of spacings to that of the fluid
  if (fluid.resolution) ratios = ratiosAt<Dim>(*fluid.resolution, positions);
  const double plainVolume = plainVolumeOf<Dim>(fluid, ratios);
  const auto fill = [&](std::size_t k, const FluidState& here) {
    densities[k] = here.density;
    pressures[k] = here.pressure;
    const double ratio = ratios.empty() ? 1 : ratios[k];
    masses[k] =
        hasEqualMasses ? fluid.particleMass : here.density * (plainVolume * power<Dim>(ratio));
    materials[k] = material;
    lengths[k] = frame.smoothingLength() * fluid.lengthScale * ratio;
    if (hasEqualMasses) lengths[k] *= std::pow(volumes[k] / fluid.lattice.cellVolume(), 1.0 / Dim);
  };
  setVelocities<Dim>(settings, positions, particles[field::velocity].subspan(first, n));
  const std::vector<double> given = givenAt<Dim>(fluid, positions);
  if (given.empty() && state.isUniform()) {
    const FluidState everywhere = state(Vec<Dim>{});
    forEachIndex(n, [&](std::size_t k) { fill(k, everywhere); });
    return;
  }
  parallelFor((n + batchLength - 1) / batchLength, [&](std::size_t b) {
    for (std::size_t k = b * batchLength; k < std::min(n, (b + 1) * batchLength); ++k)
      fill(k, given.empty()   ? state(positions[k])
              : fluid.profile ? state.withDensity(given[k])
                              : state.withPressure(given[k]));
  });
}

/// The equation of state of a wall is that of the fluid whose density it has.
template <int Dim>
SolverSettings solverOf(const WallFill<Dim>& wall, const std::vector<FluidFill<Dim>>& fluids,
                        const SolverSettings& solver) {
  for (const FluidFill<Dim>& fluid : fluids)
    if (fluid.settings.density == wall.density) return fluid.settings.ownSolver(solver);
  return solver;
}

template <int Dim>
void addWall(const WallFill<Dim>& wall, int row, std::size_t first, const SceneFrame<Dim>& frame,
             const SolverSettings& solver, ParticleSet<Dim>& particles) {
  const WallSettings& settings = wall.settings;
  const MotionState motion(wall.motion, 0);
  const InitialState state(solver, wall.density, settings.pressure, settings.hydrostatic,
                           settings.node);
  const bool isPassive =
      solver.wallPressure == "zero" && !settings.pressure && !settings.hydrostatic;
  for (std::size_t k = 0; k < wall.points.size(); ++k) {
    const WallPoint<Dim>& point = wall.points[k];
    const std::size_t i = particles.nFluid() + first + k;
    FluidState here = isPassive ? FluidState{0, wall.density} : state(point.position);
    // A wall above the surface of a liquid at rest does not pull.
    if (settings.hydrostatic && here.pressure < 0) here = state.withPressure(0);
    particles[field::position][i] = point.position;
    particles[field::velocity][i] = motion.velocityAt(point.position);
    particles[field::density][i] = here.density;
    particles[field::pressure][i] = here.pressure;
    particles[field::mass][i] = here.density * point.volume;
    particles[field::smoothingLength][i] = frame.solver.smoothingLength * wall.spacing;
    particles[field::wall][first + k] = row;
    particles[field::normal][first + k] = point.normal;
    particles[field::wallDistance][first + k] = point.depth;
  }
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
  first = 0;
  for (std::size_t k = 0; k < fluids.size(); ++k) {
    addFluid(fluids[k], static_cast<int>(k), first, frame, particles);
    first += fluids[k].nParticles;
  }
  first = 0;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    addWall(walls[k], static_cast<int>(k), first, frame, solverOf(walls[k], fluids, frame.solver),
            particles);
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
    first += fluid.nParticles;
    const double mass = orderedSum<double>(masses.size(), [&](std::size_t k) { return masses[k]; });
    const double whole = fluid.settings.density * fluid.volume.value;
    figures.emplace_back(name + ": particles", fluid.nParticles);
    figures.emplace_back(name + ": mass", mass);
    const bool hasOneDensity = !fluid.profile && !fluid.settings.hydrostatic &&
                               !fluid.settings.pressure && fluid.settings.pressureFormula.empty();
    if (fluid.nCovered == 0 && hasOneDensity)
      figures.emplace_back(name + ": density x volume", whole);
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
