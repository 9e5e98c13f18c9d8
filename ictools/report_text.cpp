// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

std::string percent(double value) { return fmt::format("{:.3f} %", 100 * value); }

std::string printedMasses(const Report& report) {
  std::string text;
  for (const FluidMass& fluid : report.masses) {
    text += fmt::format("  {:<14} {} particles, {:.9g} kg", fluid.name, fluid.n, fluid.mass);
    if (fluid.expected > 0)
      text += fmt::format("; over density times exact volume, minus 1: {:+.2e}",
                          fluid.mass / fluid.expected - 1);
    text += '\n';
  }
  return text;
}

/// A line of blocks, the highest bin full.
std::string bars(const Histogram& histogram) {
  static const char* blocks[] = {" ", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  const double most = *std::max_element(histogram.share.begin(), histogram.share.end());
  std::string line;
  for (const double share : histogram.share) {
    // Whoever is there is seen.
    const int height = share > 0 ? std::max(1, static_cast<int>(std::lround(8 * share / most))) : 0;
    line += blocks[height];
  }
  return line;
}

std::string printedSpacing(const Report& report) {
  const SpacingFigures& nn = report.nearest;
  std::string text = fmt::format(
      "  nearest neighbour, in d_ref: least {:.3f}, mean {:.3f}, largest {:.3f}; nearer than .5: "
      "{:.2f} % of the fluid\n",
      nn.least, nn.mean, nn.largest, 100 * nn.below05);
  const Histogram& h = report.nearestHistogram;
  text += fmt::format("    {:g} |{}| {:g}\n", h.lower, bars(h),
                      h.lower + h.width * static_cast<double>(h.share.size()));
  text += fmt::format(
      "  overlaps (nearer than .5 d_ref to anybody): {}, isolated (nobody within "
      "1.5 d_ref): {}\n",
      report.nOverlaps, report.nIsolated);
  if (report.dimension == 2)
    text += fmt::format("  psi_6 {:.3f} (hexagonal 1)\n", report.bondOrder);
  if (report.dimension == 3)
    text += fmt::format("  q_6 {:.3f} (hcp .485, fcc .575, random about .29)\n", report.bondOrder);
  return text;
}

std::string printedPlaces(const Report& report) {
  std::string text =
      fmt::format("  {:<19}{:>9}  {:>9} {:>9} {:>9}  {:>8}  {:>8} {:>8}\n", "density, rho/rho_0",
                  "particles", "bias", "scatter", "worst", "sum V W", "|grad| d", "largest");
  for (std::size_t p = 0; p < nPlaces; ++p) {
    const PlaceFigures& f = report.places[p];
    if (f.n == 0) continue;
    text += fmt::format("    {:<17}{:>9}  {:>9} {:>9} {:>9}  {:>8.4f}  {:>8.4f} {:>8.4f}\n",
                        nameOf(Place(p)), f.n, percent(f.bias), percent(f.scatter),
                        percent(f.worst), f.kernelSum, f.kernelGradient, f.largestGradient);
  }
  if (report.profile.n > 0)
    text += fmt::format(
        "  profile: L2 error {} against the profile smoothed with the kernel, {} "
        "against the sharp one ({} particles inside)\n",
        percent(report.profile.smoothed), percent(report.profile.sharp), report.profile.n);
  return text;
}

std::string printedWalls(const Report& report) {
  std::string text;
  for (const WallLayers& wall : report.walls) {
    const bool enough = wall.thickness >= wall.support * (1 - 1e-9);
    text += fmt::format("  wall {:<14} {:.4g} m thick, the kernel's support is {:.4g} m: {}\n",
                        wall.name, wall.thickness, wall.support, enough ? "enough" : "NOT enough");
  }
  return text;
}

nlohmann::ordered_json jsonOf(const Histogram& h) {
  return {{"lower", h.lower}, {"width", h.width}, {"share", h.share}};
}

nlohmann::ordered_json jsonOf(const PlaceFigures& f) {
  return {{"particles", f.n},
          {"density_bias", f.bias},
          {"density_scatter", f.scatter},
          {"density_worst", f.worst},
          {"kernel_sum", f.kernelSum},
          {"kernel_gradient", f.kernelGradient},
          {"kernel_gradient_largest", f.largestGradient}};
}

std::string verdictName(PairingForecast::Verdict verdict) {
  switch (verdict) {
    case PairingForecast::Verdict::safe:
      return "safe";
    case PairingForecast::Verdict::pairs:
      return "pairs";
    case PairingForecast::Verdict::unpaired:
      return "unpaired";
    case PairingForecast::Verdict::unknown:
      return "unknown";
  }
  return "";
}

}  // namespace

std::string nameOf(Place place) {
  static const char* names[nPlaces] = {"at walls", "at free surfaces", "at other fluids", "inside"};
  return names[static_cast<std::size_t>(place)];
}

std::string printed(const Report& report) {
  std::string text = "report card";
  if (!report.title.empty()) text += ": " + report.title;
  text +=
      fmt::format("\n  {}-D, kernel {}, h {:g} m ({:g} d_ref), {} fluid and {} wall particles\n",
                  report.dimension, report.kernel, report.smoothingLength,
                  report.smoothingLength / report.spacing, report.nFluid, report.nWalls);
  return text + printedMasses(report) + printedSpacing(report) + printedPlaces(report) +
         printedWalls(report) + "  pairing: " + report.pairing.text + "\n";
}

std::string json(const Report& report) {
  nlohmann::ordered_json out;
  out["title"] = report.title;
  out["dimension"] = report.dimension;
  out["kernel"] = report.kernel;
  out["smoothing_length"] = report.smoothingLength;
  out["spacing"] = report.spacing;
  out["fluid_particles"] = report.nFluid;
  out["wall_particles"] = report.nWalls;
  for (const FluidMass& fluid : report.masses) {
    nlohmann::ordered_json entry{
        {"name", fluid.name}, {"particles", fluid.n}, {"mass", fluid.mass}};
    if (fluid.expected > 0) entry["density_times_volume"] = fluid.expected;
    out["fluids"].push_back(entry);
  }
  out["nearest"] = {{"least", report.nearest.least},
                    {"mean", report.nearest.mean},
                    {"largest", report.nearest.largest},
                    {"below_0.1", report.nearest.below01},
                    {"below_0.5", report.nearest.below05},
                    {"below_0.85", report.nearest.below085},
                    {"histogram", jsonOf(report.nearestHistogram)}};
  out["overlaps"] = report.nOverlaps;
  out["isolated"] = report.nIsolated;
  out[report.dimension == 3 ? "q6" : "psi6"] = report.bondOrder;
  for (std::size_t p = 0; p < nPlaces; ++p)
    if (report.places[p].n > 0) out["places"][nameOf(Place(p))] = jsonOf(report.places[p]);
  out["density_histogram_inside"] = jsonOf(report.densityHistogram);
  if (report.profile.n > 0)
    out["profile"] = {{"particles", report.profile.n},
                      {"l2_error_smoothed", report.profile.smoothed},
                      {"l2_error_sharp", report.profile.sharp}};
  for (const WallLayers& wall : report.walls)
    out["walls"].push_back(
        {{"name", wall.name}, {"thickness", wall.thickness}, {"support", wall.support}});
  const PairingForecast& f = report.pairing;
  out["pairing"] = {{"verdict", verdictName(f.verdict)},
                    {"neighbours", f.neighbours},
                    {"transform_is_negative", f.transform.isNegative},
                    {"first_negative_kh", f.transform.firstNegative},
                    {"lowest", f.transform.lowest},
                    {"text", f.text}};
  if (f.measuredShare) out["pairing"]["measured_share"] = *f.measuredShare;
  return out.dump(2) + "\n";
}

std::vector<std::pair<std::string, double>> figuresOf(const Report& report) {
  std::vector<std::pair<std::string, double>> figures{
      {"nearest neighbour: least / d_ref", report.nearest.least},
      {"nearest neighbour: mean / d_ref", report.nearest.mean},
      {"overlaps", static_cast<double>(report.nOverlaps)},
      {"isolated", static_cast<double>(report.nIsolated)}};
  if (report.profile.n > 0) {
    figures.emplace_back("profile: L2 error, smoothed", report.profile.smoothed);
    figures.emplace_back("profile: L2 error, sharp", report.profile.sharp);
  }
  for (std::size_t p = 0; p < nPlaces; ++p) {
    const PlaceFigures& f = report.places[p];
    if (f.n == 0) continue;
    const std::string where = nameOf(Place(p)) + ": ";
    figures.emplace_back(where + "density bias", f.bias);
    figures.emplace_back(where + "density scatter", f.scatter);
    figures.emplace_back(where + "density worst", f.worst);
    figures.emplace_back(where + "kernel gradient", f.kernelGradient);
  }
  return figures;
}

}  // namespace plenum
