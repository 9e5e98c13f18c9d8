// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/vtk_blocks.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

namespace plenum {

namespace {
constexpr std::size_t blockBytes = std::size_t{256} * 1024;
/// Level 1 takes a third of the time of zlib's default and particle data come out hardly larger.
constexpr int level = 1;
/// zlib never shrinks data more than this.
constexpr std::uint64_t mostShrinking = 1032;

/// Word `k` of a header; `bytes` is long enough.
std::uint64_t headerWord(std::string_view bytes, std::size_t headerBytes, std::uint64_t k) {
  std::uint64_t word = 0;  // little endian, as this machine
  std::memcpy(&word, bytes.data() + k * headerBytes, headerBytes);
  return word;
}

/// n * valueBytes, if data of that length can stand in `bytes`.
std::optional<std::uint64_t> totalBytes(std::string_view bytes, std::size_t n,
                                        std::size_t valueBytes) {
  if (n > bytes.size() * mostShrinking) return std::nullopt;
  return std::uint64_t{n} * valueBytes;
}
}  // namespace

std::string vtkCompressed(const void* data, std::size_t nBytes) {
  const auto* bytes = static_cast<const Bytef*>(data);
  const std::size_t nBlocks = (nBytes + blockBytes - 1) / blockBytes;
  std::vector<std::string> blocks(nBlocks);
  bool failed = false;
#pragma omp parallel for schedule(dynamic) reduction(|| : failed)
  for (std::size_t k = 0; k < nBlocks; ++k) {
    const std::size_t n = std::min(blockBytes, nBytes - k * blockBytes);
    try {
      uLongf length = compressBound(n);
      blocks[k].resize(length);
      failed = compress2(reinterpret_cast<Bytef*>(blocks[k].data()), &length,
                         bytes + k * blockBytes, n, level) != Z_OK ||
               failed;
      blocks[k].resize(length);
    } catch (const std::bad_alloc&) {
      failed = true;
    }
  }
  if (failed) throw std::bad_alloc();
  std::vector<std::uint64_t> header{nBlocks, blockBytes, nBytes % blockBytes};
  for (const std::string& block : blocks) header.push_back(block.size());
  std::string all(reinterpret_cast<const char*>(header.data()), 8 * header.size());
  for (const std::string& block : blocks) all += block;
  return all;
}

std::optional<std::string> vtkPlain(std::string_view bytes, std::size_t headerBytes, std::size_t n,
                                    std::size_t valueBytes) {
  const auto total = totalBytes(bytes, n, valueBytes);
  if (!total || bytes.size() < headerBytes || headerWord(bytes, headerBytes, 0) != *total ||
      bytes.size() - headerBytes < *total)
    return std::nullopt;
  return std::string(bytes.substr(headerBytes, *total));
}

std::optional<std::string> vtkUncompressed(std::string_view bytes, std::size_t headerBytes,
                                           std::size_t n, std::size_t valueBytes) {
  const auto total = totalBytes(bytes, n, valueBytes);
  constexpr std::uint64_t fixedWords = 3;
  if (!total || bytes.size() < fixedWords * headerBytes) return std::nullopt;
  const auto word = [&](std::uint64_t k) { return headerWord(bytes, headerBytes, k); };
  const std::uint64_t nBlocks = word(0), whole = word(1), last = word(2);
  if (nBlocks > bytes.size() / headerBytes - fixedWords) return std::nullopt;
  if (nBlocks == 0) return *total == 0 ? std::optional(std::string()) : std::nullopt;
  // A first block that is the last may be short, so `whole` may exceed the total.
  if (whole == 0 || last > whole || nBlocks - 1 > *total / whole) return std::nullopt;
  if ((nBlocks - 1) * whole + (last == 0 ? whole : last) != *total) return std::nullopt;
  std::string data(*total, '\0');
  std::string_view rest = bytes.substr((fixedWords + nBlocks) * headerBytes);
  for (std::uint64_t k = 0; k < nBlocks; ++k) {
    const std::uint64_t length = word(fixedWords + k);
    const std::uint64_t wanted = k + 1 < nBlocks || last == 0 ? whole : last;
    uLongf got = wanted;
    if (length > rest.size() ||
        uncompress(reinterpret_cast<Bytef*>(data.data() + k * whole), &got,
                   reinterpret_cast<const Bytef*>(rest.data()), length) != Z_OK ||
        got != wanted)
      return std::nullopt;
    rest.remove_prefix(length);
  }
  return data;
}

}  // namespace plenum
