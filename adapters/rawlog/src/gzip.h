#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace slalom {

/// Compresses bytes as they come into a .gz file in memory, without the time of day in it.
class GzipWriter {
 public:
  GzipWriter();
  ~GzipWriter();
  GzipWriter(const GzipWriter&) = delete;
  GzipWriter& operator=(const GzipWriter&) = delete;

  void write(const void* data, std::size_t size);
  std::string finish();  ///< the whole file; nothing may be written afterwards

 private:
  struct State;
  void deflate_pending(int flush);

  std::unique_ptr<State> state_;
  std::string file_;
};

/// The content of a .gz file, or `bytes` themselves where they are not compressed. Checks the
/// checksum and takes no more memory than `limit` bytes. Throws Error (File) naming `where`.
std::string gunzip(const std::string& bytes, std::size_t limit, const std::string& where);

}  // namespace slalom
