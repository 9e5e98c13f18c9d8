// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/atomic_file.hpp"

#include "particles/errors.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace plenum {

namespace fs = std::filesystem;

namespace {

fs::path folderOf(const fs::path& path) {
  const fs::path folder = path.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

const char* remedyFor(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "free some space or write to another disk";
    case EFBIG:
      return "raise the limit on file sizes (ulimit -f) or write to another disk";
    case ENOENT:
    case ENOTDIR:
      return "create the folder first, or correct the path";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a folder in which you may write";
    case EISDIR:
      return "choose a file name";
    default:
      return "look at the disk";
  }
}

/// The rename itself must survive a power cut, so the folder is brought to the disk as well. A file
/// system that cannot do that (EINVAL) has kept the file all the same.
void syncFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

std::string writeFailure(const fs::path& path, int error) {
  std::error_code ignored;
  if ((error == ENOENT || error == ENOTDIR) && !fs::is_directory(folderOf(path), ignored))
    return fmt::format("{}: cannot be written: no such folder '{}'; {}", path.string(),
                       folderOf(path).string(), remedyFor(error));
  return fmt::format("{}: cannot be written: {}; {}", path.string(), std::strerror(error),
                     remedyFor(error));
}

AtomicFile::AtomicFile(fs::path path)
    : path_(std::move(path)),
      temporary_(path_.string() + fmt::format(".{}.tmp", static_cast<long>(::getpid()))) {
  std::error_code ignored;
  if (path_.filename().empty() || fs::is_directory(path_, ignored)) fail(EISDIR);
  if (fs::exists(path_, ignored) && !fs::is_regular_file(path_, ignored))
    throw InputError(path_.string() + ": is not a regular file and will not be replaced; choose "
                     "another name");
  descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(errno);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(temporary_.c_str());
}

void AtomicFile::write(const void* data, std::size_t nBytes) {
  const char* at = static_cast<const char*>(data);
  while (nBytes > 0) {
    const ssize_t written = ::write(descriptor_, at, nBytes);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    at += written;
    nBytes -= static_cast<std::size_t>(written);
  }
}

void AtomicFile::reserve(std::uintmax_t nBytes) {
  if (const int error = ::posix_fallocate(descriptor_, 0, static_cast<off_t>(nBytes))) fail(error);
}

void AtomicFile::trim(std::uintmax_t nBytes) {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) fail(errno);
  if (static_cast<std::uintmax_t>(status.st_size) > nBytes &&
      ::ftruncate(descriptor_, static_cast<off_t>(nBytes)) != 0)
    fail(errno);
}

void AtomicFile::commit() {
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) fail(errno);
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(errno);
  ::close(descriptor_);
  descriptor_ = -1;
  syncFolder(folderOf(path_));
}

void AtomicFile::fail(int error) const { throw RunError(writeFailure(path_, error)); }

void writeTextFile(const fs::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace plenum
