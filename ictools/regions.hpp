// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry_set.hpp"
#include "particles/case_settings.hpp"

#include <optional>

namespace plenum {

/// The regions of a case, and errors for names when it has none.
template <int Dim>
class Regions {
 public:
  /// Adds what is wrong with regions, and what was mended, to `findings`.
  Regions(const CaseSettings& settings, const std::filesystem::path& folder, Findings& findings) {
    if (settings.geometry) set_ = GeometrySet<Dim>::readAll(*settings.geometry, folder, findings);
  }

  /// Throws FollowingError for a region that is broken.
  GeometryPtr<Dim> find(const CaseNode& name) const {
    if (!set_) name.fail("the case has no [geometry] table in which to look for that name");
    return set_->find(name);
  }

  const std::optional<GeometrySet<Dim>>& all() const { return set_; }

 private:
  std::optional<GeometrySet<Dim>> set_;
};

}  // namespace plenum
