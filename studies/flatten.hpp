// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "studies/leave_outs.hpp"

#include <optional>

namespace plenum::study {

/// A 3-D case that says `uniform = "y"` in two dimensions: every vector loses that component, and
/// lattices become those of the plane. None for other cases. Whether the scene's shapes exist in
/// 2-D is for plenum-ic to say.
std::optional<LeaveOut> flattened(const CaseNode& root);

}  // namespace plenum::study
