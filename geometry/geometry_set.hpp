// SPDX-License-Identifier: GPL-3.0-or-later
//
// The regions of a case, by name:
//
//   [geometry]
//   shaft   = { disk = { center = [0, 0], radius = 0.04 } }
//   housing = { disk = { center = [0, 0], radius = 0.10 } }
//   gap     = { difference = ["housing", "shaft"] }
//   part    = { file = "gap.step", tolerance = 1e-4, scale = 0.001 }
//
// Each entry has one shape, set operation or file, and may be scaled, rotated and translated.
#pragma once

#include "geometry/geometry.hpp"
#include "particles/case_node.hpp"
#include "particles/findings.hpp"
#include "particles/section.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace plenum {

template <int Dim>
class GeometrySet {
 public:
  /// Reads the table `[geometry]`; files are relative to `caseFolder`. Throws InputError for
  /// unknown keys and names, cycles, shapes of another dimension, empty regions and bad files.
  static GeometrySet read(const CaseNode& geometryTable, const std::filesystem::path& caseFolder);

  /// As `read`, but goes on: every error and everything that was mended (as notes) is added to
  /// `findings`, and regions that could not be made are broken.
  static GeometrySet readAll(const CaseNode& geometryTable, const std::filesystem::path& caseFolder,
                             Findings& findings);

  /// The region that the string `name` of the case names; fails with the nearest known name, and
  /// with FollowingError for a broken region.
  const GeometryPtr<Dim>& find(const CaseNode& name) const;

  /// All names, in the order of the file.
  const std::vector<std::string>& names() const { return names_; }

  /// Region by its number in `names`; null if it is broken.
  const GeometryPtr<Dim>& operator[](std::size_t k) const { return regions_[k]; }

 private:
  std::vector<std::string> names_;
  std::vector<GeometryPtr<Dim>> regions_;
};

/// All shapes, set operations and file keys, for help and docs.
std::vector<SectionDoc> geometryDocs();

}  // namespace plenum
