// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/density_profile.hpp"

#include "ictools/density_table.hpp"
#include "ictools/formula.hpp"
#include "particles/errors.hpp"
#include "particles/parallel.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

template <int Dim>
Vec<Dim> toVec(const std::vector<double>& numbers) {
  Vec<Dim> v;
  for (std::size_t a = 0; a < numbers.size(); ++a) v[static_cast<int>(a)] = numbers[a];
  return v;
}

/// A profile from a function of the place.
template <int Dim, class Function>
class FunctionProfile final : public DensityProfile<Dim> {
 public:
  explicit FunctionProfile(Function function) : function_(std::move(function)) {}
  void at(std::span<const Vec<Dim>> points, std::span<double> density) const override {
    std::transform(points.begin(), points.end(), density.begin(), function_);
  }

 private:
  Function function_;
};

template <int Dim, class Function>
DensityProfilePtr<Dim> profileFrom(Function function) {
  return std::make_shared<const FunctionProfile<Dim, Function>>(std::move(function));
}

template <int Dim>
class FormulaProfile final : public DensityProfile<Dim> {
 public:
  FormulaProfile(const std::string& text, const CaseNode& node) : formula_(text, node) {}
  void at(std::span<const Vec<Dim>> points, std::span<double> density) const override {
    formula_.at(points, density);
  }

 private:
  Formula<Dim> formula_;
};

template <int Dim>
DensityProfilePtr<Dim> linear(const LinearProfileKeys& keys, const CaseNode& node) {
  const Vec<Dim> from = toVec<Dim>(keys.from), way = toVec<Dim>(keys.to) - from;
  if (!(normSquared(way) > 0)) node.fail("`from` and `to` are the same place; move one of them");
  const double first = keys.density[0], second = keys.density[1];
  return profileFrom<Dim>([=](const Vec<Dim>& x) {
    return first + (second - first) * dot(x - from, way) / normSquared(way);
  });
}

template <int Dim>
DensityProfilePtr<Dim> image(const ImageProfileKeys& keys, const CaseNode& node,
                             const std::filesystem::path& folder) {
  if constexpr (Dim == 1) {
    node.fail("an image has two dimensions, the case has one; use a radial table or a formula");
  } else {
    GridTable<2> table = readImage(folder / keys.file);
    const double black = keys.density[0], white = keys.density[1];
    for (double& v : table.value) v = black + (white - black) * v;
    for (int a = 0; a < 2; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      const double length = keys.upper[axis] - keys.lower[axis];
      if (!(length > 0)) at(node, "upper").fail("must be greater than `lower`");
      // Pixels are areas: the first and last point stand half of one inside.
      table.step[a] = length / static_cast<double>(table.shape[axis]);
      table.lower[a] = keys.lower[axis] + 0.5 * table.step[a];
    }
    return profileFrom<Dim>([table](const Vec<Dim>& x) {
      Vec<2> y{{x[0], x[1]}};
      for (int a = 0; a < 2; ++a) {  // the outer halves of the pixels at the rim
        const double last = static_cast<double>(table.shape[static_cast<std::size_t>(a)] - 1);
        const double s = (y[a] - table.lower[a]) / table.step[a];
        if (s >= -0.5 - 1e-6 && s <= last + 0.5 + 1e-6)
          y[a] = table.lower[a] + table.step[a] * std::clamp(s, 0.0, last);
      }
      return table.at(y);
    });
  }
}

}  // namespace

template <int Dim>
DensityProfilePtr<Dim> makeProfile(const ProfileKeys& keys, const CaseNode& node,
                                   const std::filesystem::path& folder) {
  const int n = static_cast<int>(keys.linear.has_value()) + keys.powerLaw.has_value() +
                keys.radialTable.has_value() + keys.image.has_value() + !keys.formula.empty() +
                !keys.table.empty();
  if (n != 1)
    node.fail(
        fmt::format("needs exactly one of linear, power_law, radial_table, image, formula, "
                    "table; has {}",
                    n));
  if (keys.linear) return linear<Dim>(*keys.linear, *node.find("linear"));
  if (keys.powerLaw) {
    const PowerLawKeys& law = *keys.powerLaw;
    return profileFrom<Dim>([law, center = toVec<Dim>(law.center)](const Vec<Dim>& x) {
      const double q = normSquared(x - center) / (law.coreRadius * law.coreRadius);
      return law.density * std::pow(1 + q, law.exponent);
    });
  }
  if (keys.radialTable) {
    const RadialTable table = readRadialTable(folder / keys.radialTable->file);
    return profileFrom<Dim>([table, center = toVec<Dim>(keys.radialTable->center)](
                                const Vec<Dim>& x) { return table.at(norm(x - center)); });
  }
  if (keys.image) return image<Dim>(*keys.image, *node.find("image"), folder);
  if (!keys.formula.empty())
    return std::make_shared<const FormulaProfile<Dim>>(keys.formula, *node.find("formula"));
  return profileFrom<Dim>(
      [table = readGridTable<Dim>(folder / keys.table)](const Vec<Dim>& x) { return table.at(x); });
}

template <int Dim>
DensityProfilePtr<Dim> profileOf(const InitialState& state) {
  return profileFrom<Dim>([state](const Vec<Dim>& x) { return state(x).density; });
}

template <int Dim>
std::vector<double> densitiesAt(const DensityProfile<Dim>& profile,
                                std::span<const Vec<Dim>> points, const CaseNode& node) {
  std::vector<double> result(points.size());
  constexpr std::size_t batch = 4096;
  parallelFor((points.size() + batch - 1) / batch, [&](std::size_t b) {
    const std::size_t first = b * batch, count = std::min(batch, points.size() - first);
    profile.at(points.subspan(first, count), std::span(result).subspan(first, count));
  });
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!(result[k] > 0 && std::isfinite(result[k])))
      node.fail(fmt::format(
          "{} at ({:g}); a density must be positive everywhere in the region",
          std::isnan(result[k]) ? "gives no density" : fmt::format("gives {:g}", result[k]),
          fmt::join(points[k].components, ", ")));
  return result;
}

#define PLENUM_PROFILE(Dim)                                                                       \
  template DensityProfilePtr<Dim> makeProfile(const ProfileKeys&, const CaseNode&,                \
                                              const std::filesystem::path&);                      \
  template DensityProfilePtr<Dim> profileOf(const InitialState&);                                 \
  template std::vector<double> densitiesAt(const DensityProfile<Dim>&, std::span<const Vec<Dim>>, \
                                           const CaseNode&);
PLENUM_PROFILE(1)
PLENUM_PROFILE(2)
PLENUM_PROFILE(3)

}  // namespace plenum
