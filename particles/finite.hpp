// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

namespace plenum {

struct NotFinite {
  std::string field;     ///< "velocity"
  std::string particle;  ///< "fluid particle 12 (id 40)"
  std::size_t index = 0;
};

/// The first value of one of `fields` that is not a finite number, if there is one.
template <int Dim>
std::optional<NotFinite> firstNotFinite(const ParticleSet<Dim>& particles, FieldSet fields) {
  std::optional<NotFinite> found;
  particles.forEachField([&](const FieldInfo& info, auto values) {
    using Value = std::remove_const_t<typename decltype(values)::value_type>;
    if constexpr (!std::is_integral_v<Value>) {
      if (found || !fields.has(info.id)) return;
      for (std::size_t k = 0; k < values.size(); ++k) {
        double sum = 0;  // of x - x: zero, or NaN for infinities and NaN
        if constexpr (std::is_arithmetic_v<Value>)
          sum = values[k] - values[k];
        else
          for (double x : values[k].components) sum += x - x;
        if (sum == 0) continue;
        const std::size_t i = info.scope == Scope::walls ? particles.nFluid() + k : k;
        std::string name =
            fmt::format("{} particle {}", i < particles.nFluid() ? "fluid" : "wall", i);
        if (particles.has(FieldId::id)) name += fmt::format(" (id {})", particles[field::id][i]);
        found = NotFinite{std::string(info.name), name, i};
        return;
      }
    }
  });
  return found;
}

}  // namespace plenum
