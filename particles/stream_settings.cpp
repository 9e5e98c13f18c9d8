// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/stream_settings.hpp"

#include <fmt/format.h>

namespace plenum {

namespace {

Section<StreamSettings> streamSection(const char* description, const char* sideDefault,
                                      const char* lengthMeaning) {
  using S = StreamSettings;
  return Section<S>(description)
      .text("axis", &S::axis, "the plane lies across this axis", {"x", "y", "z"})
      .number("at", &S::at, "m", Range::any(), "where the plane is on the axis")
      .required()
      .text("side", &S::side, sideDefault, {"lower", "upper"})
      .number("length", &S::length, "m", Range::positive(), lengthMeaning)
      .required()
      .condition([](const S& stream, const CaseNode& table, int dimension) {
        if (stream.axisNumber() < dimension) return;
        const CaseNode* axis = table.find("axis");
        (axis != nullptr ? *axis : table)
            .fail(fmt::format("a {}-D case has no axis {}", dimension, stream.axis));
      });
}

}  // namespace

Section<StreamSettings> inflowSection() {
  return streamSection(
      "a plane through which a gas comes in: what the case fills beyond it moves on as it started, "
      "again and again; absent: none",
      "end of the axis from which the gas comes",
      "how far the case's fluid reaches beyond the plane, in whole periods of its lattice; at "
      "least twice the kernel's support");
}

Section<StreamSettings> outflowSection() {
  return streamSection(
      "a plane through which a gas leaves: what has crossed it keeps its velocity and is taken out "
      "at the end of `length`; absent: none",
      "end of the axis to which the gas goes",
      "how far beyond the plane the case's fluid reaches, and later the gas that has left; at "
      "least twice the kernel's support");
}

}  // namespace plenum
