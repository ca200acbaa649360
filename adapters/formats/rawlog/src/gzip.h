// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace slalom {

/// Compresses a stream of bytes into a .gz file in memory, without a timestamp.
class GzipWriter {
 public:
  GzipWriter();
  ~GzipWriter();
  GzipWriter(const GzipWriter&) = delete;
  GzipWriter& operator=(const GzipWriter&) = delete;

  void write(const void* data, std::size_t size);
  std::string finish();  ///< the complete file; do not write afterwards

 private:
  struct State;
  void deflate_pending(int flush);

  std::unique_ptr<State> state_;
  std::string file_;
};

/// The content of a .gz file, or `bytes` if they are not compressed. Verifies the checksum and
/// returns at most `limit` bytes. Throws Error (File) with location `where`.
std::string gunzip(const std::string& bytes, std::size_t limit, const std::string& where);

}  // namespace slalom
