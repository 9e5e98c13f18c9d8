// SPDX-License-Identifier: GPL-3.0-or-later
//
// What colours the particles of a picture. Only particles/*.cpp include this.
#pragma once

#include "particles/particle_set.hpp"
#include "particles/picture_scale.hpp"

#include <string>
#include <vector>

namespace plenum {

/// One number a particle; empty arrays stand for particles that are drawn in plain grey.
struct PictureValues {
  std::string name;           ///< "|velocity|"
  std::string unit;           ///< in this dimension
  bool isCategory = false;    ///< numbers are labels
  std::vector<double> fluid;  ///< length nFluid, or empty
  std::vector<double> walls;  ///< length nWalls, or empty
};

/// Throws InputError if there is no such field in the set. `signedVectors`: 1-D vectors keep their
/// sign and walls get their values too.
template <int Dim>
PictureValues pictureValues(const ParticleSet<Dim>& particles, const std::string& field,
                            bool signedVectors);

/// From numbers to colours.
struct ColourScale {
  double lower = 0;
  double upper = 1;
  bool isCategory = false;
  bool cutBelow = false;  ///< some values lie below `lower`
  bool cutAbove = false;

  Colour operator()(double value) const;
};

/// The range of all values; a few far outliers (under one in a thousand) are cut off if they would
/// more than double it.
ColourScale scaleFor(const PictureValues& values);

}  // namespace plenum
