// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/preflight_streams.hpp"

#include "particles/errors.hpp"
#include "solver/preflight_plane.hpp"
#include "solver/stream_planes.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace plenum {

namespace {

void checkNumerics(const SolverSettings& s) {
  const std::string key = s.inflows.empty() ? "outflow" : "inflow";
  const auto refuse = [&](const std::string& why, const std::string& remedy) {
    throw InputError(fmt::format("solver.{} {}; {}", key, why, remedy));
  };
  if (s.equationOfState == "tait")
    refuse("is for gases, and equation_of_state = \"tait\" is a liquid's",
           "set equation_of_state to \"isothermal\" or \"ideal_gas\"");
  if (!s.kicksTwice())
    refuse("is known to integrator = \"kick_drift_kick\" only",
           "set solver.integrator = \"kick_drift_kick\"");
  if (!s.sumsDensity())
    refuse(
        "needs densities that particles bring along, and density = \"continuity\" integrates "
        "them where neighbours may be missing",
        "set density = \"summation\"");
  const std::pair<bool, const char*> liquids[] = {{s.collisions.has_value(), "collisions"},
                                                  {s.shifting.has_value(), "shifting"}};
  for (const auto& [isAsked, name] : liquids)
    if (isAsked)
      refuse(fmt::format("does not go with {}, which would push what is held", name),
             fmt::format("leave solver.{} out", name));
}

template <int Dim>
std::string nameOf(const StreamPlane<Dim>& plane) {
  return fmt::format("[[solver.{}]] at {} = {:g}", plane.isInflow ? "inflow" : "outflow",
                     "xyz"[plane.axis], plane.at);
}

/// Planes lie at the ends of one axis that is not periodic.
template <int Dim>
void checkArrangement(const SceneInfo<Dim>& info, const StreamPlanes<Dim>& planes) {
  const StreamPlane<Dim>* first = nullptr;
  for (const StreamPlane<Dim>& plane : planes) {
    const auto refuse = [&](const std::string& why) {
      throw InputError(fmt::format("{}: {} {}", info.caseName, nameOf(plane), why));
    };
    if (info.domain.isPeriodic(plane.axis))
      refuse(fmt::format("lies across the periodic axis {0}; take \"{0}\" out of domain.periodic",
                         "xyz"[plane.axis]));
    if (first == nullptr) {
      first = &plane;
      continue;
    }
    if (plane.axis != first->axis || plane.outward == first->outward)
      refuse(
          fmt::format("and {}: there may be one at the lower and one at the upper end of the same "
                      "axis; leave one out",
                      nameOf(*first)));
    if (!(first->depth(Vec<Dim>::filled(plane.at)) < 0))
      refuse(
          fmt::format("and {}: the plane with side = \"lower\" must lie below the one with side = "
                      "\"upper\"; swap the sides",
                      nameOf(*first)));
  }
}

}  // namespace

template <int Dim>
void checkStreams(const SceneInfo<Dim>& info, const ParticleSet<Dim>& particles,
                  const SolverSettings& settings) {
  if (!settings.hasStreams()) return;
  checkNumerics(settings);
  const StreamPlanes<Dim> planes(settings);
  checkArrangement(info, planes);
  if (!info.progress.empty()) return;
  for (const StreamPlane<Dim>& plane : planes) checkPlane(info, particles, settings, plane);
}

template void checkStreams<1>(const SceneInfo<1>&, const ParticleSet<1>&, const SolverSettings&);
template void checkStreams<2>(const SceneInfo<2>&, const ParticleSet<2>&, const SolverSettings&);
template void checkStreams<3>(const SceneInfo<3>&, const ParticleSet<3>&, const SolverSettings&);

}  // namespace plenum
