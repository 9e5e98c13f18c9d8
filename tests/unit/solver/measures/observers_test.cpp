// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/observers.hpp"

#include "particles/errors.hpp"
#include "tests/support/threads.hpp"
#include "tests/unit/solver/measures/water.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

MeasureSettings measuresOf(const std::string& text) {
  return measureSection().read(CaseNode::parse(text, "case.toml"), 2);
}

std::string namesOf(const std::vector<Figure>& row) {
  std::string names;
  for (const Figure& f : row) names += f.name + " ";
  return names;
}

const std::string many = R"(
order = false
probe = [{ name = "p1", point = [0.5, 0.3] }]
gauge = [{ name = "h1", point = [0.5] }, { name = "h2", point = [0.7], dry = 0 }]
front = { direction = "-" }
volume = [{ name = "left_half", lower = [0, 0], upper = [0.5, 1] }]
pressure_gradient = {}
couette = { inner_radius = 0.1, outer_radius = 0.5, inner_omega = 1 }
)";

TEST(Observers, AddWhatTheCaseNamesAndNothingElse) {
  const Scene<2> scene = test::stillWater<2>({{1, 0.6}}, 0.05);
  const auto state = test::observed(scene);
  std::vector<Figure> row;
  Observers<2>(measuresOf(many), state).addTo(row, state);
  EXPECT_EQ(namesOf(row),
            "p1_pressure p1_velocity_x p1_velocity_y h1 h2 front left_half "
            "pressure_gradient_error l1_velocity couette_profile_error ");
  row.clear();
  Observers<2>(measuresOf("order = false"), state).addTo(row, state);
  EXPECT_EQ(namesOf(row), "");
  Observers<2>(measuresOf(""), state).addTo(row, state);
  EXPECT_EQ(namesOf(row), "nn_min nn_mean f.1 f.5 f.85 psi6 void1 left escaped ");
}

TEST(Observers, GiveTheSameForAnyNumberOfThreads) {
  Scene<2> scene = test::stillWater<2>({{3, 2}}, 0.02);  // 15,000: several blocks of a sum
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Vec<2>& x = scene.particles[field::position][i];
    scene.particles[field::velocity][i] = {{std::sin(7 * x[0]), std::cos(9 * x[1])}};
    scene.particles[field::pressure][i] = std::sin(50 * x[0] * x[1]);
  }
  const auto rows = test::forThreads([&] {
    const auto state = test::observed(scene);
    std::vector<Figure> row;
    Observers<2>(measuresOf(many), state).addTo(row, state);
    return row;
  });
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k)
      EXPECT_EQ(row[k].value, rows.front()[k].value) << row[k].name;
}

TEST(Observers, ColumnsMustBeDistinct) {
  const Scene<2> scene = test::stillWater<2>({{1, 0.6}}, 0.05);
  const auto state = test::observed(scene);
  std::vector<Figure> row{{"time", "s", 0}};
  Observers<2>(measuresOf("gauge = [{ name = \"time\", point = [0.5] }]"), state).addTo(row, state);
  EXPECT_NE(test::refusalOf([&] { requireDistinct(row); }).find("called \"time\""),
            std::string::npos);
}

}  // namespace
}  // namespace plenum
