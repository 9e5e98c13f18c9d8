// SPDX-License-Identifier: GPL-3.0-or-later
//
// [measures] of the case file: what a run measures beside the figures that it always has. What
// each measure means is said in docs/measures.md.
#pragma once

#include "particles/gas_measure_settings.hpp"
#include "particles/section.hpp"

#include <optional>
#include <string>
#include <vector>

namespace plenum {

struct ProbeSettings {
  std::string name;
  std::vector<double> point;  ///< [m]
  std::string material = {};  ///< name of a fluid; "": all
};

struct GaugeSettings {
  std::string name;
  std::vector<double> point;  ///< horizontal place, one component less than the case [m]
  std::optional<double> dry;  ///< height while no fluid is there [m]; absent: an empty cell
  std::string material = {};  ///< name of a fluid; "": all
};

struct FrontSettings {
  std::string axis = "x";
  std::string direction = "+";
  std::string material;  ///< name of a fluid; "": all
};

struct VolumeSettings {
  std::string name;
  std::vector<double> lower;  ///< [m]
  std::vector<double> upper;  ///< [m]
  std::string material;       ///< name of a fluid; "": all
};

struct PressureGradientSettings {
  double middle = 0.8;            ///< fraction of the height
  std::optional<double> bottom;   ///< [m]; absent: half a spacing below the lowest particle
  std::optional<double> surface;  ///< [m]; absent: half a spacing above the highest particle
  std::string material;           ///< name of a fluid; "": the only one
};

struct TaylorGreenSettings {
  double speed = 1;            ///< U [m/s]
  double length = 1;           ///< edge of the periodic box [m]
  double viscosity = 0;        ///< kinematic, nu [m^2/s]
  std::vector<double> origin;  ///< corner of a cell of vortices [m]; empty: zero
};

struct CouetteSettings {
  std::vector<double> center;  ///< [m]; empty: zero
  double innerRadius = 0;      ///< [m]
  double outerRadius = 0;      ///< [m]
  double innerOmega = 0;       ///< [rad/s]
  double outerOmega = 0;       ///< [rad/s]
  int bins = 10;
};

struct MeasureSettings {
  bool freeSurface = false;
  bool order = true;
  bool loads = false;
  std::vector<ProbeSettings> probes;
  std::vector<GaugeSettings> gauges;
  std::optional<FrontSettings> front;
  std::vector<VolumeSettings> volumes;
  std::optional<PressureGradientSettings> pressureGradient;
  std::optional<TaylorGreenSettings> taylorGreen;
  std::optional<CouetteSettings> couette;
  std::optional<RiemannSettings> riemann;
  std::optional<NohSettings> noh;
  std::optional<SedovSettings> sedov;
  std::optional<GreshoSettings> gresho;
  std::optional<CloudSettings> cloud;
};

const Section<MeasureSettings>& measureSection();

}  // namespace plenum
