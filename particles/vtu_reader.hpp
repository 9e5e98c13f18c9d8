// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/file_points.hpp"

#include <string>
#include <string_view>

namespace plenum {

/// The points of a .vtu file (UnstructuredGrid in XML) that stands in `bytes`, of all its pieces,
/// with three components in the file's unit. Where the point data have an array `type` of nothing
/// but 0 and 1, as ours have, 1 is a wall. Arrays may be ascii, binary or appended, raw or base64,
/// plain or compressed with zlib, with headers of UInt32 or UInt64, little endian: what this
/// program, meshio and ParaView write unless told otherwise. Messages begin with `source`.
///
/// Throws InputError for another kind of file, other encodings (big endian, lz4, lzma) and damage.
FilePoints readVtuPoints(std::string_view bytes, const std::string& source);

}  // namespace plenum
