// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/closed_form.hpp"

#include "particles/kernels.hpp"

#include <cmath>

namespace plenum::study {

std::optional<HydrostaticColumn> HydrostaticColumn::of(const CaseSettings& settings) {
  const MeasureSettings measures = settings.measuresOrDefaults();
  const SolverSettings solver = settings.solverOrDefaults();
  const auto& asked = measures.pressureGradient;
  if (settings.dimension != 2 || !asked || !asked->surface || !asked->bottom ||
      solver.gravity.size() != 2 || !settings.fluids || settings.fluids->asArray().size() != 1)
    return std::nullopt;
  const CaseNode* lattice = settings.fluids->asArray()[0].find("lattice");
  const std::string name =
      lattice != nullptr && lattice->isString() ? lattice->asString() : "hexagonal";
  if (name != "hexagonal" && name != "square") return std::nullopt;
  HydrostaticColumn column;
  column.isHexagonal_ = name == "hexagonal";
  const double height = *asked->surface - *asked->bottom;
  column.compression_ = -solver.gravity[1] * height / (2 * solver.soundSpeed * solver.soundSpeed);
  return column;
}

double HydrostaticColumn::error(const std::string& name, double h) const {
  const double row = isHexagonal_ ? std::sqrt(3.0) / 2 : 1;
  const int reach = static_cast<int>(std::ceil(2 * h / row)) + 1;
  const kernel::Any profile{KernelId::named(name)};
  double moment = 0;
  for (int j = -reach; j <= reach; ++j)
    for (int i = -reach; i <= reach; ++i) {
      const double x = i + (isHexagonal_ ? 0.5 * std::abs(j % 2) : 0), y = j * row;
      const double r = std::hypot(x, y);
      if (r > 0 && r < 2 * h)
        moment -= row * y * y * profile.sigma(2) * std::pow(h, -4) * profile.g(r / h);
    }
  return 100 * ((1 + compression_) / moment - 1);
}

}  // namespace plenum::study
