// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <iosfwd>
#include <string>

namespace plenum {

/// Tells on stderr how far a piece of work is. On a terminal: one line, redrawn at most ten times a
/// second, with percentage and the time that remains. In a log: a plain line at every tenth of the
/// work, or after ten seconds of silence.
class Progress {
 public:
  enum class Style { terminal, log, quiet };

  /// What a test may replace.
  struct Output {
    Style style = Style::log;
    std::ostream* stream = nullptr;
    std::function<double()> now;  ///< seconds, from any start
  };

  /// `total` is the amount of work in any unit (steps, seconds of simulated time, particles);
  /// infinite if nobody knows.
  Progress(std::string label, double total, bool quiet = false);
  Progress(std::string label, double total, Output output);
  ~Progress();  ///< ends a line that stands open on the terminal
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of `total` is finished; `extra` is printed behind ("step 120, 3 collisions").
  void update(double done, const std::string& extra = "");

  /// The work is complete: one last line with the time that it took.
  void finish(const std::string& extra = "");

  /// stderr's style: a terminal or a log.
  static Output standardError(bool quiet);

 private:
  void print(const std::string& line, bool last);
  bool isDue(double now, double fraction) const;

  std::string label_;
  double total_;
  Output output_;
  double start_;
  double lastTime_;
  double lastFraction_ = 0;
  bool finished_ = false;
  bool lineOpen_ = false;
};

/// "42 s", "3 min 05 s", "2 h 10 min", "5 d 03 h".
std::string printedDuration(double seconds);

}  // namespace plenum
