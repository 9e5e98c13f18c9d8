// SPDX-License-Identifier: GPL-3.0-or-later
//
// As much of HDF5 as particle files need, over its C interface: handles that close themselves and
// errors that name file and dataset. Only particles/*.cpp include this.
#pragma once

#include <hdf5.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace plenum::hdf5 {

/// Owns an HDF5 identifier.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Handle() = default;
  Handle(hid_t id, Close closeWith) : id_(id), close_(closeWith) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() { close(); }

  bool valid() const { return id_ >= 0; }
  hid_t get() const { return id_; }
  /// False if HDF5 could not close the object, for instance because the disk is full.
  bool close() { return id_ < 0 || close_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// The type of a number, in memory and in the file.
template <class T>
hid_t typeOf();
template <>
hid_t typeOf<double>();
template <>
hid_t typeOf<std::int8_t>();
template <>
hid_t typeOf<std::uint8_t>();
template <>
hid_t typeOf<std::int32_t>();
template <>
hid_t typeOf<std::uint32_t>();
template <>
hid_t typeOf<std::int64_t>();
template <>
hid_t typeOf<std::uint64_t>();

/// Texts of one length, the longest. Not HDF5's texts of variable length: the library crashes when
/// the heap that holds them is damaged.
Handle textType(std::size_t length, H5T_cset_t set = H5T_CSET_UTF8);

/// Where messages come from and which kind of error they are.
struct Origin {
  std::string file;
  bool writing = false;
  std::uintmax_t bytes = 0;  ///< size of a file that is read; no contiguous array can be larger

  /// Throws RunError when writing, InputError when reading, with the reason that HDF5 gives.
  [[noreturn]] void fail(const std::string& what) const;
};

/// A group of a file (the root group is one too). Names may be paths ("Plenum/Walls").
class Group {
 public:
  Group(Handle handle, std::string path, const Origin& origin)
      : handle_(std::move(handle)), path_(std::move(path)), origin_(&origin) {}

  Group create(const std::string& name) const;
  Group open(const std::string& name) const;
  bool has(const std::string& name) const;

  /// A contiguous dataset of shape (n) or, if columns > 1 or `table`, (n, columns).
  template <class T>
  void write(const std::string& name, std::span<const T> values, int columns = 1) const {
    writeRaw(name, typeOf<T>(), values.data(), shapeFor(values.size(), columns));
  }
  /// The same for numbers that stand in memory nowhere: fill(first row, rows) makes some rows at a
  /// time.
  template <class T, class Fill>
  void writePieces(const std::string& name, std::size_t nRows, int columns, Fill&& fill) const {
    const auto width = static_cast<std::size_t>(columns);
    Handle set = createDataset(name, typeOf<T>(), shapeFor(nRows * width, columns), false);
    std::vector<T> piece;
    for (std::size_t first = 0; first < nRows; first += rowsPerPiece) {
      piece.resize(std::min(rowsPerPiece, nRows - first) * width);
      fill(first, std::span<T>(piece));
      writeRows(name, set, typeOf<T>(), piece.data(), {first, piece.size() / width});
    }
    finish(name, set);
  }
  /// The same in gzip-compressed chunks.
  template <class T>
  void writeCompressed(const std::string& name, std::span<const T> values) const {
    writeRaw(name, typeOf<T>(), values.data(), shapeFor(values.size(), 1), true);
  }
  void writeText(const std::string& name, const std::string& text) const;
  void writeTexts(const std::string& name, const std::vector<std::string>& texts) const;

  /// A second name for `target` of `group`: the same data, no copy.
  void link(const std::string& name, const Group& group, const std::string& target) const;

  /// Attributes of this group, or of the dataset `of`.
  template <class T>
  void setAttribute(const std::string& name, T value, const std::string& of = ".") const {
    setRaw(name, typeOf<T>(), &value, 0, of);
  }
  template <class T>
  void setAttributes(const std::string& name, std::span<const T> values) const {
    setRaw(name, typeOf<T>(), values.data(), values.size(), ".");
  }
  void setText(const std::string& name, const std::string& text, const std::string& of = ".") const;
  void setTexts(const std::string& name, const std::vector<std::string>& texts) const;
  /// VTK wants ASCII, not UTF-8.
  void setAsciiText(const std::string& name, const std::string& text) const;

  /// The lengths along the axes of a dataset. Throws InputError if it is missing.
  std::vector<hsize_t> shape(const std::string& name) const;
  /// A dataset of exactly (n) or (n, columns) numbers. Throws InputError.
  template <class T>
  std::vector<T> read(const std::string& name, std::size_t n, int columns = 1) const {
    checkShape(name, shapeFor(n * static_cast<std::size_t>(columns), columns));
    std::vector<T> values(n * static_cast<std::size_t>(columns));
    readRaw(name, typeOf<T>(), values.data());
    return values;
  }
  std::string readText(const std::string& name) const;
  std::vector<std::string> readTexts(const std::string& name) const;

  bool hasAttribute(const std::string& name) const;
  template <class T>
  T attribute(const std::string& name) const {
    T value{};
    getRaw(name, typeOf<T>(), &value, 1);
    return value;
  }
  template <class T>
  std::vector<T> attributes(const std::string& name, std::size_t n) const {
    std::vector<T> values(n);
    getRaw(name, typeOf<T>(), values.data(), n);
    return values;
  }
  std::string text(const std::string& name) const;
  std::vector<std::string> texts(const std::string& name) const;

  [[noreturn]] void fail(const std::string& name, const std::string& what) const;

 private:
  static constexpr std::size_t rowsPerPiece = 1u << 16;

  std::vector<std::string> readAllTexts(const std::string& name, std::size_t n) const;
  static std::vector<hsize_t> shapeFor(std::size_t n, int columns);
  std::string pathOf(const std::string& name) const;
  Handle dataset(const std::string& name) const;
  Handle openAttribute(const std::string& name) const;
  void checkShape(const std::string& name, const std::vector<hsize_t>& wanted) const;
  void writeRaw(const std::string& name, hid_t type, const void* data,
                const std::vector<hsize_t>& shape, bool compressed = false) const;
  Handle createDataset(const std::string& name, hid_t type, const std::vector<hsize_t>& shape,
                       bool compressed) const;
  struct Rows {
    hsize_t first;
    hsize_t count;
  };
  void writeRows(const std::string& name, const Handle& set, hid_t type, const void* data,
                 Rows rows) const;
  void finish(const std::string& name, Handle& set) const;
  void readRaw(const std::string& name, hid_t type, void* data) const;
  void setRaw(const std::string& name, hid_t type, const void* data, std::size_t n,
              const std::string& of) const;
  void getRaw(const std::string& name, hid_t type, void* data, std::size_t n) const;

  Handle handle_;
  std::string path_;
  const Origin* origin_;
};

/// An HDF5 file. HDF5's own printing of errors is turned off, and so is its cleaning up when the
/// program ends: HDF5 1.10 crashes there if a file could not be closed because of a disk error.
class File {
 public:
  /// Creates or empties `path`; messages name `shownAs`. Throws RunError.
  static File create(const std::filesystem::path& path, const std::filesystem::path& shownAs);
  /// Opens for reading. Throws InputError for a missing, truncated or other kind of file.
  static File open(const std::filesystem::path& path);

  const Group& root() const { return root_; }
  const Origin& origin() const { return *origin_; }
  /// Closes a file that was written and returns its length [bytes]. Throws RunError if what was
  /// written could not be brought to the file.
  std::uintmax_t close();

 private:
  File(Handle handle, std::unique_ptr<Origin> origin);
  static Group rootOf(const Handle& file, const Origin& origin);

  std::unique_ptr<Origin> origin_;
  Handle handle_;
  Group root_;
};

}  // namespace plenum::hdf5
