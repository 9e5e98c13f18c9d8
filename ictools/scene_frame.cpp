// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/scene_frame.hpp"

#include "ictools/ic_settings.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plenum {

template <int Dim>
SceneFrame<Dim> sceneFrame(const CaseNode& root, const CaseSettings& settings) {
  static const std::string names[] = {"x", "y", "z"};
  SceneFrame<Dim> frame{settings.spacing, Box<Dim>::nothing(), settings.solverOrDefaults()};
  std::swap(frame.domain.lower, frame.domain.upper);
  if (!settings.domain) return frame;
  const CaseNode& domain = at(root, "domain");
  for (const std::string& name : settings.domain->periodicAxes) {
    const auto axis = static_cast<std::size_t>(std::find(names, names + 3, name) - names);
    if (axis >= Dim)
      at(domain, "periodic")
          .fail(fmt::format("a case of {} dimension{} has no axis \"{}\"", Dim, Dim == 1 ? "" : "s",
                            name));
    const int a = static_cast<int>(axis);
    frame.domain.periodic[axis] = true;
    frame.domain.lower[a] = settings.domain->lower[axis];
    frame.domain.upper[a] = settings.domain->upper[axis];
    const double length = frame.domain.upper[a] - frame.domain.lower[a];
    if (length < 2 * frame.support())
      domain.fail(
          fmt::format("periodic axis {} is {:g} m long, less than twice the kernel's support of "
                      "{:g} m; make it "
                      "longer, or spacing or solver.smoothing_length smaller",
                      name, length, frame.support()));
  }
  return frame;
}

template SceneFrame<1> sceneFrame<1>(const CaseNode&, const CaseSettings&);
template SceneFrame<2> sceneFrame<2>(const CaseNode&, const CaseSettings&);
template SceneFrame<3> sceneFrame<3>(const CaseNode&, const CaseSettings&);

}  // namespace plenum
