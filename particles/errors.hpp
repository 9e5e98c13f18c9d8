// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace plenum {

/// What the user gave cannot be used. The message names file, key, value, range and remedy. Exit
/// code 1.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The run itself failed (a state that is not finite, a full disk). Exit code 2.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum ExitCode : int { exitOk = 0, exitInputAtFault = 1, exitFailure = 2 };

/// Runs a program's body, prints one line for an error and returns the exit code.
template <class Body>
int runProgram(const char* program, Body&& body);

/// `candidate` of `known` nearest to `word` by edit distance, or "" if none is near.
template <class Strings>
std::string nearest(const std::string& word, const Strings& known);

/// Number of single-character edits that turn `a` into `b` (Levenshtein 1966).
int editDistance(const std::string& a, const std::string& b);

/// The one line that a program prints for an exception, and its exit code.
int reportError(const char* program);

/// Makes the file-size limit (ulimit -f) an error of the write that meets it, not a silent death.
void ignoreFileSizeSignal();

template <class Body>
int runProgram(const char* program, Body&& body) {
  ignoreFileSizeSignal();
  try {
    return body();
  } catch (...) {
    return reportError(program);
  }
}

template <class Strings>
std::string nearest(const std::string& word, const Strings& known) {
  std::string best;
  int bestDistance = static_cast<int>(word.size()) / 2 + 2;
  for (const auto& candidate : known) {
    const int distance = editDistance(word, std::string(candidate));
    if (distance < bestDistance) {
      bestDistance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace plenum
