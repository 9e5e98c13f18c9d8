// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report card of a particle set: what a run will see in its first step.
#pragma once

#include "ictools/density_profile.hpp"
#include "ictools/pairing_forecast.hpp"
#include "particles/scene.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace plenum {

/// Where a fluid particle stands; the first that applies.
enum class Place {
  wall,         ///< a wall particle within the support
  freeSurface,  ///< a particle of a free surface within the support
  interface,    ///< a particle of another fluid within the support
  inside
};
inline constexpr std::size_t nPlaces = 4;
std::string nameOf(Place place);

/// Sums over the neighbours of the fluid particles in one kind of place.
struct PlaceFigures {
  std::size_t n = 0;
  double bias = 0;             ///< mean of rho_SPH/rho - 1
  double scatter = 0;          ///< its standard deviation
  double worst = 0;            ///< largest |rho_SPH/rho - 1|
  double kernelSum = 0;        ///< mean of sum V W
  double kernelGradient = 0;   ///< mean of |sum V grad W| d_ref
  double largestGradient = 0;  ///< largest of these
};

struct FluidMass {
  std::string name;
  std::size_t n = 0;
  double mass = 0;      ///< [kg]
  double expected = 0;  ///< density times exact volume [kg]; 0 where that is not known
};

struct WallLayers {
  std::string name;
  double thickness = 0;  ///< [m]
  double support = 0;    ///< of the kernel [m]
};

struct Histogram {
  double lower = 0, width = 1;  ///< of the first bin, of each bin
  std::vector<double> share;    ///< of all values; the last bin has those beyond, too
};

/// Distances of fluid particles to the nearest particle of any kind, in units of d_ref; where
/// smoothing lengths differ, of d_ref times the mean of the pair's over that of the scene.
struct SpacingFigures {
  double least = 0, mean = 0, largest = 0;        ///< 2.5: nobody so near
  double below01 = 0, below05 = 0, below085 = 0;  ///< shares of particles nearer than .1, .5, .85
};

/// How well densities meet a profile, in places whose support lies in the fluid: relative L2
/// errors.
struct ProfileErrors {
  std::size_t n = 0;    ///< particles looked at
  double smoothed = 0;  ///< against the profile smoothed with the same kernel
  double sharp = 0;     ///< against the profile as it is
};

struct Report {
  std::string title, kernel;
  int dimension = 0;
  double spacing = 0, smoothingLength = 0;  ///< [m]
  std::size_t nFluid = 0, nWalls = 0;
  std::vector<FluidMass> masses;
  SpacingFigures nearest;
  Histogram nearestHistogram;  ///< in spacings
  std::array<PlaceFigures, nPlaces> places;
  Histogram densityHistogram;  ///< of rho_SPH/rho - 1 inside
  std::size_t nOverlaps = 0;   ///< fluid particles nearer than d_ref/2 to another one
  std::size_t nIsolated = 0;   ///< fluid particles with nobody within 1.5 d_ref
  ProfileErrors profile;       ///< of fluids that have one
  double bondOrder = 0;        ///< psi_6 (2-D), mean q_6 over twelve neighbours (3-D)
  std::vector<WallLayers> walls;
  PairingForecast pairing;
};

/// Judges a scene with its own kernel and smoothing length. rho is the density that the file gives
/// a particle, V its mass over that.
/// `profiles[m]` is that of material m, or null.
template <int Dim>
Report reportOn(const Scene<Dim>& scene, const std::vector<DensityProfilePtr<Dim>>& profiles = {});

/// As text for the terminal, and as JSON with the same figures.
std::string printed(const Report& report);
std::string json(const Report& report);

/// Histograms of distances and densities as a PNG.
void drawReport(const std::filesystem::path& path, const Report& report);

/// The figures that are kept in the particle file, with their names.
std::vector<std::pair<std::string, double>> figuresOf(const Report& report);

}  // namespace plenum
