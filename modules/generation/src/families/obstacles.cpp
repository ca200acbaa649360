// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/generation/obstacles.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

double draw_log_normal(RandomEngine& engine, const SizeOptions& o) {
  constexpr int kDraws = 1000;
  const double mean = (math::log(o.min_size) + math::log(o.max_size)) / 2;
  for (int i = 0; i < kDraws; ++i) {
    const double size = math::exp(normal(engine, mean, o.size_log_sigma));
    if (size >= o.min_size && size <= o.max_size) return size;
  }
  return math::exp(mean);
}

/// Inverse transform sampling, with the limit at exponent 1.
double draw_power_law(RandomEngine& engine, const SizeOptions& o) {
  const double u = uniform_real(engine, 0, 1), k = 1 - o.size_exponent;
  const double ratio = o.max_size / o.min_size;
  const double size = std::abs(k) < 1e-9
                          ? o.min_size * math::pow(ratio, u)
                          : o.min_size * math::pow(1 + u * (math::pow(ratio, k) - 1), 1 / k);
  return std::clamp(size, o.min_size, o.max_size);
}

/// Vertices in angular order around the center: on the circle for a convex polygon, between half
/// the radius and the radius for a star-shaped one. Both are simple polygons.
Polygon draw_polygon(RandomEngine& engine, const TPoint2D& center, double size,
                     double concave_fraction) {
  const int corners = uniform_int(engine, 3, 7);
  const bool concave = uniform_real(engine, 0, 1) < concave_fraction;
  const double turn = uniform_real(engine, 0, 2 * M_PI);
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2 * M_PI * (i + uniform_real(engine, 0.1, 0.9)) / corners;
    const double radius = concave ? size * uniform_real(engine, 0.5, 1) : size;
    polygon.vertices.emplace_back(center.x + radius * math::cos(angle),
                                  center.y + radius * math::sin(angle));
  }
  return polygon;
}

TPoint2D draw_center(RandomEngine& engine, const Bounds& bounds, const PositionFilter& is_valid) {
  constexpr int kDraws = 200;
  TPoint2D center;
  for (int i = 0; i < kDraws; ++i) {
    center.x = uniform_real(engine, bounds.x_min, bounds.x_max);
    center.y = uniform_real(engine, bounds.y_min, bounds.y_max);
    if (!is_valid || is_valid(center)) break;
  }
  return center;
}

}  // namespace

double sample_obstacle_size(RandomEngine& engine, const SizeOptions& options) {
  if (options.size_distribution == SizeDistribution::LogNormal)
    return draw_log_normal(engine, options);
  if (options.size_distribution == SizeDistribution::PowerLaw)
    return draw_power_law(engine, options);
  return uniform_real(engine, options.min_size, options.max_size);
}

Primitives scatter_obstacles(RandomEngine& engine, const ObstacleOptions& options,
                             const Bounds& bounds, const StartGoal& start_goal, double clear_radius,
                             const PositionFilter& is_valid) {
  Primitives obstacles;
  const int count = uniform_int(engine, options.min_obstacles, options.max_obstacles);
  for (int i = 0; i < count; ++i) {
    const double size = sample_obstacle_size(engine, options.size);
    const TPoint2D center = draw_center(engine, bounds, is_valid);
    const bool is_polygon = uniform_real(engine, 0, 1) < options.polygon_fraction;
    Polygon polygon;
    if (is_polygon) polygon = draw_polygon(engine, center, size, options.concave_fraction);
    const auto is_near = [&](const TPoint2D& point) {
      return distance_between(center, point) < size + clear_radius;
    };
    if (is_near(start_goal.start) || is_near(start_goal.goal)) continue;
    if (is_polygon) {
      obstacles.polygons.push_back(std::move(polygon));
    } else {
      obstacles.discs.push_back({center, size});
    }
  }
  return obstacles;
}

void SizeOptions::visit(OptionVisitor& v) {
  v.option("min_size", min_size, "m", "minimum radius of an obstacle", Range::positive());
  v.option("max_size", max_size, "m", "maximum radius of an obstacle", Range::positive());
  v.option("size_distribution", size_distribution, "distribution of sizes between these limits");
  v.option("size_log_sigma", size_log_sigma, "-",
           "log_normal: standard deviation of the natural logarithm", Range::positive());
  v.option("size_exponent", size_exponent, "-",
           "power_law: the density is proportional to size^-size_exponent",
           Range::between(-20, 20));
}

void ObstacleOptions::visit(OptionVisitor& v) {
  v.option("min_obstacles", min_obstacles, "-", "minimum number of obstacles",
           Range::between(0, 1e6));
  v.option("max_obstacles", max_obstacles, "-", "maximum number of obstacles",
           Range::between(0, 1e6));
  size.visit(v);
  v.option("polygon_fraction", polygon_fraction, "-", "fraction of polygons, the rest are discs",
           Range::between(0, 1));
  v.option("concave_fraction", concave_fraction, "-",
           "fraction of star-shaped polygons among polygons", Range::between(0, 1));
}

}  // namespace slalom
