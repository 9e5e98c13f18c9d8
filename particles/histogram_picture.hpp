// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plenum {

/// One histogram of a picture.
struct HistogramPanel {
  std::string title;
  std::string xName;               ///< with unit
  double lower = 0;                ///< of the first bin
  double width = 1;                ///< of a bin
  std::vector<double> share;       ///< of all values [1]
  std::vector<std::string> notes;  ///< lines beneath
};

/// Draws panels side by side as a PNG. Throws RunError if the file cannot be written.
void drawHistograms(const std::filesystem::path& path, const std::string& title,
                    const std::vector<HistogramPanel>& panels);

}  // namespace plenum
