// SPDX-License-Identifier: BSD-3-Clause
#include "free_rectangles.h"
#include "rectangle_codes.h"
#include "scan_kernel.h"

#include <slalom/core/math.h>
#include <slalom/scenario/ray_caster.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace slalom {
namespace {

/// A ray that passes a corner within this distance (cells) touches it: far above the rounding of
/// coordinates on any map that fits in memory, far below the resolution of any sensor.
constexpr double kBorderTolerance = 1e-9;

/// Direction components below this are rounding errors of sine and cosine: the ray is parallel to
/// an axis.
constexpr double kParallel = 1e-14;

/// Offsets (bytes) in vectors have 32 bits.
constexpr std::size_t kMaxOffset = std::numeric_limits<std::int32_t>::max();

/// The directions of a scan's rays relative to its heading.
struct Directions {
  int count = 0;
  double aperture = 0;
  std::vector<double> cosine, sine;  ///< in complete chunks, the last one repeated
};

/// Caches the directions of the last geometry: a sensor's geometry hardly ever changes.
const Directions& directions_of(const ScanGeometry& geometry) {
  thread_local Directions cached;
  if (cached.count == geometry.count && cached.aperture == geometry.aperture) return cached;
  const int chunks = (std::max(0, geometry.count) + RayChunk::kSize - 1) / RayChunk::kSize;
  const auto size = static_cast<std::size_t>(chunks) * RayChunk::kSize;
  const std::vector<double> empty(size);
  cached = {geometry.count, geometry.aperture, empty, empty};
  for (std::size_t i = 0; i < size; ++i) {
    const double angle = geometry.angle(std::min(static_cast<int>(i), geometry.count - 1));
    cached.cosine[i] = math::cos(angle);
    cached.sine[i] = math::sin(angle);
  }
  return cached;
}

bool near_integer(double x) {
  return std::abs(x - std::floor(x) - 0.5) > 0.5 - kBorderTolerance;
}

}  // namespace

RayCaster::RayCaster(const Occupancy& occupancy, ArrayReader* written)
    : size_x_(occupancy.size_x()),
      size_y_(occupancy.size_y()),
      stride_(static_cast<std::size_t>(size_x_) + 2),
      plane_(stride_ * (static_cast<std::size_t>(size_y_) + 2)),
      resolution_(occupancy.resolution()),
      origin_(occupancy.origin()),
      rectangles_(written != nullptr ? written->read<std::uint8_t>(table_size())
                                     : SharedArray<std::uint8_t>(free_rectangles(occupancy))) {}

std::vector<std::uint8_t> RayCaster::free_rectangles(const Occupancy& occupancy) const {
  std::vector<std::uint8_t> rectangles(table_size(), 0);
  for (const bool left : {false, true})
    for (const bool down : {false, true})
      fill_free_rectangles(occupancy.cells().data(), size_x_, size_y_, left, down,
                           static_cast<std::ptrdiff_t>(stride_),
                           rectangles.data() + plane_of(left, down) + index(0, 0));
  return rectangles;
}

void RayCaster::write(ArrayWriter& writer) const {
  writer.write(rectangles_);
}

RayCaster::Ray RayCaster::make_ray(const mrpt::math::TPoint2D& origin, double cosine,
                                   double sine) const {
  Ray ray;
  ray.x = (origin.x - origin_.x) / resolution_;
  ray.y = (origin.y - origin_.y) / resolution_;
  if (cosine < 0) ray.x = size_x_ - ray.x;
  if (sine < 0) ray.y = size_y_ - ray.y;
  ray.dx = std::abs(cosine) < kParallel ? 0 : std::abs(cosine);
  ray.dy = std::abs(sine) < kParallel ? 0 : std::abs(sine);
  ray.rectangles = rectangles_.data() + plane_of(cosine < 0, sine < 0);
  return ray;
}

bool RayCaster::starts_free(const Ray& ray) const {
  const bool inside = ray.x > 0 && ray.x < size_x_ && ray.y > 0 && ray.y < size_y_;
  if (!inside || !std::isfinite(ray.dx)) return false;
  for (const double x : {ray.x - kBorderTolerance, ray.x + kBorderTolerance})
    for (const double y : {ray.y - kBorderTolerance, ray.y + kBorderTolerance})
      if (ray.rectangles[index(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)))] ==
          0)
        return false;
  return true;
}

double RayCaster::trace(const Ray& ray, double limit) const {
  if (ray.dx == 0)
    return std::min(limit, trace_parallel(ray.rectangles, ray.y, ray.x, stride_, 1, 4));
  if (ray.dy == 0)
    return std::min(limit, trace_parallel(ray.rectangles, ray.x, ray.y, 1, stride_, 0));
  return trace_oblique(ray, limit);
}

double RayCaster::trace_parallel(const std::uint8_t* rectangles, double along, double across,
                                 std::size_t step_along, std::size_t step_across,
                                 int extent_shift) const {
  double nearest = size_x_ + size_y_;
  for (const double side :
       {across - kBorderTolerance, across + kBorderTolerance}) {  // both rows when on their border
    const std::size_t row = (static_cast<std::size_t>(side) + 1) * step_across;
    std::size_t cell = static_cast<std::size_t>(along);
    while (const std::uint8_t codes = rectangles[row + (cell + 1) * step_along])
      cell += kExtents[codes >> extent_shift & 15];
    nearest = std::min(nearest, static_cast<double>(cell) - along);
  }
  return nearest;
}

double RayCaster::trace_oblique(const Ray& ray, double limit) const {
  const double per_x = 1 / ray.dx, per_y = 1 / ray.dy;
  int cx = static_cast<int>(ray.x), cy = static_cast<int>(ray.y);
  double t = 0;
  while (const unsigned codes = ray.rectangles[index(cx, cy)]) {
    const int far_x = cx + kExtents[codes & 15], far_y = cy + kExtents[codes >> 4];
    const double tx = (far_x - ray.x) * per_x, ty = (far_y - ray.y) * per_y;
    const bool through_x = tx < ty;
    t = through_x ? tx : ty;
    if (t >= limit) return limit;
    const double other = through_x ? ray.y + t * ray.dy : ray.x + t * ray.dx;
    const int other_cell = static_cast<int>(other);
    // Never back: at corners rounding could, and the ray would go around them forever.
    cx = through_x ? far_x : std::max(cx, other_cell);
    cy = through_x ? std::max(cy, other_cell) : far_y;
    if (near_integer(other)) {
      const int corner = static_cast<int>(std::lround(other));
      if (touches_corner(ray.rectangles, through_x ? cx : corner, through_x ? corner : cy))
        return std::min(t, through_x ? (corner - ray.y) * per_y : (corner - ray.x) * per_x);
    }
  }
  return t;
}

bool RayCaster::touches_corner(const std::uint8_t* rectangles, int x, int y) const {
  const std::uint8_t* above = rectangles + index(x, y);
  const std::uint8_t* below = above - stride_;
  return above[0] == 0 || above[-1] == 0 || below[0] == 0 || below[-1] == 0;
}

double RayCaster::cast(const mrpt::math::TPoint2D& origin, double angle, double max_range) const {
  return cast(origin, {math::cos(angle), math::sin(angle)}, max_range);
}

double RayCaster::cast(const mrpt::math::TPoint2D& origin, const mrpt::math::TPoint2D& direction,
                       double max_range) const {
  const Ray ray = make_ray(origin, direction.x, direction.y);
  if (!starts_free(ray)) return 0;
  return std::min(max_range, resolution_ * trace(ray, max_range / resolution_));
}

ScanOrigin RayCaster::scan_origin(const Ray& ray, double heading, double max_range) const {
  ScanOrigin origin{};
  for (const int mirrored : {0, 1}) {
    origin.x[mirrored] = mirrored ? size_x_ - ray.x : ray.x;
    origin.y[mirrored] = mirrored ? size_y_ - ray.y : ray.y;
    const std::size_t column =
        plane_of(mirrored, false) + index(static_cast<int>(origin.x[mirrored]), -1);
    const std::size_t row =
        plane_of(false, mirrored) + index(-1, static_cast<int>(origin.y[mirrored]));
    origin.column[mirrored] = static_cast<std::int32_t>(column);
    origin.row[mirrored] = static_cast<std::int32_t>(row);
  }
  for (const int left : {0, 1})
    for (const int down : {0, 1})
      origin.codes[left][down] =
          rectangles_[plane_of(left, down) +
                      index(static_cast<int>(origin.x[left]), static_cast<int>(origin.y[down]))];
  const auto [sine, cosine] = math::sin_cos(heading);
  origin.cosine = cosine;
  origin.sine = sine;
  origin.limit = max_range / resolution_;
  origin.max_range = max_range;
  origin.resolution = resolution_;
  origin.stride = static_cast<std::int32_t>(stride_);
  origin.size_x = size_x_;
  origin.size_y = size_y_;
  origin.rectangles = rectangles_.size() < kMaxOffset ? rectangles_.data() : nullptr;
  return origin;
}

void RayCaster::cast_scan(const mrpt::math::TPose2D& pose, const ScanGeometry& geometry,
                          float* ranges) const {
  const mrpt::math::TPoint2D position(pose.x, pose.y);
  const Ray straight = make_ray(position, 1, 0);
  if (!starts_free(straight) || !std::isfinite(pose.phi)) {
    std::fill_n(ranges, std::max(0, geometry.count), 0.0F);
    return;
  }
  const ScanOrigin origin = scan_origin(straight, pose.phi, geometry.max_range);
  const Directions& directions = directions_of(geometry);
  RayChunk rays;
  for (int first = 0; first < geometry.count; first += RayChunk::kSize) {
    const int count = std::min(geometry.count - first, RayChunk::kSize);
    const bool uncertain = cast_rays(origin, directions.cosine.data() + first,
                                     directions.sine.data() + first, count, rays);
    std::copy_n(rays.range, count, ranges + first);
    for (int i = 0; uncertain && i < count; ++i)
      if (rays.range[i] == RayChunk::kUncertain) {
        const double t = trace(make_ray(position, rays.cosine[i], rays.sine[i]), origin.limit);
        ranges[first + i] = static_cast<float>(std::min(geometry.max_range, resolution_ * t));
      }
  }
}

}  // namespace slalom
