// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/cheapest.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plenum::study {

namespace {

constexpr double bestOrder = 2;
/// Orders of convergence between two spacings and the next two differ by less (docs/validation.md).
constexpr double orderMargin = 0.3;
/// Costs over estimated work scatter by so much between kernels and sizes.
constexpr double margin = 1.5;

class CheapestSearch {
 public:
  CheapestSearch(const std::vector<Candidate>& candidates, double error)
      : candidates_(candidates), error_(error), results_(candidates.size()) {}

  Search operator()(const std::function<std::optional<CostAndError>(std::size_t)>& run) {
    std::vector<std::size_t> order(candidates_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return candidates_[k].work; });
    for (const std::size_t k : order) {
      if (isTooDear(k)) break;
      if (!mayReach(k)) continue;
      results_[k] = run(k);
      search_.tried.push_back(k);
      note(k);
    }
    return search_;
  }

 private:
  /// Whether its run would cost more than the best found, by the least cost a unit of work so far.
  bool isTooDear(std::size_t k) const {
    if (!search_.found) return false;
    return candidates_[k].work * costOfWork_ > margin * results_[*search_.found]->cost;
  }

  /// Whether the errors of its family on coarser particles leave a chance.
  bool mayReach(std::size_t k) const {
    std::vector<std::size_t> coarser;
    for (const std::size_t t : search_.tried)
      if (results_[t] && candidates_[t].family == candidates_[k].family &&
          candidates_[t].spacing > candidates_[k].spacing)
        coarser.push_back(t);
    if (coarser.empty()) return true;
    std::ranges::sort(coarser, {}, [&](std::size_t t) { return candidates_[t].spacing; });
    const auto spacing = [&](std::size_t t) { return candidates_[t].spacing; };
    const auto errorOf = [&](std::size_t t) { return results_[t]->error; };
    const std::size_t finest = coarser[0];
    if (errorOf(finest) == 0) return true;
    double order = bestOrder;
    if (coarser.size() > 1) {
      const double shown = std::log(errorOf(coarser[1]) / errorOf(finest)) /
                           std::log(spacing(coarser[1]) / spacing(finest));
      order = std::clamp(shown + orderMargin, 0.0, bestOrder);
    }
    return errorOf(finest) * std::pow(spacing(k) / spacing(finest), order) <= error_;
  }

  void note(std::size_t k) {
    if (!results_[k]) return;
    // The cheapest cost a unit of work so far: dearer ones do not end the search too early.
    const double ratio = results_[k]->cost / candidates_[k].work;
    costOfWork_ = costOfWork_ == 0 ? ratio : std::min(costOfWork_, ratio);
    if (results_[k]->error > error_) return;
    if (!search_.found || results_[k]->cost < results_[*search_.found]->cost) search_.found = k;
  }

  const std::vector<Candidate>& candidates_;
  double error_;
  std::vector<std::optional<CostAndError>> results_;
  double costOfWork_ = 0;
  Search search_;
};

}  // namespace

Search findCheapest(const std::vector<Candidate>& candidates, double error,
                    const std::function<std::optional<CostAndError>(std::size_t)>& run) {
  return CheapestSearch(candidates, error)(run);
}

}  // namespace plenum::study
