// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/box_shape.hpp"
#include "geometry/extrusion.hpp"
#include "geometry/files.hpp"
#include "geometry/placement.hpp"
#include "geometry/polygon.hpp"
#include "geometry/round_shapes.hpp"
#include "geometry/shape_keys.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plenum {

namespace {

template <int Dim>
Vec<Dim> toVec(const std::vector<double>& components) {
  Vec<Dim> v;
  std::copy_n(components.begin(), Dim, v.components.begin());
  return v;
}

template <int Dim>
GeometryPtr<Dim> makeBox(const CaseNode& node, const BoxKeys& keys) {
  const Box<Dim> box{toVec<Dim>(keys.lower), toVec<Dim>(keys.upper), {}};
  for (int a = 0; a < Dim; ++a)
    if (!(box.lower[a] < box.upper[a]))
      node.fail(fmt::format("is empty: lower {} must be smaller than upper {} along {}",
                            box.lower[a], box.upper[a], "xyz"[a]));
  return makeGeometry(BoxShape<Dim>{box});
}

template <int Dim>
GeometryPtr<Dim> makeHalfSpace(const CaseNode& node, const HalfSpaceKeys& keys) {
  const Vec<Dim> normal = toVec<Dim>(keys.normal);
  if (!(norm(normal) > 0)) node.find("normal")->fail("has no direction: must not be zero");
  return makeGeometry(HalfSpace<Dim>{toVec<Dim>(keys.point), normal / norm(normal)});
}

Loop readLoop(const CaseNode& node) {
  Loop loop;
  for (const CaseNode& corner : node.asArray())
    loop.push_back(toVec<2>(section_detail::readVector(corner, 2)));
  return loop;
}

GeometryPtr<2> makeInlinePolygon(const CaseNode& node, const PolygonKeys& keys) {
  PolygonLoops loops{readLoop(*keys.points), {}};
  if (keys.holes)
    for (const CaseNode& hole : keys.holes->asArray()) loops.holes.push_back(readLoop(hole));
  const std::string source = fmt::format("{}:{}: {}", node.fileName(), node.line(), node.path());
  return makePolygon({loops}, source);
}

GeometryPtr<2> makeShape2(const CaseNode& node, const EntryKeys& keys) {
  if (keys.disk) return makeGeometry(Ball<2>{toVec<2>(keys.disk->center), keys.disk->radius});
  if (keys.polygon) return makeInlinePolygon(node, *keys.polygon);
  const AnnulusKeys& annulus = *keys.annulus;
  if (!(annulus.innerRadius < annulus.outerRadius))
    node.fail(fmt::format("is empty: inner_radius {} must be smaller than outer_radius {}",
                          annulus.innerRadius, annulus.outerRadius));
  return makeGeometry(Annulus{toVec<2>(annulus.center), annulus.innerRadius, annulus.outerRadius});
}

GeometryPtr<3> makeExtrusion(const CaseNode& node, const ExtrudeKeys& keys,
                             const std::filesystem::path& caseFolder, const FindingSink& report) {
  if (!(keys.lower < keys.upper))
    node.fail(
        fmt::format("is empty: lower {} must be smaller than upper {}", keys.lower, keys.upper));
  const CaseNode& base = *keys.of;
  if (!base.isTable()) base.fail("must be a 2-D region in braces, like { disk = { ... } }");
  const CaseNode& shape = shapeNodeOf(base, 2);
  if (const std::string key = keyOf(shape); isSetOperation(key))
    shape.fail("only shapes and files are extruded; extrude each part and take the " + key +
               " of the results");
  return extruded(makeRegion<2>(base, caseFolder, report), keys.lower, keys.upper);
}

GeometryPtr<3> makeShape3(const CaseNode& node, const EntryKeys& keys) {
  if (keys.ball) return makeGeometry(Ball<3>{toVec<3>(keys.ball->center), keys.ball->radius});
  const Cylinder shape{toVec<3>(keys.cylinder->from), toVec<3>(keys.cylinder->to),
                       keys.cylinder->radius};
  if (!(norm(shape.to - shape.from) > 0)) node.fail("is empty: the points from and to must differ");
  return makeGeometry(shape);
}

template <int Dim>
Placement<Dim> placementOf(const EntryKeys& keys) {
  Placement<Dim> placement;
  placement.scale = keys.scale;
  if (!keys.translate.empty()) placement.translation = toVec<Dim>(keys.translate);
  if (!keys.rotate) return placement;
  const CaseNode& node = *keys.rotate;
  if constexpr (Dim == 1) {
    node.fail("there is no rotation in 1-D; remove it");
  } else if constexpr (Dim == 2) {
    if (!node.isNumber()) node.fail("must be one number in 2-D: the angle [degrees]");
    section_detail::checkNumber(node, node.asNumber(), Range::any(), "degrees");
    placement.rotate(node.asNumber(), {0, 0, 1});
  } else {
    if (!node.isTable()) node.fail("must be { axis = [x, y, z], angle = degrees } in 3-D");
    const RotationKeys rotation = rotationSection().read(node, 3);
    const Vec<3> axis = toVec<3>(rotation.axis);
    if (!(norm(axis) > 0)) node.find("axis")->fail("has no direction: must not be zero");
    placement.rotate(rotation.angle, axis.components);
  }
  return placement;
}

std::optional<Thickening> thickeningOf(const CaseNode& entry, const EntryKeys& keys) {
  if (!keys.thickness) {
    if (const CaseNode* side = entry.find("side"))
      side->fail("says where a wall's thickness is; give thickness, or remove side");
    return std::nullopt;
  }
  const WallSide side = keys.side == "outer"   ? WallSide::outer
                        : keys.side == "inner" ? WallSide::inner
                                               : WallSide::middle;
  return Thickening{*keys.thickness, side};
}

/// A minus is understood, but not guessed at.
void checkThicknessIsPositive(const CaseNode& entry) {
  const CaseNode* node = entry.find("thickness");
  if (node != nullptr && node->isNumber() && node->asNumber() < 0)
    node->fail("must be > 0; for a wall on the other side of the surface give side = \"inner\"");
}

template <int Dim>
GeometryPtr<Dim> readFile(const CaseNode& node, const EntryKeys& keys,
                          const std::optional<Thickening>& thickening,
                          const std::filesystem::path& caseFolder, const FindingSink& report) {
  if constexpr (Dim == 1) {
    node.fail("there are no files in 1-D; use box");
  } else {
    const auto here = [&](Finding finding) {
      finding.what = node.where() + ": " + finding.what;
      report(finding);
    };
    const MendKeys mend = keys.mend.value_or(MendKeys{});
    try {
      return readGeometryFile<Dim>(caseFolder / keys.file, {keys.tolerance,
                                                            placementOf<Dim>(keys),
                                                            thickening,
                                                            {mend.holes, mend.largestHole},
                                                            here});
    } catch (const InputError& error) {
      node.fail(error);
    }
  }
}

}  // namespace

template <int Dim>
GeometryPtr<Dim> placedAs(const EntryKeys& keys, GeometryPtr<Dim> region) {
  return placed(std::move(region), placementOf<Dim>(keys));
}

template <int Dim>
GeometryPtr<Dim> makeRegion(const CaseNode& entry, const std::filesystem::path& caseFolder,
                            const FindingSink& report) {
  const CaseNode& node = shapeNodeOf(entry, Dim);
  checkThicknessIsPositive(entry);
  const EntryKeys keys = entrySection().read(entry, Dim);
  if (!keys.file.empty() || keyOf(node) == "file") {
    if (keys.mend && Dim != 3)
      entry.find("mend")->fail("concerns triangle meshes in 3-D only; remove it");
    return readFile<Dim>(node, keys, thickeningOf(entry, keys), caseFolder, report);
  }
  checkHasNoFileKeys(entry);
  if (keys.box) return placedAs(keys, makeBox<Dim>(node, *keys.box));
  if (keys.halfSpace) return placedAs(keys, makeHalfSpace<Dim>(node, *keys.halfSpace));
  if constexpr (Dim == 2) return placedAs(keys, makeShape2(node, keys));
  if constexpr (Dim == 3) {
    if (keys.extrude) return placedAs(keys, makeExtrusion(node, *keys.extrude, caseFolder, report));
    return placedAs(keys, makeShape3(node, keys));
  }
  node.fail("does not exist in 1-D; use box");
}

template GeometryPtr<1> makeRegion<1>(const CaseNode&, const std::filesystem::path&,
                                      const FindingSink&);
template GeometryPtr<2> makeRegion<2>(const CaseNode&, const std::filesystem::path&,
                                      const FindingSink&);
template GeometryPtr<3> makeRegion<3>(const CaseNode&, const std::filesystem::path&,
                                      const FindingSink&);
template GeometryPtr<1> placedAs<1>(const EntryKeys&, GeometryPtr<1>);
template GeometryPtr<2> placedAs<2>(const EntryKeys&, GeometryPtr<2>);
template GeometryPtr<3> placedAs<3>(const EntryKeys&, GeometryPtr<3>);

}  // namespace plenum
