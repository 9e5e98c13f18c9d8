// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/probe.hpp"

#include "particles/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

namespace plenum {

template <int Dim>
Probe<Dim>::Probe(const ProbeSettings& settings, const Observed<Dim>& start, const Box<Dim>& reach,
                  const std::string& key)
    : name_(settings.name), choice_(settings.material, start.info, key + ".material") {
  std::copy_n(settings.point.begin(), Dim, point_.components.begin());
  if (!reach.contains(point_))
    throw InputError(fmt::format(
        "{} \"{}\": point = ({:g}) m lies outside of the scene, which reaches from ({:g}) to "
        "({:g}) m; move it inside",
        key, name_, fmt::join(settings.point, ", "), fmt::join(reach.lower.components, ", "),
        fmt::join(reach.upper.components, ", ")));
}

template <int Dim>
void Probe<Dim>::addTo(std::vector<Figure>& row, const Interpolation<Dim>& fluid) const {
  // A corner of three walls that is full of fluid has an eighth; a droplet at the edge of the
  // kernel's support says nothing of this place.
  constexpr double leastFluid = 0.05;
  const auto sums = fluid.at(point_, choice_);
  const double scale =
      sums.fluid > leastFluid ? 1 / sums.fluid : std::numeric_limits<double>::quiet_NaN();
  row.push_back({name_ + "_pressure", pressureUnit(Dim), scale * sums.pressure});
  for (int a = 0; a < Dim; ++a)
    row.push_back({name_ + "_velocity_" + "xyz"[a], "m/s", scale * sums.velocity[a]});
}

template class Probe<1>;
template class Probe<2>;
template class Probe<3>;

}  // namespace plenum
