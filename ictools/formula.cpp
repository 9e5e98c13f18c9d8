// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/formula.hpp"

#include "particles/parallel.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plenum {

template <int Dim>
Formula<Dim>::Formula(std::string text, const CaseNode& node) : text_(std::move(text)) {
  try {
    const Vec<Dim> origin{};
    double value = 0;
    at(std::span(&origin, 1), std::span(&value, 1));
  } catch (const mu::Parser::exception_type& error) {
    node.fail(fmt::format("{}; names: {}, r, pi; functions: sin, cos, exp, log, sqrt, min, ...",
                          error.GetMsg(),
                          Dim == 1   ? "x"
                          : Dim == 2 ? "x, y"
                                     : "x, y, z"));
  }
}

template <int Dim>
void Formula<Dim>::at(std::span<const Vec<Dim>> points, std::span<double> values) const {
  // A parser for each call: they are not made for several threads.
  Vec<Dim> x;
  double r = 0;
  mu::Parser parser;
  for (int a = 0; a < Dim; ++a) parser.DefineVar(std::string(1, "xyz"[a]), &x[a]);
  parser.DefineVar("r", &r);
  parser.DefineConst("pi", std::numbers::pi);
  parser.SetExpr(text_);
  for (std::size_t k = 0; k < points.size(); ++k) {
    x = points[k];
    r = norm(x);
    values[k] = parser.Eval();
  }
}

template <int Dim>
std::vector<double> finiteValuesAt(const Formula<Dim>& formula, std::span<const Vec<Dim>> points,
                                   const CaseNode& node) {
  std::vector<double> values(points.size());
  constexpr std::size_t batch = 4096;
  parallelFor((points.size() + batch - 1) / batch, [&](std::size_t b) {
    const std::size_t first = b * batch, count = std::min(batch, points.size() - first);
    formula.at(points.subspan(first, count), std::span(values).subspan(first, count));
  });
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!std::isfinite(values[k]))
      node.fail(fmt::format("gives {} at ({:g}); it must be finite everywhere in the region",
                            values[k], fmt::join(points[k].components, ", ")));
  return values;
}

template class Formula<1>;
template class Formula<2>;
template class Formula<3>;
template std::vector<double> finiteValuesAt(const Formula<1>&, std::span<const Vec<1>>,
                                            const CaseNode&);
template std::vector<double> finiteValuesAt(const Formula<2>&, std::span<const Vec<2>>,
                                            const CaseNode&);
template std::vector<double> finiteValuesAt(const Formula<3>&, std::span<const Vec<3>>,
                                            const CaseNode&);

}  // namespace plenum
