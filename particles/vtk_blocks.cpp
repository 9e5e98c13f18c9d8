// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/vtk_blocks.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <vector>

namespace plenum {

namespace {
constexpr std::size_t blockBytes = std::size_t{256} * 1024;
/// Level 1 takes a third of the time of zlib's default and particle data come out hardly larger.
constexpr int level = 1;
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

}  // namespace plenum
