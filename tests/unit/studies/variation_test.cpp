// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/variation.hpp"

#include "particles/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace plenum::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string caseFile(const std::string& name) {
  return std::string(PLENUM_SOURCE_DIR) + "/cases/" + name;
}
const std::string tank = caseFile("hydrostatic_tank.toml");

std::vector<std::string> settingsOf(const std::vector<std::string>& vary, std::size_t place,
                                    const std::string& file = tank) {
  std::vector<Variation> axes;
  for (const std::string& text : vary) axes.push_back(Variation::parse(text, file));
  return gridOf(axes, {file, {}, 1, false}).at(place).request.settings;
}

std::string refusal(const std::string& text) {
  try {
    const Variation axis = Variation::parse(text, tank);
    gridOf({axis}, {tank, {}, 1, false});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Variation, KnowsShortNames) {
  EXPECT_THAT(Variation::parse("kernel=convex", tank).keys, ElementsAre("solver.kernel"));
  EXPECT_THAT(Variation::parse("h=1.5,2", tank).keys, ElementsAre("solver.smoothing_length"));
  EXPECT_THAT(Variation::parse("spacing=0.1", tank).keys, ElementsAre("spacing"));
  EXPECT_THAT(Variation::parse("fluid[0].seed=1,2", tank).keys, ElementsAre("fluid[0].seed"));
  const Variation lattice =
      Variation::parse("lattice=square,hexagonal", caseFile("dam_break_multiphase.toml"));
  EXPECT_THAT(lattice.keys, ElementsAre("fluid[0].lattice", "fluid[1].lattice"));
  EXPECT_THAT(lattice.values[0], ElementsAre("square", "square"));
}

TEST(Variation, SplitsOutsideOfBracketsOnly) {
  const Variation axis = Variation::parse(
      "collisions=case,{restitution=0.01,range=0.85},{range=0.5,pairs=\"a,b:c\"}", tank);
  ASSERT_EQ(axis.values.size(), 3u);
  EXPECT_EQ(axis.textOf(1), "{restitution=0.01,range=0.85}");
  EXPECT_EQ(axis.textOf(2), "{range=0.5,pairs=\"a,b:c\"}");
}

TEST(Variation, NamesAllThatIsTied) {
  const Variation axis = Variation::parse("kernel:h=convex:1.5,convex:2,wendland_c2:2", tank);
  EXPECT_EQ(axis.name(), "kernel:h");
  EXPECT_EQ(axis.textOf(1), "convex:2");
  EXPECT_EQ(axis.textOf(1, 1), "2");
  EXPECT_EQ(describe({axis}, {2}), "wendland_c2, h = 2 d_ref");
}

TEST(Variation, NamesAKeyOfAllFluidsOnce) {
  const Variation axis =
      Variation::parse("lattice:h=square:1.5,hexagonal:2", caseFile("dam_break_multiphase.toml"));
  EXPECT_EQ(axis.textOf(1), "hexagonal:2");
}

TEST(Variation, TiesKeys) {
  EXPECT_THAT(settingsOf({"spacing:solver.time_step=0.02:4e-4,0.01:1e-4"}, 1),
              ElementsAre("spacing=0.01", "solver.time_step=1e-4"));
}

TEST(Variation, RefusesWhatItCannotRead) {
  EXPECT_THAT(refusal("kernl=convex"), HasSubstr("did you mean kernel?"));
  EXPECT_THAT(refusal("h"), HasSubstr("h"));
  EXPECT_THAT(refusal("h=1.5,,2"), HasSubstr("KEY=VALUE,VALUE"));
  EXPECT_THAT(refusal("h:spacing=1.5"), HasSubstr("KEY:KEY=VALUE:VALUE"));
  EXPECT_THAT(refusal("h=1.5,2,1.5"), HasSubstr("1.5 stands there twice"));
  EXPECT_THAT(refusal("h=1.5,1.50"), HasSubstr("1.50 stands there twice"));
  EXPECT_THAT(refusal("h:h=1:2"), HasSubstr("solver.smoothing_length is varied twice"));
  EXPECT_THAT(refusal("threads=1.5"), HasSubstr("no positive whole number"));
  EXPECT_THAT(refusal("time_step_factor=-1"), HasSubstr("no positive number"));
}

TEST(Grid, HasAllCombinationsTheLastAxisFastest) {
  const std::vector<Variation> axes{Variation::parse("kernel=convex,wendland_c2", tank),
                                    Variation::parse("h=1.5,2,2.5", tank)};
  const auto grid = gridOf(axes, {tank, {"solver.end_time=0.5"}, 1, false});
  ASSERT_EQ(grid.size(), 6u);
  EXPECT_THAT(grid[4].at, ElementsAre(1, 1));
  EXPECT_THAT(
      grid[4].request.settings,
      ElementsAre("solver.end_time=0.5", "solver.kernel=wendland_c2", "solver.smoothing_length=2"));
  EXPECT_EQ(describe(axes, grid[4].at), "wendland_c2, h = 2 d_ref");
  EXPECT_EQ(gridOf({}, {tank, {}, 1, false}).size(), 1u);
  EXPECT_EQ(describe({}, {}), "as the case has it");
}

/// The tank fixes 2e-4 s at a spacing of .01 m.
TEST(Grid, KeepsTheRatioOfTimeStepAndSpacing) {
  EXPECT_THAT(settingsOf({"spacing=0.02"}, 0),
              ElementsAre("spacing=0.02", "solver.time_step=0.0004"));
  EXPECT_THAT(settingsOf({"spacing=0.01"}, 0), ElementsAre("spacing=0.01"));
  EXPECT_THAT(settingsOf({"spacing=0.02", "time_step_factor=0.25"}, 0),
              ElementsAre("spacing=0.02", "solver.time_step=0.0001"));
}

/// A step that somebody set is the one that a factor is of, at every spacing.
TEST(Grid, LeavesAStepThatIsSetToWhomSetsIt) {
  const std::vector<Variation> axes{Variation::parse("spacing=0.02,0.01", tank),
                                    Variation::parse("time_step_factor=1,0.5", tank)};
  const auto grid = gridOf(axes, {tank, {"solver.time_step=1e-4"}, 1, false});
  for (const std::size_t k : {0u, 2u})
    EXPECT_EQ(grid[k].request.settings.front(), "solver.time_step=1e-4");
  for (const std::size_t k : {1u, 3u})
    EXPECT_EQ(grid[k].request.settings.back(), "solver.time_step=5e-05");
}

TEST(Grid, MultipliesTheStepThatTheCaseHas) {
  EXPECT_THAT(settingsOf({"time_step_factor=0.5"}, 0), ElementsAre("solver.time_step=0.0001"));
  EXPECT_THAT(settingsOf({"time_step_factor=1"}, 0), ElementsAre());
  const std::string sod = caseFile("sod.toml");  // has a Courant number, or the default of .2
  EXPECT_THAT(settingsOf({"time_step_factor=0.5"}, 0, sod),
              ElementsAre(testing::StartsWith("solver.cfl=")));
}

TEST(Grid, RefusesWhatIsSetAndVaried) {
  EXPECT_THROW(gridOf({Variation::parse("h=1.5,2", tank)},
                      {tank, {"solver.smoothing_length=1.8"}, 1, false}),
               InputError);
}

TEST(Grid, HasThreadsThatAreNoSettings) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "one core";
  const auto grid = gridOf({Variation::parse("threads=1,2", tank)}, {tank, {}, 1, false});
  EXPECT_EQ(grid[1].request.threads, 2);
  EXPECT_TRUE(grid[1].request.settings.empty());
}

}  // namespace
}  // namespace plenum::study
