// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/instruction_set.hpp"

#include "particles/errors.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace plenum {

bool isAvailable(InstructionSet set) {
#if defined(PLENUM_HAS_X86_LOOPS)
  if (set == InstructionSet::avx512) return __builtin_cpu_supports("x86-64-v4");
  if (set == InstructionSet::avx2) return __builtin_cpu_supports("x86-64-v3");
#endif
  return set == InstructionSet::baseline;
}

std::string_view nameOf(InstructionSet set) {
  return withInstructionSet(set, [](auto isa) { return decltype(isa)::name; });
}

namespace {
InstructionSet chosen() {
  constexpr InstructionSet sets[] = {InstructionSet::avx512, InstructionSet::avx2,
                                     InstructionSet::baseline};
  constexpr std::string_view words[] = {"avx512", "avx2", "baseline"};
  const char* asked = std::getenv("PLENUM_INSTRUCTION_SET");
  for (int k = 0; k < 3; ++k) {
    if (asked == nullptr || *asked == '\0') {
      if (isAvailable(sets[k])) return sets[k];
    } else if (asked == words[k]) {
      if (isAvailable(sets[k])) return sets[k];
      throw InputError(
          fmt::format("PLENUM_INSTRUCTION_SET={}: this processor or this build has no such "
                      "instructions; leave it unset to get the best that there is",
                      asked));
    }
  }
  throw InputError(fmt::format(
      "PLENUM_INSTRUCTION_SET={}: expected baseline, avx2 or avx512, or nothing", asked));
}
}  // namespace

InstructionSet instructionSet() {
  static const InstructionSet set = chosen();
  return set;
}

}  // namespace plenum
