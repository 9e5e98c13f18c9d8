// SPDX-License-Identifier: GPL-3.0-or-later
//
// A section of the case file, declared once: every key with its type, unit, range, default and
// description. Reading, error messages, `--help` and the docs all come from the declaration.
#pragma once

#include "particles/case_node.hpp"

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace plenum {

/// Allowed values of a number. Bounds are included unless said otherwise.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lowerExcluded = false;

  static Range any() { return {}; }
  static Range positive() { return {0, std::numeric_limits<double>::infinity(), true}; }
  static Range notNegative() { return {0, std::numeric_limits<double>::infinity(), false}; }
  static Range between(double lower, double upper) { return {lower, upper, false}; }
  static Range above(double lower, double upper) { return {lower, upper, true}; }

  bool has(double x) const { return (lowerExcluded ? x > lower : x >= lower) && x <= upper; }
  std::string printed() const;
};

/// What help and docs say of one key.
struct ParameterDoc {
  std::string key;
  std::string type;
  std::string unit;
  std::string range;         ///< "" if anything of that type goes
  std::string defaultValue;  ///< "" if there is none
  bool required = false;
  std::string description;
};

/// What help and docs say of one section and of the tables inside it.
struct SectionDoc {
  std::string key;  ///< "" for the top level of a case
  std::string description;
  std::vector<ParameterDoc> parameters;
  std::vector<SectionDoc> inner;
  bool isList = false;  ///< the key holds a list of such tables, [[key]]

  /// Plain text for `--help`, one line a key, indented by `indent` blanks.
  std::string printed(int indent = 0) const;
  /// A Markdown table for the docs.
  std::string markdown(const std::string& prefix = "") const;
};

/// Free parts of `Section`, apart from the template.
namespace section_detail {
void checkNumber(const CaseNode& node, double value, const Range& range, const std::string& unit);
void checkChoice(const CaseNode& node, std::span<const std::string> choices);
void checkKeys(const CaseNode& table, const std::vector<ParameterDoc>& docs);
int asInt(const CaseNode& node, std::int64_t value);
std::vector<double> readVector(const CaseNode& node, int dimension);
std::vector<double> readList(const CaseNode& node, const Range& range, const std::string& unit);
std::string printNumber(double value);
std::string printChoices(std::span<const std::string> choices);
}  // namespace section_detail

/// Declares the keys of one section and reads it into a plain struct S, whose member initialisers
/// are the defaults.
template <class S>
class Section {
 public:
  explicit Section(std::string description) : description_(std::move(description)) {}

  Section& number(const std::string& key, double S::*member, const std::string& unit,
                  const Range& range, const std::string& description) {
    return add({key, "number", unit, range.printed(), section_detail::printNumber(S{}.*member),
                false, description},
               [=](S& settings, const CaseNode& node, int) {
                 settings.*member = node.asNumber();
                 section_detail::checkNumber(node, settings.*member, range, unit);
               });
  }

  /// A number without a default: absent means what the description says.
  Section& number(const std::string& key, std::optional<double> S::*member, const std::string& unit,
                  const Range& range, const std::string& description) {
    return add({key, "number", unit, range.printed(), "", false, description},
               [=](S& settings, const CaseNode& node, int) {
                 settings.*member = node.asNumber();
                 section_detail::checkNumber(node, *(settings.*member), range, unit);
               });
  }

  Section& integer(const std::string& key, int S::*member, const Range& range,
                   const std::string& description) {
    return add(
        {key, "integer", "", range.printed(), std::to_string(S{}.*member), false, description},
        [=](S& settings, const CaseNode& node, int) {
          const std::int64_t value = node.asInteger();
          section_detail::checkNumber(node, static_cast<double>(value), range, "");
          settings.*member = static_cast<int>(value);
        });
  }

  Section& integer(const std::string& key, std::optional<int> S::*member, const Range& range,
                   const std::string& description) {
    return add({key, "integer", "", range.printed(), "", false, description},
               [=](S& settings, const CaseNode& node, int) {
                 const std::int64_t value = node.asInteger();
                 section_detail::checkNumber(node, static_cast<double>(value), range, "");
                 settings.*member = section_detail::asInt(node, value);
               });
  }

  Section& flag(const std::string& key, bool S::*member, const std::string& description) {
    return add({key, "true or false", "", "", S{}.*member ? "true" : "false", false, description},
               [=](S& settings, const CaseNode& node, int) { settings.*member = node.asBool(); });
  }

  /// A string; with `choices` it must be one of them.
  Section& text(const std::string& key, std::string S::*member, const std::string& description,
                std::vector<std::string> choices = {}) {
    return add(
        {key, "string", "", section_detail::printChoices(choices), S{}.*member, false, description},
        [=](S& settings, const CaseNode& node, int) {
          settings.*member = node.asString();
          if (!choices.empty()) section_detail::checkChoice(node, choices);
        });
  }

  /// A list of as many numbers as the case has dimensions.
  Section& vector(const std::string& key, std::vector<double> S::*member, const std::string& unit,
                  const std::string& description) {
    return add({key, "vector", unit, "", "", false, description},
               [=](S& settings, const CaseNode& node, int dimension) {
                 settings.*member = section_detail::readVector(node, dimension);
               });
  }

  /// A list of `count` numbers, whatever the case's dimension.
  Section& numbers(const std::string& key, std::vector<double> S::*member, int count,
                   const std::string& unit, const std::string& description) {
    return add({key, std::to_string(count) + " numbers", unit, "", "", false, description},
               [=](S& settings, const CaseNode& node, int) {
                 settings.*member = section_detail::readVector(node, count);
               });
  }

  /// A list of any number of numbers.
  Section& list(const std::string& key, std::vector<double> S::*member, const std::string& unit,
                const Range& range, const std::string& description) {
    return add({key, "list of numbers", unit, range.printed(), "", false, description},
               [=](S& settings, const CaseNode& node, int) {
                 settings.*member = section_detail::readList(node, range, unit);
               });
  }

  /// A list of strings.
  Section& texts(const std::string& key, std::vector<std::string> S::*member,
                 const std::string& description, std::vector<std::string> choices = {}) {
    return add(
        {key, "list of strings", "", section_detail::printChoices(choices), "", false, description},
        [=](S& settings, const CaseNode& node, int) {
          (settings.*member).clear();
          for (const CaseNode& item : node.asArray()) {
            (settings.*member).push_back(item.asString());
            if (!choices.empty()) section_detail::checkChoice(item, choices);
          }
        });
  }

  /// A table of its own; absent means that the thing it describes is not there.
  template <class Inner>
  Section& section(const std::string& key, std::optional<Inner> S::*member,
                   const Section<Inner>& inner) {
    inner_.push_back(inner.doc(key));
    return add({key, "table", "", "", "", false, inner.doc(key).description},
               [=](S& settings, const CaseNode& node, int dimension) {
                 settings.*member = inner.read(node, dimension);
               });
  }

  /// A list of tables, `[[key]]`, all of one form; absent means none.
  template <class Inner>
  Section& sections(const std::string& key, std::vector<Inner> S::*member,
                    const Section<Inner>& inner) {
    inner_.push_back(inner.doc(key));
    inner_.back().isList = true;
    return add({key, "list of tables", "", "", "", false, inner.doc(key).description},
               [=](S& settings, const CaseNode& node, int dimension) {
                 (settings.*member).clear();
                 for (const CaseNode& item : node.asArray())
                   (settings.*member).push_back(inner.read(item, dimension));
               });
  }

  /// A value of any form, kept as it stands for somebody else to read.
  Section& node(const std::string& key, std::optional<CaseNode> S::*member, const std::string& type,
                const std::string& description) {
    return add({key, type, "", "", "", false, description},
               [=](S& settings, const CaseNode& node, int) { settings.*member = node; });
  }

  /// What must hold between keys: called after they are read; throws by `table.fail`.
  using Condition = std::function<void(const S&, const CaseNode& table, int dimension)>;
  Section& condition(Condition condition) {
    conditions_.push_back(std::move(condition));
    return *this;
  }

  /// The key declared last must be there.
  Section& required() {
    docs_.back().required = true;
    docs_.back().defaultValue.clear();
    return *this;
  }

  /// Throws InputError for unknown keys (with the nearest known one), wrong types, values out of
  /// range, missing keys and conditions that do not hold. `dimension` is the length of vectors.
  S read(const CaseNode& table, int dimension) const {
    section_detail::checkKeys(table, docs_);
    S settings;
    for (std::size_t k = 0; k < docs_.size(); ++k)
      if (const CaseNode* node = table.find(docs_[k].key)) readers_[k](settings, *node, dimension);
    for (const Condition& condition : conditions_) condition(settings, table, dimension);
    return settings;
  }

  SectionDoc doc(const std::string& key) const { return {key, description_, docs_, inner_, false}; }

 private:
  using Reader = std::function<void(S&, const CaseNode&, int dimension)>;

  Section& add(ParameterDoc doc, Reader reader) {
    docs_.push_back(std::move(doc));
    readers_.push_back(std::move(reader));
    return *this;
  }

  std::string description_;
  std::vector<ParameterDoc> docs_;
  std::vector<Reader> readers_;
  std::vector<Condition> conditions_;
  std::vector<SectionDoc> inner_;
};

}  // namespace plenum
