// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/rigid_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace plenum {
namespace {

constexpr double pi = std::numbers::pi;

MotionTable sineTable(std::size_t nRows, double end) {
  MotionTable table;
  for (std::size_t k = 0; k < nRows; ++k) {
    const double t = end * static_cast<double>(k) / static_cast<double>(nRows - 1);
    table.times.push_back(t);
    table.places.push_back(
        {std::sin(t), 0.2 * std::cos(2 * t), 0.1 * t * t, 0.5 * std::sin(3 * t)});
  }
  return table;
}

RigidMotion constantMotion() {
  RigidMotion m;
  m.velocity = {0.2, 0.1, -0.4};
  m.angularVelocity = {0, 0, 1.1};
  m.center = {0.1, 0.2, 0.3};
  return m;
}

/// One motion of each kind, and all of them together. Slow enough that differences over 1e-4 s are
/// exact to 1e-6.
std::vector<std::pair<std::string, RigidMotion>> allKinds() {
  const Harmonic plain{1.2, 0.4, 0.1, 1.3, 0}, ramped{0.8, 0.3, 0.05, 2, 0.6};
  std::vector<std::pair<std::string, RigidMotion>> kinds{{"constant", constantMotion()}};
  const auto add = [&](const std::string& name) -> RigidMotion& {
    return kinds.emplace_back(name, RigidMotion{}).second;
  };
  add("oscillation").oscillation = {{0.1, -0.2, 0.3}, plain};
  add("ramped oscillation").oscillation = {{0.1, -0.2, 0.3}, ramped};
  RigidMotion& rocking = add("rocking");
  rocking.rocking = {0.3, plain};
  rocking.center = {0.3, -0.2, 0.1};
  add("ramped rocking").rocking = {0.3, ramped};
  add("table").table = sineTable(9, 2);
  RigidMotion all = constantMotion();
  all.oscillation = {{0.1, -0.2, 0.3}, ramped};
  all.rocking = {-0.2, plain};
  all.table = sineTable(9, 2);
  kinds.emplace_back("all together", all);
  return kinds;
}

/// The same motion about an axis that is none of the coordinate axes, for 3-D.
RigidMotion inclined(RigidMotion motion) {
  const double rate = motion.angularVelocity[2];
  motion.axis = {2.0 / 3, -1.0 / 3, 2.0 / 3};
  for (std::size_t a = 0; a < 3; ++a) motion.angularVelocity[a] = rate * motion.axis[a];
  return motion;
}

template <int Dim>
void expectDerivatives(const std::string& name, const RigidMotion& motion) {
  SCOPED_TRACE(name);
  ASSERT_EQ(faultOf(motion), std::nullopt);
  const Vec<Dim> start = fromThree<Dim>({0.7, -0.4, 0.5});
  const double dt = 1e-4;
  // Central differences: dt^2/6 times a third derivative of at most 600 m/s^3 (of the place) or a
  // fourth of 2000 m/s^4 (of the velocity). No time is within dt of a row or of a jump.
  for (const double time : {0.02, 0.33, 0.6, 1.01, 1.27, 1.62, 1.9, 2.5}) {
    const auto place = [&](double t) { return Displacement(motion, 0.0, t).moved(start); };
    const auto velocity = [&](double t) { return MotionState(motion, t).velocityAt(place(t)); };
    const Vec<Dim> slope = (place(time + dt) - place(time - dt)) / (2 * dt);
    EXPECT_LE(norm(slope - velocity(time)), 1e-6) << "velocity at " << time;
    const Vec<Dim> change = (velocity(time + dt) - velocity(time - dt)) / (2 * dt);
    const Vec<Dim> acceleration = MotionState(motion, time).accelerationAt(place(time));
    EXPECT_LE(norm(change - acceleration), 4e-6) << "acceleration at " << time;
  }
}

TEST(RigidMotion, VelocityAndAccelerationAreDerivatives) {
  for (const auto& [name, motion] : allKinds()) {
    expectDerivatives<2>(name + ", 2-D", motion);
    expectDerivatives<3>(name + ", 3-D", motion);
    expectDerivatives<3>(name + ", inclined", inclined(motion));
  }
  RigidMotion line;
  line.oscillation = {{0.1, 0, 0}, {1.2, 0.4, 0.1, 1.3, 0.2}};
  expectDerivatives<1>("1-D", line);
}

TEST(RigidMotion, OneDisplacementIsTheSumOfTwo) {
  for (const auto& [name, motion] : allKinds()) {
    const Vec<3> x{{0.7, -0.4, 0.5}};
    const Vec<3> there = Displacement(motion, 0.2, 0.9).moved(x);
    const Vec<3> further = Displacement(motion, 0.9, 1.7).moved(there);
    EXPECT_LE(norm(further - Displacement(motion, 0.2, 1.7).moved(x)), 2e-15) << name;  // round-off
  }
}

TEST(Harmonic, ValuesWithoutARamp) {
  const Harmonic h{0.5, pi / 6, 1, 2.5, 0};  // sin(pi (t - 1) + 30 degrees) - 1/2
  const double roundOff = 1e-15 * 4;
  EXPECT_EQ(h.at(0.999).value, 0);
  EXPECT_EQ(h.at(0.999).rate, 0);
  EXPECT_NEAR(h.at(1).value, 0, roundOff);
  EXPECT_NEAR(h.at(1).rate, pi * std::cos(pi / 6), roundOff);  // a jump: the later value holds
  EXPECT_NEAR(h.at(1 + 1.0 / 3).value, 0.5, roundOff);         // the peak
  EXPECT_NEAR(h.at(1 + 1.0 / 3).rate, 0, roundOff);
  EXPECT_NEAR(h.at(1 + 1.0 / 3).secondRate, -pi * pi, 4 * roundOff);
  for (const double later : {2.5, 3.0, 1e9}) {  // it stands where it was at 2.5 s
    EXPECT_NEAR(h.at(later).value, -std::cos(pi / 6) - 0.5, roundOff);
    EXPECT_EQ(h.at(later).rate, 0);
    EXPECT_EQ(h.at(later).secondRate, 0);
  }
}

TEST(Harmonic, ARampHasNoJump) {
  const Harmonic h{2, 1, 0.5, 3, 0.8};
  const double tiny = 1e-7;
  // S(q) = 10 q^3 to first order: at q = 1e-7/0.8 the second derivative is 60 q/ramp^2 = 1.2e-5,
  // and everything else is less.
  for (const double time : {h.from, h.until})
    for (const double side : {-tiny, tiny}) {
      const Signal s = h.at(time + side);
      EXPECT_NEAR(s.value, 0, 1e-12);
      EXPECT_NEAR(s.rate, 0, 1e-5);
      EXPECT_NEAR(s.secondRate, 0, 1e-4);
    }
  for (const double seam : {h.from + h.ramp, h.until - h.ramp}) {
    const Signal before = h.at(seam - tiny), after = h.at(seam + tiny);
    EXPECT_NEAR(before.value, after.value, 1e-5);            // 2 tiny times the rate, 4 pi
    EXPECT_NEAR(before.rate, after.rate, 1e-4);              // ... times (4 pi)^2
    EXPECT_NEAR(before.secondRate, after.secondRate, 1e-3);  // ... times (4 pi)^3
  }
  EXPECT_NEAR(h.at(1.7).value, std::sin(2 * pi * 2 * 1.2 + 1), 1e-14);  // full between the ramps
}

TEST(MotionTable, PassesThroughItsRows) {
  const MotionTable table = sineTable(11, 4);
  for (std::size_t k = 0; k < table.times.size(); ++k)
    for (std::size_t c = 0; c < MotionTable::nColumns; ++c)
      EXPECT_EQ(table.at(table.times[k])[c].value, table.places[k][c]);
  for (const double outside : {-1.0, 4.0, 5.0}) {
    EXPECT_EQ(table.at(outside)[0].value, outside < 0 ? 0 : table.places.back()[0]);
    EXPECT_EQ(table.at(outside)[0].rate, 0);
    EXPECT_EQ(table.at(outside)[0].secondRate, 0);
  }
}

TEST(MotionTable, VelocityIsContinuous) {
  const MotionTable table = sineTable(11, 4);
  for (const double row : table.times) {
    const double before = table.at(row - 1e-9)[3].rate, after = table.at(row + 1e-9)[3].rate;
    EXPECT_NEAR(before, after,
                1e-7);  // 2e-9 s times an acceleration below 10 rad/s^2, and rounding
  }
}

/// Largest errors of place and velocity of a table of sin(t) away from its ends.
std::pair<double, double> errorsOf(std::size_t nRows) {
  const MotionTable table = sineTable(nRows, 2 * pi);
  double place = 0, velocity = 0;
  for (double t = 1; t < 5; t += 0.001) {
    const Signal s = table.at(t)[0];
    place = std::max(place, std::abs(s.value - std::sin(t)));
    velocity = std::max(velocity, std::abs(s.rate - std::cos(t)));
  }
  return {place, velocity};
}

TEST(MotionTable, ConvergesToASineWithThirdAndSecondOrder) {
  const auto [coarse, coarseRate] = errorsOf(41);
  const auto [fine, fineRate] = errorsOf(81);
  // The leading error is h^2/6 f''' of the tangents; the next term is some h of it, 8 % here.
  EXPECT_NEAR(std::log2(coarse / fine), 3, 0.12);
  EXPECT_NEAR(std::log2(coarseRate / fineRate), 2, 0.12);
}

TEST(MotionTable, IsExactForAParabolaOfUnevenTimes) {
  MotionTable table;
  for (const double t : {0.0, 0.3, 0.4, 1.0, 1.1, 2.0}) {
    table.times.push_back(t);
    table.places.push_back({3 + 2 * t - t * t, 0, 0, 0});
  }
  for (double t = 0.3; t < 1.1; t += 0.01) {  // the outer intervals end at rest
    const Signal s = table.at(t)[0];
    EXPECT_NEAR(s.value, 3 + 2 * t - t * t, 1e-14);  // round-off
    EXPECT_NEAR(s.rate, 2 - 2 * t, 1e-13);
    EXPECT_NEAR(s.secondRate, -2, 1e-11);
  }
}

TEST(RigidMotion, CountsATableFromItsPlaceAtTimeZero) {
  RigidMotion motion;
  motion.table = {{-1, 0, 2}, {{5, 0, 0, 0}, {7, 1, 0, 0}, {8, 1, 0, 0.5}}};
  const Displacement moved(motion, 0, 2);
  EXPECT_EQ(moved.moved(Vec<3>{}), (Vec<3>{{1, 0, 0}}));
}

TEST(RigidMotion, NamesWhatHasNoSense) {
  EXPECT_EQ(faultOf(RigidMotion{}), std::nullopt);
  for (const auto& [name, motion] : allKinds()) EXPECT_EQ(faultOf(motion), std::nullopt) << name;
  const auto fault = [](auto&& change) {
    RigidMotion motion = allKinds().back().second;
    change(motion);
    return faultOf(motion).value_or("none");
  };
  using M = RigidMotion;
  EXPECT_EQ(fault([](M& m) { m.velocity[1] = NAN; }), "a vector that is not finite");
  EXPECT_EQ(fault([](M& m) { m.rocking.amplitude = INFINITY; }), "an amplitude that is not finite");
  EXPECT_EQ(fault([](M& m) { m.axis = {1, 0, 0}; }), "rotations about two axes");
  EXPECT_EQ(fault([](M& m) { m.axis = {0, 0, 2}; }), "an axis that is no unit vector");
  EXPECT_EQ(fault([](M& m) { m.rocking.harmonic.frequency = -1; }),
            "a frequency of -1 1/s and a phase of 0.4 rad");
  EXPECT_EQ(fault([](M& m) { m.rocking.harmonic.until = 0.1; }),
            "a harmonic motion from 0.1 s until 0.1 s");
  EXPECT_EQ(fault([](M& m) { m.oscillation.harmonic.ramp = 1; }),
            "a ramp of 1 s from 0.05 s until 2 s");
  EXPECT_EQ(fault([](M& m) { m.table.times[3] = m.table.times[2]; }),
            "a table with 0.5 s after 0.5 s");
  EXPECT_EQ(fault([](M& m) { m.table.places[3][2] = NAN; }), "row 4 of a table that is not finite");
  EXPECT_EQ(fault([](M& m) { m.table.places.pop_back(); }), "a table of 9 times and 8 places");
}

TEST(RigidMotion, KnowsWhetherItIsStill) {
  EXPECT_TRUE(RigidMotion{}.isStill());
  for (const auto& [name, motion] : allKinds()) EXPECT_FALSE(motion.isStill()) << name;
  RigidMotion none;
  none.oscillation.harmonic.frequency = 3;
  EXPECT_TRUE(none.isStill());
}

}  // namespace
}  // namespace plenum
