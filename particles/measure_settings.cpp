// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/measure_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace plenum {

namespace {

constexpr const char* nameMeaning = "name of the column in history.csv";
constexpr const char* materialMeaning = "name of the fluid that counts; absent: all fluids";

/// A name that can head a column of a CSV file and be named on a command line.
template <class S>
void requireName(const S& settings, const CaseNode& table, int) {
  const auto isPlain = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  if (settings.name.empty() || !std::ranges::all_of(settings.name, isPlain))
    table.find("name")->fail("must be made of letters, digits and _");
}

Section<ProbeSettings> probeSection() {
  using S = ProbeSettings;
  return Section<S>(
             "pressure and velocity at a point, interpolated between the fluid particles near it")
      .text("name", &S::name, "first part of the columns NAME_pressure, NAME_velocity_x, ...")
      .required()
      .vector("point", &S::point, "m", "where")
      .required()
      .text("material", &S::material, materialMeaning)
      .condition(requireName<S>);
}

Section<GaugeSettings> gaugeSection() {
  using S = GaugeSettings;
  return Section<S>("height of the fluid's surface above a place; up is against gravity")
      .text("name", &S::name, nameMeaning)
      .required()
      .list("point", &S::point, "m", Range::any(),
            "the horizontal place: [x] in 2-D, [x, y] in 3-D with gravity along the last axis")
      .required()
      .number("dry", &S::dry, "m", Range::any(),
              "height to write while there is no fluid, the height of the ground say; absent: an "
              "empty cell")
      .text("material", &S::material, materialMeaning)
      .condition(requireName<S>)
      .condition([](const S& gauge, const CaseNode& table, int dimension) {
        if (dimension == 1) table.fail("a case of one dimension has no surface to gauge");
        if (static_cast<int>(gauge.point.size()) != dimension - 1)
          table.find("point")->fail(
              fmt::format("must have {} component{}: the horizontal axes of a {}-D case",
                          dimension - 1, dimension == 2 ? "" : "s", dimension));
      });
}

Section<FrontSettings> frontSection() {
  using S = FrontSettings;
  return Section<S>("how far the fluid has come: its outermost particle that is no lost droplet")
      .text("axis", &S::axis, "along which axis", {"x", "y", "z"})
      .text("direction", &S::direction, "towards larger or smaller coordinates", {"+", "-"})
      .text("material", &S::material, materialMeaning)
      .condition([](const S& front, const CaseNode& table, int dimension) {
        if (front.axis[0] - 'x' >= dimension)
          table.find("axis")->fail(fmt::format("a {}-D case has no such axis", dimension));
      });
}

Section<VolumeSettings> volumeSection() {
  using S = VolumeSettings;
  return Section<S>("volume of the fluid inside a box: sum of m/rho")
      .text("name", &S::name, nameMeaning)
      .required()
      .vector("lower", &S::lower, "m", "lower corner")
      .required()
      .vector("upper", &S::upper, "m", "upper corner")
      .required()
      .text("material", &S::material, materialMeaning)
      .condition(requireName<S>)
      .condition([](const S& box, const CaseNode& table, int dimension) {
        for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
          if (!(box.upper[a] > box.lower[a])) table.fail("upper must be above lower on every axis");
      });
}

Section<PressureGradientSettings> pressureGradientSection() {
  using S = PressureGradientSettings;
  return Section<S>("how far the pressure of a column at rest is from rho0 g per height")
      .number("middle", &S::middle, "", Range::above(0, 1),
              "share of the column, in the middle of its height, whose particles count")
      .number(
          "bottom", &S::bottom, "m", Range::any(),
          "coordinate of the column's lower end; absent: half a spacing below the lowest particle "
          "of each row's time")
      .number(
          "surface", &S::surface, "m", Range::any(),
          "coordinate of the column's upper end; absent: half a spacing above the highest particle")
      .text("material", &S::material, "name of the fluid that counts; absent: the only one")
      .condition([](const S& column, const CaseNode& table, int) {
        if (column.bottom && column.surface && *column.surface == *column.bottom)
          table.find("surface")->fail("must not be at the bottom");
      });
}

/// For flows that are known in the plane only.
template <class S>
void requirePlane(const S&, const CaseNode& table, int dimension) {
  if (dimension != 2) table.fail(fmt::format("is a flow in 2-D, the case is {}-D", dimension));
}

Section<TaylorGreenSettings> taylorGreenSection() {
  using S = TaylorGreenSettings;
  return Section<S>("distance from the decaying vortices of Taylor and Green, 2-D")
      .number("speed", &S::speed, "m/s", Range::positive(), "largest speed U at t = 0")
      .required()
      .number("length", &S::length, "m", Range::positive(), "edge L of the periodic box")
      .required()
      .number("viscosity", &S::viscosity, "m^2/s", Range::notNegative(), "kinematic viscosity nu")
      .required()
      .vector("origin", &S::origin, "m", "a corner of the box; absent: zero")
      .condition(requirePlane<S>);
}

Section<CouetteSettings> couetteSection() {
  using S = CouetteSettings;
  return Section<S>("distance from the steady flow between two rotating cylinders, 2-D")
      .vector("center", &S::center, "m", "axis of both cylinders; absent: zero")
      .number("inner_radius", &S::innerRadius, "m", Range::positive(), "radius of the inner one")
      .required()
      .number("outer_radius", &S::outerRadius, "m", Range::positive(), "radius of the outer one")
      .required()
      .number("inner_omega", &S::innerOmega, "rad/s", Range::any(), "angular velocity, inner one")
      .number("outer_omega", &S::outerOmega, "rad/s", Range::any(), "angular velocity, outer one")
      .integer("bins", &S::bins, Range::between(1, 1000),
               "rings of equal width in which the profile is averaged")
      .condition(requirePlane<S>)
      .condition([](const S& flow, const CaseNode& table, int) {
        if (!(flow.outerRadius > flow.innerRadius))
          table.find("outer_radius")->fail("must be above inner_radius");
        if (flow.innerOmega == 0 && flow.outerOmega == 0)
          table.fail("one of inner_omega and outer_omega must not be zero");
      });
}

void requireDistinctNames(const MeasureSettings& measures, const CaseNode& table, int) {
  std::set<std::string> names;
  const auto add = [&](const std::string& key, const auto& list) {
    for (std::size_t k = 0; k < list.size(); ++k)
      if (!names.insert(list[k].name).second)
        table.find(key)->asArray()[k].find("name")->fail("another measure has this name");
  };
  add("probe", measures.probes);
  add("gauge", measures.gauges);
  add("volume", measures.volumes);
}

}  // namespace

const Section<MeasureSettings>& measureSection() {
  using S = MeasureSettings;
  static const Section<S> section =
      Section<S>("what history.csv holds, and how it is measured; definitions in docs/measures.md")
          .flag("free_surface", &S::freeSurface,
                "holes count only between particles: within 2 d_ref in every quadrant")
          .flag("order", &S::order,
                "nn_min, nn_mean, f.1, f.5, f.85, psi6, void1, left and escaped; a row with them "
                "costs "
                "as much as some tens of steps")
          .flag("loads", &S::loads,
                "WALL_force_x ... and WALL_torque_z ... of each wall, the mean since the last row")
          .sections("probe", &S::probes, probeSection())
          .sections("gauge", &S::gauges, gaugeSection())
          .section("front", &S::front, frontSection())
          .sections("volume", &S::volumes, volumeSection())
          .section("pressure_gradient", &S::pressureGradient, pressureGradientSection())
          .section("taylor_green", &S::taylorGreen, taylorGreenSection())
          .section("couette", &S::couette, couetteSection())
          .section("riemann", &S::riemann, riemannSection())
          .section("noh", &S::noh, nohSection())
          .section("sedov", &S::sedov, sedovSection())
          .section("gresho", &S::gresho, greshoSection())
          .section("cloud", &S::cloud, cloudSection())
          .condition(requireDistinctNames);
  return section;
}

}  // namespace plenum
