// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/vtk_xml.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace plenum {

/// What all arrays of one VTK file in XML have in common.
struct VtkEncoding {
  std::string source;           ///< begins every message
  std::size_t headerBytes = 4;  ///< of a length before the data: 4 or 8
  bool isCompressed = false;    ///< with zlib
  std::string_view appended;    ///< what stands behind the underscore
  bool appendedIsBase64 = false;
};

/// The values of a DataArray: `ascii`, `binary` (base64) or `appended` (raw or base64), plain or in
/// blocks of zlib, of any VTK number type. length `n`. Throws InputError for another type or
/// encoding and for data that do not hold exactly `n` values.
std::vector<double> readVtkArray(const VtkElement& array, std::size_t n,
                                 const VtkEncoding& encoding);

/// A whole number of an attribute. Throws InputError if it is missing or none.
std::size_t countOf(const VtkElement& element, std::string_view key, const std::string& source);

}  // namespace plenum
