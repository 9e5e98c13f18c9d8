// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/key.hpp"

#include "particles/errors.hpp"

#include <fmt/format.h>

#include <fstream>
#include <vector>

namespace plenum::study {

void Key::addBytes(std::string_view bytes) {
  for (const char byte : bytes) {
    state_ ^= static_cast<unsigned char>(byte);
    state_ *= 0x100000001b3u;
  }
}

void Key::add(std::string_view text) {
  addBytes(fmt::format("{}:", text.size()));
  addBytes(text);
}

void Key::addFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("{}: cannot be read", path.string()));
  std::vector<char> part(1 << 16);
  while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0)
    addBytes({part.data(), static_cast<std::size_t>(file.gcount())});
  add("end of file");
}

std::string Key::text() const { return fmt::format("{:016x}", state_); }

}  // namespace plenum::study
