// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace plenum::study {

/// Names what a run depends on: FNV-1a of 64 bits over texts and files
/// (doi 10.17487/RFC9923). Not against people who want two runs to have one name.
class Key {
 public:
  /// Texts do not run together: ("ab", "c") is not ("a", "bc").
  void add(std::string_view text);
  /// The bytes of a file. Throws InputError if it cannot be read.
  void addFile(const std::filesystem::path& path);

  std::string text() const;  ///< sixteen hexadecimal digits

 private:
  void addBytes(std::string_view bytes);

  std::uint64_t state_ = 0xcbf29ce484222325u;
};

}  // namespace plenum::study
