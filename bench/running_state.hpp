// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/scenes.hpp"

#include <filesystem>

namespace plenum::bench {

/// The dam break of damBreakAtRest after it has run for sqrt(H/g): the column has lost some third
/// of its height and the front has gone as far as that. Read from `folder` if some earlier call
/// left it there; otherwise run now, with a line on stderr, and left there.
template <int Dim>
Setup<Dim> damBreakRunning(std::size_t n, const std::filesystem::path& folder);

}  // namespace plenum::bench
