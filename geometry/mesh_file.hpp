// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/triangle_soup.hpp"

#include <filesystem>
#include <string>

namespace plenum {

/// Triangles of an STL (ASCII or binary), OBJ, OFF or PLY (ASCII or binary) file, by its ending.
/// Faces with more corners are cut into triangles from their first corner. Throws InputError that
/// names the file and line or byte: another kind of file, truncated, corners that are not numbers.
TriangleSoup readMeshFile(const std::filesystem::path& path);

TriangleSoup readStl(const std::string& bytes, const std::string& source);
TriangleSoup readObj(const std::string& bytes, const std::string& source);
TriangleSoup readOff(const std::string& bytes, const std::string& source);
TriangleSoup readPly(const std::string& bytes, const std::string& source);

/// Adds a face with corners numbered from 0; throws InputError if `nPoints` are fewer.
void addFace(TriangleSoup& soup, const std::vector<std::size_t>& corners, std::size_t nPoints,
             const std::string& source);

}  // namespace plenum
