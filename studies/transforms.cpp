// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/transforms.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace plenum::study {

std::vector<KernelTransforms> transformsOf(const std::vector<std::string>& kernels) {
  std::vector<KernelTransforms> all;
  for (const std::string& name : kernels.empty() ? KernelId::names() : kernels) {
    const KernelId kernel = KernelId::named(name);
    all.push_back(
        {name, {transformSign(kernel, 1), transformSign(kernel, 2), transformSign(kernel, 3)}});
  }
  return all;
}

double firstNegativeWavelength(const TransformSign& sign, double h) {
  return sign.isNegative ? 2 * kernel::pi * h / sign.firstNegative
                         : std::numeric_limits<double>::quiet_NaN();
}

std::string tableOf(const std::vector<KernelTransforms>& transforms) {
  std::string text =
      fmt::format("{:<20}{:>20}{:>20}{:>20}\n", "first negative k h", "1-D", "2-D", "3-D");
  for (const KernelTransforms& kernel : transforms) {
    text += fmt::format("{:<20}", kernel.kernel);
    for (const TransformSign& sign : kernel.sign)
      text += fmt::format("{:>20}", sign.isNegative ? fmt::format("{:.2f} ({:.1e})",
                                                                  sign.firstNegative, sign.lowest)
                                                    : "never");
    text += "\n";
  }
  return text;
}

std::string csvOf(const std::vector<KernelTransforms>& transforms,
                  const std::vector<double>& smoothingLengths) {
  std::string text = "kernel,dimension,first negative k h,lowest over its value at 0";
  for (const double h : smoothingLengths)
    text += fmt::format(",wavelength at h = {:g} d_ref [d_ref]", h);
  text += "\n";
  for (const KernelTransforms& kernel : transforms)
    for (int d = 1; d <= 3; ++d) {
      const TransformSign& sign = kernel.sign[static_cast<std::size_t>(d - 1)];
      text += fmt::format("{},{},{},{:.4g}", kernel.kernel, d,
                          sign.isNegative ? fmt::format("{:.4f}", sign.firstNegative) : "",
                          sign.lowest);
      for (const double h : smoothingLengths)
        text += sign.isNegative ? fmt::format(",{:.4f}", firstNegativeWavelength(sign, h)) : ",";
      text += "\n";
    }
  return text;
}

Chart transformChart(const std::vector<KernelTransforms>& transforms, int dimension) {
  Chart chart{
      fmt::format("Fourier transforms of kernels in {} dimensions (dashed: negative)", dimension),
      {"k h", false, 0, 20},
      {"|W^(k)|", true, 1e-7, 1},
      {}};
  constexpr double step = 0.05;
  for (const KernelTransforms& kernel : transforms) {
    const KernelId id = KernelId::named(kernel.kernel);
    Series positive{kernel.kernel, SeriesStyle::line, {}, false};
    Series negative{"", SeriesStyle::dashed, {}, false};
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    for (double k = 0; k <= 20; k += step) {
      const double value = kernelTransform(id, dimension, k);
      positive.points.push_back({k, value > 0 ? value : nothing, ""});
      negative.points.push_back({k, value < 0 ? -value : nothing, ""});
    }
    chart.series.push_back(std::move(positive));
    chart.series.push_back(std::move(negative));
  }
  return chart;
}

}  // namespace plenum::study
