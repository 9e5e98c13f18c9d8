// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/kernels.hpp"

#include "particles/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace plenum {

const std::vector<std::string>& KernelId::names() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names;
    kernel::forEachProfile([&](auto profile) { names.emplace_back(profile.name); });
    return names;
  }();
  return all;
}

KernelId KernelId::named(const std::string& name) {
  const auto& all = names();
  const auto found = std::find(all.begin(), all.end(), name);
  if (found == all.end())
    throw InputError(
        fmt::format("kernel \"{}\" is unknown; known: {}", name, fmt::join(all, ", ")));
  return KernelId(static_cast<int>(found - all.begin()));
}

double kernel::Any::sigma(int dim) const {
  double value = 0;
  withProfile(id, [&](auto profile) { value = profile.sigma[static_cast<std::size_t>(dim - 1)]; });
  return value;
}

}  // namespace plenum
