#pragma once

#include <string>

namespace slalom {

/// zstd with a checksum; the same bytes give the same result.
std::string compress(const std::string& bytes);

/// Throws Error (File) naming `where` when the bytes are damaged or would take more than
/// `max_size`.
std::string decompress(const std::string& bytes, const std::string& where,
                       std::size_t max_size = std::size_t{1} << 30);

}  // namespace slalom
