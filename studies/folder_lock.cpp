// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/folder_lock.hpp"

#include "particles/errors.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace plenum::study {

FolderLock::FolderLock(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw RunError(fmt::format("{}: cannot be made: {}; name another folder with -o",
                               folder.string(), error.message()));
  const std::filesystem::path path = folder / ".lock";
  file_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0)
    throw RunError(fmt::format("{}: cannot be written: {}; name another folder with -o",
                               path.string(), std::strerror(errno)));
  if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  close(file_);
  throw InputError(
      fmt::format("{}: another study is running here; wait for it, or name another "
                  "folder with -o",
                  folder.string()));
}

FolderLock::~FolderLock() { close(file_); }

}  // namespace plenum::study
