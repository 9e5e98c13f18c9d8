// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/vec.hpp"

#include <fmt/format.h>

#include <string>

namespace plenum {

/// "(0.1, -2)": a point as messages show it.
template <int Dim>
std::string printed(const Vec<Dim>& x) {
  std::string text;
  for (int a = 0; a < Dim; ++a) text += fmt::format("{}{:.6g}", a == 0 ? "" : ", ", x[a]);
  return "(" + text + ")";
}

}  // namespace plenum
