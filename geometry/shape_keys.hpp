// SPDX-License-Identifier: GPL-3.0-or-later
//
// What one entry of the case's [geometry] table may say.
#pragma once

#include "geometry/geometry.hpp"
#include "geometry/mend_surface.hpp"
#include "particles/section.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plenum {

struct BoxKeys {
  std::vector<double> lower;
  std::vector<double> upper;
};

struct BallKeys {
  std::vector<double> center;
  double radius = 1;
};

struct AnnulusKeys {
  std::vector<double> center;
  double innerRadius = 1;
  double outerRadius = 2;
};

struct CylinderKeys {
  std::vector<double> from;
  std::vector<double> to;
  double radius = 1;
};

struct HalfSpaceKeys {
  std::vector<double> point;
  std::vector<double> normal;
};

struct PolygonKeys {
  std::optional<CaseNode> points;
  std::optional<CaseNode> holes;
};

struct ExtrudeKeys {
  std::optional<CaseNode> of;
  double lower = 0;
  double upper = 1;
};

struct RotationKeys {
  std::vector<double> axis;
  double angle = 0;
};

struct MendKeys {
  bool holes = false;
  double largestHole = MendOptions::defaultLargestHole;
};

struct EntryKeys {
  std::optional<BoxKeys> box;
  std::optional<BallKeys> disk;
  std::optional<BallKeys> ball;
  std::optional<AnnulusKeys> annulus;
  std::optional<CylinderKeys> cylinder;
  std::optional<HalfSpaceKeys> halfSpace;
  std::optional<PolygonKeys> polygon;
  std::optional<ExtrudeKeys> extrude;
  std::vector<std::string> unionOf;
  std::vector<std::string> intersectionOf;
  std::vector<std::string> differenceOf;
  std::string file;
  std::optional<double> tolerance;
  std::optional<MendKeys> mend;
  std::optional<double> thickness;
  std::string side = "outer";
  double scale = 1;
  std::optional<CaseNode> rotate;
  std::vector<double> translate;
};

const Section<EntryKeys>& entrySection();
const Section<RotationKeys>& rotationSection();

/// The one key of `entry` that says what the region is. Fails if there is none or more than one, or
/// if that shape has not `dimension` dimensions.
const CaseNode& shapeNodeOf(const CaseNode& entry, int dimension);

/// The last word of a node's dotted path.
std::string keyOf(const CaseNode& node);

/// Whether the region of this key is made of others, by their names.
bool isSetOperation(const std::string& key);

/// Fails for keys that make no sense without a file.
void checkHasNoFileKeys(const CaseNode& entry);

/// The region of an entry that refers to no other: a shape or a file, put into its place. `report`
/// is told what was mended.
template <int Dim>
GeometryPtr<Dim> makeRegion(const CaseNode& entry, const std::filesystem::path& caseFolder,
                            const FindingSink& report);

/// `region` put where the entry says; set operations and shapes alike.
template <int Dim>
GeometryPtr<Dim> placedAs(const EntryKeys& keys, GeometryPtr<Dim> region);

}  // namespace plenum
