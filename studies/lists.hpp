// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lists behind options: words or numbers with commas between.
#pragma once

#include <string>
#include <vector>

namespace plenum::study {

/// "1,2.5" or "box,tank" as values. Throws InputError, in one line, that names `option`, for what
/// is empty and for what should be a number and is none.
void readList(const std::string& option, const std::string& text, std::vector<double>& values);
void readList(const std::string& option, const std::string& text, std::vector<std::string>& values);

/// Values of an axis are numbers in [lowest, highest]. Throws InputError, in one line, that names
/// `option`, the value and the range, for others, for none and for one that stands there twice.
void requireNumbers(const std::string& option, const std::vector<double>& values, double lowest,
                    double highest);

/// The same for words that must be of `known`.
void requireWords(const std::string& option, const std::vector<std::string>& values,
                  const std::vector<std::string>& known);

}  // namespace plenum::study
