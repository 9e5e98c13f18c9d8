// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/measure_settings.hpp"
#include "solver/measures/box_volume.hpp"
#include "solver/measures/cloud.hpp"
#include "solver/measures/couette.hpp"
#include "solver/measures/front.hpp"
#include "solver/measures/gresho.hpp"
#include "solver/measures/noh.hpp"
#include "solver/measures/pressure_gradient.hpp"
#include "solver/measures/probe.hpp"
#include "solver/measures/sedov.hpp"
#include "solver/measures/shock_tube.hpp"
#include "solver/measures/taylor_green.hpp"
#include "solver/measures/wave_gauge.hpp"

namespace plenum {

/// The measures that a case names, each of which adds its figures to a row. What is not named
/// costs nothing. Figures are the same for any number of threads.
template <int Dim>
class Observers {
 public:
  /// Throws InputError, naming the key, for measures that this scene cannot have.
  Observers(const MeasureSettings& settings, const Observed<Dim>& start);

  void addTo(std::vector<Figure>& row, const Observed<Dim>& state) const;

 private:
  void addGasMeasures(const MeasureSettings& settings, const Observed<Dim>& start);
  void addGases(std::vector<Figure>& row, const Observed<Dim>& state) const;
  void addOrder(std::vector<Figure>& row, const Observed<Dim>& state) const;

  MeasureSettings settings_;
  std::vector<Probe<Dim>> probes_;
  std::vector<WaveGauge<Dim>> gauges_;
  std::optional<Front<Dim>> front_;
  std::vector<BoxVolume<Dim>> volumes_;
  std::optional<PressureGradient<Dim>> pressureGradient_;
  std::optional<TaylorGreen> taylorGreen_;  // in 2-D only
  std::optional<Couette> couette_;          // in 2-D only
  std::optional<ShockTube<Dim>> riemann_;
  std::optional<Noh<Dim>> noh_;
  std::optional<Sedov<Dim>> sedov_;
  std::optional<Gresho<Dim == 1 ? 2 : Dim>> gresho_;  // not in 1-D
  std::optional<Cloud<Dim>> cloud_;
};

extern template class Observers<1>;
extern template class Observers<2>;
extern template class Observers<3>;

}  // namespace plenum
