#include <slalom/scenario/ray_caster.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// A ray that passes a corner within this many cells touches it. Far above the rounding of
/// coordinates on any map that fits in memory, far below anything a sensor can tell.
constexpr double kTouch = 1e-9;
/// Direction components below this are the rounding of sine and cosine: the ray is parallel to an
/// axis.
constexpr double kParallel = 1e-14;
constexpr int kLargestSquare = 65535;

bool near_integer(double x) {
  return std::abs(x - std::floor(x) - 0.5) > 0.5 - kTouch;
}

}  // namespace

RayCaster::RayCaster(const Occupancy& occupancy)
    : size_x_(occupancy.size_x()),
      size_y_(occupancy.size_y()),
      stride_(static_cast<std::size_t>(size_x_) + 2),
      resolution_(occupancy.resolution()),
      origin_(occupancy.origin()) {
  for (unsigned quadrant = 0; quadrant < 4; ++quadrant) fill(occupancy, quadrant);
}

void RayCaster::fill(const Occupancy& occupancy, unsigned quadrant) {
  auto& squares = squares_[quadrant];
  squares.assign(stride_ * (static_cast<std::size_t>(size_y_) + 2), 0);
  for (int y = size_y_ - 1; y >= 0; --y) {
    const int cy = quadrant & 2U ? size_y_ - 1 - y : y;
    for (int x = size_x_ - 1; x >= 0; --x) {
      if (occupancy.occupied(quadrant & 1U ? size_x_ - 1 - x : x, cy)) continue;
      std::uint16_t* here = &squares[index(x, y)];
      const int smallest = std::min({here[1], here[stride_], here[stride_ + 1]});
      *here = static_cast<std::uint16_t>(std::min(smallest + 1, kLargestSquare));
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
  ray.squares = squares_[(cosine < 0 ? 1U : 0U) + (sine < 0 ? 2U : 0U)].data();
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
  if (!starts_free(ray)) return 0;
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
  return std::min(max_range, resolution_ * trace(ray, max_range / resolution_));
}

void RayCaster::cast_scan(const mrpt::math::TPose2D& pose, const ScanGeometry& geometry,
                          float* ranges) const {
  const mrpt::math::TPoint2D origin(pose.x, pose.y);
  for (int i = 0; i < geometry.count; ++i)
    ranges[i] = static_cast<float>(cast(origin, pose.phi + geometry.angle(i), geometry.max_range));
}

}  // namespace slalom
