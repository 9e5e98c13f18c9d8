// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/report.hpp"

#include <span>

namespace plenum {

/// Compares densities by summation [kg/m^d] of the particles marked `inside` with the profiles of
/// their materials: at most 20,000 of them, evenly picked. Kernels must not reach beyond the fluid
/// there. `particles` have position, smoothing length and, for several fluids, material.
template <int Dim>
ProfileErrors profileErrors(KernelId kernel, const ParticleSet<Dim>& particles,
                            const Box<Dim>& domain, std::span<const double> density,
                            std::span<const std::uint8_t> inside,
                            const std::vector<DensityProfilePtr<Dim>>& profiles);

}  // namespace plenum
