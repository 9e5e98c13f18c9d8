// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/numbers.hpp"

#include <charconv>

namespace plenum::study {

std::optional<double> numberIn(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace plenum::study
