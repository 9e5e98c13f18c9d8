// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/scene_frame.hpp"

#include "ictools/ic_settings.hpp"
#include "ictools/lattice.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plenum {

namespace {

/// (m/rho)^(1/d) of the first fluid's lattice [m]. Random sets have the closest packing's.
template <int Dim>
double cellSizeOf(const CaseSettings& settings) {
  const std::string name = readFluids(settings).front().lattice;
  const Lattice<Dim> lattice(name == "random" ? latticeNames(Dim).front() : name, settings.spacing);
  return std::pow(lattice.cellVolume(), 1.0 / Dim);
}

}  // namespace

template <int Dim>
SceneFrame<Dim> sceneFrame(const CaseNode& root, const CaseSettings& settings) {
  static const std::string names[] = {"x", "y", "z"};
  SceneFrame<Dim> frame{settings.spacing, Box<Dim>::nothing(), settings.solverOrDefaults()};
  std::swap(frame.domain.lower, frame.domain.upper);
  if (frame.solver.lengthsFollow()) frame.cellSize = cellSizeOf<Dim>(settings);
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
