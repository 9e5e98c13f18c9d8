// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/picture_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plenum {

namespace {

/// CIE lightness 20 to 90 in even steps, hue from 305 over 225 to 95 degrees, chroma within what
/// the screen shows.
constexpr std::array<Colour, 13> anchors{{{49, 32, 117},
                                          {34, 54, 135},
                                          {3, 73, 150},
                                          {2, 90, 157},
                                          {3, 109, 155},
                                          {1, 127, 158},
                                          {27, 145, 156},
                                          {56, 163, 146},
                                          {89, 179, 133},
                                          {124, 195, 115},
                                          {163, 208, 96},
                                          {206, 219, 78},
                                          {254, 227, 63}}};

std::uint8_t between(std::uint8_t a, std::uint8_t b, double t) {
  return static_cast<std::uint8_t>(std::lround(a + t * (b - a)));
}

std::string superscript(int number) {
  static constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴",
                                                      "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(number))
    text += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
  return text;
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

}  // namespace

Colour sequentialColour(double t) {
  if (std::isnan(t)) return {255, 0, 255};
  const double s = std::clamp(t, 0.0, 1.0) * (anchors.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(s), anchors.size() - 2);
  const Colour &a = anchors[k], &b = anchors[k + 1];
  const double w = s - static_cast<double>(k);
  return {between(a.red, b.red, w), between(a.green, b.green, w), between(a.blue, b.blue, w)};
}

Colour categoryColour(int k) {
  static constexpr std::array<Colour, 8> colours{{{33, 102, 172},
                                                  {230, 145, 20},
                                                  {30, 150, 90},
                                                  {190, 40, 60},
                                                  {130, 80, 170},
                                                  {90, 190, 220},
                                                  {120, 85, 50},
                                                  {225, 120, 180}}};
  return colours[static_cast<std::size_t>((k % 8 + 8) % 8)];
}

Ticks niceTicks(double lower, double upper, int wanted) {
  Ticks ticks;
  const double largest = std::max(std::fabs(lower), std::fabs(upper));
  if (largest >= 1e5 || (largest > 0 && largest < 1e-2))
    ticks.exponent = 3 * static_cast<int>(std::floor(std::log10(largest) / 3));
  const double unit = std::pow(10.0, ticks.exponent);
  if (!(upper > lower)) {
    ticks.at = {lower};
    ticks.labels = {fmt::format("{:.6g}", lower / unit)};
    return ticks;
  }
  const double raw = (upper - lower) / std::max(wanted, 1);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double ratio = raw / power;
  const double step = power * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
  // The tolerances keep ticks that rounding has put just outside the ends.
  const int decimals =
      std::clamp(static_cast<int>(-std::floor(std::log10(step / unit) + 1e-9)), 0, 9);
  const double first = std::ceil(lower / step - 1e-9), last = std::floor(upper / step + 1e-9);
  for (double k = first; k <= last && ticks.at.size() < 100; ++k) {
    ticks.at.push_back(k * step);
    ticks.labels.push_back(fmt::format("{:.{}f}", k == 0 ? 0.0 : k * step / unit, decimals));
  }
  return ticks;
}

std::string axisTitle(const std::string& name, const std::string& unit, int exponent) {
  std::string inside = exponent == 0 ? "" : "10" + superscript(exponent);
  if (!unit.empty()) inside += (inside.empty() ? "" : " ") + unit;
  return inside.empty() ? name : name + " [" + inside + "]";
}

std::string unitIn(std::string_view unit, int dimension) {
  const auto metres = [](int exponent) {
    return exponent == 0   ? std::string()
           : exponent == 1 ? std::string("m")
                           : fmt::format("m{}", superscript(exponent));
  };
  std::string text(unit);
  if (dimension == 3) {
    replaceAll(text, "/m^(3-d)", "");
    replaceAll(text, " m^(3-d)", "");
  }
  replaceAll(text, "m^(3-d)", metres(3 - dimension));
  replaceAll(text, "m^d", metres(dimension));
  replaceAll(text, "^2", "²");
  return text;
}

}  // namespace plenum
