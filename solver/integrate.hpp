// SPDX-License-Identifier: GPL-3.0-or-later
//
// How particles change by what the last pass summed. Bits do not depend on the number of threads.
#pragma once

#include "engine/engine.hpp"

#include <optional>

namespace plenum {

/// How a change of all values went. If some result is not sound, none is kept (to rounding).
struct Advanced {
  double largestChange = 0;
  std::optional<std::size_t> bad;  ///< the first particle whose new value is not sound
};

/// rho <- rho (1 - dt div v), of fluids or of walls, too; rho <- the sum of the last pass.
template <int Dim>
Advanced advanceDensities(Engine<Dim>& engine, ParticleSet<Dim>& particles, double dt,
                          bool wallsToo);
template <int Dim>
void takeSummedDensities(Engine<Dim>& engine, ParticleSet<Dim>& particles, bool wallsToo);

/// v <- v + dt (force/m + g), by the forces that were summed.
template <int Dim>
Advanced kick(Engine<Dim>& engine, ParticleSet<Dim>& particles, const Vec<Dim>& gravity, double dt);

/// field::acceleration <- force/m + g; v <- v + dt of it.
template <int Dim>
Advanced storeAccelerations(Engine<Dim>& engine, ParticleSet<Dim>& particles,
                            const Vec<Dim>& gravity);
template <int Dim>
void kickByAccelerations(Engine<Dim>& engine, ParticleSet<Dim>& particles, double dt);

/// e <- e + dt de/dt, by field::internalEnergyRate. A sound energy is positive.
template <int Dim>
Advanced heat(Engine<Dim>& engine, ParticleSet<Dim>& particles, double dt);

/// v <- v + impulse/m.
template <int Dim>
Advanced takeImpulses(Engine<Dim>& engine, ParticleSet<Dim>& particles);

/// x <- x + dt v of the fluids, `fastest` of which is the fastest [m/s]; periodic axes are wrapped.
template <int Dim>
void drift(Engine<Dim>& engine, const Box<Dim>& domain, ParticleSet<Dim>& particles, double dt,
           double fastest);
template <int Dim>
void wrapPositions(const Box<Dim>& domain, ParticleSet<Dim>& particles);

/// The largest |v| or |a| of the fluids.
template <int Dim>
double largestNorm(std::span<const Vec<Dim>> vectors);

}  // namespace plenum
