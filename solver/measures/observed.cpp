// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/observed.hpp"

#include "particles/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace plenum {

template <int Dim>
Vertical verticalOf(const Vec<Dim>& gravity, const std::string& key) {
  Vertical vertical;
  int nAxes = 0;
  for (int a = 0; a < Dim; ++a)
    if (gravity[a] != 0) {
      vertical = {a, gravity[a] < 0 ? 1.0 : -1.0};
      ++nAxes;
    }
  if (nAxes != 1)
    throw InputError(
        fmt::format("{}: needs to know what is up: set solver.gravity along one axis; it is ({:g})",
                    key, fmt::join(gravity.components, ", ")));
  return vertical;
}

template <int Dim>
Box<Dim> reachOf(const Observed<Dim>& start) {
  Box<Dim> reach = Box<Dim>::nothing();
  for (const Vec<Dim>& x : start.particles[field::position]) reach.extend(x);
  if (!start.info.container.empty()) reach.extend(start.info.container.bounds());
  for (int a = 0; a < Dim; ++a)
    if (start.info.domain.isPeriodic(a)) {
      reach.lower[a] = start.info.domain.lower[a];
      reach.upper[a] = start.info.domain.upper[a];
    }
  return reach;
}

template <int Dim>
FluidChoice::FluidChoice(const std::string& name, const SceneInfo<Dim>& info,
                         const std::string& key) {
  if (name.empty()) return;
  std::vector<std::string> known;
  for (const Material& m : info.materials) known.push_back(m.name);
  const auto found = std::ranges::find(known, name);
  if (found == known.end()) {
    const std::string near = nearest(name, known);
    throw InputError(fmt::format("{} = \"{}\": no such fluid; this scene has {}{}", key, name,
                                 fmt::join(known, ", "),
                                 near.empty() ? "" : "; did you mean \"" + near + "\"?"));
  }
  if (known.size() > 1) material_ = static_cast<std::int32_t>(found - known.begin());
}

template Vertical verticalOf<1>(const Vec<1>&, const std::string&);
template Vertical verticalOf<2>(const Vec<2>&, const std::string&);
template Vertical verticalOf<3>(const Vec<3>&, const std::string&);
template Box<1> reachOf<1>(const Observed<1>&);
template Box<2> reachOf<2>(const Observed<2>&);
template Box<3> reachOf<3>(const Observed<3>&);
template FluidChoice::FluidChoice(const std::string&, const SceneInfo<1>&, const std::string&);
template FluidChoice::FluidChoice(const std::string&, const SceneInfo<2>&, const std::string&);
template FluidChoice::FluidChoice(const std::string&, const SceneInfo<3>&, const std::string&);

}  // namespace plenum
