// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/hdf5.hpp"

#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

Handle variableText() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), H5T_VARIABLE);
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  return type;
}

Handle space(const std::vector<hsize_t>& shape) {
  return shape.empty()
             ? Handle(H5Screate(H5S_SCALAR), H5Sclose)
             : Handle(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                      H5Sclose);
}

std::vector<const char*> pointersTo(const std::vector<std::string>& texts) {
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  return pointers;
}

/// Moves strings that HDF5 allocated into ours.
std::vector<std::string> taken(const std::vector<char*>& pointers) {
  std::vector<std::string> texts;
  for (char* pointer : pointers) {
    texts.emplace_back(pointer == nullptr ? "" : pointer);
    H5free_memory(pointer);
  }
  return texts;
}

constexpr hsize_t chunkLength = 1u << 16;

}  // namespace

void Origin::fail(const std::string& what) const {
  const Reason reason = lastReason();
  if (writing && reason.error != 0) throw RunError(writeFailure(file, reason.error));
  const std::string because = reason.text.empty() ? "" : " (HDF5: " + reason.text + ")";
  if (writing) throw RunError(fmt::format("{}: {}{}", file, what, because));
  throw InputError(fmt::format("{}: {}{}; generate the particle file again", file, what, because));
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
  Handle group(H5Gcreate2(handle_.get(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
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

void Group::writeRaw(const std::string& name, hid_t type, const void* data,
                     const std::vector<hsize_t>& shape, bool compressed) const {
  const Handle dataSpace = space(shape);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  if (compressed && shape[0] > 0) {
    const hsize_t chunk = std::min(shape[0], chunkLength);
    H5Pset_chunk(properties.get(), 1, &chunk);
    H5Pset_deflate(properties.get(), 6);
  }
  Handle set(H5Dcreate2(handle_.get(), name.c_str(), type, dataSpace.get(), H5P_DEFAULT,
                        properties.get(), H5P_DEFAULT),
             H5Dclose);
  if (!set.valid() || H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0 ||
      !set.close())
    fail(name, "cannot be written");
}

void Group::writeText(const std::string& name, const std::string& text) const {
  const char* pointer = text.c_str();
  writeRaw(name, variableText().get(), &pointer, {});
}

void Group::writeTexts(const std::string& name, const std::vector<std::string>& texts) const {
  const auto pointers = pointersTo(texts);
  writeRaw(name, variableText().get(), pointers.data(), {pointers.size()});
}

void Group::link(const std::string& name, const Group& group, const std::string& target) const {
  if (H5Lcreate_hard(group.handle_.get(), target.c_str(), handle_.get(), name.c_str(), H5P_DEFAULT,
                     H5P_DEFAULT) < 0)
    fail(name, "cannot be written");
}

void Group::setRaw(const std::string& name, hid_t type, const void* data, std::size_t n,
                   const std::string& of) const {
  const Handle dataSpace = space(n == 0 ? std::vector<hsize_t>{} : std::vector<hsize_t>{n});
  Handle attribute(H5Acreate_by_name(handle_.get(), of.c_str(), name.c_str(), type, dataSpace.get(),
                                     H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose);
  if (!attribute.valid() || H5Awrite(attribute.get(), type, data) < 0 || !attribute.close())
    fail(of, "cannot take the attribute " + name);
}

void Group::setText(const std::string& name, const std::string& text, const std::string& of) const {
  const char* pointer = text.c_str();
  setRaw(name, variableText().get(), &pointer, 0, of);
}

void Group::setTexts(const std::string& name, const std::vector<std::string>& texts) const {
  const auto pointers = pointersTo(texts);
  setRaw(name, variableText().get(), pointers.data(), pointers.size(), ".");
}

void Group::setFixedText(const std::string& name, const std::string& text) const {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), text.size());
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  setRaw(name, type.get(), text.data(), 0, ".");
}

Handle Group::dataset(const std::string& name) const {
  if (!has(name)) fail(name, "is missing");
  Handle set(H5Dopen2(handle_.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set.valid()) fail(name, "cannot be read as a dataset");
  return set;
}

std::vector<hsize_t> Group::shape(const std::string& name) const {
  const Handle set = dataset(name);
  const Handle dataSpace(H5Dget_space(set.get()), H5Sclose);
  const int rank = dataSpace.valid() ? H5Sget_simple_extent_ndims(dataSpace.get()) : -1;
  if (rank < 0) fail(name, "has no readable shape");
  std::vector<hsize_t> lengths(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(dataSpace.get(), lengths.data(), nullptr);
  // A damaged length must not make us allocate the moon: zlib never shrinks more than 1032-fold.
  double elements = 1;
  for (hsize_t length : lengths) elements *= static_cast<double>(length);
  const Handle properties(H5Dget_create_plist(set.get()), H5Pclose);
  const bool chunked = H5Pget_layout(properties.get()) == H5D_CHUNKED;
  if (elements > static_cast<double>(origin_->bytes) * (chunked ? 1032 : 1))
    fail(name, "claims more values than the file can hold");
  return lengths;
}

void Group::checkShape(const std::string& name, const std::vector<hsize_t>& wanted) const {
  const std::vector<hsize_t> found = shape(name);
  if (found != wanted)
    fail(name, fmt::format("has the shape ({}), must have ({})", fmt::join(found, ", "),
                           fmt::join(wanted, ", ")));
}

void Group::readRaw(const std::string& name, hid_t type, void* data) const {
  const Handle set = dataset(name);
  if (H5Dread(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
    fail(name, "cannot be read");
}

std::string Group::readText(const std::string& name) const {
  if (!shape(name).empty()) fail(name, "is not one text");
  std::vector<char*> pointer(1);
  readRaw(name, variableText().get(), pointer.data());
  return taken(pointer)[0];
}

std::vector<std::string> Group::readTexts(const std::string& name) const {
  const std::vector<hsize_t> lengths = shape(name);
  if (lengths.size() != 1) fail(name, "is not a list of texts");
  std::vector<char*> pointers(lengths[0]);
  readRaw(name, variableText().get(), pointers.data());
  return taken(pointers);
}

Handle Group::openAttribute(const std::string& name) const {
  Handle attribute(H5Aopen(handle_.get(), name.c_str(), H5P_DEFAULT), H5Aclose);
  if (!attribute.valid()) {
    H5Eclear2(H5E_DEFAULT);
    fail(".", "lacks the attribute " + name);
  }
  return attribute;
}

void Group::getRaw(const std::string& name, hid_t type, void* data, std::size_t n) const {
  const Handle attribute = openAttribute(name);
  const Handle dataSpace(H5Aget_space(attribute.get()), H5Sclose);
  const hssize_t found = H5Sget_simple_extent_npoints(dataSpace.get());
  if (found != static_cast<hssize_t>(n))
    fail(".", fmt::format("has an attribute {} of {} values, must have {}", name, found, n));
  if (H5Aread(attribute.get(), type, data) < 0)
    fail(".", "has an attribute " + name + " that cannot be read");
}

std::string Group::text(const std::string& name) const {
  std::vector<char*> pointer(1);
  getRaw(name, variableText().get(), pointer.data(), 1);
  return taken(pointer)[0];
}

std::vector<std::string> Group::texts(const std::string& name) const {
  const Handle attribute = openAttribute(name);
  const Handle dataSpace(H5Aget_space(attribute.get()), H5Sclose);
  const hssize_t n = H5Sget_simple_extent_npoints(dataSpace.get());
  if (n < 0 || n > 4096) fail(".", "has an attribute " + name + " that cannot be read");
  std::vector<char*> pointers(static_cast<std::size_t>(n));
  if (n > 0) getRaw(name, variableText().get(), pointers.data(), pointers.size());
  return taken(pointers);
}

File::File(Handle handle, std::unique_ptr<Origin> origin)
    : origin_(std::move(origin)), handle_(std::move(handle)), root_(rootOf(handle_, *origin_)) {}

Group File::rootOf(const Handle& file, const Origin& origin) {
  Handle group(H5Gopen2(file.get(), "/", H5P_DEFAULT), H5Gclose);
  if (!group.valid()) origin.fail("is damaged: it has no root group");
  return Group(std::move(group), "/", origin);
}

File File::create(const fs::path& path, const fs::path& shownAs) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  auto origin = std::make_unique<Origin>(Origin{shownAs.string(), true, 0});
  Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  if (!file.valid()) origin->fail("cannot be written");
  return File(std::move(file), std::move(origin));
}

File File::open(const fs::path& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
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
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.valid())
    origin->fail(fmt::format("is truncated or damaged ({} bytes are there)", origin->bytes));
  return File(std::move(file), std::move(origin));
}

void File::close() {
  const bool flushed = H5Fflush(handle_.get(), H5F_SCOPE_LOCAL) >= 0;
  if (!flushed) origin_->fail("cannot be written");
  root_ = Group(Handle(), "/", *origin_);
  if (!handle_.close()) origin_->fail("cannot be written");
}

}  // namespace plenum::hdf5
