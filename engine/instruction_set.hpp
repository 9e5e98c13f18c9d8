// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace plenum {

/// Instruction sets that the loops over pairs are compiled for. Each is a type, too: code made for
/// one bears its name, so that the linker cannot take it for another's.
namespace isa {
struct Baseline {  ///< what every processor of the platform has
  static constexpr std::string_view name = "baseline";
  static constexpr int bytes = 16;
};
struct Avx2 {  ///< x86-64-v3: 256-bit numbers, multiply-add
  static constexpr std::string_view name = "AVX2 + FMA";
  static constexpr int bytes = 32;
};
struct Avx512 {  ///< x86-64-v4: 512-bit numbers
  static constexpr std::string_view name = "AVX-512";
  static constexpr int bytes = 64;
};
}  // namespace isa

enum class InstructionSet { baseline, avx2, avx512 };

/// The best that this processor has and this program was built with; PLENUM_INSTRUCTION_SET
/// (baseline, avx2 or avx512) asks for a lesser one. Throws InputError if that is not available.
InstructionSet instructionSet();

std::string_view nameOf(InstructionSet set);
bool isAvailable(InstructionSet set);

/// Calls `visit` with the type of an instruction set.
template <class Visit>
decltype(auto) withInstructionSet(InstructionSet set, Visit&& visit) {
#if defined(PLENUM_HAS_X86_LOOPS)
  if (set == InstructionSet::avx512) return visit(isa::Avx512{});
  if (set == InstructionSet::avx2) return visit(isa::Avx2{});
#endif
  (void)set;
  return visit(isa::Baseline{});
}

}  // namespace plenum
