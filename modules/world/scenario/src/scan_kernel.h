// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace slalom {

/// A sensor's pose and range, in cells where nothing else is said; positions are given in the
/// mirrored frames of a RayCaster (index 1: mirrored).
struct ScanOrigin {
  double x[2], y[2];
  double cosine, sine;             ///< of the heading
  double limit, max_range;         ///< the same in cells and in m
  double resolution;               ///< m
  std::int32_t column[2], row[2];  ///< their sum is the index of the origin's cell in the table
  std::uint8_t codes[2][2];        ///< of the free rectangles there, by mirrored x and y
  std::int32_t stride;
  int size_x, size_y;  ///< of the grid
  /// The table; null if it has more than 2^31 elements: then no ray is certain.
  const std::uint8_t* rectangles;
};

/// Rays that are cast in parallel (SIMD).
struct RayChunk {
  static constexpr int kSize = 192;
  static constexpr float kUncertain = -1;
  alignas(64) double cosine[kSize];  ///< of the directions (world)
  alignas(64) double sine[kSize];
  alignas(64) float range[kSize];  ///< m; kUncertain where single precision does not suffice
  // Scratch: the face that stops the ray, in columns (positive) or rows (negative) from the
  // origin's cell.
  alignas(64) std::int32_t face[kSize];
  static constexpr std::int32_t kNothing = 0;  ///< the limit is reached before any face
  static constexpr std::int32_t kUndecided = INT32_MIN;
};

/// Casts the first `count` rays with the widest vectors of this processor; true if some of the
/// ranges are uncertain. `cosine` and `sine` are kSize directions relative to the heading. The walk
/// from rectangle to rectangle uses single precision with an error bound, the range to the face
/// found uses double precision: the result is bit-identical with every instruction set. Cases that
/// the bound cannot decide (a crossing close to a corner, a ray almost parallel to an axis) are
/// left to the caller.
bool cast_rays(const ScanOrigin& origin, const double* cosine, const double* sine, int count,
               RayChunk& rays);

}  // namespace slalom
