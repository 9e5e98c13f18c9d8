// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/scene.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plenum {

/// A cut through a 3-D set, shown as a 2-D picture of the other two axes.
struct Slice {
  int axis = 2;          ///< normal of the cut
  double position = 0;   ///< [m]
  double thickness = 0;  ///< particles within half of it on either side are shown [m]; 0: spacing
};

template <int Dim>
struct PictureOptions {
  /// Colours the particles: a name of the field table, or "type" for fluids and walls apart.
  /// Vectors are shown by magnitude (in 1-D with their sign), labels by distinct colours.
  std::string field = "velocity";
  std::string title = {};
  double time = 0;     ///< [s]
  double spacing = 0;  ///< diameter of the disks [m]; 0: from the extent and number of particles
  double smoothingLength = 0;  ///< that goes with the diameter [m]; where particles have different
                               ///< ones, their disks differ alike; 0: all disks have one size
  int width = 1200;            ///< of the picture [px]; slender scenes make it narrower
  /// What to show [m]; absent: walls and container, or else where nearly all particles are.
  std::optional<Box<Dim>> view = {};
  std::optional<Box<Dim>> container = {};               ///< is always in the picture [m]
  std::optional<std::pair<double, double>> range = {};  ///< of the colours; absent: of the values
  std::vector<std::string> labels = {};                 ///< names of materials or walls
  std::optional<Slice> slice = {};                      ///< in 3-D
  /// 2-D and slices: the field of the fluids smoothed by the particles' kernels instead of disks.
  bool smooth = false;
  /// 3-D: the axis to look along; density becomes column density [kg m^-2], other fields their mean
  /// weighted by mass.
  std::optional<int> column = {};
  std::string kernel = {};  ///< of smooth pictures
  Box<Dim> domain = {};     ///< whose periodic axes smooth pictures continue
};

/// Options that a scene suggests: title, time, spacing, kernel, container or periodic domain,
/// names.
template <int Dim>
PictureOptions<Dim> pictureOptions(const SceneInfo<Dim>& info,
                                   const std::string& field = "velocity");

/// Draws particles as a PNG: disks of their true size coloured by a field, walls in grey, with
/// colour bar, axes in metres and a line that counts what lies outside the picture. 2-D as it is;
/// 3-D as lit balls seen from the front right, walls between viewer and fluid left out (or a
/// slice); 1-D as the field against x. Smooth pictures show fluids only. A million particles take a
/// second or two.
///
/// Throws InputError for an unknown field or one that the set does not carry (with those it does),
/// for no particles and a view without extent; RunError if the file cannot be written.
template <int Dim>
void drawParticles(const std::filesystem::path& path, const ParticleSet<Dim>& particles,
                   const PictureOptions<Dim>& options = {});

}  // namespace plenum
