// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/lists.hpp"

#include "particles/errors.hpp"
#include "studies/numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace plenum::study {

namespace {

template <class Value>
void requireOnceEach(const std::string& option, const std::vector<Value>& values) {
  if (values.empty())
    throw InputError(fmt::format("{}: no value is given; leave it out for the default", option));
  for (std::size_t k = 0; k < values.size(); ++k)
    if (std::find(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k), values[k]) !=
        values.begin() + static_cast<std::ptrdiff_t>(k))
      throw InputError(
          fmt::format("{}: {} is there twice; name each value once", option, values[k]));
}

}  // namespace

void readList(const std::string& option, const std::string& text,
              std::vector<std::string>& values) {
  values.clear();
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    if (comma == from)
      throw InputError(fmt::format(
          "{}: a value is missing in '{}'; give a list with commas between, or leave it out",
          option, text));
    values.push_back(text.substr(from, comma - from));
    from = comma + 1;
  }
}

void readList(const std::string& option, const std::string& text, std::vector<double>& values) {
  std::vector<std::string> words;
  readList(option, text, words);
  values.clear();
  for (const std::string& word : words) {
    const std::optional<double> value = numberIn(word);
    if (!value)
      throw InputError(
          fmt::format("{}: '{}' is no number; give numbers with commas between", option, word));
    values.push_back(*value);
  }
}

void requireNumbers(const std::string& option, const std::vector<double>& values, double lowest,
                    double highest) {
  requireOnceEach(option, values);
  for (const double value : values)
    if (!(value >= lowest && value <= highest))
      throw InputError(fmt::format("{}: {:g} is not in [{:g}, {:g}]; give values in that range",
                                   option, value, lowest, highest));
}

void requireWords(const std::string& option, const std::vector<std::string>& values,
                  const std::vector<std::string>& known) {
  requireOnceEach(option, values);
  for (const std::string& value : values) {
    if (std::ranges::count(known, value) > 0) continue;
    const std::string near = nearest(value, known);
    throw InputError(fmt::format("{}: '{}' is not known{}; known are {}", option, value,
                                 near.empty() ? "" : ", is '" + near + "' meant?",
                                 fmt::join(known, ", ")));
  }
}

}  // namespace plenum::study
