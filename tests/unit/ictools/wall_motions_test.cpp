// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/wall_motions.hpp"

#include "scenes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

namespace plenum {
namespace {

constexpr double pi = std::numbers::pi;

/// A box of water on ground that moves as `keys` say.
std::string groundCase(const std::string& keys, int dimension = 2) {
  const std::string rest = dimension == 3 ? ", 0" : "", one = dimension == 3 ? ", 1" : "";
  return "dimension = " + std::to_string(dimension) + "\nspacing = 0.2\n[geometry]\n" +
         "water = { box = { lower = [0, 0" + rest + "], upper = [1, 1" + one + "] } }\n" +
         "ground = { half_space = { point = [0, 0" + rest + "], normal = [0, 1" + rest + "] } }\n" +
         "[[fluid]]\nregion = \"water\"\n[[wall]]\nregion = \"ground\"\n" + keys;
}

template <int Dim>
RigidMotion motionOf(const std::string& keys, const std::string& file = "test.toml") {
  return test::sceneOf<Dim>(groundCase(keys, Dim), nullptr, file).info.walls.at(0).motion;
}

TEST(WallMotions, RigidMotionInSpace) {
  WallSettings wall;
  wall.velocity = {1, 0, 0};
  wall.rotation = RotationSettings{{}, 2.0, {0, 0, 1}, {0, 3, 0}};
  const MotionState state(rigidMotion<3>(wall, ""), 0);
  // v = (1, 0, 0) + (0, 2, 0) x (x - (0, 0, 1))
  EXPECT_NEAR(norm(state.velocityAt(Vec<3>{{1, 5, 3}}) - Vec<3>{{1 + 4, 0, -2}}), 0, 1e-14);
}

TEST(WallMotions, ReadsHarmonicMotions) {
  const RigidMotion motion = motionOf<3>(
      "velocity = [0, 0, 1]\n"
      "oscillation = { amplitude = [0.02, 0, 0.1], frequency = 1.5, phase = 90, from = 1, until = "
      "3, ramp = 0.5 }\n"
      "rocking = { amplitude = 5, frequency = 2, center = [1, 2, 3], axis = [0, 3, 4] }\n");
  EXPECT_EQ(motion.velocity, (std::array<double, 3>{0, 0, 1}));
  EXPECT_EQ(motion.oscillation.amplitude, (std::array<double, 3>{0.02, 0, 0.1}));
  EXPECT_EQ(motion.oscillation.harmonic, (Harmonic{1.5, pi / 2, 1, 3, 0.5}));
  EXPECT_DOUBLE_EQ(motion.rocking.amplitude, pi / 36);
  EXPECT_EQ(motion.rocking.harmonic, (Harmonic{2}));
  EXPECT_EQ(motion.center, (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(motion.axis, (std::array<double, 3>{0, 0.6, 0.8}));
}

TEST(WallMotions, WallsStartWithTheirVelocity) {
  const std::string keys =
      "velocity = [0.5, 0]\noscillation = { amplitude = [0, 0.1], frequency = 1 }\n"
      "rotation = { omega = 2 }\nrocking = { amplitude = 18, frequency = 0.5 }\n";
  const Scene<2> scene = test::sceneOf<2>(groundCase(keys));
  const double rate = 2 + pi / 10 * pi;  // rocking: amplitude 2 pi f
  for (std::size_t i = scene.particles.nFluid(); i < scene.particles.size(); ++i) {
    const Vec<2> x = scene.particles[field::position][i];
    const Vec<2> v{{0.5 - rate * x[1], 0.1 * 2 * pi + rate * x[0]}};
    EXPECT_LE(norm(scene.particles[field::velocity][i] - v), 1e-14);  // round-off
  }
}

TEST(WallMotions, ReadsATableBesideTheCase) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "shake.csv") << "time,x,angle\n0,0,0\n1,0.5,180\n2,0,0\n";
  const RigidMotion motion = motionOf<2>(
      "rotation = { rpm = 1, center = [3, 4] }\n"
      "motion = { table = \"shake.csv\", center = [3, 4] }\n",
      (folder / "case.toml").string());
  EXPECT_EQ(motion.table.times, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(motion.table.places[1], (std::array<double, 4>{0.5, 0, 0, pi}));
  EXPECT_EQ(motion.center, (std::array<double, 3>{3, 4, 0}));
}

TEST(WallMotions, RefusesWhatHasNoSense) {
  const auto expectSays = [](const std::string& keys, const std::string& says, int dimension = 2) {
    const std::string text = groundCase(keys, dimension);
    const std::string message =
        dimension == 2 ? test::messageOf<2>(text) : test::messageOf<3>(text);
    EXPECT_NE(message.find(says), std::string::npos) << keys << "\nsays: " << message;
  };
  expectSays("oscillation = { amplitude = [1, 0] }", "frequency");
  expectSays("oscillation = { frequency = 1 }", "amplitude");
  expectSays("oscillation = { amplitude = [1], frequency = 1 }", "amplitude");
  expectSays("oscillation = { amplitude = [1, 0], frequency = 0 }", "must be > 0");
  expectSays("oscillation = { amplitude = [1, 0], frequency = 1, from = -1 }", "must be >= 0");
  expectSays("oscillation = { amplitude = [1, 0], frequency = 1, ramp = -1 }", "must be >= 0");
  expectSays("oscillation = { amplitude = [1, 0], frequency = 1, from = 2, until = 2 }",
             "must be later than from = 2 s");
  expectSays("oscillation = { amplitude = [1, 0], frequency = 1, until = 2, ramp = 1.5 }",
             "must be in [0, 1] s");
  expectSays("rocking = { amplitude = 5, frequency = 1, axis = [0, 0] }",
             "in two dimensions the axis is z");
  expectSays("rocking = { amplitude = 5, frequency = 1, axis = [0, 0, 0] }", "has no direction", 3);
  expectSays("rotation = { rpm = 1 }\nrocking = { amplitude = 5, frequency = 1, center = [1, 0] }",
             "has another centre or axis than `rotation`");
  expectSays("rotation = { rpm = 1 }\nrocking = { amplitude = 5, frequency = 1, axis = [1, 0, 0] }",
             "has another centre or axis than `rotation`", 3);
  expectSays("rotation = { center = [1, 0] }", "needs either rpm");
  expectSays("motion = { center = [1, 0] }", "table");
  expectSays("motion = { table = \"\" }", "names no file");
  expectSays("motion = { table = \"nowhere.csv\" }", "no such file");
  expectSays("swinging = 1", "swinging");
}

TEST(WallMotions, RefusesTablesThatDoNotGoWithOtherKeys) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "way.csv") << "time,x\n0,0\n1,1\n";
  std::ofstream(folder / "turn.csv") << "time,angle\n0,0\n1,1\n";
  const auto expectSays = [&](const std::string& keys, const std::string& says) {
    std::string message;
    try {
      motionOf<2>(keys, (folder / "case.toml").string());
    } catch (const InputError& error) {
      message = error.what();
    }
    EXPECT_NE(message.find(says), std::string::npos) << keys << "\nsays: " << message;
  };
  expectSays("motion = { table = \"way.csv\", center = [1, 0] }", "goes with a column angle");
  expectSays("rotation = { rpm = 1 }\nmotion = { table = \"turn.csv\", center = [1, 0] }",
             "another centre or axis");
  expectSays(
      "rocking = { amplitude = 1, frequency = 1 }\nmotion = { table = \"turn.csv\", center = [1, "
      "0] }",
      "another centre or axis");
}

TEST(WallMotions, AreDescribed) {
  EXPECT_EQ(describeMotion({}, 2), "still");
  RigidMotion motion;
  motion.velocity = {0.5, 0, 0};
  motion.angularVelocity = {0, 0, -2};
  motion.oscillation = {{0.1, 0, 0}, {1.5, 0, 1, 3, 0}};
  motion.rocking = {pi / 36, {2}};
  motion.table = {{0, 4}, {{}, {}}};
  EXPECT_EQ(
      describeMotion(motion, 2),
      "moves at (0.5, 0) m/s; turns at -2 rad/s about (0, 0); oscillates by (0.1, 0) m at 1.5 "
      "1/s from 1 s until 3 s; rocks by 5 degrees at 2 1/s about (0, 0); follows a table of 2 "
      "rows from 0 s until 4 s");
}

}  // namespace
}  // namespace plenum
