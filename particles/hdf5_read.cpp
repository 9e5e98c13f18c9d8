// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/hdf5.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace plenum::hdf5 {

namespace {

std::vector<std::string> unpacked(const std::string& bytes, std::size_t length) {
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < bytes.size(); at += length) {
    const std::string text = bytes.substr(at, length);
    texts.push_back(text.substr(0, text.find('\0')));
  }
  return texts;
}

/// Length of the texts of a type, or 0 if it is not one of ours.
std::size_t textLength(const Handle& type) {
  if (!type.valid() || H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0)
    return 0;
  return H5Tget_size(type.get());
}

}  // namespace

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
  return readAllTexts(name, 1)[0];
}

std::vector<std::string> Group::readTexts(const std::string& name) const {
  const std::vector<hsize_t> lengths = shape(name);
  if (lengths.size() != 1) fail(name, "is not a list of texts");
  return readAllTexts(name, lengths[0]);
}

std::vector<std::string> Group::readAllTexts(const std::string& name, std::size_t n) const {
  const Handle set = dataset(name);
  const std::size_t length = textLength(Handle(H5Dget_type(set.get()), H5Tclose));
  if (length == 0) fail(name, "is not text of fixed length");
  if (static_cast<double>(n) * static_cast<double>(length) > static_cast<double>(origin_->bytes))
    fail(name, "claims more text than the file can hold");
  std::string bytes(n * length, '\0');
  readRaw(name, textType(length).get(), bytes.data());
  return unpacked(bytes, length);
}

bool Group::hasAttribute(const std::string& name) const {
  return H5Aexists(handle_.get(), name.c_str()) > 0;
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
  const std::vector<std::string> all = texts(name);
  if (all.size() != 1) fail(".", "has an attribute " + name + " that is not one text");
  return all[0];
}

std::vector<std::string> Group::texts(const std::string& name) const {
  const Handle attribute = openAttribute(name);
  const Handle dataSpace(H5Aget_space(attribute.get()), H5Sclose);
  const hssize_t n = H5Sget_simple_extent_npoints(dataSpace.get());
  const std::size_t length = textLength(Handle(H5Aget_type(attribute.get()), H5Tclose));
  constexpr hssize_t most = 65536;  // bytes that HDF5 lets an attribute have
  if (n < 0 || n > most || length == 0 || static_cast<hssize_t>(length) > most)
    fail(".", "has an attribute " + name + " that is not text of fixed length");
  std::string bytes(static_cast<std::size_t>(n) * length, '\0');
  if (n > 0) getRaw(name, textType(length).get(), bytes.data(), static_cast<std::size_t>(n));
  return unpacked(bytes, length);
}

}  // namespace plenum::hdf5
