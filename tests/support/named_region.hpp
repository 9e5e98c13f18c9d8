// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry_set.hpp"

#include <string>

namespace plenum::test {

/// The region `name`, as a case would find it.
template <int Dim>
GeometryPtr<Dim> regionNamed(const GeometrySet<Dim>& set, const std::string& name) {
  return set.find(*CaseNode::parse("region = \"" + name + "\"", "case.toml").find("region"));
}

}  // namespace plenum::test
