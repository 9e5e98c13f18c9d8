// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/arrangement.hpp"

#include <memory>
#include <string>

namespace plenum {

/// One way of moving particles until they stand evenly.
template <int Dim>
class RelaxationMethod {
 public:
  virtual ~RelaxationMethod() = default;
  /// Sets field::velocity, the next move [m] of every fluid particle; `state` is that of the places
  /// from which they move.
  virtual void plan(Arrangement<Dim>& arrangement, const RelaxationState& state) = 0;
};

/// By the name that a case gives it: packing, wvt or lloyd (relaxation.hpp). Throws
/// std::invalid_argument for any other.
template <int Dim>
std::unique_ptr<RelaxationMethod<Dim>> relaxationMethod(const std::string& name);

}  // namespace plenum
