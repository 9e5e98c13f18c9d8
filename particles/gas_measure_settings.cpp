// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/gas_measure_settings.hpp"

#include <fmt/format.h>

namespace plenum {

namespace {

constexpr const char* centerMeaning = "where the flow is centred; absent: zero";

Section<RiemannSideSettings> riemannSideSection(const std::string& where) {
  using S = RiemannSideSettings;
  return Section<S>("the gas " + where + " of the jump at t = 0")
      .number("density", &S::density, "kg/m^d", Range::positive(), "rho")
      .required()
      .number("velocity", &S::velocity, "m/s", Range::any(), "along the axis")
      .number("pressure", &S::pressure, "Pa m^(3-d)", Range::positive(),
              "p; an isothermal gas has c^2 rho and none is given");
}

}  // namespace

Section<RiemannSettings> riemannSection() {
  using S = RiemannSettings;
  return Section<S>("distance from the solution of a Riemann problem: shock tubes, streams")
      .text("axis", &S::axis, "along which axis the gas is uniform in two parts", {"x", "y", "z"})
      .number("position", &S::position, "m", Range::any(), "where the jump is at t = 0")
      .section("left", &S::left, riemannSideSection("left"))
      .required()
      .section("right", &S::right, riemannSideSection("right"))
      .required()
      .numbers("window", &S::window, 2, "m",
               "lower and upper end of what counts along the axis; absent: all fluid particles")
      .number("margin", &S::margin, "h", Range::notNegative(),
              "velocity_noise leaves out particles that are nearer to the end of the plateau, in "
              "their own smoothing lengths")
      .condition([](const S& tube, const CaseNode& table, int dimension) {
        if (tube.axis[0] - 'x' >= dimension)
          table.find("axis")->fail(fmt::format("a {}-D case has no such axis", dimension));
        if (!tube.window.empty() && !(tube.window[1] > tube.window[0]))
          table.find("window")->fail("the upper end must be above the lower one");
      });
}

Section<NohSettings> nohSection() {
  using S = NohSettings;
  return Section<S>("distance from Noh's implosion: cold gas that runs into itself")
      .vector("center", &S::center, "m", centerMeaning)
      .number("speed", &S::speed, "m/s", Range::positive(), "inwards, everywhere at t = 0")
      .number("density", &S::density, "kg/m^d", Range::positive(), "everywhere at t = 0")
      .number(
          "radius", &S::radius, "m", Range::positive(),
          "of the gas at t = 0: what its edge may have reached does not count; absent: all does")
      .number("within", &S::within, "m", Range::positive(),
              "radius in which particles count; absent: twice that of the shock");
}

Section<SedovSettings> sedovSection() {
  using S = SedovSettings;
  return Section<S>("distance from Sedov's point explosion in a cold gas of uniform density")
      .vector("center", &S::center, "m", centerMeaning)
      .number("energy", &S::energy, "J m^(d-3)", Range::positive(),
              "of the whole explosion: in 1-D of both sides")
      .required()
      .number("density", &S::density, "kg/m^d", Range::positive(), "of the gas around")
      .required();
}

Section<GreshoSettings> greshoSection() {
  using S = GreshoSettings;
  return Section<S>("distance from the vortex of Gresho and Chan, 2-D, or about the z axis in 3-D")
      .vector("center", &S::center, "m", "axis of the vortex at t = 0; absent: zero")
      .number("radius", &S::radius, "m", Range::positive(),
              "at which the speed is largest; beyond twice that the gas is at rest")
      .number("speed", &S::speed, "m/s", Range::positive(), "the largest")
      .vector("drift", &S::drift, "m/s", "velocity of all the gas beside; absent: none")
      .condition([](const S&, const CaseNode& table, int dimension) {
        if (dimension == 1) table.fail("a case of one dimension has no vortices");
      });
}

Section<CloudSettings> cloudSection() {
  using S = CloudSettings;
  return Section<S>("how much of a dense cloud in a wind is left")
      .number("density", &S::density, "kg/m^d", Range::positive(), "of the cloud at t = 0")
      .required()
      .number("radius", &S::radius, "m", Range::positive(), "of the cloud at t = 0")
      .required()
      .number("wind_density", &S::windDensity, "kg/m^d", Range::positive(), "of the wind at t = 0")
      .required()
      .number("wind_internal_energy", &S::windInternalEnergy, "J/kg", Range::positive(),
              "of the wind at t = 0")
      .required()
      .number("wind_speed", &S::windSpeed, "m/s", Range::positive(),
              "of the wind relative to the cloud at t = 0")
      .required()
      .condition([](const S& cloud, const CaseNode& table, int) {
        if (!(cloud.density > cloud.windDensity))
          table.find("density")->fail("must be above wind_density");
      });
}

}  // namespace plenum
