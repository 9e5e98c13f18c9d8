// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/picture_values.hpp"

#include "particles/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

template <int Dim>
FieldId fieldToDraw(const ParticleSet<Dim>& particles, const std::string& name) {
  const auto id = fieldNamed(name);
  if (id && *id != FieldId::position && particles.has(*id)) return *id;
  std::string carried = "type";
  std::vector<std::string> names{"type"};
  particles.forEachField([&](const FieldInfo& info, const auto&) {
    if (info.id == FieldId::position) return;
    carried += ", " + std::string(info.name);
    names.emplace_back(info.name);
  });
  const std::string near = id ? "" : nearest(name, names);
  throw InputError(fmt::format("field '{}': {}; these particles carry: {}{}", name,
                               id ? "cannot colour a picture here" : "no such field", carried,
                               near.empty() ? "" : "; did you mean '" + near + "'?"));
}

double magnitude(double value, bool) { return value; }
double magnitude(std::int32_t value, bool) { return value; }
double magnitude(std::uint64_t value, bool) { return static_cast<double>(value); }
template <int Dim>
double magnitude(const Vec<Dim>& value, bool signedVectors) {
  return Dim == 1 && signedVectors ? value[0] : norm(value);
}

}  // namespace

template <int Dim>
PictureValues pictureValues(const ParticleSet<Dim>& particles, const std::string& field,
                            bool signedVectors) {
  PictureValues result;
  if (field == "type") {
    result = {"type", "", true, std::vector<double>(particles.nFluid(), 0.0), {}};
    return result;
  }
  const FieldId chosen = fieldToDraw(particles, field);
  particles.forEachField([&](const FieldInfo& info, auto values) {
    if (info.id != chosen) return;
    const bool isVector = info.rank == Rank::vector;
    const std::string name = [&] {
      std::string text(info.name);
      std::replace(text.begin(), text.end(), '_', ' ');
      return text;
    }();
    result.name = isVector && !(Dim == 1 && signedVectors) ? "|" + name + "|" : name;
    result.unit = unitIn(info.unit, Dim);
    result.isCategory = info.rank == Rank::label;
    const std::size_t nFluid = info.scope == Scope::walls ? 0 : particles.nFluid();
    for (std::size_t k = 0; k < values.size(); ++k)
      (k < nFluid ? result.fluid : result.walls).push_back(magnitude(values[k], signedVectors));
    // Beside coloured fluids, walls are grey so that the eye can tell them apart.
    if (!result.fluid.empty() && !signedVectors) result.walls.clear();
  });
  return result;
}

Colour ColourScale::operator()(double value) const {
  if (isCategory) return categoryColour(static_cast<int>(value));
  return sequentialColour(upper > lower ? (value - lower) / (upper - lower) : 0.5);
}

ColourScale scaleFor(const PictureValues& values) {
  ColourScale scale;
  scale.isCategory = values.isCategory;
  std::vector<double> finite;
  for (const auto* part : {&values.fluid, &values.walls})
    for (double value : *part)
      if (std::isfinite(value)) finite.push_back(value);
  if (finite.empty()) return scale;
  const auto quantile = [&](double share) {
    const auto at = finite.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(finite.size() - 1));
    std::nth_element(finite.begin(), at, finite.end());
    return *at;
  };
  const double least = quantile(0), most = quantile(1);
  const double low = quantile(0.001), high = quantile(0.999);
  const bool hasOutliers = most - least > 2 * (high - low) && high > low;
  scale.lower = hasOutliers ? low : least;
  scale.upper = hasOutliers ? high : most;
  scale.cutBelow = scale.lower > least;
  scale.cutAbove = scale.upper < most;
  // A field that is the same everywhere but for round-off must not look like one with structure.
  const double size = std::max(std::fabs(scale.lower), std::fabs(scale.upper));
  if (scale.upper - scale.lower < 1e-12 * size) scale.upper = scale.lower;
  return scale;
}

template PictureValues pictureValues(const ParticleSet<1>&, const std::string&, bool);
template PictureValues pictureValues(const ParticleSet<2>&, const std::string&, bool);
template PictureValues pictureValues(const ParticleSet<3>&, const std::string&, bool);

}  // namespace plenum
