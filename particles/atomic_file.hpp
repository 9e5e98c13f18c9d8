// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace plenum {

/// A file that appears under its final name only when it is complete: it is written as
/// "NAME.PID.tmp" in the same folder, brought to the disk (fsync) and renamed by `commit`. Without
/// `commit` the destructor removes it. A killed program leaves at most the temporary file.
class AtomicFile {
 public:
  /// Creates the temporary file. Throws RunError if the folder is missing or not writable, or if
  /// `path` is a folder, and InputError if it is a device or a pipe.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// For libraries that open files by name.
  const std::filesystem::path& temporaryPath() const { return temporary_; }
  const std::filesystem::path& path() const { return path_; }

  /// Appends bytes. Throws RunError, for instance if the disk is full.
  void write(const void* data, std::size_t nBytes);
  void write(std::string_view text) { write(text.data(), text.size()); }

  /// Takes `nBytes` of the disk now, so that a library that writes by name meets no full disk
  /// later. Throws RunError if there is not so much.
  void reserve(std::uintmax_t nBytes);
  /// Gives back what lies beyond `nBytes`. Throws RunError.
  void trim(std::uintmax_t nBytes);

  /// Gives the file its final name, replacing what had it. Throws RunError.
  void commit();

 private:
  [[noreturn]] void fail(int error) const;

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;
};

/// Writes a whole text file. Throws RunError.
void writeTextFile(const std::filesystem::path& path, std::string_view text);

/// "PATH: cannot be written: REASON; REMEDY" for a value of errno.
std::string writeFailure(const std::filesystem::path& path, int error);

}  // namespace plenum
