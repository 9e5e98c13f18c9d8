// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/findings.hpp"

#include <algorithm>

namespace plenum {

namespace {

std::string summaryOf(const std::vector<Finding>& errors) {
  const std::size_t more = errors.size() - 1;
  std::string text = errors.front().text();
  if (more > 0)
    text += " (and " + std::to_string(more) + " more error" + (more == 1 ? "" : "s") +
            ": plenum-ic check lists all)";
  return text;
}

}  // namespace

const char* nameOf(Severity severity) {
  if (severity == Severity::note) return "note";
  return severity == Severity::warning ? "warning" : "error";
}

FaultyInput::FaultyInput(std::vector<Finding> errors)
    : InputError(summaryOf(errors)), errors_(std::move(errors)) {}

Finding findingOf(Severity severity, const std::string& message) {
  const std::size_t end = message.rfind("; ");
  if (end == std::string::npos) return {severity, message, "", {}};
  return {severity, message.substr(0, end), message.substr(end + 2), {}};
}

std::vector<Finding> findingsOf(const InputError& error) {
  if (const auto* faulty = dynamic_cast<const FaultyInput*>(&error)) return faulty->errors();
  return {findingOf(Severity::error, error.what())};
}

std::size_t Findings::count(Severity severity) const {
  return static_cast<std::size_t>(std::ranges::count(all_, severity, &Finding::severity));
}

void Findings::throwErrors() const {
  std::vector<Finding> errors;
  std::ranges::copy_if(all_, std::back_inserter(errors),
                       [](const Finding& f) { return f.severity == Severity::error; });
  if (!errors.empty()) throw FaultyInput(std::move(errors));
}

}  // namespace plenum
