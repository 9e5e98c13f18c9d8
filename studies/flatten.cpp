// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/flatten.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

namespace plenum::study {

namespace {

/// Keys of places, directions and velocities, which have a component for each axis.
constexpr std::array vectorKeys{"lower",   "upper",    "center", "point",         "normal",
                                "gravity", "from",     "to",     "translate",     "amplitude",
                                "origin",  "velocity", "drift",  "lattice_origin"};

/// Lattices of space and of the plane.
constexpr std::array<std::pair<const char*, const char*>, 4> lattices{
    {{"cubic", "square"}, {"bcc", "square"}, {"fcc", "hexagonal"}, {"hcp", "hexagonal"}}};

std::string lastKeyOf(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  return path.substr(dot == std::string::npos ? 0 : dot + 1);
}

class Flattener {
 public:
  Flattener(const CaseNode& root, std::size_t axis) : flat_(root), axis_(axis) { visit(root); }

  CaseNode done() {
    for (const auto& [key, text] : changes_) flat_.set(key, text);
    flat_.set("dimension", "2");
    flat_.remove("uniform");
    return flat_;
  }

 private:
  void visit(const CaseNode& node) {
    if (node.isTable()) {
      for (const auto& [key, child] : node.asTable()) visit(child);
    } else if (node.isString()) {
      visitText(node);
    } else if (node.isArray()) {
      visitList(node);
    }
  }

  void visitText(const CaseNode& node) {
    if (lastKeyOf(node.path()) != "lattice") return;
    for (const auto& [inSpace, inPlane] : lattices)
      if (node.asString() == inSpace) changes_.emplace_back(node.path(), inPlane);
  }

  void visitList(const CaseNode& node) {
    const CaseNode::Array& items = node.asArray();
    if (node.path() == "domain.periodic") return visitAxes(node);
    if (!std::ranges::all_of(items, &CaseNode::isNumber)) {
      for (const CaseNode& item : items) visit(item);
      return;
    }
    // Horizontal places of wave gauges have two.
    const bool isVector = std::ranges::count(vectorKeys, lastKeyOf(node.path())) > 0;
    if (!isVector || items.size() < 2 || axis_ >= items.size()) return;
    std::vector<std::string> kept;
    for (std::size_t k = 0; k < items.size(); ++k)
      if (k != axis_) kept.push_back(items[k].printed());
    changes_.emplace_back(node.path(), fmt::format("[{}]", fmt::join(kept, ", ")));
  }

  /// Axes behind the one that goes move up by one.
  void visitAxes(const CaseNode& node) {
    std::vector<std::string> kept;
    for (const CaseNode& item : node.asArray()) {
      const auto axis = static_cast<std::size_t>(item.asString().at(0) - 'x');
      if (axis != axis_)
        kept.push_back(fmt::format("\"{}\"", static_cast<char>('x' + axis - (axis > axis_))));
    }
    changes_.emplace_back(node.path(), fmt::format("[{}]", fmt::join(kept, ", ")));
  }

  CaseNode flat_;
  std::size_t axis_;
  std::vector<std::pair<std::string, std::string>> changes_;
};

}  // namespace

std::optional<LeaveOut> flattened(const CaseNode& root) {
  const CaseNode *axis = root.find("uniform"), *dimension = root.find("dimension");
  if (axis == nullptr || axis->asString() == "none" || dimension == nullptr ||
      dimension->asInteger() != 3)
    return std::nullopt;
  const std::string& name = axis->asString();
  return LeaveOut{"the third dimension, along " + name,
                  Flattener(root, static_cast<std::size_t>(name.at(0) - 'x')).done(), true};
}

}  // namespace plenum::study
