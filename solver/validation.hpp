// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/validate_settings.hpp"
#include "solver/figure.hpp"

#include <optional>
#include <string>
#include <vector>

namespace plenum {

/// How one entry of [[validate]] came out.
enum class Verdict {
  ok,
  failed,
  notReached,  ///< the run ended before the time that is asked for
  noValue,     ///< the column is empty where it is asked for
};

/// "ok", "FAILED", "not reached", "no value".
const char* nameOf(Verdict verdict);

struct ValidationResult {
  ValidateSettings asked;
  std::string unit;                ///< of the quantity
  std::optional<double> measured;  ///< of a curve the mean deviation, relative if that is asked for
  Verdict verdict = Verdict::noValue;
};

/// Compares the rows of history.csv with what a case says they must show. Keeps only the columns
/// that it needs.
class Validation {
 public:
  /// `row` has the figures that every row will have. Throws InputError that names the key and the
  /// nearest column for a quantity that the run does not measure.
  Validation(std::vector<ValidateSettings> asked, const std::vector<Figure>& row);

  /// The times at which there must be rows, ascending [s].
  static std::vector<double> timesOf(const std::vector<ValidateSettings>& asked);

  /// Rows come in the order of time; one that is not later than those before replaces them from
  /// its time on, as a run that is resumed replaces what came after its checkpoint.
  void addRow(const std::vector<Figure>& row);

  /// A verdict for each entry, from the rows so far. Rows with an empty cell do not count. Values
  /// at a time are linear between rows; means are over time, by the trapezoidal rule.
  std::vector<ValidationResult> evaluate() const;

 private:
  struct Column {
    std::string name, unit;
    std::vector<double> values;  // NaN: empty
  };

  std::vector<ValidateSettings> asked_;
  std::vector<double> times_;
  std::vector<Column> columns_;        // no name twice
  std::vector<std::size_t> columnOf_;  // of each entry
};

/// True if every verdict is ok.
bool allOk(const std::vector<ValidationResult>& results);

}  // namespace plenum
