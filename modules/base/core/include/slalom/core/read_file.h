// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace slalom {

constexpr std::uint64_t kMegabyte = 1'000'000;

/// Maximum sizes of files that are read completely into memory.
constexpr std::uint64_t kMaxConfigSize = 16 * kMegabyte;  ///< .ini files and scripts
constexpr std::uint64_t kMaxTextSize = 1000 * kMegabyte;  ///< scenarios, trajectories, tables

/// The content of a regular file of at most `max_size` bytes. Any other file (folder, fifo, device,
/// one without an end) is refused without waiting for it and without reading more than that. Throws
/// Error (File) at `path`, with `kind`, for example "a rawlog", as what was expected.
std::string read_file(const std::string& path, const std::string& kind = "a file",
                      std::uint64_t max_size = kMaxTextSize);

/// The same of a text, without the byte order mark that some editors and spreadsheets write first.
std::string read_text(const std::string& path, const std::string& kind,
                      std::uint64_t max_size = kMaxTextSize);

/// The same of a text in UTF-8. Throws Error (File) with the line for one that is not.
std::string read_utf8(const std::string& path, const std::string& kind,
                      std::uint64_t max_size = kMaxTextSize);

/// Throws as read_file() does, without reading: for files that a library opens by their path.
void require_regular_file(const std::string& path, const std::string& kind,
                          std::uint64_t max_size = std::numeric_limits<std::uint64_t>::max());

}  // namespace slalom
