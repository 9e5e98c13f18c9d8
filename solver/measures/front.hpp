// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/measure_settings.hpp"
#include "solver/figure.hpp"
#include "solver/measures/observed.hpp"

namespace plenum {

/// How far the fluid has come along an axis: the coordinate of its outermost particle that has at
/// least 1, 3, 6 (in one, two, three dimensions) other particles of the same choice within
/// 2 d_ref, so that a lost droplet does not count and the tip of a thin tongue does.
template <int Dim>
class Front {
 public:
  /// Throws InputError that names `key` for an unknown material or a periodic axis.
  Front(const FrontSettings& settings, const Observed<Dim>& start, const std::string& key);

  /// front [m]; empty where no particle has so many neighbours.
  void addTo(std::vector<Figure>& row, const Observed<Dim>& state) const;

 private:
  int axis_;
  double sign_;
  FluidChoice choice_;
};

extern template class Front<1>;
extern template class Front<2>;
extern template class Front<3>;

}  // namespace plenum
