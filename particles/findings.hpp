// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is wrong with an input, or worth knowing of it, collected instead of stopping at the first.
#pragma once

#include "particles/errors.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace plenum {

enum class Severity { note, warning, error };

/// "note", "warning" or "error".
const char* nameOf(Severity severity);

struct Finding {
  Severity severity = Severity::error;
  std::string what;           ///< where in the input, and what is so there, in one line
  std::string remedy;         ///< what to do about it
  std::vector<double> place;  ///< one coordinate a dimension [m]; empty: nowhere in particular

  /// "what; remedy", as messages have it.
  std::string text() const { return remedy.empty() ? what : what + "; " + remedy; }
};

/// Several errors at once. Its message is the first of them and says how many more there are.
class FaultyInput : public InputError {
 public:
  /// `errors` must not be empty.
  explicit FaultyInput(std::vector<Finding> errors);
  const std::vector<Finding>& errors() const { return errors_; }

 private:
  std::vector<Finding> errors_;
};

/// An error that only follows from one that was reported before: what needs a broken region.
class FollowingError : public InputError {
 public:
  using InputError::InputError;
};

/// The findings that `error` stands for: those of a FaultyInput, or its message, whose remedy
/// stands behind the last "; ".
std::vector<Finding> findingsOf(const InputError& error);

/// A message "what; remedy" as a finding.
Finding findingOf(Severity severity, const std::string& message);

class Findings {
 public:
  void add(Finding finding) { all_.push_back(std::move(finding)); }

  /// Runs `work`; an InputError that it throws becomes findings. True if it went well.
  template <class Work>
  bool attempt(Work&& work) {
    try {
      work();
      return true;
    } catch (const FollowingError&) {  // its cause is among the findings already
    } catch (const InputError& error) {
      for (Finding& finding : findingsOf(error)) add(std::move(finding));
    }
    return false;
  }

  /// Somewhere to say "what; remedy" as a warning; lives no longer than this.
  std::function<void(const std::string&)> warner() {
    return [this](const std::string& message) { add(findingOf(Severity::warning, message)); };
  }

  const std::vector<Finding>& all() const { return all_; }
  std::size_t count(Severity severity) const;
  bool hasErrors() const { return count(Severity::error) > 0; }

  /// Throws FaultyInput with all errors if there are any.
  void throwErrors() const;

 private:
  std::vector<Finding> all_;
};

/// Takes findings one by one.
using FindingSink = std::function<void(const Finding&)>;

}  // namespace plenum
