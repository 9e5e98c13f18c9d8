// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/hdf5.hpp"

#include <algorithm>

namespace plenum::hdf5 {

namespace {

std::size_t longest(const std::vector<std::string>& texts) {
  std::size_t length = 1;
  for (const std::string& text : texts) length = std::max(length, text.size());
  return length;
}

/// All texts behind each other, each filled up with zeros.
std::string packed(const std::vector<std::string>& texts) {
  const std::size_t length = longest(texts);
  std::string bytes(texts.size() * length, '\0');
  for (std::size_t k = 0; k < texts.size(); ++k) texts[k].copy(bytes.data() + k * length, length);
  return bytes;
}

Handle space(const std::vector<hsize_t>& shape) {
  return shape.empty()
             ? Handle(H5Screate(H5S_SCALAR), H5Sclose)
             : Handle(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                      H5Sclose);
}

constexpr hsize_t chunkLength = 1u << 16;

}  // namespace

Handle Group::createDataset(const std::string& name, hid_t type, const std::vector<hsize_t>& shape,
                            bool compressed) const {
  const Handle dataSpace = space(shape);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties.get(), false);  // equal contents, equal files
  if (compressed && shape[0] > 0) {
    const hsize_t chunk = std::min(shape[0], chunkLength);
    H5Pset_chunk(properties.get(), 1, &chunk);
    H5Pset_deflate(properties.get(), 1);
  }
  Handle set(H5Dcreate2(handle_.get(), name.c_str(), type, dataSpace.get(), H5P_DEFAULT,
                        properties.get(), H5P_DEFAULT),
             H5Dclose);
  if (!set.valid()) fail(name, "cannot be written");
  return set;
}

void Group::writeRaw(const std::string& name, hid_t type, const void* data,
                     const std::vector<hsize_t>& shape, bool compressed) const {
  Handle set = createDataset(name, type, shape, compressed);
  if (H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
    fail(name, "cannot be written");
  finish(name, set);
}

void Group::writeRows(const std::string& name, const Handle& set, hid_t type, const void* data,
                      Rows rows) const {
  const Handle inFile(H5Dget_space(set.get()), H5Sclose);
  hsize_t start[2] = {0, 0};
  hsize_t count[2] = {1, 1};
  H5Sget_simple_extent_dims(inFile.get(), count, nullptr);
  start[0] = rows.first;
  count[0] = rows.count;
  const Handle inMemory(H5Screate_simple(H5Sget_simple_extent_ndims(inFile.get()), count, nullptr),
                        H5Sclose);
  if (H5Sselect_hyperslab(inFile.get(), H5S_SELECT_SET, start, nullptr, count, nullptr) < 0 ||
      H5Dwrite(set.get(), type, inMemory.get(), inFile.get(), H5P_DEFAULT, data) < 0)
    fail(name, "cannot be written");
}

void Group::finish(const std::string& name, Handle& set) const {
  if (!set.close()) fail(name, "cannot be written");
}

void Group::writeText(const std::string& name, const std::string& text) const {
  writeRaw(name, textType(text.size()).get(), packed({text}).data(), {});
}

void Group::writeTexts(const std::string& name, const std::vector<std::string>& texts) const {
  writeRaw(name, textType(longest(texts)).get(), packed(texts).data(), {texts.size()});
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
  setRaw(name, textType(text.size()).get(), packed({text}).data(), 0, of);
}

void Group::setTexts(const std::string& name, const std::vector<std::string>& texts) const {
  setRaw(name, textType(longest(texts)).get(), packed(texts).data(), texts.size(), ".");
}

void Group::setAsciiText(const std::string& name, const std::string& text) const {
  setRaw(name, textType(text.size(), H5T_CSET_ASCII).get(), text.data(), 0, ".");
}

}  // namespace plenum::hdf5
