// SPDX-License-Identifier: BSD-3-Clause
#include "gzip.h"

#include <slalom/core/error.h>

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>
#include <utility>
#include <zlib.h>

namespace slalom {
namespace {

constexpr std::size_t kChunkSize = std::size_t(1) << 16;
constexpr int kGzip = 15 + 16;  // zlib: maximum window size, gzip header
constexpr int kLevel = 1;       // as used by MRPT

bool is_gzip(const std::string& bytes) {
  return bytes.size() >= 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b';
}

/// RAII wrapper of an inflate stream.
struct InflateStream {
  z_stream stream{};
  InflateStream() {
    if (inflateInit2(&stream, kGzip) != Z_OK) throw std::bad_alloc();
  }
  ~InflateStream() { inflateEnd(&stream); }
  InflateStream(const InflateStream&) = delete;
  InflateStream& operator=(const InflateStream&) = delete;
};

}  // namespace

struct GzipWriter::State {
  z_stream stream{};
};

GzipWriter::GzipWriter() : state_(std::make_unique<State>()) {
  constexpr int kMemory = 8;
  if (deflateInit2(&state_->stream, kLevel, Z_DEFLATED, kGzip, kMemory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
}

GzipWriter::~GzipWriter() {
  deflateEnd(&state_->stream);
}

void GzipWriter::write(const void* data, std::size_t size) {
  const auto* bytes = static_cast<const Bytef*>(data);
  while (size > 0) {
    const std::size_t part = std::min(size, kChunkSize);
    state_->stream.next_in = const_cast<Bytef*>(bytes);
    state_->stream.avail_in = static_cast<uInt>(part);
    deflate_pending(Z_NO_FLUSH);
    bytes += part;
    size -= part;
  }
}

std::string GzipWriter::finish() {
  state_->stream.avail_in = 0;
  deflate_pending(Z_FINISH);
  return std::move(file_);
}

void GzipWriter::deflate_pending(int flush) {
  std::array<char, kChunkSize> out{};
  do {
    state_->stream.next_out = reinterpret_cast<Bytef*>(out.data());
    state_->stream.avail_out = static_cast<uInt>(out.size());
    if (deflate(&state_->stream, flush) == Z_STREAM_ERROR)
      throw std::logic_error("gzip: bad state");
    file_.append(out.data(), out.size() - state_->stream.avail_out);
  } while (state_->stream.avail_out == 0);
}

std::string gunzip(const std::string& bytes, std::size_t limit, const std::string& where) {
  if (!is_gzip(bytes)) return bytes;
  InflateStream in;
  in.stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  std::size_t left = bytes.size();
  std::string content;
  std::array<char, kChunkSize> out{};
  for (int status = Z_OK; status != Z_STREAM_END;) {
    if (in.stream.avail_in == 0) {
      in.stream.avail_in = static_cast<uInt>(std::min(left, kChunkSize));
      left -= in.stream.avail_in;
    }
    in.stream.next_out = reinterpret_cast<Bytef*>(out.data());
    in.stream.avail_out = static_cast<uInt>(out.size());
    status = inflate(&in.stream, Z_NO_FLUSH);
    if (status == Z_BUF_ERROR) throw file_error(where, "is truncated", "a complete rawlog");
    if (status != Z_OK && status != Z_STREAM_END)
      throw file_error(where, "corrupt compressed data", "a rawlog");
    content.append(out.data(), out.size() - in.stream.avail_out);
    if (content.size() > limit)
      throw file_error(where, "is larger than " + std::to_string(limit >> 20) + " MiB uncompressed",
                       "a smaller rawlog");
  }
  return content;
}

}  // namespace slalom
