// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace plenum {

/// `nBytes` bytes as VTK's vtkZLibDataCompressor lays them out: a header of UInt64 (number of
/// blocks, bytes a block, bytes of a last short block or 0, compressed bytes of each block), then
/// the blocks. Blocks are compressed in parallel; the result does not depend on the threads.
std::string vtkCompressed(const void* data, std::size_t nBytes);

/// The `n` values of `valueBytes` bytes that `bytes` begins with, laid out as above with header
/// words of `headerBytes` (4 or 8) bytes, little endian; blocks of any size. Nothing if the data
/// are damaged, cut off or of another length: that is found out before memory is taken for them.
std::optional<std::string> vtkUncompressed(std::string_view bytes, std::size_t headerBytes,
                                           std::size_t n, std::size_t valueBytes);

/// The same for data that are not compressed: one header word, their number of bytes.
std::optional<std::string> vtkPlain(std::string_view bytes, std::size_t headerBytes, std::size_t n,
                                    std::size_t valueBytes);

}  // namespace plenum
