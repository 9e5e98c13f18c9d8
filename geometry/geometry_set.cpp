// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/geometry_set.hpp"

#include "geometry/set_operation.hpp"
#include "geometry/shape_keys.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace plenum {

namespace {

/// Makes regions in the order in which they are needed; entries may refer to later ones.
template <int Dim>
class Builder {
 public:
  Builder(const CaseNode& table, const std::filesystem::path& caseFolder, Findings& findings)
      : table_(table), caseFolder_(caseFolder), findings_(findings) {}

  /// The region; throws FollowingError if it is broken, after what is wrong was added to the
  /// findings once.
  GeometryPtr<Dim> region(const std::string& name, const CaseNode& entry) {
    if (!done_.contains(name)) {
      if (std::ranges::find(underWay_, name) != underWay_.end())
        entry.fail(fmt::format("refers to itself: {} -> {}; break the circle",
                               fmt::join(underWay_, " -> "), name));
      underWay_.push_back(name);
      GeometryPtr<Dim> made;
      findings_.attempt([&] { made = make(entry); });
      underWay_.pop_back();
      done_[name] = made;
    }
    if (!done_[name]) throw FollowingError(entry.where() + ": is broken; mend it");
    return done_[name];
  }

 private:
  GeometryPtr<Dim> make(const CaseNode& entry) {
    const std::string key = keyOf(shapeNodeOf(entry, Dim));
    return isSetOperation(key) ? operation(entry, key)
                               : makeRegion<Dim>(entry, caseFolder_, report_);
  }

  GeometryPtr<Dim> operation(const CaseNode& entry, const std::string& key) {
    const EntryKeys keys = entrySection().read(entry, Dim);
    const CaseNode& node = *entry.find(key);
    checkHasNoFileKeys(entry);
    if (node.asArray().size() < (key == "difference" ? 2 : 1))
      node.fail(key == "difference" ? "needs two regions or more: the first without the others"
                                    : "needs the names of regions");
    std::vector<GeometryPtr<Dim>> parts;
    for (const CaseNode& name : node.asArray()) parts.push_back(named(name));
    try {
      if (key == "union") return placedAs(keys, unionOf(parts));
      if (key == "intersection") return placedAs(keys, intersectionOf(parts));
      return placedAs(keys, differenceOf(parts));
    } catch (const InputError& error) {
      node.fail(error);
    }
  }

  GeometryPtr<Dim> named(const CaseNode& name) {
    if (const CaseNode* entry = table_.find(name.asString()))
      return region(name.asString(), *entry);
    std::vector<std::string> known;
    for (const auto& [other, entry] : table_.asTable()) known.push_back(other);
    failUnknown(name, known);
  }

 public:
  [[noreturn]] static void failUnknown(const CaseNode& name,
                                       const std::vector<std::string>& known) {
    const std::string near = nearest(name.asString(), known);
    name.fail("there is no region of that name in [geometry]" +
              (near.empty() ? fmt::format("; known: {}", fmt::join(known, ", "))
                            : "; did you mean \"" + near + "\"?"));
  }

 private:
  const CaseNode& table_;
  const std::filesystem::path& caseFolder_;
  Findings& findings_;
  FindingSink report_ = [this](const Finding& finding) { findings_.add(finding); };
  std::map<std::string, GeometryPtr<Dim>> done_;
  std::vector<std::string> underWay_;
};

}  // namespace

template <int Dim>
GeometrySet<Dim> GeometrySet<Dim>::read(const CaseNode& geometryTable,
                                        const std::filesystem::path& caseFolder) {
  Findings findings;
  GeometrySet set = readAll(geometryTable, caseFolder, findings);
  findings.throwErrors();
  return set;
}

template <int Dim>
GeometrySet<Dim> GeometrySet<Dim>::readAll(const CaseNode& geometryTable,
                                           const std::filesystem::path& caseFolder,
                                           Findings& findings) {
  GeometrySet set;
  Builder<Dim> builder(geometryTable, caseFolder, findings);
  for (const auto& [name, entry] : geometryTable.asTable()) {
    set.names_.push_back(name);
    set.regions_.emplace_back();
    findings.attempt([&] { set.regions_.back() = builder.region(name, entry); });
  }
  return set;
}

template <int Dim>
const GeometryPtr<Dim>& GeometrySet<Dim>::find(const CaseNode& name) const {
  const auto found = std::ranges::find(names_, name.asString());
  if (found == names_.end()) Builder<Dim>::failUnknown(name, names_);
  const GeometryPtr<Dim>& region = regions_[static_cast<std::size_t>(found - names_.begin())];
  if (!region) throw FollowingError(name.where() + ": that region is broken; mend it");
  return region;
}

std::vector<SectionDoc> geometryDocs() {
  SectionDoc entry = entrySection().doc("geometry.<name>");
  entry.inner.push_back(rotationSection().doc("rotate"));
  return {entry};
}

template class GeometrySet<1>;
template class GeometrySet<2>;
template class GeometrySet<3>;

}  // namespace plenum
