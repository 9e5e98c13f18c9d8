// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace plenum::study {
/// A cell of CSV: in quotes where it must be (RFC 4180).
std::string csvCell(const std::string& text);

}  // namespace plenum::study
