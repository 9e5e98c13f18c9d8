// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of [measures] that compares gases with solutions that are known. What each measure means
// is said in docs/measures.md.
#pragma once

#include "particles/section.hpp"

#include <optional>
#include <string>
#include <vector>

namespace plenum {

/// The gas on one side of a Riemann problem.
struct RiemannSideSettings {
  double density = 0;              ///< [kg/m^d]
  double velocity = 0;             ///< along the axis [m/s]
  std::optional<double> pressure;  ///< [Pa m^(3-d)]; absent: of an isothermal gas
};

struct RiemannSettings {
  std::string axis = "x";
  double position = 0;                       ///< of the jump at t = 0 [m]
  std::optional<RiemannSideSettings> left;   ///< towards smaller coordinates
  std::optional<RiemannSideSettings> right;  ///< towards larger coordinates
  std::vector<double> window;                ///< lower and upper end [m]; empty: everywhere
  double margin = 10;                        ///< of the velocity noise [h]
};

struct NohSettings {
  std::vector<double> center;    ///< [m]; empty: zero
  double speed = 1;              ///< inwards at t = 0 [m/s]
  double density = 1;            ///< at t = 0 [kg/m^d]
  std::optional<double> radius;  ///< of the gas at t = 0 [m]; absent: beyond reach
  std::optional<double> within;  ///< [m]; absent: twice the radius of the shock, or up to its edge
};

struct SedovSettings {
  std::vector<double> center;  ///< [m]; empty: zero
  double energy = 1;           ///< of the explosion [J m^(d-3)]
  double density = 1;          ///< of the gas around [kg/m^d]
};

struct GreshoSettings {
  std::vector<double> center;  ///< at t = 0 [m]; empty: zero
  double radius = 0.2;         ///< at which the speed is largest [m]
  double speed = 1;            ///< there [m/s]
  std::vector<double> drift;   ///< velocity of all the gas [m/s]; empty: none
};

struct CloudSettings {
  double density = 0;             ///< of the cloud at t = 0 [kg/m^d]
  double radius = 0;              ///< R of the cloud at t = 0 [m]
  double windDensity = 0;         ///< [kg/m^d]
  double windInternalEnergy = 0;  ///< [J/kg]
  double windSpeed = 0;           ///< relative to the cloud at t = 0 [m/s]
};

Section<RiemannSettings> riemannSection();
Section<NohSettings> nohSection();
Section<SedovSettings> sedovSection();
Section<GreshoSettings> greshoSection();
Section<CloudSettings> cloudSection();

}  // namespace plenum
