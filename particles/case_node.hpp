// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace plenum {

class InputError;

/// One value of a case file (TOML) together with where it stands, so that every error can name
/// file, line and key. Keys keep the order of the file.
class CaseNode {
 public:
  using Array = std::vector<CaseNode>;
  using Table = std::vector<std::pair<std::string, CaseNode>>;
  using Value = std::variant<bool, std::int64_t, double, std::string, Array, Table>;

  /// Throws InputError for a missing file, a directory, or text that is not TOML (with the line).
  static CaseNode load(const std::filesystem::path& path);
  static CaseNode parse(const std::string& text, const std::string& fileName);

  const Value& value() const { return value_; }
  const std::string& path() const { return path_; }  ///< dotted key, "solver.kernel"
  int line() const { return line_; }                 ///< 1-based; 0 if set on the command line
  const std::string& fileName() const { return *fileName_; }

  bool isTable() const { return std::holds_alternative<Table>(value_); }
  bool isArray() const { return std::holds_alternative<Array>(value_); }
  bool isString() const { return std::holds_alternative<std::string>(value_); }
  bool isNumber() const {
    return std::holds_alternative<double>(value_) || std::holds_alternative<std::int64_t>(value_);
  }

  /// Typed access; throws InputError that names the type found and the one asked for.
  bool asBool() const;
  std::int64_t asInteger() const;
  double asNumber() const;
  const std::string& asString() const;
  const Array& asArray() const;
  const Table& asTable() const;

  /// The entry of a table, or nullptr.
  const CaseNode* find(const std::string& key) const;

  /// The two sides of "key=value". Throws InputError if it has another form.
  static std::pair<std::string, std::string> splitAssignment(const std::string& assignment);

  /// Sets `key` ("solver.kernel", "fluid[0].seed") to the TOML value `text`; bare words are taken
  /// as strings. Throws InputError for an index beyond the list.
  void set(const std::string& key, const std::string& text);

  /// Takes `key`, or an entry of a list ("solver.collisions", "fluid[1]"), out of the case, if it
  /// is there. Lists inside of lists are not looked into.
  void remove(const std::string& key);

  /// The value as it would stand in the file, for messages.
  std::string printed() const;

  /// The whole case as a file, behind a first line with a comment.
  std::string printedFile(const std::string& comment) const;

  /// "file:line: key = value"; lists and tables by their key alone.
  std::string where() const;

  /// Throws InputError "file:line: key = value: message".
  [[noreturn]] void fail(const std::string& message) const;

  /// Throws the findings of `error`, each with where this stands.
  [[noreturn]] void fail(const InputError& error) const;

  /// Reads TOML; the only function that knows the parser.
  struct Builder;

 private:
  CaseNode& child(const std::string& name);
  void comeFrom(const std::shared_ptr<const std::string>& origin, const std::string& path);

  Value value_ = Table{};
  std::string path_;
  int line_ = 0;
  std::shared_ptr<const std::string> fileName_ = std::make_shared<std::string>("case");
};

}  // namespace plenum
