// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/generate.hpp"

#include "ictools/wall_motions.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plenum {

namespace {

template <int Dim>
std::string describeFluids(const Scene<Dim>& scene) {
  const ParticleSet<Dim>& particles = scene.particles;
  std::string text;
  for (std::size_t m = 0; m < scene.info.materials.size(); ++m) {
    std::size_t n = 0;
    double mass = 0;
    for (std::size_t i = 0; i < particles.nFluid(); ++i) {
      const bool isHere = !particles.has(field::material) ||
                          particles[field::material][i] == static_cast<std::int32_t>(m);
      if (!isHere) continue;
      ++n;
      mass += particles[field::mass][i];
    }
    const Material& material = scene.info.materials[m];
    text += fmt::format("  fluid {:<12} {:>9} particles, mass {:.6g} kg, density {:g} kg/m^{}\n",
                        material.name, n, mass, material.density, Dim);
  }
  return text;
}

template <int Dim>
std::string describeWalls(const Scene<Dim>& scene) {
  std::string text;
  for (std::size_t w = 0; w < scene.info.walls.size(); ++w) {
    const auto rows = scene.particles[field::wall];
    const auto n = std::count(rows.begin(), rows.end(), static_cast<std::int32_t>(w));
    const Wall& wall = scene.info.walls[w];
    text += fmt::format("  wall  {:<12} {:>9} particles, {} layers ({}), {}\n", wall.name, n,
                        wall.layers, wall.method, describeMotion(wall.motion, Dim));
  }
  return text;
}

/// Deviations that are not nothing, and the smallest distance.
template <int Dim>
std::string describeQuality(const SceneInfo<Dim>& info) {
  std::string text;
  for (const auto& [name, value] : info.quality) {
    if (name.find("/ asked for - 1") != std::string::npos)
      text += fmt::format("  {}: {:+.3f} %\n", name, 100 * value);
    if (name.find("left to earlier") != std::string::npos && value > 0)
      text += fmt::format("  {}: {} places\n", name, value);
    if (name.starts_with("smallest")) text += fmt::format("  {}: {:.4f}\n", name, value);
    const std::size_t at = name.find(": density x volume");
    if (at == std::string::npos) continue;
    for (const auto& [other, mass] : info.quality)
      if (other == name.substr(0, at) + ": mass")
        text +=
            fmt::format("  {} over density x volume, minus 1: {:+.3e}\n", other, mass / value - 1);
  }
  return text;
}

}  // namespace

template <int Dim>
std::string describe(const Scene<Dim>& scene) {
  const SceneInfo<Dim>& info = scene.info;
  std::string text = info.title.empty() ? "" : info.title + "\n";
  text +=
      fmt::format("  {}-D, spacing {:g} m, h {:g} m ({:g} d_ref), kernel {}\n", Dim, info.spacing,
                  info.smoothingLength, info.smoothingLength / info.spacing, info.kernel);
  for (int a = 0; a < Dim; ++a)
    text += fmt::format("  {} from {:g} to {:g} m{}\n", "xyz"[a], info.domain.lower[a],
                        info.domain.upper[a], info.domain.isPeriodic(a) ? ", periodic" : "");
  return text + describeFluids(scene) + describeWalls(scene) + describeQuality(info);
}

template std::string describe(const Scene<1>&);
template std::string describe(const Scene<2>&);
template std::string describe(const Scene<3>&);

}  // namespace plenum
