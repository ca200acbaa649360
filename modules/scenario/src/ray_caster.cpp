#include "scan_kernel.h"

#include <slalom/scenario/ray_caster.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace slalom {
namespace {

/// A ray that passes a corner within this distance (cells) touches it: far above the rounding of
/// coordinates on any map that fits in memory, far below the resolution of any sensor.
constexpr double kTouch = 1e-9;
constexpr int kMaxSquare = 65535;

/// Offsets (bytes) in vectors have 32 bits.
constexpr std::size_t kMaxOffset = std::numeric_limits<std::int32_t>::max();

/// The directions of a scan's rays relative to its heading.
struct Directions {
  int count = 0;
  double aperture = 0;
  std::vector<double> cosine, sine;
};

/// Caches the directions of the last geometry: a sensor's geometry hardly ever changes.
const Directions& directions_of(const ScanGeometry& geometry) {
  thread_local Directions cached;
  if (cached.count == geometry.count && cached.aperture == geometry.aperture) return cached;
  cached = {geometry.count, geometry.aperture, {}, {}};
  for (int i = 0; i < geometry.count; ++i) {
    cached.cosine.push_back(std::cos(geometry.angle(i)));
    cached.sine.push_back(std::sin(geometry.angle(i)));
  }
  return cached;
}

/// Directions first..first+count-1 rotated by a heading; the rest of the chunk repeats the last
/// one.
void rotate(const Directions& directions, int first, int count, double cosine, double sine,
            RayChunk& rays) {
  const double *c = directions.cosine.data() + first, *s = directions.sine.data() + first;
  for (int i = 0; i < count; ++i) {
    rays.cosine[i] = cosine * c[i] - sine * s[i];
    rays.sine[i] = sine * c[i] + cosine * s[i];
  }
  std::fill(rays.cosine + count, rays.cosine + RayChunk::kSize, rays.cosine[count - 1]);
  std::fill(rays.sine + count, rays.sine + RayChunk::kSize, rays.sine[count - 1]);
}

bool near_integer(double x) {
  return std::abs(x - std::floor(x) - 0.5) > 0.5 - kTouch;
}

}  // namespace

RayCaster::RayCaster(const Occupancy& occupancy, ArrayReader* written)
    : size_x_(occupancy.size_x()),
      size_y_(occupancy.size_y()),
      stride_(static_cast<std::size_t>(size_x_) + 2),
      plane_(stride_ * (static_cast<std::size_t>(size_y_) + 2)),
      resolution_(occupancy.resolution()),
      origin_(occupancy.origin()),
      squares_(written != nullptr ? written->read<std::uint16_t>(table_size())
                                  : SharedArray<std::uint16_t>(free_squares(occupancy))) {}

std::vector<std::uint16_t> RayCaster::free_squares(const Occupancy& occupancy) const {
  std::vector<std::uint16_t> squares(table_size(), 0);
  for (const bool left : {false, true})
    for (const bool down : {false, true})
      fill(occupancy, left, down, squares.data() + plane_of(left, down));
  return squares;
}

void RayCaster::write(ArrayWriter& writer) const {
  writer.write(squares_);
}

/// Fills one plane.
void RayCaster::fill(const Occupancy& occupancy, bool left, bool down,
                     std::uint16_t* squares) const {
  for (int y = size_y_ - 1; y >= 0; --y) {
    const std::uint8_t* cells = occupancy.cells().data() +
                                occupancy.index(left ? 0 : size_x_ - 1, down ? size_y_ - 1 - y : y);
    std::uint16_t* here = squares + index(size_x_ - 1, y);
    int right = 0, above_right = 0;  // in registers: faster than loads
    for (int x = size_x_ - 1; x >= 0; --x, --here, cells += left ? 1 : -1) {
      const int above = here[stride_];
      const int side = std::min({right, above, above_right}) + 1;
      above_right = above;
      right = *cells != 0 ? 0 : std::min(side, kMaxSquare);
      *here = static_cast<std::uint16_t>(right);
    }
  }
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
  ray.squares = squares_.data() + plane_of(cosine < 0, sine < 0);
  return ray;
}

bool RayCaster::starts_free(const Ray& ray) const {
  const bool inside = ray.x > 0 && ray.x < size_x_ && ray.y > 0 && ray.y < size_y_;
  if (!inside || !std::isfinite(ray.dx)) return false;
  for (const double x : {ray.x - kTouch, ray.x + kTouch})
    for (const double y : {ray.y - kTouch, ray.y + kTouch})
      if (ray.squares[index(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)))] == 0)
        return false;
  return true;
}

double RayCaster::trace(const Ray& ray, double limit) const {
  if (ray.dx == 0) return std::min(limit, trace_parallel(ray.squares, ray.y, ray.x, stride_, 1));
  if (ray.dy == 0) return std::min(limit, trace_parallel(ray.squares, ray.x, ray.y, 1, stride_));
  return trace_oblique(ray, limit);
}

double RayCaster::trace_parallel(const std::uint16_t* squares, double along, double across,
                                 std::size_t step_along, std::size_t step_across) const {
  double nearest = size_x_ + size_y_;
  for (const double side : {across - kTouch, across + kTouch}) {  // both rows when on their border
    const std::size_t row = (static_cast<std::size_t>(side) + 1) * step_across;
    std::size_t cell = static_cast<std::size_t>(along);
    while (const std::uint16_t free = squares[row + (cell + 1) * step_along]) cell += free;
    nearest = std::min(nearest, static_cast<double>(cell) - along);
  }
  return nearest;
}

double RayCaster::trace_oblique(const Ray& ray, double limit) const {
  const double per_x = 1 / ray.dx, per_y = 1 / ray.dy;
  int cx = static_cast<int>(ray.x), cy = static_cast<int>(ray.y);
  double t = 0;
  while (const int free = ray.squares[index(cx, cy)]) {
    const double tx = (cx + free - ray.x) * per_x, ty = (cy + free - ray.y) * per_y;
    const bool through_x = tx < ty;
    t = through_x ? tx : ty;
    if (t >= limit) return limit;
    const double other = through_x ? ray.y + t * ray.dy : ray.x + t * ray.dx;
    const int other_cell = static_cast<int>(other);
    cx = through_x ? cx + free : other_cell;
    cy = through_x ? other_cell : cy + free;
    if (near_integer(other)) {
      const int corner = static_cast<int>(std::lround(other));
      if (touches_corner(ray.squares, through_x ? cx : corner, through_x ? corner : cy)) return t;
    }
  }
  return t;
}

bool RayCaster::touches_corner(const std::uint16_t* squares, int x, int y) const {
  const std::uint16_t* above = squares + index(x, y);
  const std::uint16_t* below = above - stride_;
  return above[0] == 0 || above[-1] == 0 || below[0] == 0 || below[-1] == 0;
}

double RayCaster::cast(const mrpt::math::TPoint2D& origin, double angle, double max_range) const {
  const Ray ray = make_ray(origin, std::cos(angle), std::sin(angle));
  if (!starts_free(ray)) return 0;
  return std::min(max_range, resolution_ * trace(ray, max_range / resolution_));
}

ScanOrigin RayCaster::scan_origin(const Ray& ray, double limit) const {
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
  origin.limit = limit;
  origin.squares = squares_.data();
  origin.stride = static_cast<std::int32_t>(stride_);
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
  const ScanOrigin origin = scan_origin(straight, geometry.max_range / resolution_);
  const Directions& directions = directions_of(geometry);
  const double cosine = std::cos(pose.phi), sine = std::sin(pose.phi);
  const bool fits = squares_.size() < kMaxOffset / sizeof(std::uint16_t);
  RayChunk rays;
  for (int first = 0; first < geometry.count; first += RayChunk::kSize) {
    const int count = std::min(geometry.count - first, RayChunk::kSize);
    rotate(directions, first, count, cosine, sine, rays);
    if (fits)
      cast_rays(origin, count, rays);
    else
      std::fill_n(rays.range, count, RayChunk::kUncertain);
    for (int i = 0; i < count; ++i) {
      double range = rays.range[i];
      if (range == RayChunk::kUncertain)
        range = trace(make_ray(position, rays.cosine[i], rays.sine[i]), origin.limit);
      ranges[first + i] = static_cast<float>(std::min(geometry.max_range, resolution_ * range));
    }
  }
}

}  // namespace slalom
