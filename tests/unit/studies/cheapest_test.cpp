// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/cheapest.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plenum::study {
namespace {

/// Families of first and second order and one that does not converge, at six spacings; costs as the
/// inverse cube of the spacing, times a factor that nobody told.
struct Grid {
  std::vector<Candidate> candidates;
  std::vector<CostAndError> truth;
  double all = 0;

  Grid() {
    const double firstErrors[] = {0.4, 0.9, 0.05}, orders[] = {1, 2, 0}, factors[] = {1, 1.3, 0.8};
    for (int k = 0; k < 6; ++k)
      for (std::size_t family = 0; family < 3; ++family) {
        const double spacing = std::pow(2, -k);
        const double work = std::pow(spacing, -3);
        candidates.push_back({work, spacing, family});
        truth.push_back(
            {work * factors[family], firstErrors[family] * std::pow(spacing, orders[family])});
        all += truth.back().cost;
      }
  }

  /// What the whole grid says.
  std::optional<std::size_t> best(double error) const {
    std::optional<std::size_t> found;
    for (std::size_t k = 0; k < truth.size(); ++k)
      if (truth[k].error <= error && (!found || truth[k].cost < truth[*found].cost)) found = k;
    return found;
  }
};

TEST(Cheapest, IsThatOfTheWholeGridAtAThirdOfItsCost) {
  const Grid grid;
  for (const double error : {0.3, 0.1, 0.06, 0.03, 0.02}) {
    double spent = 0;
    const Search search = findCheapest(grid.candidates, error, [&](std::size_t k) {
      spent += grid.truth[k].cost;
      return std::optional(grid.truth[k]);
    });
    EXPECT_EQ(search.found, grid.best(error)) << error;
    EXPECT_LE(spent, grid.all / 3) << error;
  }
}

TEST(Cheapest, DoesNotTryWhatCannotReachIt) {
  const Grid grid;
  const Search search = findCheapest(grid.candidates, 1e-9,
                                     [&](std::size_t k) { return std::optional(grid.truth[k]); });
  EXPECT_FALSE(search.found);
  EXPECT_EQ(search.tried.size(), 3u);  // the coarsest of each family says enough
}

TEST(Cheapest, GoesOnAfterFailures) {
  const Grid grid;
  const Search search = findCheapest(grid.candidates, 0.3, [&](std::size_t k) {
    return grid.candidates[k].family == 2 ? std::nullopt : std::optional(grid.truth[k]);
  });
  ASSERT_TRUE(search.found);
  EXPECT_NE(grid.candidates[*search.found].family, 2u);
}

}  // namespace
}  // namespace plenum::study
