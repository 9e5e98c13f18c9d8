// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace plenum::study {

/// Keeps a folder for this process, as long as it lives: two studies that made the same run at once
/// would spoil it for each other.
class FolderLock {
 public:
  /// Makes the folder. Throws InputError if another process has it, RunError if it cannot be made.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_ = -1;
};

}  // namespace plenum::study
