// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/case.hpp"

#include <cmath>

namespace plenum::bench {

std::vector<std::vector<Case>> casesOf(const Choice& choice) {
  constexpr double sizeForMixedOnly = 1e6;
  std::vector<std::vector<Case>> sizes;
  for (double n = choice.smallest; n <= choice.largest * (1 + 1e-9); n *= 10) {
    std::vector<Case> cases;
    for (const std::string& scene : choice.scenes)
      for (const int dimension : choice.dimensions)
        for (const std::string& precision : choice.precisions) {
          const bool isChosen = choice.full || choice.precisions.size() == 1 ||
                                precision == "mixed" || n < sizeForMixedOnly;
          if (isChosen)
            cases.push_back(
                {scene, dimension, precision, static_cast<std::size_t>(std::llround(n))});
        }
    sizes.push_back(std::move(cases));
  }
  return sizes;
}

}  // namespace plenum::bench
