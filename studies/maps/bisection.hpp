// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace plenum::study {

/// Where something that goes well at small values goes wrong, on a logarithmic scale. The ends are
/// tried only if nothing between them has gone well, or nothing wrong.
class Bisection {
 public:
  /// Until the last good and the first bad value are within a factor `precision`, above 1.
  Bisection(double lowest, double highest, double precision);

  /// The value to try now; none if the search is over.
  std::optional<double> next() const;
  /// What came of a value near `next`.
  void record(double value, bool isGood);

  /// The largest value that went well: none if even the lowest went wrong.
  std::optional<double> good() const { return good_; }
  /// The smallest that went wrong: none if even the highest went well.
  std::optional<double> bad() const { return bad_; }

 private:
  double lowest_, highest_, precision_;
  std::optional<double> good_, bad_;
  bool triedLowest_ = false, triedHighest_ = false;
};

}  // namespace plenum::study
