// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/front.hpp"

#include "engine/point_search.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace plenum {

namespace {

constexpr int leastNeighbours[] = {1, 3, 6};  // in one, two, three dimensions
constexpr double range = 2;                   // d_ref

}  // namespace

template <int Dim>
Front<Dim>::Front(const FrontSettings& settings, const Observed<Dim>& start, const std::string& key)
    : axis_(settings.axis[0] - 'x'),
      sign_(settings.direction == "+" ? 1 : -1),
      choice_(settings.material, start.info, key + ".material") {
  if (start.info.domain.isPeriodic(axis_))
    throw InputError(
        fmt::format("{}.axis = \"{}\": the domain is periodic along it, so nothing is outermost; "
                    "choose another axis",
                    key, settings.axis));
}

template <int Dim>
void Front<Dim>::addTo(std::vector<Figure>& row, const Observed<Dim>& state) const {
  const auto all = state.particles[field::position].first(state.particles.nFluid());
  std::vector<Vec<Dim>> chosen;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (choice_.has(state.particles, i)) chosen.push_back(all[i]);
  const PointSearch<Dim> search(chosen, state.info.domain, range * state.info.spacing);
  const auto countAround = [&](std::size_t i) {
    int count = -1;  // itself
    search.around(chosen[i], [&](std::uint32_t, const Vec<Dim>&, double) { ++count; });
    return count;
  };
  std::vector<double> outward(chosen.size());
  std::ranges::transform(chosen, outward.begin(), [&](const auto& x) { return sign_ * x[axis_]; });
  const auto lessOutward = [&](std::size_t i, std::size_t j) { return outward[i] < outward[j]; };
  std::vector<std::size_t> heap(chosen.size());
  for (std::size_t i = 0; i < heap.size(); ++i) heap[i] = i;
  std::ranges::make_heap(heap, lessOutward);  // the first few only are asked for
  double front = std::numeric_limits<double>::quiet_NaN();
  while (!heap.empty() && std::isnan(front)) {
    if (countAround(heap.front()) >= leastNeighbours[Dim - 1])
      front = sign_ * outward[heap.front()];
    std::ranges::pop_heap(heap, lessOutward);
    heap.pop_back();
  }
  row.push_back({"front", "m", front});
}

template class Front<1>;
template class Front<2>;
template class Front<3>;

}  // namespace plenum
