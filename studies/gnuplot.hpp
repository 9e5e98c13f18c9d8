// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace plenum::study {

/// What gnuplot draws by a script: the bytes of its output file. Throws RunError if it is not
/// installed, or with what it says if it refuses.
std::string gnuplot(const std::string& script);

/// A text in quotation marks, as gnuplot reads it back.
std::string quotedForGnuplot(const std::string& text);

}  // namespace plenum::study
