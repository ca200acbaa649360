// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// zstd with a checksum; deterministic.
std::string compress(const std::string& bytes);

/// Throws Error (File) at `where` when the bytes are damaged or would decompress to more than
/// `max_size` bytes.
std::string decompress(const std::string& bytes, const std::string& where,
                       std::size_t max_size = std::size_t{1} << 30);

}  // namespace slalom
