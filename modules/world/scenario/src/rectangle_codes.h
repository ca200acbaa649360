// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace slalom {

/// Codes of extents (cells) in tables of free rectangles: code i means kExtents[i], and less than
/// the next; 0 is an occupied cell. Each extent but 1 is at most twice an earlier one.
constexpr std::array<std::uint8_t, 16> kExtents = {0,  1,  2,  3,  4,  6,  8,   12,
                                                   16, 24, 32, 48, 64, 96, 128, 192};

constexpr std::size_t kCodes = kExtents.size();

/// A run of an extent is free when two of extent `half` are, the second `offset` cells on.
struct Doubling {
  std::size_t half = 0;
  int offset = 0;
};

constexpr std::array<Doubling, kCodes> make_doublings() {
  std::array<Doubling, kCodes> doublings = {};
  for (std::size_t code = 2; code < kCodes; ++code) {
    std::size_t half = 1;
    while (2 * kExtents[half] < kExtents[code]) ++half;
    doublings[code] = {half, kExtents[code] - kExtents[half]};
  }
  return doublings;
}
constexpr std::array<Doubling, kCodes> kDoublings = make_doublings();

/// How many rows of runs of an extent are needed to find those of the others, a power of two.
constexpr unsigned kept_rows(std::size_t code) {
  unsigned rows = 1;
  for (const Doubling& doubling : kDoublings)
    while (doubling.half == code && rows <= static_cast<unsigned>(doubling.offset)) rows *= 2;
  return rows;
}

/// First row of an extent, in rows of all extents.
constexpr std::size_t first_row(std::size_t code) {
  std::size_t rows = 0;
  for (std::size_t i = 1; i < code; ++i) rows += kept_rows(i);
  return rows;
}

constexpr std::size_t kAllRows = first_row(kCodes);

/// Scores of the rectangles with these codes of height and width: 1 to 127, the higher the better,
/// 0 when empty.
struct RectangleScores {
  alignas(16) std::int8_t score[kCodes][kCodes] = {};
  RectangleScores();
};

}  // namespace slalom
