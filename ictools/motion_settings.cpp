// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/motion_settings.hpp"

#include "ictools/ic_settings.hpp"
#include "ictools/wall_motions.hpp"

#include <fmt/format.h>

#include <utility>

namespace plenum {

namespace {

template <class S>
void declareAxis(Section<S>& section) {
  section.vector("center", &S::center, "m", "a point on the axis; absent: the origin")
      .vector("axis", &S::axis, "", "direction, 3-D only; absent: z");
}

template <class S>
void declareHarmonic(Section<S>& section) {
  section.number("frequency", &S::frequency, "1/s", Range::positive(), "oscillations in a second")
      .required()
      .number("phase", &S::phase, "degrees", Range::any(), "of the sine at `from`")
      .number("from", &S::from, "s", Range::notNegative(), "the wall stands still before")
      .number("until", &S::until, "s", Range::positive(),
              "the wall stands where it is then; absent: for ever")
      .number("ramp", &S::ramp, "s", Range::notNegative(),
              "the amplitude grows from zero and, before `until`, dies away in this time, so that "
              "velocity and acceleration have no jump; 0: at once");
}

void checkAxis(const CaseNode& rotation, const std::vector<double>& axis, int dimension) {
  if (dimension == 1) rotation.fail("nothing rotates in one dimension");
  if (axis.empty()) return;
  if (dimension == 2) at(rotation, "axis").fail("in two dimensions the axis is z; leave it out");
  if (axis == std::vector<double>{0, 0, 0}) at(rotation, "axis").fail("has no direction");
}

void checkHarmonic(const CaseNode& node, const HarmonicKeys& keys) {
  if (!keys.until) return;
  if (!(*keys.until > keys.from))
    at(node, "until")
        .fail(fmt::format("must be later than from = {:g} s; make it larger, or leave it out",
                          keys.from));
  if (2 * keys.ramp > *keys.until - keys.from)
    at(node, "ramp")
        .fail(fmt::format(
            "must be in [0, {:g}] s: the amplitude grows and dies away between `from` and `until`",
            0.5 * (*keys.until - keys.from)));
}

}  // namespace

Section<RotationSettings> wallRotationSection() {
  using S = RotationSettings;
  Section<S> section("rigid rotation, counter-clockwise seen against the axis");
  section.number("rpm", &S::rpm, "1/min", Range::any(), "turns per minute")
      .number("omega", &S::omega, "rad/s", Range::any(), "angular velocity, instead of rpm");
  declareAxis(section);
  return section;
}

Section<OscillationSettings> oscillationSection() {
  using S = OscillationSettings;
  Section<S> section(
      "translation to and fro: amplitude (g(t) - g(from)), g = e(t) sin(2 pi frequency (t - from) "
      "+ phase); e = 1, or with a ramp from 0 to 1 and back as q^3 (10 - 15 q + 6 q^2), q the "
      "part of the ramp that has passed");
  section.vector("amplitude", &S::amplitude, "m", "largest way from the middle, in each direction")
      .required();
  declareHarmonic(section);
  return section;
}

Section<RockingSettings> rockingSection() {
  using S = RockingSettings;
  Section<S> section(
      "rotation to and fro: the angle is amplitude (g(t) - g(from)), as for "
      "`oscillation`");
  section
      .number("amplitude", &S::amplitude, "degrees", Range::any(),
              "largest angle from the middle, counter-clockwise seen against the axis")
      .required();
  declareAxis(section);
  declareHarmonic(section);
  return section;
}

Section<TableMotionSettings> tableMotionSection() {
  using S = TableMotionSettings;
  Section<S> section("motion that a file gives");
  section
      .text("table", &S::table,
            "text file, relative to the case file: a line that names the columns (time [s], any of "
            "x, y, z [m] and angle [degrees]), then a row for each time; what counts is the "
            "difference from t = 0; still before the first and after the last row")
      .required();
  declareAxis(section);
  return section;
}

void checkMotions(const WallSettings& wall, int dimension) {
  if (wall.rotation) {
    const CaseNode& rotation = at(wall.node, "rotation");
    checkAxis(rotation, wall.rotation->axis, dimension);
    if (wall.rotation->rpm.has_value() == wall.rotation->omega.has_value())
      rotation.fail("needs either rpm [1/min] or omega [rad/s]");
  }
  if (wall.oscillation) checkHarmonic(at(wall.node, "oscillation"), *wall.oscillation);
  if (wall.rocking) {
    const CaseNode& rocking = at(wall.node, "rocking");
    checkAxis(rocking, wall.rocking->axis, dimension);
    checkHarmonic(rocking, *wall.rocking);
    if (wall.rotation && !(axisOf(*wall.rotation) == axisOf(*wall.rocking)))
      rocking.fail(
          "has another centre or axis than `rotation`; give both the same ones, or leave one out");
  }
  if (!wall.motion) return;
  const CaseNode& motion = at(wall.node, "motion");
  if (!wall.motion->axis.empty()) checkAxis(motion, wall.motion->axis, dimension);
  if (wall.motion->table.empty()) at(motion, "table").fail("names no file; give its path");
}

}  // namespace plenum
