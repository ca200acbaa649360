// SPDX-License-Identifier: BSD-3-Clause
#include "compression.h"

#include <slalom/core/error.h>

#include <memory>
#include <zstd.h>

namespace slalom {
namespace {

/// A zstd block of 4 bytes expands to at most 128 KiB: a larger announced size is invalid.
constexpr unsigned long long kMaxExpansion = 32768;

}  // namespace

std::string compress(const std::string& bytes, int level) {
  // Used again: to allocate it takes longer than to compress a run.
  thread_local const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(),
                                                                                  ZSTD_freeCCtx);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  std::string result(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress2(context.get(), result.data(), result.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size) != 0) throw job_error("compression", ZSTD_getErrorName(size));
  result.resize(size);
  return result;
}

std::string decompress_head(const std::string& bytes, std::size_t size) {
  const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(),
                                                                     ZSTD_freeDCtx);
  std::string head(size, '\0');
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  ZSTD_outBuffer out{head.data(), head.size(), 0};
  while (out.pos < out.size && in.pos < in.size)
    if (ZSTD_isError(ZSTD_decompressStream(context.get(), &out, &in)) != 0) break;
  head.resize(out.pos);
  return head;
}

std::string decompress(const std::string& bytes, const std::string& where, std::size_t max_size) {
  const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN || size > max_size ||
      size > kMaxExpansion * bytes.size())
    throw file_error(where, "is damaged (invalid size)", "content written by Slalom");
  std::string result(static_cast<std::size_t>(size), '\0');
  const std::size_t got = ZSTD_decompress(result.data(), result.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(got) != 0 || got != size)
    throw file_error(where, "is damaged (" + std::string(ZSTD_getErrorName(got)) + ")",
                     "content written by Slalom");
  return result;
}

}  // namespace slalom
