#pragma once

#include <cstdint>

namespace slalom {

/// Direction components below this are rounding errors of sine and cosine: the ray is parallel to
/// an axis.
constexpr double kParallel = 1e-14;

/// A sensor's position in the four mirrored frames of a RayCaster (index 1: mirrored), in cells.
struct ScanOrigin {
  double x[2], y[2];
  std::int32_t column[2], row[2];  ///< their sum is the index of the origin's cell in `squares`
  double limit;                    ///< maximum range
  const std::uint16_t* squares;    ///< readable one element beyond the last cell
  std::int32_t stride;
};

/// Rays that are cast in parallel (SIMD).
struct RayChunk {
  static constexpr int kSize = 192;
  // Directions (world), all filled.
  alignas(64) double cosine[kSize];
  alignas(64) double sine[kSize];
  // Scratch space of the kernel: origins within their cell, directions and their inverses.
  alignas(64) float x[kSize];
  alignas(64) float y[kSize];
  alignas(64) float dx[kSize];
  alignas(64) float dy[kSize];
  alignas(64) float per_x[kSize];
  alignas(64) float per_y[kSize];
  alignas(64) std::int32_t cell[kSize];
  // The face that stops the ray, in columns (positive) or rows (negative) from the origin's cell.
  alignas(64) std::int32_t face[kSize];
  // Result: ranges in cells, at most the limit; kUncertain where single precision does not suffice.
  alignas(64) double range[kSize];

  static constexpr std::int32_t kNothing = 0;  ///< the limit is reached before any face
  static constexpr std::int32_t kUndecided = INT32_MIN;
  static constexpr double kUncertain = -1;
};

/// Casts the first `count` rays with the widest vectors of this processor. The traversal from
/// square to square uses single precision with an error bound, the range to the face found uses
/// double precision: the result is bit-identical with every instruction set. Cases that the bound
/// cannot decide (a crossing close to a corner, a ray parallel to an axis) are left to the caller.
void cast_rays(const ScanOrigin& origin, int count, RayChunk& rays);

}  // namespace slalom
