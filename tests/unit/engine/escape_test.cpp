// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions that are no numbers, and particles that leave an open domain for good: the engine names
// the former, and neither its memory nor the sums of those that stayed suffer from the latter.
#include "engine/engine.hpp"

#include "engine/pass_of.hpp"
#include "particles/errors.hpp"
#include "tests/support/dimensions.hpp"
#include "tests/support/pair_sums.hpp"
#include "tests/support/random_particles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace plenum {
namespace {

template <class T>
class EscapeTest : public testing::Test {};
TYPED_TEST_SUITE(EscapeTest, test::Dimensions);

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

template <int Dim>
std::string refusal(Engine<Dim>& engine, ParticleSet<Dim>& particles) {
  try {
    engine.update(particles);
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

/// All numbers of a set, so that NaN equals NaN.
template <int Dim>
std::vector<std::byte> bytesOf(const ParticleSet<Dim>& particles) {
  std::vector<std::byte> bytes;
  particles.forEachField([&](const FieldInfo&, auto values) {
    const auto raw = std::as_bytes(values);
    bytes.insert(bytes.end(), raw.begin(), raw.end());
  });
  return bytes;
}

TYPED_TEST(EscapeTest, APositionThatIsNoNumberIsNamedAndNothingChanges) {
  constexpr int Dim = TypeParam::value;
  for (const bool periodic : {false, true})
    for (const double value : {nan, infinity, -infinity, 1e300, -1e30})
      for (const std::size_t bad : {0, 57, 119}) {  // a fluid particle; the last wall
        const Box<Dim> box = test::unitBox<Dim>(periodic);
        auto particles = test::randomParticles<Dim>(box, 80, 40);
        Engine<Dim> engine(box, {0.2, 0.2});
        engine.update(particles);  // sorted once
        const double before = particles[field::position][bad][Dim - 1];
        particles[field::position][bad][Dim - 1] = value;
        const auto state = bytesOf(particles);
        // Whoever moves a particle by NaN has moved it too far for the present list.
        engine.moved(std::abs(value - before));
        for (int attempt = 0; attempt < 2; ++attempt) {
          const std::string message = refusal(engine, particles);
          EXPECT_NE(message.find("particle " + std::to_string(particles[field::id][bad]) + ":"),
                    std::string::npos)
              << message;
          const std::string number = std::isfinite(value) ? "e+"
                                     : std::isnan(value)  ? "nan"
                                                          : "inf";
          EXPECT_NE(message.find(number), std::string::npos) << message;
          EXPECT_EQ(bytesOf(particles), state);
        }
        particles[field::position][bad][Dim - 1] = before;
        EXPECT_TRUE(engine.update(particles)) << "must search anew";
        EXPECT_LE(test::deviationOf(engine, particles, box), test::toleranceOf(Precision::mixed));
      }
}

TEST(Escape, WithoutIdsTheParticleIsNamedByItsPlace) {
  const Box<2> box = test::unitBox<2>(false);
  auto particles = test::randomParticles<2>(box, 20, 0);
  particles.remove({field::id});
  particles[field::position][13][0] = nan;
  Engine<2> engine(box, {0.2, 0.2});
  EXPECT_TRUE(refusal(engine, particles).starts_with("particle 13: "));
}

TEST(Escape, MoreParticlesThanIndicesAreRefused) {
  EXPECT_NO_THROW(requireIndices(0));
  EXPECT_NO_THROW(requireIndices(std::size_t{1} << 30));
  for (const std::size_t n : {(std::size_t{1} << 30) + 1, std::size_t{1} << 32,
                              std::numeric_limits<std::size_t>::max()}) {
    try {
      requireIndices(n);
      FAIL() << "no error for " << n;
    } catch (const RunError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(std::to_string(n) + " particles: "));
      EXPECT_NE(std::string(error.what()).find("1073741824"), std::string::npos) << error.what();
    }
  }
}

/// A few particles fly off, faster and faster, and come back at last; the others jitter in place.
/// All clusters are full, so that none has as many strays as others: positions are relative to the
/// median of a cluster, and would lose digits if that were a stray.
template <int Dim>
struct Flight {
  static constexpr std::size_t nFlying = 3;
  static constexpr int nSteps = 2000;
  Box<Dim> box = test::unitBox<Dim>(false);
  ParticleSet<Dim> particles = test::randomParticles<Dim>(box, 104, 0);
  std::vector<Vec<Dim>> home;  // by id

  Flight() {
    home.resize(particles.size() + 1);
    for (std::size_t i = 0; i < particles.size(); ++i)
      home[particles[field::id][i]] = particles[field::position][i];
  }

  /// How far the fastest is away at a step [m]: up to a hundred million boxes.
  static double distance(int step) {
    return step == nSteps ? 0 : std::pow(10.0, 8.0 * step / nSteps) - 1;
  }

  void moveTo(int step) {
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const std::size_t id = particles[field::id][i];
      Vec<Dim> way;
      for (int a = 0; a < Dim; ++a)
        way[a] = id > nFlying
                     ? 1e-3 * std::sin(static_cast<double>(id) + step)
                     : (id % 2 == 0 ? -1 : 1) * distance(step) / (static_cast<double>(id) + a);
      particles[field::position][i] = home[id] + way;
    }
  }
};

TYPED_TEST(EscapeTest, MemoryIsBoundedAndSumsAreRightWhileParticlesFlyAway) {
  constexpr int Dim = TypeParam::value;
  Flight<Dim> flight;
  Engine<Dim> engine(flight.box, {0.2, 0.2});
  std::size_t early = 0, late = 0;  // most bytes in each half of the flight
  double worst = 0;
  for (int step = 0; step <= flight.nSteps; ++step) {
    flight.moveTo(step);
    engine.forget();
    engine.update(flight.particles);
    (step < flight.nSteps / 2 ? early : late) =
        std::max(step < flight.nSteps / 2 ? early : late, engine.bytes());
    if (step == 0 || step == flight.nSteps) {
      EXPECT_EQ(engine.precision(), Precision::mixed) << "step " << step;
    } else if (step > flight.nSteps / 2) {  // ten thousand boxes
      EXPECT_EQ(engine.precision(), Precision::doubled) << "step " << step;
    }
    if (step % 100 != 0) continue;
    const double deviation = test::deviationOf(engine, flight.particles, flight.box);
    worst = std::max(worst, deviation);
    // Those that stayed are where they were: the distance of the others must not show.
    EXPECT_LE(deviation, test::toleranceOf(engine.precision())) << "step " << step;
  }
  std::cout << "  largest deviation " << worst << ", bytes " << early << ", " << late << "\n";
  // The list of these few particles varies with who shares a cluster with a stray, not with the
  // distance: a quarter is the room that arrays keep when they grow.
  EXPECT_LE(late, early + early / 4);
}

/// In double, too, no place without a particle may be met: five particles leave three places of
/// their cluster empty, and these must lie somewhere.
TYPED_TEST(EscapeTest, NobodyOnTheWayMeetsTheEmptyPlacesOfACluster) {
  constexpr int Dim = TypeParam::value;
  const Box<Dim> box = test::unitBox<Dim>(false);
  const double support = 0.5, h = 0.5 * support;
  const Pass<kernel::WendlandC2, test::GradientProbe> pass{{}, h, {}};
  const auto made = passOf<Dim>(pass);
  auto particles = test::randomParticles<Dim>(box, 5, 0);
  for (Vec<Dim>& x : particles[field::position]) x *= 0.1;  // near the diagonal
  Engine<Dim> engine(box, {support, 0.2, false, Precision::doubled});
  const double W0 = Kernel<Dim, kernel::WendlandC2>::W(0, h);
  const auto placeOf = [&](std::uint64_t id) {
    const auto ids = std::as_const(particles)[field::id];
    return static_cast<std::size_t>(std::ranges::find(ids, id) - ids.begin());
  };
  // Along the diagonal from beyond the others' support on, so that every place is passed in less
  // than .75 supports. Two fly, each half of the way.
  const double end = 60000 * std::sqrt(Dim);
  for (double way = 5; way < end / 2; way += 1.5) {
    for (const std::uint64_t id : {1, 2})
      particles[field::position][placeOf(id)] =
          Vec<Dim>::filled(support * (way + (id == 2 ? end / 2 : 0.0)) / std::sqrt(Dim));
    engine.forget();
    engine.update(particles);
    engine.run(made, particles);
    for (const std::uint64_t id : {1, 2}) {
      const double expected = particles[field::mass][placeOf(id)] * W0;
      // One pair: a few roundings.
      ASSERT_NEAR(engine.sums(field::density)[placeOf(id)], expected, 1e-15 * expected)
          << "particle " << id << ", " << way << " supports away";
    }
  }
}

/// Tiles, memory and work of a set with some strays, far less than without order.
TYPED_TEST(EscapeTest, StraysDoNotMakeTheListsOfTheOthersLonger) {
  constexpr int Dim = TypeParam::value;
  const Box<Dim> box = test::unitBox<Dim>(false);
  const std::size_t n = 20000;
  const double support = 2 * std::pow(1.0 / static_cast<double>(n), 1.0 / Dim);
  auto alone = test::randomParticles<Dim>(box, n, 0);
  Engine<Dim> reference(box, {support, 0.2});
  reference.update(alone);
  const auto expected = static_cast<double>(reference.tiles().nTiles());
  for (const double distance : {1e3, 1e5, 1e7})
    for (const std::size_t nStrays : {1, 7}) {
      auto particles = test::randomParticles<Dim>(box, n, 0);
      for (std::size_t i = 0; i < nStrays; ++i)
        particles[field::position][i] += Vec<Dim>::filled(i % 2 == 0 ? distance : -distance);
      Engine<Dim> engine(box, {support, 0.2});
      engine.update(particles);
      const auto nTiles = static_cast<double>(engine.tiles().nTiles());
      std::cout << "  " << nStrays << " strays at " << distance << " m: " << nTiles / expected
                << " of the tiles, "
                << static_cast<double>(engine.bytes()) / static_cast<double>(reference.bytes())
                << " of the bytes\n";
      // A cluster of strays may see all n/8 others with each of its halves, no more.
      EXPECT_LE(nTiles, 1.1 * expected + 2.0 * static_cast<double>(nStrays * n) / clusterSize);
    }
}

}  // namespace
}  // namespace plenum
