// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_node.hpp"
#include "particles/vec.hpp"

#include <span>
#include <string>
#include <vector>

namespace plenum {

/// A number that depends on the place: a formula of x, y, z [m], r, the distance from the origin
/// [m], and pi. May be asked from several threads.
template <int Dim>
class Formula {
 public:
  /// Throws InputError of `node`, with the names that may be used, for text that is no formula.
  Formula(std::string text, const CaseNode& node);

  /// values[k] at points[k]; may be NaN.
  void at(std::span<const Vec<Dim>> points, std::span<double> values) const;

 private:
  std::string text_;
};

/// The values at all points, from all threads. Throws InputError of `node`, with the place, where
/// one is not finite.
template <int Dim>
std::vector<double> finiteValuesAt(const Formula<Dim>& formula, std::span<const Vec<Dim>> points,
                                   const CaseNode& node);

}  // namespace plenum
