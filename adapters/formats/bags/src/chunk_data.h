// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/bags/bag.h>

#include <functional>
#include <string>
#include <string_view>

namespace slalom {

/// The largest chunk or message, uncompressed, bytes; those of ROS's recorders have about 1 MB.
constexpr std::uint64_t kMaxChunkSize = std::uint64_t(1) << 28;

/// Decompresses a chunk of `size` bytes that is compressed by "zstd", "lz4" (frames) or "bz2".
/// Throws Error (File) at `place` if it is damaged, of another size, or too large.
std::string decompress_chunk(std::string_view method, std::string_view packed, std::uint64_t size,
                             const BagPlace& place);

/// Whether bytes begin as a frame of zstd (RFC 8878, section 3.1.1).
bool is_zstd(std::string_view bytes);

/// Decompresses frames of zstd of unknown size.
std::string decompress_zstd(std::string_view packed, const BagPlace& place);

/// Decompresses a file of frames of zstd part by part, until `use` returns false.
void decompress_zstd_file(const std::string& path,
                          const std::function<bool(std::string_view)>& use);

}  // namespace slalom
