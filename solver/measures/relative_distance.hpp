// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace plenum {

/// Sum |a - a_ref| / sum |a_ref|: relative L1.
struct RelativeDistance {
  double difference = 0, reference = 0;

  RelativeDistance& operator+=(const RelativeDistance& b) {
    difference += b.difference;
    reference += b.reference;
    return *this;
  }
  /// NaN where the reference is zero everywhere.
  double value() const {
    return reference > 0 ? difference / reference : std::numeric_limits<double>::quiet_NaN();
  }
};

}  // namespace plenum
