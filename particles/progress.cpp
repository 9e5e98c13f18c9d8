// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace plenum {

namespace {

constexpr double redrawEvery = 0.1;   // [s]
constexpr double silenceOfLogs = 10;  // [s]
constexpr double stepOfLogs = 0.1;    // of the work

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

std::string printedDuration(double seconds) {
  if (!std::isfinite(seconds)) return "unknown";
  if (seconds < 9.95) return fmt::format("{:.1f} s", std::max(seconds, 0.0));
  if (seconds >= 1e11) return "ages";
  const auto s = static_cast<long long>(std::llround(seconds));
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  if (s < 86400) return fmt::format("{} h {:02} min", s / 3600, s % 3600 / 60);
  return fmt::format("{} d {:02} h", s / 86400, s % 86400 / 3600);
}

Progress::Output Progress::standardError(bool quiet) {
  const Style style = quiet ? Style::quiet : ::isatty(2) != 0 ? Style::terminal : Style::log;
  return {style, &std::cerr, steadySeconds};
}

Progress::Progress(std::string label, double total, bool quiet)
    : Progress(std::move(label), total, standardError(quiet)) {}

Progress::Progress(std::string label, double total, Output output)
    : label_(std::move(label)),
      total_(total),
      output_(std::move(output)),
      start_(output_.now()),
      lastTime_(start_) {}

Progress::~Progress() {
  if (lineOpen_) *output_.stream << std::endl;
}

bool Progress::isDue(double now, double fraction) const {
  if (output_.style == Style::terminal) return now - lastTime_ >= redrawEvery;
  return now - lastTime_ >= silenceOfLogs ||
         std::floor(fraction / stepOfLogs + 1e-9) > std::floor(lastFraction_ / stepOfLogs + 1e-9);
}

void Progress::update(double done, const std::string& extra) {
  if (output_.style == Style::quiet || finished_) return;
  const double fraction = total_ > 0 ? std::clamp(done / total_, 0.0, 1.0) : 0;
  const double now = output_.now();
  if (!isDue(now, fraction)) return;
  const double elapsed = now - start_;
  std::string line = label_ + ":";
  if (std::isfinite(total_)) line += fmt::format(" {:.0f} %", std::floor(100 * fraction));
  // A first tenth of a second, or nothing done yet, says nothing about the rest.
  if (fraction > 0 && fraction < 1 && elapsed >= redrawEvery)
    line += ", " + printedDuration(elapsed * (1 - fraction) / fraction) + " left";
  if (!extra.empty()) line += (std::isfinite(total_) ? ", " : " ") + extra;
  print(line, false);
  lastTime_ = now;
  lastFraction_ = fraction;
}

void Progress::finish(const std::string& extra) {
  if (output_.style == Style::quiet || finished_) return;
  finished_ = true;
  std::string line = fmt::format("{}: done in {}", label_, printedDuration(output_.now() - start_));
  if (!extra.empty()) line += ", " + extra;
  print(line, true);
}

void Progress::print(const std::string& line, bool last) {
  std::ostream& out = *output_.stream;
  if (output_.style == Style::terminal) {
    out << '\r' << line << "\x1b[K";  // erases what a longer line left behind
    lineOpen_ = !last;
    if (last) out << '\n';
  } else {
    out << line << '\n';
  }
  out.flush();
}

}  // namespace plenum
