// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/hdf5.hpp"

#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace plenum::hdf5 {

namespace fs = std::filesystem;

template <>
hid_t typeOf<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
hid_t typeOf<std::int8_t>() {
  return H5T_NATIVE_INT8;
}
template <>
hid_t typeOf<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}
template <>
hid_t typeOf<std::int32_t>() {
  return H5T_NATIVE_INT32;
}
template <>
hid_t typeOf<std::uint32_t>() {
  return H5T_NATIVE_UINT32;
}
template <>
hid_t typeOf<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
hid_t typeOf<std::uint64_t>() {
  return H5T_NATIVE_UINT64;
}

namespace {

/// What HDF5 says at the innermost level of its error stack, and errno if it was a system call.
struct Reason {
  std::string text;
  int error = 0;
};

Reason lastReason() {
  Reason reason;
  const auto visit = [](unsigned, const H5E_error2_t* entry, void* data) -> herr_t {
    auto* found = static_cast<Reason*>(data);
    found->text = entry->desc == nullptr ? "" : entry->desc;
    const auto at = found->text.find("errno = ");
    if (at != std::string::npos) found->error = std::atoi(found->text.c_str() + at + 8);
    return 1;  // the innermost entry is enough
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, visit, &reason);
  return reason;
}

void prepareLibrary() {
  [[maybe_unused]] static const herr_t once = H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// Files are replaced as a whole and never changed, so locks protect nothing; some network disks
/// refuse them.
Handle withoutLocks() {
  Handle properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(properties.get(), false, true);
  return properties;
}

}  // namespace

void Origin::fail(const std::string& what) const {
  const Reason reason = lastReason();
  if (writing && reason.error != 0) throw RunError(writeFailure(file, reason.error));
  const std::string because = reason.text.empty() ? "" : " (HDF5: " + reason.text + ")";
  if (writing) throw RunError(fmt::format("{}: {}{}", file, what, because));
  throw InputError(fmt::format("{}: {}{}; generate the particle file again", file, what, because));
}

Handle textType(std::size_t length, H5T_cset_t set) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), std::max(length, std::size_t{1}));
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  H5Tset_cset(type.get(), set);
  return type;
}

void Group::fail(const std::string& name, const std::string& what) const {
  origin_->fail(pathOf(name) + " " + what);
}

std::string Group::pathOf(const std::string& name) const {
  return name == "." ? path_ : (path_ == "/" ? "/" : path_ + "/") + name;
}

std::vector<hsize_t> Group::shapeFor(std::size_t n, int columns) {
  if (columns == 1) return {n};
  return {n / static_cast<std::size_t>(columns), static_cast<hsize_t>(columns)};
}

Group Group::create(const std::string& name) const {
  const Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties.get(), false);  // equal contents, equal files
  Handle group(H5Gcreate2(handle_.get(), name.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
               H5Gclose);
  if (!group.valid()) fail(name, "cannot be written");
  return Group(std::move(group), pathOf(name), *origin_);
}

Group Group::open(const std::string& name) const {
  if (!has(name)) fail(name, "is missing");
  Handle group(H5Gopen2(handle_.get(), name.c_str(), H5P_DEFAULT), H5Gclose);
  if (!group.valid()) fail(name, "is not a group");
  return Group(std::move(group), pathOf(name), *origin_);
}

bool Group::has(const std::string& name) const {
  const bool found = H5Lexists(handle_.get(), name.c_str(), H5P_DEFAULT) > 0;
  H5Eclear2(H5E_DEFAULT);
  return found;
}

void Group::link(const std::string& name, const Group& group, const std::string& target) const {
  if (H5Lcreate_hard(group.handle_.get(), target.c_str(), handle_.get(), name.c_str(), H5P_DEFAULT,
                     H5P_DEFAULT) < 0)
    fail(name, "cannot be written");
}

File::File(Handle handle, std::unique_ptr<Origin> origin)
    : origin_(std::move(origin)), handle_(std::move(handle)), root_(rootOf(handle_, *origin_)) {}

Group File::rootOf(const Handle& file, const Origin& origin) {
  Handle group(H5Gopen2(file.get(), "/", H5P_DEFAULT), H5Gclose);
  if (!group.valid()) origin.fail("is damaged: it has no root group");
  return Group(std::move(group), "/", origin);
}

File File::create(const fs::path& path, const fs::path& shownAs) {
  prepareLibrary();
  auto origin = std::make_unique<Origin>(Origin{shownAs.string(), true, 0});
  Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, withoutLocks().get()), H5Fclose);
  if (!file.valid()) origin->fail("cannot be written");
  return File(std::move(file), std::move(origin));
}

File File::open(const fs::path& path) {
  prepareLibrary();
  const std::string name = path.string();
  std::error_code error;
  if (!fs::exists(path, error)) throw InputError(name + ": no such particle file");
  if (!fs::is_regular_file(path, error)) throw InputError(name + ": not a file");
  if (!std::ifstream(path))
    throw InputError(name + ": cannot be read: " + std::strerror(errno) + "; look at its rights");
  auto origin = std::make_unique<Origin>(Origin{name, false, fs::file_size(path)});
  if (H5Fis_hdf5(path.c_str()) <= 0)
    throw InputError(name +
                     ": not an HDF5 file; a particle file is made by 'plenum-ic generate CASE'");
  H5Eclear2(H5E_DEFAULT);
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, withoutLocks().get()), H5Fclose);
  if (!file.valid())
    origin->fail(fmt::format("is truncated or damaged ({} bytes are there)", origin->bytes));
  return File(std::move(file), std::move(origin));
}

std::uintmax_t File::close() {
  hsize_t nBytes = 0;
  if (H5Fflush(handle_.get(), H5F_SCOPE_LOCAL) < 0 || H5Fget_filesize(handle_.get(), &nBytes) < 0)
    origin_->fail("cannot be written");
  root_ = Group(Handle(), "/", *origin_);
  if (!handle_.close()) origin_->fail("cannot be written");
  return nBytes;
}

}  // namespace plenum::hdf5
