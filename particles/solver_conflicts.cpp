// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/solver_conflicts.hpp"

#include "particles/kernels.hpp"
#include "particles/number.hpp"
#include "particles/self_term.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <vector>

namespace plenum {

namespace {

/// What has smoothing lengths or energies of its own, for messages.
std::string reasonOf(const SolverSettings& s) {
  if (s.isIdealGas()) return "equation_of_state = \"ideal_gas\"";
  if (s.adaptive) return "adaptive";
  if (s.usesBalsara()) return "viscosity.monaghan.balsara";
  return s.bulk() ? "viscosity.bulk" : "viscosity.neumann_richtmyer";
}

std::optional<Conflict> conflictOfViscosities(const SolverSettings& s) {
  const bool hasPairs = s.monaghan() != nullptr || s.tensor() != nullptr;
  const bool hasPressure = s.bulk() != nullptr || s.neumannRichtmyer() != nullptr;
  if ((s.monaghan() != nullptr && s.tensor() != nullptr) || (hasPairs && hasPressure))
    return Conflict{"viscosity", "",
                    "has several artificial viscosities, each of which is meant to be enough",
                    "keep monaghan, or tensor, or bulk and neumann_richtmyer"};
  return std::nullopt;
}

std::optional<Conflict> conflictOfSelfTerm(const SolverSettings& s, int dimension) {
  if (!s.selfTermCorrection) return std::nullopt;
  if (!hasSelfTermCorrection(s.kernel, dimension))
    return Conflict{"self_term_correction", "",
                    fmt::format("is not known for {} in {}-D", s.kernel, dimension),
                    "it is for wendland_c2, wendland_c4 and wendland_c6 in 3-D"};
  if (!s.lengthsFollow())
    return Conflict{"self_term_correction", "",
                    "depends on the number of neighbours, which adaptive keeps",
                    "set adaptive = {} beside it"};
  return std::nullopt;
}

std::optional<Conflict> conflictOfLiquids(const SolverSettings& s) {
  const std::string gas = reasonOf(s);
  if (!s.sumsDensity())
    return Conflict{"density", "\"continuity\"",
                    "does not go with " + gas + ": smoothing lengths follow summed densities",
                    "set density = \"summation\""};
  if (s.momentum == "density_product")
    return Conflict{"momentum", "\"density_product\"", "does not go with " + gas,
                    "leave momentum out, or set \"density_squared\""};
  if (s.wallsEvolve() || s.wallsExtrapolate())
    return Conflict{"wall_pressure", "\"" + s.wallPressure + "\"",
                    "is not known for particles with smoothing lengths of their own (" + gas + ")",
                    "set wall_pressure = \"initial\" or \"zero\""};
  const std::pair<bool, const char*> liquids[] = {{s.laminar() != nullptr, "viscosity.laminar"},
                                                  {s.collisions.has_value(), "collisions"},
                                                  {s.shifting.has_value(), "shifting"}};
  for (const auto& [isAsked, key] : liquids)
    if (isAsked)
      return Conflict{key, "", "is for liquids and does not go with " + gas,
                      "leave one of the two out"};
  return std::nullopt;
}

/// h rho^(1/d) = eta m^(1/d) has no solution where a particle's own part of the density, m W(0),
/// is more than all that the length allows: sigma f(0) > eta^d.
std::optional<Conflict> conflictOfLength(const SolverSettings& s, int dimension) {
  if (!s.hasForm("grad_h")) return std::nullopt;
  double own = 0;
  kernel::withProfile(KernelId::named(s.kernel), [&](auto profile) {
    own = profile.sigma[static_cast<std::size_t>(dimension - 1)] * profile.f(0.0);
  });
  const double least = std::pow(own, 1.0 / dimension);
  if (s.smoothingLength > least) return std::nullopt;
  return Conflict{
      "smoothing_length", fmt::format("{:g}", s.smoothingLength),
      fmt::format("is too small for {} and adaptive.form = \"grad_h\" in {}-D: a particle alone "
                  "has a higher density than belongs to such a length",
                  s.kernel, dimension),
      fmt::format("set it above {:.3g}; usual are 1.2 to 2", least)};
}

using Keys = std::vector<const char*>;

/// Keys of [solver] that an equation of state does not use.
Keys unusedBy(const std::string& equationOfState) {
  if (equationOfState == "ideal_gas")
    return {"sound_speed", "background_pressure", "tait_exponent", "cavitation_pressure"};
  if (equationOfState == "isothermal")
    return {"background_pressure", "tait_exponent", "cavitation_pressure", "adiabatic_index",
            "molecular_weight"};
  return {"adiabatic_index", "molecular_weight"};
}

}  // namespace

std::optional<Conflict> conflictOf(const SolverSettings& s, int dimension) {
  if (auto conflict = conflictOfViscosities(s)) return conflict;
  if (s.conductivity && !s.isIdealGas())
    return Conflict{"conductivity", "", "conducts internal energy, which only an ideal gas has",
                    "set equation_of_state = \"ideal_gas\", or leave conductivity out"};
  if (auto conflict = conflictOfSelfTerm(s, dimension)) return conflict;
  if (!s.hasOwnLengths()) return std::nullopt;
  if (auto conflict = conflictOfLiquids(s)) return conflict;
  return conflictOfLength(s, dimension);
}

void checkSolverTable(const SolverSettings& settings, const CaseNode& table, int dimension) {
  for (const char* key : unusedBy(settings.equationOfState))
    if (const CaseNode* node = table.find(key))
      node->fail(fmt::format("has no effect with equation_of_state = \"{}\"; leave it out",
                             settings.equationOfState));
  if (const CaseNode* adaptive = table.find("adaptive")) {
    const std::string& form = settings.adaptive->form;
    const Keys unused = form == "grad_h" ? Keys{"change_limit"}
                        : form == "mean_density"
                            ? Keys{"tolerance", "max_iterations"}
                            : Keys{"change_limit", "tolerance", "max_iterations"};
    for (const char* key : unused)
      if (const CaseNode* node = adaptive->find(key))
        node->fail(fmt::format("has no effect with form = \"{}\"; leave it out", form));
  }
  const std::optional<Conflict> conflict = conflictOf(settings, dimension);
  if (!conflict) return;
  const CaseNode* node = &table;
  for (std::string_view rest = conflict->key; !rest.empty();) {
    const std::size_t dot = rest.find('.');
    const CaseNode* next = node->find(std::string(rest.substr(0, dot)));
    if (next == nullptr) break;
    node = next;
    rest = dot == std::string_view::npos ? std::string_view() : rest.substr(dot + 1);
  }
  const std::string name = node == &table ? conflict->key + " " : "";
  node->fail(name + conflict->why + "; " + conflict->remedy);
}

}  // namespace plenum
