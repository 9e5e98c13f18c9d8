// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace plenum::study {

/// Particles count as paired from this share on. Where nothing pairs the share is 0, and where
/// pairing sets in it jumps to some percent and more at once. Kernels with a steep tip lie across
/// the line: schuessler_schmitt has 0 to .1 at any smoothing length, in no order.
inline constexpr double pairedShare = 0.03;

/// A range of places [from, to] of an axis in which all shares are above pairedShare; `before` and
/// `after` are the places next to it, equal to its ends at the ends of the axis.
struct PairedRange {
  double before = 0, from = 0, to = 0, after = 0;
};

/// The ranges along rising `places`; shares that are no number count as paired (those runs failed).
std::vector<PairedRange> pairedRanges(std::vector<double> places, std::vector<double> shares);

/// In words: "pairs from h/d_ref 1.1 - 1.2 on".
std::string onsetSentence(const std::vector<double>& places, const std::vector<double>& shares,
                          const std::string& axis);

}  // namespace plenum::study
