// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace plenum {

/// `nBytes` bytes as VTK's vtkZLibDataCompressor lays them out: a header of UInt64 (number of
/// blocks, bytes a block, bytes of a last short block or 0, compressed bytes of each block), then
/// the blocks. Blocks are compressed in parallel; the result does not depend on the threads.
std::string vtkCompressed(const void* data, std::size_t nBytes);

}  // namespace plenum
