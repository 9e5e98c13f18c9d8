// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/numbers.hpp"

#include <charconv>
#include <cmath>

namespace plenum::study {

std::optional<double> numberIn(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

double roundedDown(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= value) return factor * power;
  return power;
}

}  // namespace plenum::study
