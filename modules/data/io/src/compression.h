// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// zstd with a checksum; deterministic. `level`: of zstd, 1 (fast) to 19 (small).
std::string compress(const std::string& bytes, int level = 3);

/// The first bytes of a content that was compressed by zstd, at most `size`, of the first bytes of
/// the result: kHeadOfBlock of them suffice. Fewer if these are damaged or nothing of the kind.
std::string decompress_head(const std::string& bytes, std::size_t size);
constexpr std::size_t kHeadOfBlock = 1 << 18;

/// Throws Error (File) at `where` when the bytes are damaged or would decompress to more than
/// `max_size` bytes.
std::string decompress(const std::string& bytes, const std::string& where,
                       std::size_t max_size = std::size_t{1} << 30);

}  // namespace slalom
