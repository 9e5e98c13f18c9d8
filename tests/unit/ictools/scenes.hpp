// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes from text, and distances the slow way.
#pragma once

#include "ictools/generate.hpp"
#include "particles/errors.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace plenum::test {

/// The scene of a case that stands in a string.
template <int Dim>
Scene<Dim> sceneOf(const std::string& text, std::vector<std::string>* warnings = nullptr,
                   const std::string& fileName = "test.toml") {
  const CaseNode root = CaseNode::parse(text, fileName);
  return generate<Dim>(root, readCase(root), fileName,
                       [&](const std::string& message) {
                         if (warnings != nullptr) warnings->push_back(message);
                       })
      .scene;
}

/// The message of the InputError that a case ends with; "" if there is none.
template <int Dim>
std::string messageOf(const std::string& text) {
  try {
    sceneOf<Dim>(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Distance of every point to the nearest other one.
template <int Dim, class Points>
std::vector<double> nearestDistances(const Points& points, const Box<Dim>& box) {
  std::vector<double> result(points.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double r = norm(box.nearestImage(points[i] - points[j]));
      result[i] = std::fmin(result[i], r);
      result[j] = std::fmin(result[j], r);
    }
  return result;
}

/// One fluid in a periodic box of 1 m; `fluid` is appended to it.
inline std::string periodicBox(const std::string& spacing, const std::string& fluid) {
  return "dimension = 2\nspacing = " + spacing + R"(
[domain]
lower = [0, 0]
upper = [1, 1]
periodic = ["x", "y"]
[[fluid]]
)" + fluid;
}

/// The annulus of [C] (Kruisbrink et al. 2018, doi 10.4236/jamp.2018.69158), section 5: radius .04
/// to .1 m, d_ref = 1/200 m; `wall` is appended to both walls.
inline std::string shaftCase(const std::string& wall = "") {
  return R"(
dimension = 2
spacing = 0.005
[geometry]
shaft = { disk = { center = [0, 0], radius = 0.04 } }
housing = { disk = { center = [0, 0], radius = 0.10 } }
gap = { difference = ["housing", "shaft"] }
[solver]
smoothing_length = 1.5
[[fluid]]
region = "gap"
lattice = "hexagonal"
lattice_origin = [0, 0]
[[wall]]
region = "shaft"
layers = 8
rotation = { rpm = 1000 }
)" + wall +
         R"(
[[wall]]
outside = "housing"
layers = 4
)" + wall;
}

}  // namespace plenum::test
