// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/shape_keys.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plenum {

namespace {

const Section<BoxKeys>& boxSection() {
  static const auto section =
      Section<BoxKeys>("an axis-aligned box; an interval in 1-D, a rectangle in 2-D")
          .vector("lower", &BoxKeys::lower, "m", "corner with the smallest coordinates")
          .required()
          .vector("upper", &BoxKeys::upper, "m", "corner with the largest coordinates")
          .required();
  return section;
}

Section<BallKeys> ballSection(const std::string& description) {
  return Section<BallKeys>(description)
      .vector("center", &BallKeys::center, "m", "its centre")
      .required()
      .number("radius", &BallKeys::radius, "m", Range::positive(), "its radius")
      .required();
}

const Section<AnnulusKeys>& annulusSection() {
  static const auto section =
      Section<AnnulusKeys>("the gap between two concentric circles (2-D)")
          .vector("center", &AnnulusKeys::center, "m", "their centre")
          .required()
          .number("inner_radius", &AnnulusKeys::innerRadius, "m", Range::positive(),
                  "radius of the hole")
          .required()
          .number("outer_radius", &AnnulusKeys::outerRadius, "m", Range::positive(),
                  "radius of the outer circle, larger than inner_radius")
          .required();
  return section;
}

const Section<CylinderKeys>& cylinderSection() {
  static const auto section =
      Section<CylinderKeys>("a cylinder with flat caps (3-D)")
          .vector("from", &CylinderKeys::from, "m", "centre of one cap")
          .required()
          .vector("to", &CylinderKeys::to, "m", "centre of the other cap")
          .required()
          .number("radius", &CylinderKeys::radius, "m", Range::positive(), "its radius")
          .required();
  return section;
}

const Section<HalfSpaceKeys>& halfSpaceSection() {
  static const auto section =
      Section<HalfSpaceKeys>("all points on one side of a plane (a line in 2-D)")
          .vector("point", &HalfSpaceKeys::point, "m", "any point of the plane")
          .required()
          .vector("normal", &HalfSpaceKeys::normal, "",
                  "direction out of the region, of any length")
          .required();
  return section;
}

const Section<PolygonKeys>& polygonSection() {
  static const auto section =
      Section<PolygonKeys>("a polygon, with holes if need be (2-D)")
          .node("points", &PolygonKeys::points, "list of [x, y] [m]",
                "corners in order, either way round; the last is joined to the first")
          .required()
          .node("holes", &PolygonKeys::holes, "list of lists of [x, y] [m]",
                "corners of each hole");
  return section;
}

const Section<ExtrudeKeys>& extrudeSection() {
  static const auto section =
      Section<ExtrudeKeys>("a 2-D region drawn out along z (3-D)")
          .node("of", &ExtrudeKeys::of, "table",
                "the 2-D region in the x-y plane, as it stands in a case with dimension = 2: box, "
                "disk, annulus, half_space, polygon or file, with scale, rotate and translate")
          .required()
          .number("lower", &ExtrudeKeys::lower, "m", Range::any(), "z where it begins")
          .required()
          .number("upper", &ExtrudeKeys::upper, "m", Range::any(),
                  "z where it ends, larger than lower")
          .required();
  return section;
}

const Section<MendKeys>& mendSection() {
  static const auto section =
      Section<MendKeys>("what may be mended in a triangle mesh besides what is safe")
          .flag("holes", &MendKeys::holes, "small holes are closed")
          .number("largest_hole", &MendKeys::largestHole, "", Range::above(0, 0.5),
                  "diagonal of a hole's bounds over that of the part's up to which it is closed");
  return section;
}

}  // namespace

const Section<RotationKeys>& rotationSection() {
  static const auto section =
      Section<RotationKeys>("rotation about the origin in 3-D")
          .vector("axis", &RotationKeys::axis, "", "direction of the axis, of any length")
          .required()
          .number("angle", &RotationKeys::angle, "degrees", Range::any(), "by the right hand")
          .required();
  return section;
}

const Section<EntryKeys>& entrySection() {
  static const auto section =
      Section<EntryKeys>(
          "a region: one of box ... file, and where it is put; scaled first, then rotated, then "
          "translated")
          .section("box", &EntryKeys::box, boxSection())
          .section("disk", &EntryKeys::disk, ballSection("a disk (2-D)"))
          .section("ball", &EntryKeys::ball, ballSection("a ball (3-D)"))
          .section("annulus", &EntryKeys::annulus, annulusSection())
          .section("cylinder", &EntryKeys::cylinder, cylinderSection())
          .section("half_space", &EntryKeys::halfSpace, halfSpaceSection())
          .section("polygon", &EntryKeys::polygon, polygonSection())
          .section("extrude", &EntryKeys::extrude, extrudeSection())
          .texts("union", &EntryKeys::unionOf, "points in any of the regions named")
          .texts("intersection", &EntryKeys::intersectionOf, "points in all of the regions named")
          .texts("difference", &EntryKeys::differenceOf,
                 "points in the first region named and in none of the others")
          .text("file", &EntryKeys::file,
                "file, relative to the case file. 2-D: .wkt .txt .xy .dat (polygon) .geo .step "
                ".stp .brep .msh; 3-D: .stl .obj .off .ply (triangle mesh, closed or with "
                "thickness) .geo .step .stp "
                ".brep .msh")
          .number("tolerance", &EntryKeys::tolerance, "m", Range::positive(),
                  "how far the represented surface of a CAD file may be from its curved one; "
                  "default 1e-4 of the diagonal of its bounds")
          .section("mend", &EntryKeys::mend, mendSection())
          .number(
              "thickness", &EntryKeys::thickness, "m", Range::positive(),
              "makes a wall of a file that holds an open surface (.stl .obj .off .ply) or open "
              "lines (.wkt: LINESTRING, MULTILINESTRING; .txt .xy .dat); a length of the scene, "
              "after scale")
          .text("side", &EntryKeys::side,
                "where the wall's thickness is, seen from the surface or line: outer, where its "
                "normals point (to where corners run counter-clockwise; in 2-D to the right of the "
                "line), inner, or half of it on either side",
                {"outer", "inner", "middle"})
          .number("scale", &EntryKeys::scale, "", Range::positive(),
                  "factor on lengths; 0.001 for a mesh in millimetres (STEP files state their unit "
                  "and are read in metres)")
          .node("rotate", &EntryKeys::rotate, "number [degrees] or table",
                "about the origin: in 2-D an angle, counter-clockwise; in 3-D { axis, angle }")
          .vector("translate", &EntryKeys::translate, "m", "shift");
  return section;
}

void checkHasNoFileKeys(const CaseNode& entry) {
  for (const char* key : {"tolerance", "mend", "thickness", "side"})
    if (const CaseNode* node = entry.find(key)) node->fail("concerns files only; remove it");
}

std::string keyOf(const CaseNode& node) { return node.path().substr(node.path().rfind('.') + 1); }

bool isSetOperation(const std::string& key) {
  return key == "union" || key == "intersection" || key == "difference";
}

const CaseNode& shapeNodeOf(const CaseNode& entry, int dimension) {
  struct Shape {
    const char* key;
    std::vector<int> dimensions;
    const char* remedy;
  };
  static const std::vector<Shape> shapes = {
      {"box", {1, 2, 3}, ""},
      {"disk", {2}, "use ball or cylinder in 3-D, box in 1-D"},
      {"ball", {3}, "use disk in 2-D, box in 1-D"},
      {"annulus", {2}, "use extrude or the difference of two cylinders or balls in 3-D"},
      {"cylinder", {3}, "use disk (its cross-section) or box in 2-D"},
      {"half_space", {1, 2, 3}, ""},
      {"polygon", {2}, "use extrude, a closed triangle mesh or a CAD file in 3-D, box in 1-D"},
      {"extrude", {3}, "give what is extruded itself in 2-D, box in 1-D"},
      {"union", {1, 2, 3}, ""},
      {"intersection", {1, 2, 3}, ""},
      {"difference", {1, 2, 3}, ""},
      {"file", {2, 3}, "use box in 1-D"}};
  std::string all;
  const CaseNode* found = nullptr;
  for (const Shape& shape : shapes) {
    all += (all.empty() ? "" : ", ") + std::string(shape.key);
    const CaseNode* node = entry.find(shape.key);
    if (node == nullptr) continue;
    if (found != nullptr)
      node->fail(
          fmt::format("the region is already a {}; keep one of the two, or give each a name "
                      "and join them with union",
                      keyOf(*found)));
    if (std::ranges::find(shape.dimensions, dimension) == shape.dimensions.end())
      node->fail(fmt::format("'{}' does not exist in {}-D (dimension = {}); {}", shape.key,
                             dimension, dimension, shape.remedy));
    found = node;
  }
  if (found == nullptr) {
    entrySection().read(entry, dimension);  // a misspelt shape is an unknown key
    entry.fail("says not what the region is: give one of " + all);
  }
  return *found;
}

}  // namespace plenum
