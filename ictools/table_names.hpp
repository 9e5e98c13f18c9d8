// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/ic_settings.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plenum {

/// Gives nameless tables a name and refuses a name that is taken.
template <class Settings>
void nameAll(std::vector<Settings>& all, const std::string& kind) {
  const auto taken = [&](const std::string& name) {
    return std::count_if(all.begin(), all.end(), [&](const auto& s) { return s.name == name; });
  };
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k].name.empty()) {
      std::string name = all[k].region;
      if constexpr (requires { all[k].outside; }) name += all[k].outside;
      if (name.empty()) name = kind;
      all[k].name = taken(name) == 0 ? name : fmt::format("{} {}", name, k + 1);
    }
  for (const Settings& settings : all)
    if (taken(settings.name) > 1)
      at(settings.node, "name").fail("another " + kind + " has that name; names must differ");
}

}  // namespace plenum
