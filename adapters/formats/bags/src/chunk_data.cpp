// SPDX-License-Identifier: BSD-3-Clause
#include "chunk_data.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <bzlib.h>
#include <fstream>
#include <lz4frame.h>
#include <memory>
#include <new>
#include <zstd.h>

namespace slalom {
namespace {

/// Decompresses to `out`, and returns the number of bytes, or -1 if they are damaged.
std::int64_t inflate_zstd(std::string_view packed, std::string& out) {
  const std::size_t size = ZSTD_decompress(out.data(), out.size(), packed.data(), packed.size());
  return ZSTD_isError(size) != 0 ? -1 : static_cast<std::int64_t>(size);
}

std::int64_t inflate_lz4(std::string_view packed, std::string& out) {
  LZ4F_dctx* created = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&created, LZ4F_VERSION)) != 0)
    throw std::bad_alloc();
  const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> context(
      created, LZ4F_freeDecompressionContext);
  std::size_t written = 0, read = 0;
  for (std::size_t hint = 1; hint != 0;) {
    std::size_t to = out.size() - written, from = packed.size() - read;
    hint =
        LZ4F_decompress(created, out.data() + written, &to, packed.data() + read, &from, nullptr);
    if (LZ4F_isError(hint) != 0 || (to == 0 && from == 0 && hint != 0)) return -1;
    written += to;
    read += from;
  }
  return static_cast<std::int64_t>(written);
}

std::int64_t inflate_bz2(std::string_view packed, std::string& out) {
  auto size = static_cast<unsigned>(out.size());
  const int status = BZ2_bzBuffToBuffDecompress(out.data(), &size, const_cast<char*>(packed.data()),
                                                static_cast<unsigned>(packed.size()), 0, 0);
  return status == BZ_OK ? static_cast<std::int64_t>(size) : -1;
}

/// Decompresses frames of zstd that come in pieces.
class ZstdStream {
 public:
  ZstdStream() {
    if (!context_) throw std::bad_alloc();
  }

  /// Calls use(part) for what the bytes give; false if they are damaged, or if `use` returns false.
  bool add(std::string_view packed, const std::function<bool(std::string_view)>& use) {
    ZSTD_inBuffer in{packed.data(), packed.size(), 0};
    bool is_full = true;
    while (in.pos < in.size || (is_full && state_ != 0)) {
      ZSTD_outBuffer to{part_.data(), part_.size(), 0};
      const std::size_t before = in.pos;
      state_ = ZSTD_decompressStream(context_.get(), &to, &in);
      if (ZSTD_isError(state_) != 0) return false;
      if (to.pos > 0 && !use({part_.data(), to.pos})) return false;
      if (to.pos == 0 && in.pos == before) break;
      is_full = to.pos == to.size;
    }
    return true;
  }

  bool is_at_end() const { return state_ == 0; }  ///< of a frame

 private:
  std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context_{ZSTD_createDCtx(),
                                                                   ZSTD_freeDCtx};
  std::string part_ = std::string(ZSTD_DStreamOutSize(), '\0');
  std::size_t state_ = 1;
};

}  // namespace

std::string decompress_chunk(std::string_view method, std::string_view packed, std::uint64_t size,
                             const BagPlace& place) {
  if (size > kMaxChunkSize)
    throw place.error("a chunk of " + std::to_string(size) + " bytes",
                      "at most " + std::to_string(kMaxChunkSize));
  const auto inflate = method == "zstd"  ? inflate_zstd
                       : method == "lz4" ? inflate_lz4
                       : method == "bz2" ? inflate_bz2
                                         : nullptr;
  if (inflate == nullptr)
    throw place.error("a chunk is compressed by '" + std::string(method) + "'",
                      "none, lz4, bz2 or zstd");
  std::string out(static_cast<std::size_t>(size), '\0');
  if (inflate(packed, out) != static_cast<std::int64_t>(size))
    throw place.error("a chunk cannot be decompressed");
  return out;
}

bool is_zstd(std::string_view bytes) {
  return starts_with(bytes, "\x28\xb5\x2f\xfd");
}

std::string decompress_zstd(std::string_view packed, const BagPlace& place) {
  ZstdStream stream;
  std::string out;
  const bool complete = stream.add(packed, [&](std::string_view part) {
    out += part;
    if (out.size() > kMaxChunkSize) throw place.error("it is too large uncompressed");
    return true;
  });
  if (!complete || !stream.is_at_end()) throw place.error("it cannot be decompressed");
  return out;
}

void decompress_zstd_file(const std::string& path,
                          const std::function<bool(std::string_view)>& use) {
  std::ifstream file(path, std::ios::binary);
  ZstdStream stream;
  bool wanted = true;
  const auto use_part = [&](std::string_view part) { return wanted = use(part); };
  std::string bytes(ZSTD_DStreamInSize(), '\0');
  while (wanted && file) {
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    const auto size = static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0));
    if (!stream.add(std::string_view(bytes).substr(0, size), use_part) && wanted)
      throw file_error(path, "cannot be decompressed", "a file compressed by zstd");
  }
  if (wanted && !stream.is_at_end()) throw file_error(path, "is cut off", "a complete file");
}

}  // namespace slalom
