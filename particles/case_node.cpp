// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/case_node.hpp"

#include "particles/findings.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>

namespace plenum {

struct CaseNode::Builder {
  std::shared_ptr<const std::string> fileName;

  CaseNode build(const toml::node& node, const std::string& path) const {
    CaseNode result;
    result.path_ = path;
    result.line_ = static_cast<int>(node.source().begin.line);
    result.fileName_ = fileName;
    if (const auto* table = node.as_table())
      result.value_ = buildTable(*table, path);
    else if (const auto* array = node.as_array())
      result.value_ = buildArray(*array, path);
    else if (const auto* text = node.as_string())
      result.value_ = text->get();
    else if (const auto* integer = node.as_integer())
      result.value_ = integer->get();
    else if (const auto* number = node.as_floating_point())
      result.value_ = number->get();
    else if (const auto* flag = node.as_boolean())
      result.value_ = flag->get();
    else
      result.fail("dates and times have no meaning in a case file");
    return result;
  }

 private:
  Table buildTable(const toml::table& source, const std::string& path) const {
    std::vector<std::pair<toml::source_position, std::pair<std::string, CaseNode>>> entries;
    for (const auto& [key, node] : source) {
      const std::string name(key.str());
      CaseNode child = build(node, path.empty() ? name : path + "." + name);
      if (child.line_ == 0) child.line_ = static_cast<int>(key.source().begin.line);
      entries.push_back({key.source().begin, {name, std::move(child)}});
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    Table table;
    for (auto& entry : entries) table.push_back(std::move(entry.second));
    return table;
  }

  Array buildArray(const toml::array& source, const std::string& path) const {
    Array array;
    for (const auto& node : source)
      array.push_back(build(node, fmt::format("{}[{}]", path, array.size())));
    return array;
  }
};

CaseNode CaseNode::parse(const std::string& text, const std::string& fileName) {
  try {
    const toml::table table = toml::parse(text, fileName);
    return Builder{std::make_shared<const std::string>(fileName)}.build(table, "");
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: not valid TOML: {}", fileName, error.source().begin.line,
                                 error.description()));
  }
}

CaseNode CaseNode::load(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  if (!fs::exists(path)) throw InputError(path.string() + ": no such case file");
  if (!fs::is_regular_file(path)) throw InputError(path.string() + ": not a file");
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in)
    throw InputError(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
  if (text.str().starts_with("\x89HDF"))
    throw InputError(path.string() + ": is a particle file (HDF5); a case file (TOML) is needed");
  return parse(text.str(), path.string());
}

std::string CaseNode::where() const {
  const std::string where = line_ > 0 ? fmt::format("{}:{}", *fileName_, line_) : *fileName_;
  if (path_.empty()) return where;
  return isTable() || isArray() ? fmt::format("{}: {}", where, path_)
                                : fmt::format("{}: {} = {}", where, path_, printed());
}

void CaseNode::fail(const std::string& message) const {
  throw InputError(where() + ": " + message);
}

void CaseNode::fail(const InputError& error) const {
  if (dynamic_cast<const FollowingError*>(&error) != nullptr) throw FollowingError(error.what());
  std::vector<Finding> findings = findingsOf(error);
  for (Finding& finding : findings) finding.what = where() + ": " + finding.what;
  throw FaultyInput(std::move(findings));
}

namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      result += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      result += c;
  }
  return result + '"';
}

bool isBareKey(const std::string& key) {
  return !key.empty() && std::ranges::all_of(key, [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-';
  });
}

std::string printedKey(const std::string& key) { return isBareKey(key) ? key : quoted(key); }

}  // namespace

std::string CaseNode::printed() const {
  struct Printer {
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(std::int64_t i) const { return std::to_string(i); }
    std::string operator()(double d) const { return fmt::format("{}", d); }
    std::string operator()(const std::string& s) const { return quoted(s); }
    std::string operator()(const Array& items) const {
      std::string text;
      for (const CaseNode& item : items) text += (text.empty() ? "" : ", ") + item.printed();
      return "[" + text + "]";
    }
    std::string operator()(const Table& entries) const {
      std::string text;
      for (const auto& [key, node] : entries)
        text += (text.empty() ? "" : ", ") + printedKey(key) + " = " + node.printed();
      return "{ " + text + " }";
    }
  };
  return std::visit(Printer{}, value_);
}

std::string CaseNode::printedFile(const std::string& comment) const {
  std::string text = "# " + comment + "\n", sections;
  const auto lines = [](const CaseNode& table) {
    std::string all;
    for (const auto& [key, node] : table.asTable())
      all += fmt::format("{} = {}\n", printedKey(key), node.printed());
    return all;
  };
  const auto isListOfTables = [](const CaseNode& node) {
    return node.isArray() && !node.asArray().empty() &&
           std::ranges::all_of(node.asArray(), &CaseNode::isTable);
  };
  for (const auto& [key, node] : asTable()) {
    if (node.isTable()) {
      sections += fmt::format("\n[{}]\n{}", printedKey(key), lines(node));
    } else if (isListOfTables(node)) {
      for (const CaseNode& item : node.asArray())
        sections += fmt::format("\n[[{}]]\n{}", printedKey(key), lines(item));
    } else {
      text += fmt::format("{} = {}\n", printedKey(key), node.printed());
    }
  }
  return text + sections;
}

namespace {
std::string wrongType(const CaseNode& node, const char* wanted) {
  static constexpr const char* names[] = {"true or false", "an integer", "a number",
                                          "a string",      "a list",     "a table"};
  return fmt::format("is {}, must be {}", names[node.value().index()], wanted);
}
}  // namespace

bool CaseNode::asBool() const {
  if (const auto* flag = std::get_if<bool>(&value_)) return *flag;
  fail(wrongType(*this, "true or false"));
}

std::int64_t CaseNode::asInteger() const {
  if (const auto* integer = std::get_if<std::int64_t>(&value_)) return *integer;
  fail(wrongType(*this, "an integer"));
}

double CaseNode::asNumber() const {
  if (const auto* number = std::get_if<double>(&value_)) return *number;
  if (const auto* integer = std::get_if<std::int64_t>(&value_))
    return static_cast<double>(*integer);
  fail(wrongType(*this, "a number"));
}

const std::string& CaseNode::asString() const {
  if (const auto* text = std::get_if<std::string>(&value_)) return *text;
  fail(wrongType(*this, "a string"));
}

const CaseNode::Array& CaseNode::asArray() const {
  if (const auto* array = std::get_if<Array>(&value_)) return *array;
  fail(wrongType(*this, "a list"));
}

const CaseNode::Table& CaseNode::asTable() const {
  if (const auto* table = std::get_if<Table>(&value_)) return *table;
  fail(wrongType(*this, "a table"));
}

const CaseNode* CaseNode::find(const std::string& key) const {
  for (const auto& [name, node] : asTable())
    if (name == key) return &node;
  return nullptr;
}

namespace {

/// "fluid[0]" -> "fluid" and 0; a plain name has no index.
struct KeyPart {
  std::string name;
  std::optional<std::size_t> index;

  KeyPart(const std::string& text, const std::string& origin) : name(text) {
    const std::size_t bracket = text.find('[');
    if (bracket != std::string::npos) {
      name = text.substr(0, bracket);
      const std::string digits = text.substr(bracket + 1, text.size() - bracket - 2);
      const bool isNumber = !digits.empty() && digits.size() < 7 && text.back() == ']' &&
                            digits.find_first_not_of("0123456789") == std::string::npos;
      if (!isNumber) throw InputError(origin + ": write the index as in fluid[0].density");
      index = std::stoul(digits);
    }
    if (name.empty()) throw InputError(origin + ": an empty key; write --set section.key=value");
  }
};

}  // namespace

/// The child of a table, made if it is not there.
CaseNode& CaseNode::child(const std::string& name) {
  auto* table = std::get_if<Table>(&value_);
  if (table == nullptr) fail("is not a table, so it has no key '" + name + "'");
  for (auto& [key, node] : *table)
    if (key == name) return node;
  CaseNode node;
  node.path_ = path_.empty() ? name : path_ + "." + name;
  node.fileName_ = fileName_;
  return table->emplace_back(name, std::move(node)).second;
}

std::pair<std::string, std::string> CaseNode::splitAssignment(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  std::string key = assignment.substr(0, equals);
  while (!key.empty() && key.back() == ' ') key.pop_back();
  if (equals == std::string::npos || key.empty())
    throw InputError("--set " + assignment +
                     ": write key=value, for instance --set solver.kernel=convex");
  return {key, assignment.substr(equals + 1)};
}

/// This value and all below it were set on the command line, not in a line of the file.
void CaseNode::comeFrom(const std::shared_ptr<const std::string>& origin, const std::string& path) {
  fileName_ = origin;
  path_ = path;
  line_ = 0;
  if (auto* table = std::get_if<Table>(&value_))
    for (auto& [key, node] : *table) node.comeFrom(origin, path + "." + key);
  if (auto* items = std::get_if<Array>(&value_))
    for (std::size_t k = 0; k < items->size(); ++k)
      (*items)[k].comeFrom(origin, fmt::format("{}[{}]", path, k));
}

void CaseNode::set(const std::string& key, const std::string& text) {
  const std::string origin = fmt::format("--set {}={}", key, text);
  CaseNode parsed;
  try {
    parsed = parse("value = " + text, origin);
  } catch (const InputError&) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool isNumber = error == std::errc() && end == text.data() + text.size();
    // .05 and 5. are numbers everywhere but in TOML; a bare word is a string.
    parsed = parse("value = " + (isNumber ? fmt::format("{}", number) : "'" + text + "'"), origin);
  }
  CaseNode* node = this;
  for (std::size_t begin = 0; begin != std::string::npos;) {
    const std::size_t dot = key.find('.', begin);
    const KeyPart part(key.substr(begin, dot - begin), origin);
    node = &node->child(part.name);
    if (part.index) {
      auto* items = std::get_if<Array>(&node->value_);
      if (items == nullptr || *part.index >= items->size())
        throw InputError(fmt::format("{}: the case has {} entries of '{}'", origin,
                                     items == nullptr ? 0 : items->size(), part.name));
      node = &(*items)[*part.index];
    }
    begin = dot == std::string::npos ? dot : dot + 1;
  }
  node->value_ = parsed.find("value")->value_;
  node->comeFrom(std::make_shared<const std::string>(origin), node->path_);
}

void CaseNode::remove(const std::string& key) {
  const std::size_t dot = key.rfind('.');
  const KeyPart last(key.substr(dot == std::string::npos ? 0 : dot + 1), "remove " + key);
  CaseNode* parent = this;
  for (std::size_t begin = 0; dot != std::string::npos && begin <= dot;) {
    const std::size_t end = key.find('.', begin);
    auto* table = std::get_if<Table>(&parent->value_);
    if (table == nullptr) return;
    const auto entry =
        std::ranges::find(*table, key.substr(begin, end - begin), &Table::value_type::first);
    if (entry == table->end()) return;
    parent = &entry->second;
    begin = end + 1;
  }
  auto* table = std::get_if<Table>(&parent->value_);
  if (table == nullptr) return;
  const auto entry = std::ranges::find(*table, last.name, &Table::value_type::first);
  if (entry == table->end()) return;
  if (!last.index) {
    table->erase(entry);
  } else if (auto* items = std::get_if<Array>(&entry->second.value_);
             items != nullptr && *last.index < items->size()) {
    items->erase(items->begin() + static_cast<std::ptrdiff_t>(*last.index));
  }
}

}  // namespace plenum
