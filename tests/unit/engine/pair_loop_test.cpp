// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums over tiles of packs against a double loop over particles.
#include "engine/pair_loop.hpp"

#include "engine/engine.hpp"
#include "engine/pass_of.hpp"
#include "particles/errors.hpp"
#include "tests/support/dimensions.hpp"
#include "tests/support/pair_sums.hpp"
#include "tests/support/random_particles.hpp"
#include "tests/support/threads.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <iostream>

namespace plenum {
namespace {

/// A scalar and a vector that depend on everything that a pair knows. It treats i and j
/// differently, so that an exchange of the two shows.
struct Probe {
  static constexpr FieldSet reads{field::mass, field::velocity};
  static constexpr FieldSet writes{field::density, field::acceleration};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.density += ij.j.mass * ij.W * (Real(1) + Real(0.5) * ij.i.mass) +
                 Real(0.01) * ij.j.mass * ij.velocityDotGradW();
    i.acceleration += ij.j.mass * ij.velocityDotR * ij.gradW();
    i.acceleration -= ij.i.mass * ij.gradW();
    i.acceleration += ij.j.mass * ij.W * (ij.i.velocity + Real(0.25) * ij.j.velocity);
  }
};

/// What i gets and j loses, along r_ij and otherwise, from every field that is derived.
struct ExchangeProbe {
  static constexpr FieldSet reads{field::velocity, field::volume, field::specificVolume,
                                  field::pressureOverDensitySquared};
  static constexpr FieldSet writes{field::force};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  void operator()(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i) const {
    i.force -= ij.i.volume * ij.j.volume *
               (ij.i.pressureOverDensitySquared + ij.j.pressureOverDensitySquared) * ij.gradW();
    i.force += Real(0.1) * ij.W *
               (ij.i.specificVolume * ij.i.velocity - ij.j.specificVolume * ij.j.velocity);
  }
};

/// Every way to use smoothing lengths of two particles: gather, scatter, means.
struct AdaptiveProbe {
  static constexpr FieldSet reads{field::mass};
  static constexpr FieldSet writes{field::density, field::velocityDivergence, field::acceleration};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.density += ij.j.mass * ij.ofI.W;
    i.velocityDivergence += ij.j.mass * ij.ofJ.W * ij.h;
    i.acceleration += ij.j.mass * ij.gradW();
    i.acceleration += (ij.ofI.F + Real(0.5) * ij.ofJ.F) * ij.r;
  }
};

/// Sums whose units are those of their fields.
struct MassDensity {
  static constexpr FieldSet reads{field::mass};
  static constexpr FieldSet writes{field::density};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.density += ij.j.mass * ij.W;
  }
};
struct MomentumFlux {
  static constexpr FieldSet reads{field::volume, field::velocity};
  static constexpr FieldSet writes{field::acceleration};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    const Real speedSquared = normSquared(ij.i.velocity - ij.j.velocity);
    i.acceleration -= ij.j.volume * speedSquared * ij.gradW();
  }
};

template <class T>
class PairLoopTest : public testing::Test {};
TYPED_TEST_SUITE(PairLoopTest, test::Dimensions);

struct Worst {
  double mixed = 0, doubled = 0;
  void note(Precision precision, double deviation) {
    double& worst = precision == Precision::mixed ? mixed : doubled;
    worst = std::max(worst, deviation);
    EXPECT_LE(deviation, test::toleranceOf(precision)) << test::nameOf(precision);
  }
  ~Worst() {
    std::cout << "  largest deviation / typical sum of |terms|: mixed " << mixed << ", double "
              << doubled << "\n";
  }
};

template <int Dim, class P>
void expectEqualToDoubleLoop(const P& pass, const Box<Dim>& box, std::size_t nFluid,
                             std::size_t nWalls, Worst& worst) {
  for (const Precision precision : test::bothPrecisions) {
    auto particles = test::randomParticles<Dim>(box, nFluid, nWalls);
    Engine<Dim> engine(box, {2 * pass.smoothingLength, 0.2, true, precision});
    engine.update(particles);
    for (const Group receivers : test::allGroups)
      for (const Group sources : test::allGroups) {
        SCOPED_TRACE(testing::Message()
                     << nFluid << " fluid, " << nWalls << " walls, periodic " << box.anyPeriodic()
                     << ", receivers " << static_cast<int>(receivers) << ", sources "
                     << static_cast<int>(sources));
        const auto expected = test::sumOfAllPairs<Dim>(pass, particles, box, receivers, sources);
        const auto check = [&](const PairPass<Dim>& made) {
          engine.run(made, particles);
          worst.note(precision,
                     test::worstDeviation(engine, pass.writes, particles, expected, receivers));
        };
        check(passOf<Dim, 16>(pass, receivers, sources));
        check(passOf<Dim, 32>(pass, receivers, sources));
        check(passOf<Dim, 64>(pass, receivers, sources));
      }
  }
}

TYPED_TEST(PairLoopTest, EqualsADoubleLoopOverAllPairs) {
  constexpr int Dim = TypeParam::value;
  const Pass<kernel::WendlandC4, Probe, ExchangeProbe> pass{{}, 0.15, {}};
  Worst worst;
  for (const bool periodic : {false, true}) {
    const Box<Dim> box = test::unitBox<Dim>(periodic);
    expectEqualToDoubleLoop<Dim>(pass, box, 200, 80, worst);
    expectEqualToDoubleLoop<Dim>(pass, box, 9, 0, worst);
    expectEqualToDoubleLoop<Dim>(pass, box, 0, 9, worst);
    expectEqualToDoubleLoop<Dim>(pass, box, 1, 1, worst);
  }
}

/// A box of barely two supports: every image is next to every other.
TYPED_TEST(PairLoopTest, EqualsADoubleLoopInASmallPeriodicBox) {
  constexpr int Dim = TypeParam::value;
  const Pass<kernel::WendlandC4, Probe> pass{{}, 0.2499, {}};
  Worst worst;
  expectEqualToDoubleLoop<Dim>(pass, test::unitBox<Dim>(true), 150, 60, worst);
}

TYPED_TEST(PairLoopTest, EveryKernelChosenAtRunTimeEqualsTheDoubleLoop) {
  constexpr int Dim = TypeParam::value;
  const Box<Dim> box = test::unitBox<Dim>(true);
  for (const std::string& name : KernelId::names()) {
    const Pass<kernel::Any, Probe> pass{{KernelId::named(name)}, 0.15, {}};
    for (const Precision precision : test::bothPrecisions) {
      auto particles = test::randomParticles<Dim>(box, 300, 0);
      Engine<Dim> engine(box, {0.3, 0.2, false, precision});
      engine.update(particles);
      engine.run(passOf<Dim>(pass), particles);
      const double deviation = test::worstDeviation(
          engine, pass.writes, particles,
          test::sumOfAllPairs<Dim>(pass, particles, box, Group::fluids, Group::all), Group::fluids);
      EXPECT_LE(deviation, test::toleranceOf(precision)) << name << ", " << test::nameOf(precision);
      std::cout << "  " << name << ", " << test::nameOf(precision) << ": " << deviation << "\n";
    }
  }
}

/// Packs particles denser and denser to the middle of the unit box, where smoothing lengths are a
/// hundredth of those at its sides: what adaptive smoothing is for.
template <int Dim>
void grade(ParticleSet<Dim>& particles) {
  const auto toMiddle = [](double s) { return 0.5 + 0.5 * s * (0.01 + 0.99 * s * s); };
  const auto lengths = particles[field::smoothingLength];
  for (std::size_t i = 0; i < particles.size(); ++i) {
    double largest = 0;
    for (int a = 0; a < Dim; ++a) {
      double& x = particles[field::position][i][a];
      const double s = 2 * x - 1;
      x = toMiddle(s);
      largest = std::max(largest, 0.01 + 0.99 * 3 * s * s);
    }
    lengths[i] = 0.24 * largest / (0.01 + 0.99 * 3);
  }
}

/// Smoothing lengths of 1 : 100: gather, scatter and means of both, periodic and open. In any order
/// they are no sensible scene (clusters are wider than small supports), but right in double.
TYPED_TEST(PairLoopTest, EqualsADoubleLoopWithASmoothingLengthForEachParticle) {
  constexpr int Dim = TypeParam::value;
  using Profile = Adaptive<kernel::WendlandC4>;
  const Pass<Profile, AdaptiveProbe, ExchangeProbe> pass{{}, 0, {}};
  Worst worst;
  for (const bool periodic : {false, true})
    for (const bool graded : {false, true})
      for (const Precision precision : test::bothPrecisions) {
        if (!graded && precision == Precision::mixed) continue;
        const Box<Dim> box = test::unitBox<Dim>(periodic);
        auto particles = test::randomParticles<Dim>(box, 300, 80);
        particles.add({field::smoothingLength});
        std::mt19937_64 generator(3);
        std::uniform_real_distribution<double> uniform(0, 1);
        for (double& h : particles[field::smoothingLength])
          h = 0.24 * std::pow(0.01, uniform(generator));
        if (graded) grade(particles);
        typename Engine<Dim>::Options options;
        options.wallsReceive = true;
        options.precision = precision;
        options.adaptive = true;
        Engine<Dim> engine(box, options);
        engine.update(particles);
        // Two more states of the same list: particles move, smoothing lengths grow and shrink.
        for (int step = 0; step < 3; ++step) {
          for (const Group receivers : test::allGroups) {
            SCOPED_TRACE(testing::Message()
                         << "periodic " << periodic << ", graded " << graded << ", step " << step
                         << ", receivers " << static_cast<int>(receivers));
            engine.run(passOf<Dim>(pass, receivers, Group::all), particles);
            const auto expected =
                test::sumOfAllPairs<Dim>(pass, particles, box, receivers, Group::all);
            worst.note(precision, test::worstDeviation(engine, pass.writes, particles, expected,
                                                       receivers, test::Measure::own));
          }
          const double smallest = std::ranges::min(particles[field::smoothingLength]);
          for (auto& x : particles[field::position])
            for (int a = 0; a < Dim; ++a) x[a] += 0.02 * smallest * (uniform(generator) - 0.5);
          for (double& h : particles[field::smoothingLength])
            h = std::min(0.24, h * (0.96 + 0.08 * uniform(generator)));
          engine.moved(0.01 * std::sqrt(Dim) * smallest);
          engine.grew(1.04);
          engine.update(particles);
        }
        EXPECT_LE(engine.nRebuilds(), 2u) << "lists must live a while";
      }
}

TYPED_TEST(PairLoopTest, ASmoothingLengthThatIsNoLengthIsAnError) {
  constexpr int Dim = TypeParam::value;
  for (const double bad : {0.0, -0.1, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    const Box<Dim> box = test::unitBox<Dim>(false);
    auto particles = test::randomParticles<Dim>(box, 20, 0);
    particles.add({field::smoothingLength});
    std::ranges::fill(particles[field::smoothingLength], 0.1);
    particles[field::smoothingLength][7] = bad;
    typename Engine<Dim>::Options options;
    options.adaptive = true;
    Engine<Dim> engine(box, options);
    EXPECT_THROW(engine.update(particles), RunError) << bad;
  }
}

/// Sums of one particle only: its own part with r = 0.
TYPED_TEST(PairLoopTest, AParticleIsItsOwnNeighbour) {
  constexpr int Dim = TypeParam::value;
  const Box<Dim> box = test::unitBox<Dim>(false);
  for (const Precision precision : test::bothPrecisions) {
    auto particles = test::randomParticles<Dim>(box, 1, 0);
    Engine<Dim> engine(box, {0.3, 0.2, false, precision});
    engine.update(particles);
    engine.run(passOf<Dim>(Pass<kernel::WendlandC4, Probe>{{}, 0.15, {}}), particles);
    const double m = particles[field::mass][0], W0 = Kernel<Dim, kernel::WendlandC4>::W(0, 0.15);
    const double expected = m * W0 * (1 + 0.5 * m);
    // One pair: a few roundings.
    EXPECT_NEAR(engine.sums(field::density)[0], expected,
                expected * (precision == Precision::mixed ? 1e-6 : 1e-15));
  }
}

TYPED_TEST(PairLoopTest, CoincidentParticlesGiveFiniteSumsAndNoGradient) {
  constexpr int Dim = TypeParam::value;
  const Box<Dim> box = test::unitBox<Dim>(false);
  for (const Precision precision : test::bothPrecisions)
    for (const std::size_t n : {2, 5, 20})
      kernel::forEachProfile([&](auto profile) {
        auto particles = test::randomParticles<Dim>(box, n, 0);
        std::ranges::fill(particles[field::position], Vec<Dim>::filled(0.3));
        Engine<Dim> engine(box, {0.3, 0.2, false, precision});
        engine.update(particles);
        engine.run(passOf<Dim>(Pass<decltype(profile), test::GradientProbe>{profile, 0.15, {}}),
                   particles);
        for (std::size_t i = 0; i < n; ++i) {
          EXPECT_TRUE(std::isfinite(engine.sums(field::density)[i])) << profile.name;
          EXPECT_EQ(norm(engine.sums(field::acceleration)[i]), 0) << profile.name;
        }
      });
}

/// A set in metres and the same in other units of length, mass and time: with the units of the
/// engine near the scene's own, the sums are those of metres.
template <int Dim>
void expectRightInUnitsOf(double length, double mass, double time) {
  const Pass<kernel::Convex, MassDensity, MomentumFlux> inMetres{{}, 0.15, {}};
  auto pass = inMetres;
  pass.smoothingLength *= length;
  for (const Precision precision : test::bothPrecisions) {
    Box<Dim> box = test::unitBox<Dim>(true);
    box.upper *= length;
    auto particles = test::randomParticles<Dim>(box, 200, 0);
    for (double& m : particles[field::mass]) m *= mass;
    for (double& rho : particles[field::density]) rho *= mass / power<Dim>(length);
    for (auto& v : particles[field::velocity]) v *= length / time;
    const Units units = Units::near(pass.smoothingLength, mass, length / time);
    Engine<Dim> engine(box, {2 * pass.smoothingLength, 0.2, false, precision, units});
    engine.update(particles);
    engine.run(passOf<Dim>(pass, Group::fluids, Group::all, units), particles);
    EXPECT_LE(test::worstDeviation(
                  engine, pass.writes, particles,
                  test::sumOfAllPairs<Dim>(pass, particles, box, Group::fluids, Group::all),
                  Group::fluids),
              test::toleranceOf(precision))
        << test::nameOf(precision) << ", unit of length " << length << " m";
  }
}

TYPED_TEST(PairLoopTest, IsRightForMicrochannels) {
  expectRightInUnitsOf<TypeParam::value>(1e-6, 1e-15, 1e-6);
}
TYPED_TEST(PairLoopTest, IsRightForGalaxies) {
  expectRightInUnitsOf<TypeParam::value>(1e19, 1e33, 1e14);
}
/// Squares of metres would overflow in float.
TYPED_TEST(PairLoopTest, IsRightForClustersOfGalaxies) {
  expectRightInUnitsOf<TypeParam::value>(1e23, 1e40, 1e17);
}

TEST(PairLoop, SumsHaveTheSameBitsForAnyNumberOfThreads) {
  const Box<2> box = test::unitBox<2>(true);
  for (const Precision precision : test::bothPrecisions)
    for (const Group receivers : {Group::fluids, Group::all}) {
      const auto results = test::forThreads([&] {
        auto particles = test::randomParticles<2>(box, 20000, 5000);
        Engine<2> engine(box, {0.02, 0.2, receivers == Group::all, precision});
        engine.update(particles);
        EXPECT_GT(engine.tiles().chunks().size(), 5u);
        engine.run(passOf<2>(Pass<kernel::WendlandC4, Probe>{{}, 0.01, {}}, receivers), particles);
        return std::pair(engine.sums(field::density), engine.sums(field::acceleration));
      });
      EXPECT_EQ(results[0], results[1]);
      EXPECT_EQ(results[0], results[2]);
    }
}

}  // namespace
}  // namespace plenum
