// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/vtu_reader.hpp"

#include "particles/errors.hpp"
#include "particles/vtk_array.hpp"
#include "particles/vtk_xml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace plenum {

namespace {

/// The arrays of a piece that are wanted, not yet decoded: appended data stand behind all of them.
struct Piece {
  std::size_t nPoints = 0;
  std::optional<VtkElement> points, type;
};

[[noreturn]] void failEncoding(const std::string& source, const std::string& what) {
  throw InputError(
      fmt::format("{}: {}; little-endian ascii, binary and appended arrays are read, plain or "
                  "compressed with zlib: export the file so",
                  source, what));
}

void readFileTag(const VtkElement& file, VtkEncoding& encoding) {
  const std::string_view type = file.attribute("type").value_or("");
  if (type != "UnstructuredGrid")
    throw InputError(fmt::format("{}: holds {}, must hold UnstructuredGrid; export it as .vtu",
                                 encoding.source, type.empty() ? "an unknown grid" : type));
  if (file.attribute("byte_order").value_or("LittleEndian") != "LittleEndian")
    failEncoding(encoding.source, "its numbers are big-endian");
  const std::string_view header = file.attribute("header_type").value_or("UInt32");
  if (header != "UInt32" && header != "UInt64")
    failEncoding(encoding.source, fmt::format("header_type is {}", header));
  encoding.headerBytes = header == "UInt64" ? 8 : 4;
  const std::string_view compressor = file.attribute("compressor").value_or("");
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    failEncoding(encoding.source, fmt::format("is compressed with {}", compressor));
  encoding.isCompressed = !compressor.empty();
}

void readAppendedTag(const VtkElement& tag, VtkEncoding& encoding) {
  const std::string_view kind = tag.attribute("encoding").value_or("");
  if (kind != "raw" && kind != "base64")
    failEncoding(encoding.source, fmt::format("its appended data have the encoding \"{}\"", kind));
  encoding.appendedIsBase64 = kind == "base64";
  const std::size_t underscore = tag.text.find('_');
  if (underscore == std::string_view::npos)
    throw InputError(encoding.source +
                     ": its appended data do not begin with '_': damaged; export it again");
  encoding.appended = tag.text.substr(underscore + 1);
}

/// All tags of the file; `encoding` is filled on the way.
std::vector<Piece> readTags(std::string_view bytes, VtkEncoding& encoding) {
  std::vector<Piece> pieces;
  VtkXml xml(bytes, encoding.source);
  std::string_view section;
  bool isVtk = false, isWhole = false;
  while (const auto element = xml.next()) {
    const std::string_view name = element->name;
    if (name == "VTKFile") {
      readFileTag(*element, encoding);
      isVtk = true;
    } else if (name == "Piece") {
      pieces.push_back({countOf(*element, "NumberOfPoints", encoding.source), {}, {}});
    } else if (name == "AppendedData") {
      readAppendedTag(*element, encoding);
    } else if (name == "Points" || name == "PointData" || name == "Cells" || name == "CellData") {
      section = name;
    } else if (name == "/UnstructuredGrid") {
      isWhole = true;
    } else if (name == "/Points" || name == "/PointData") {
      section = {};
    } else if (name == "DataArray" && !pieces.empty()) {
      if (section == "Points") pieces.back().points = *element;
      if (section == "PointData" && element->attribute("Name") == "type")
        pieces.back().type = *element;
    }
  }
  if (!isVtk)
    throw InputError(encoding.source + ": is no VTK file in XML; export the particles as .vtu");
  if (!isWhole)
    throw InputError(encoding.source + ": its grid does not end: truncated? export it again");
  return pieces;
}

/// For each point whether it is a wall; empty if the file does not say so.
std::vector<bool> wallsOf(const Piece& piece, const VtkEncoding& encoding) {
  if (!piece.type || piece.type->attribute("NumberOfComponents").value_or("1") != "1") return {};
  const std::vector<double> type = readVtkArray(*piece.type, piece.nPoints, encoding);
  std::vector<bool> isWall(type.size());
  for (std::size_t k = 0; k < type.size(); ++k) {
    if (type[k] != 0 && type[k] != 1) return {};
    isWall[k] = type[k] == 1;
  }
  return isWall;
}

void addPiece(const Piece& piece, const VtkEncoding& encoding, FilePoints& result) {
  if (piece.nPoints == 0) return;
  if (!piece.points)
    throw InputError(encoding.source + ": has a piece without Points; export it again");
  if (piece.points->attribute("NumberOfComponents").value_or("") != "3")
    throw InputError(encoding.source +
                     ": its points have not three components each; export it again");
  if (piece.nPoints > std::size_t{1} << 32)
    throw InputError(fmt::format("{}: says that it has {} points, more than 2^32: damaged?",
                                 encoding.source, piece.nPoints));
  const std::vector<double> x = readVtkArray(*piece.points, 3 * piece.nPoints, encoding);
  const std::vector<bool> isWall = wallsOf(piece, encoding);
  for (std::size_t k = 0; k < piece.nPoints; ++k) {
    if (!isWall.empty() && isWall[k])
      ++result.nWalls;
    else
      result.positions.push_back({{x[3 * k], x[3 * k + 1], x[3 * k + 2]}});
  }
}

}  // namespace

FilePoints readVtuPoints(std::string_view bytes, const std::string& source) {
  VtkEncoding encoding;
  encoding.source = source;
  const std::vector<Piece> pieces = readTags(bytes, encoding);
  FilePoints result;
  for (const Piece& piece : pieces) addPiece(piece, encoding, result);
  return result;
}

}  // namespace plenum
