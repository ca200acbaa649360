// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bag_writers.h"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

namespace slalom::testing {

inline std::string zstd(const std::string& bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1));
  return packed;
}

inline std::string lz4(const std::string& bytes) {
  std::string packed(LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
  packed.resize(
      LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), nullptr));
  return packed;
}

inline std::string bz2(const std::string& bytes) {
  auto size = unsigned(bytes.size() + bytes.size() / 100 + 600);  // as bzlib.h demands
  std::string packed(size, '\0');
  BZ2_bzBuffToBuffCompress(packed.data(), &size, const_cast<char*>(bytes.data()),
                           unsigned(bytes.size()), 9, 0, 0);
  packed.resize(size);
  return packed;
}

}  // namespace slalom::testing
