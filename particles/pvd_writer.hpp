// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace plenum {

/// A time series for ParaView: a .pvd file that lists .vtu files with their times. It is complete
/// after every addition, so a run can be watched while it runs.
class PvdSeries {
 public:
  explicit PvdSeries(std::filesystem::path path) : path_(std::move(path)) {}

  /// Keeps what the file lists until `time` [s]; nothing where there is no file. Throws
  /// InputError for a file that is not a series written by this class.
  void continueUntil(double time);

  /// Adds `file`, that stands for `time` [s], and writes the .pvd anew. The .pvd names the file
  /// relative to its own folder, so that the folder can be moved. Throws RunError.
  void add(double time, const std::filesystem::path& file);

  const std::filesystem::path& path() const { return path_; }
  std::size_t size() const { return entries_.size(); }

 private:
  void write() const;

  std::filesystem::path path_;
  std::vector<std::string> entries_;  // lines of the file
};

}  // namespace plenum
