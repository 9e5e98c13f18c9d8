// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/gas.hpp"

#include "particles/errors.hpp"

#include <fmt/format.h>

namespace plenum {

void requireGas(const SolverSettings& settings, const std::string& key) {
  if (settings.equationOfState == "tait")
    throw InputError(fmt::format(
        "{}: is a flow of gases, but solver.equation_of_state = \"tait\": choose \"isothermal\" or "
        "\"ideal_gas\", or leave this measure out",
        key));
}

void requireIdealGas(const SolverSettings& settings, const std::string& key) {
  if (!settings.isIdealGas())
    throw InputError(
        fmt::format("{}: is a flow of an ideal gas, but solver.equation_of_state = \"{}\": choose "
                    "\"ideal_gas\", or leave this measure out",
                    key, settings.equationOfState));
}

}  // namespace plenum
