// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/engine.hpp"
#include "particles/case_settings.hpp"
#include "particles/field.hpp"

#include <memory>
#include <string>

namespace plenum {

/// A pass whose kernel and terms were chosen at run time.
template <int Dim>
class PairPass {
 public:
  virtual ~PairPass() = default;

  /// Overwrites the fields in `writes()` for the pass's receivers.
  virtual void run(const Engine<Dim>& engine, ParticleSet<Dim>& particles) const = 0;
  virtual FieldSet reads() const = 0;
  virtual FieldSet writes() const = 0;
};

/// The passes of a step, as the case asks for them; null where the scene does not model it.
template <int Dim>
struct StepPasses {
  std::unique_ptr<PairPass<Dim>> density;     ///< writes density or its rate
  std::unique_ptr<PairPass<Dim>> forces;      ///< writes acceleration
  std::unique_ptr<PairPass<Dim>> collisions;  ///< writes velocityChange
};

/// The only place where run-time choices become template arguments (pass_selection.cpp).
/// `spacing` is d_ref [m]. Kernels in the scenes' list get a loop of their own; the others share
/// one loop that chooses the kernel at run time.
template <int Dim>
StepPasses<Dim> selectPasses(const SolverSettings& settings, double spacing, bool hasWalls);

/// Momentum form with "matching" resolved.
std::string momentumForm(const SolverSettings& settings);

}  // namespace plenum
