// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of a study: one HTML file that a browser opens offline.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plenum::study {

/// Sorted by a click on a column's name: as numbers where all cells of it are.
struct PageTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

struct PagePicture {
  std::filesystem::path png;
  std::string caption;
};

/// From top to bottom: heading, paragraphs, charts, table, pictures; empty ones are left out.
struct PagePart {
  std::string heading;
  std::vector<std::string> paragraphs;
  std::vector<std::string> svgs;  ///< of svgOf
  PageTable table;
  std::vector<PagePicture> pictures;  ///< stored inside the page
};

struct Page {
  std::string title;
  std::vector<PagePart> parts;
};

/// The whole page; texts are escaped. Throws RunError for a picture that cannot be read.
std::string htmlOf(const Page& page);

}  // namespace plenum::study
