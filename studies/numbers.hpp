// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace plenum::study {

/// The number that a text is, and nothing else: "2", ".05", "1e-3". None for other texts.
std::optional<double> numberIn(const std::string& text);

/// The largest of 1, 2 and 5 times a power of ten that is not above `value`, which is positive.
double roundedDown(double value);

}  // namespace plenum::study
