// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/csv.hpp"
#include "studies/maps/bisection.hpp"
#include "studies/maps/collisions.hpp"
#include "studies/maps/grid.hpp"
#include "studies/maps/interface.hpp"
#include "studies/maps/onset.hpp"
#include "studies/maps/pairing.hpp"
#include "studies/maps/tension.hpp"
#include "studies/maps/time_step.hpp"

#include "particles/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace plenum::study {

namespace {

RunOutcome outcomeWith(double share) {
  RunOutcome outcome;
  outcome.figures["f.5"] = share;
  return outcome;
}

RunOutcome failedAt(double time) {
  RunOutcome outcome = outcomeWith(1);
  outcome.failure = "too fast, \"5 c\"";
  outcome.failureTime = time;
  return outcome;
}

/// One row, two columns: two seeds that ended; one that did and one that failed.
Grid smallGrid() {
  Grid grid;
  grid.plan.rows = wordAxis("kernel", "solver.kernel", {"convex"});
  grid.plan.columns = numberAxis("h/d_ref", "solver.smoothing_length", {1.5, 2});
  grid.outcomes = {{{outcomeWith(.25), outcomeWith(.75)}, {outcomeWith(.5), failedAt(.125)}}};
  return grid;
}

/// Finds where values above `limit` are bad.
Bisection searched(double limit) {
  Bisection search(.03, 3.2, 1.03);
  for (int k = 0; k < 30 && search.next(); ++k) {
    const double value = *search.next();
    search.record(value, value <= limit);
  }
  return search;
}

}  // namespace

TEST(MapGrid, SeedsBecomeOneNumberAndFailuresDoNotCount) {
  const Grid grid = smallGrid();
  const Figure share = lastFigure("f.5");
  EXPECT_EQ(grid.at(0, 0, share), .5);  // of binary fractions: exact
  EXPECT_EQ(grid.at(0, 1, share), .5);
  EXPECT_TRUE(std::isnan(grid.at(0, 0, lastFigure("psi6"))));
}

TEST(MapGrid, ChartMarksCellsThatFailed) {
  Grid grid = smallGrid();
  const HeatMap map = grid.chart("title", "f.5", lastFigure("f.5"));
  EXPECT_EQ(map.texts[0], (std::vector<std::string>{"0.5", "0.5!"}));
  grid.outcomes[0][1] = {failedAt(.125), failedAt(.25)};
  EXPECT_EQ(grid.chart("", "", lastFigure("f.5")).texts[0][1], "at 0.12 s");
  EXPECT_TRUE(std::isnan(grid.chart("", "", lastFigure("f.5")).values[0][1]));
}

TEST(MapGrid, TableHasARowForEachRun) {
  Map map;
  smallGrid().tabulate({{"f.5", lastFigure("f.5")}}, map);
  ASSERT_EQ(map.rows.size(), 4u);
  EXPECT_EQ(map.columns.size(), map.rows[0].size());
  EXPECT_EQ(map.rows[1], (std::vector<std::string>{"convex", "1.5", "2", "0.75", "", ""}));
  EXPECT_EQ(map.rows[3],
            (std::vector<std::string>{"convex", "2", "2", "", "0.125", "too fast, \"5 c\""}));
  EXPECT_EQ(csvCell(map.rows[3][5]), "\"too fast, \"\"5 c\"\"\"");
  EXPECT_EQ(csvCell("plain"), "plain");
}

TEST(MapFiles, TextAlignsColumns) {
  HeatMap map{"Title", "k", "h", "f", {"convex", "c"}, {"1", "2.5"}, {{.5, 0}, {1, NAN}},
              {},      {},  {}};
  EXPECT_EQ(textOf(map), "Title (f)\nk \\ h     1  2.5\nconvex  0.5    0\nc         1    -\n");
}

TEST(Onset, FindsRangesAndSaysThem) {
  const std::vector<double> places{1, 1.1, 1.2, 1.3, 1.4};
  EXPECT_EQ(onsetSentence(places, {0, 0, 0, 0, .02}, "h"), "no pairs at any h of the map");
  EXPECT_EQ(onsetSentence(places, {0, 0, .5, .9, 1}, "h"), "pairs from h 1.1 - 1.2 on");
  EXPECT_EQ(onsetSentence(places, {.2, 0, 0, .5, NAN}, "h"),
            "pairs from h 1, the least of the map, on up to 1 - 1.1, and again from 1.2 - 1.3 on");
  EXPECT_EQ(onsetSentence({1.3, 1.1, 1.2}, {.5, 0, 0}, "h"), "pairs from h 1.2 - 1.3 on");
}

TEST(Bisection, FindsALimitWithinItsPrecision) {
  for (const double limit : {.06, .9, 1.7, 3.1}) {
    const Bisection search = searched(limit);
    ASSERT_TRUE(search.good() && search.bad()) << limit;
    EXPECT_LE(*search.good(), limit);
    EXPECT_GT(*search.bad(), limit);
    EXPECT_LE(*search.bad(), *search.good() * 1.03);
  }
}

TEST(Bisection, SaysWhereTheLimitIsOutside) {
  EXPECT_FALSE(searched(.02).good());
  EXPECT_FALSE(searched(.02).next());
  EXPECT_FALSE(searched(10).bad());
  EXPECT_EQ(searched(10).good(), 3.2);
}

TEST(Pairing, LengthsOfNeighboursAreThoseOfLattices) {
  // (3 N/(32 pi))^(1/3) (V/N)^(1/3), with d_ref = 2^(1/6) (V/N)^(1/3) in hcp: cases/pairing_3d.toml
  // has 1.240 and 1.105 for 64, cut off after three digits.
  EXPECT_NEAR(lengthOfNeighbours(64, 3), 1.105, 1e-3);
  EXPECT_NEAR(lengthOfNeighbours(64, 3) * std::pow(2, 1. / 6), 1.240, 1e-3);
  // In 2-D a support of 4 d_ref has 16 pi / (sqrt(3)/2) particles.
  EXPECT_NEAR(lengthOfNeighbours(16 * M_PI / (std::sqrt(3) / 2), 2), 2, 1e-14);  // round-off
}

TEST(InterfaceGap, IsTheMedianOverColumns) {
  Scene<2> scene;
  scene.info.spacing = .1;
  scene.info.domain.lower = {0, 0};
  scene.info.domain.upper = {.6, 1};
  scene.particles = ParticleSet<2>(FieldSet{FieldId::position, FieldId::material}, 6, 0);
  const auto x = scene.particles[field::position];
  const auto material = scene.particles[field::material];
  const double gaps[] = {.1, .3, .2};  // of the three columns [m]
  for (std::size_t k = 0; k < 3; ++k) {
    x[2 * k] = {.2 * static_cast<double>(k) + .1, .5};
    x[2 * k + 1] = {.2 * static_cast<double>(k) + .1, .5 + gaps[k]};
    material[2 * k] = 0;
    material[2 * k + 1] = 1;
  }
  EXPECT_NEAR(interfaceGap(scene), 2, 1e-12);  // round-off
  for (std::size_t i = 0; i < 6; ++i) material[i] = 0;
  EXPECT_TRUE(std::isnan(interfaceGap(scene)));
}

// Nothing runs before options have been read: these would need programs, and leave a folder.
TEST(MapOptions, WhatCannotBeUsedIsRefusedInOneLine) {
  const auto refusal = [](auto options, auto run) -> std::string {
    options.common.folder = "must_not_appear";
    options.common.programs = "nowhere";
    try {
      run(options);
    } catch (const InputError& error) {
      EXPECT_FALSE(std::filesystem::exists("must_not_appear"));
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return error.what();
    }
    return "not refused";
  };
  PairingOptions pairing;
  pairing.kernels = {"convx"};
  EXPECT_EQ(refusal(pairing, runPairing).substr(0, 58),
            "--kernels: 'convx' is not known, is 'convex' meant?; known");
  pairing.kernels = {"convex", "convex"};
  EXPECT_EQ(refusal(pairing, runPairing), "--kernels: convex is there twice; name each value once");
  pairing.kernels.clear();
  pairing.lengths = {2, 9};
  EXPECT_EQ(refusal(pairing, runPairing),
            "--smoothing-length: 9 is not in [0.6, 4.5]; give values in that range");
  pairing.lengths.clear();
  pairing.seeds = 0;
  EXPECT_EQ(refusal(pairing, runPairing),
            "--seeds: 0 is not in [1, 1000]; give values in that range");
  TensionOptions tension;
  tension.pressures.clear();
  EXPECT_EQ(refusal(tension, runTension),
            "--pressures: no value is given; leave it out for the default");
  CollisionOptions collisions;
  collisions.restitutions = {NAN};
  EXPECT_EQ(refusal(collisions, runCollisions),
            "--restitution: nan is not in [0, 1]; give values in that range");
  TimeStepOptions steps;
  steps.scenes = {"tenk"};
  EXPECT_EQ(refusal(steps, runTimeStep),
            "--scenes: 'tenk' is not known, is 'tank' meant?; known are box, tank, shaft, dam");
  InterfaceOptions interface;
  interface.ratios = {.5};
  EXPECT_EQ(refusal(interface, runInterface),
            "--ratios: 0.5 is not in [1, 100000]; give values in that range");
}

}  // namespace plenum::study
