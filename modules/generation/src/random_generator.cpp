#include <slalom/core/error.h>
#include <slalom/generation/random_generator.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kPi = 3.14159265358979323846;

class RandomGenerator : public Generator {
 public:
  explicit RandomGenerator(const RandomGeneratorOptions& options) : options_(options) {}

  std::string name() const override { return "random"; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const auto [start, goal] = draw_ends(engine);
    Primitives obstacles;
    const int count = uniform_int(engine, options_.min_obstacles, options_.max_obstacles);
    for (int i = 0; i < count; ++i) add_obstacle(engine, start, goal, obstacles);
    const double bearing = std::atan2(goal.y - start.y, goal.x - start.x);
    const double heading = bearing + uniform_real(engine, -kPi / 4, kPi / 4);
    return Scenario::continuous(scenario_name, {0, 0, options_.width, options_.height},
                                std::move(obstacles), {start.x, start.y, heading}, goal);
  }

 private:
  TPoint2D draw_point(RandomEngine& engine, double margin) const {
    const double x = uniform_real(engine, margin, options_.width - margin);
    return {x, uniform_real(engine, margin, options_.height - margin)};
  }

  /// Start and goal far enough apart; opposite corners when luck does not give such a pair.
  std::pair<TPoint2D, TPoint2D> draw_ends(RandomEngine& engine) const {
    const double m = options_.margin;
    for (int attempt = 0; attempt < 1000; ++attempt) {
      const TPoint2D start = draw_point(engine, m), goal = draw_point(engine, m);
      if (std::hypot(goal.x - start.x, goal.y - start.y) >= options_.min_distance)
        return {start, goal};
    }
    return {{m, m}, {options_.width - m, options_.height - m}};
  }

  void add_obstacle(RandomEngine& engine, const TPoint2D& start, const TPoint2D& goal,
                    Primitives& obstacles) const {
    const double size = uniform_real(engine, options_.min_size, options_.max_size);
    const TPoint2D center = draw_point(engine, 0);
    const bool is_polygon = uniform_real(engine, 0, 1) < options_.polygon_share;
    Polygon polygon;
    if (is_polygon) polygon = draw_polygon(engine, center, size);
    for (const TPoint2D& end : {start, goal})
      if (std::hypot(center.x - end.x, center.y - end.y) < size + options_.clear_radius) return;
    if (is_polygon) {
      obstacles.polygons.push_back(std::move(polygon));
    } else {
      obstacles.discs.push_back({center, size});
    }
  }

  /// Vertices in order of angle about the centre: on the circle for a convex polygon, between half
  /// the radius and the radius for a star-shaped one. Either way the polygon is simple.
  Polygon draw_polygon(RandomEngine& engine, const TPoint2D& center, double size) const {
    const int corners = uniform_int(engine, 3, 7);
    const bool concave = uniform_real(engine, 0, 1) < options_.concave_share;
    const double turn = uniform_real(engine, 0, 2 * kPi);
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
      const double angle = turn + 2 * kPi * (i + uniform_real(engine, 0.1, 0.9)) / corners;
      const double radius = concave ? size * uniform_real(engine, 0.5, 1) : size;
      polygon.vertices.emplace_back(center.x + radius * std::cos(angle),
                                    center.y + radius * std::sin(angle));
    }
    return polygon;
  }

  RandomGeneratorOptions options_;
};

void expect_order(const IniFile& ini, const std::string& low, double low_value,
                  const std::string& high, double high_value) {
  if (low_value <= high_value) return;
  throw usage_error(ini.where("generator.random", high), "is less than " + low,
                    "at least " + std::to_string(low_value));
}

}  // namespace

void RandomGeneratorOptions::visit(OptionVisitor& v) {
  v.option("width", width, "m", "width of the floor", Range::positive());
  v.option("height", height, "m", "height of the floor", Range::positive());
  v.option("min_obstacles", min_obstacles, "-", "fewest obstacles", Range::between(0, 1e6));
  v.option("max_obstacles", max_obstacles, "-", "most obstacles", Range::between(0, 1e6));
  v.option("min_size", min_size, "m", "smallest radius of an obstacle", Range::positive());
  v.option("max_size", max_size, "m", "largest radius of an obstacle", Range::positive());
  v.option("polygon_share", polygon_share, "-", "share of polygons, the rest are discs",
           Range::between(0, 1));
  v.option("concave_share", concave_share, "-", "share of star-shaped polygons among polygons",
           Range::between(0, 1));
  v.option("clear_radius", clear_radius, "m", "kept free about start and goal", Range::at_least(0));
  v.option("min_distance", min_distance, "m", "straight distance from start to goal",
           Range::at_least(0));
  v.option("margin", margin, "m", "of start and goal from the border", Range::at_least(0));
}

std::unique_ptr<Generator> make_random_generator(const IniFile& ini) {
  const auto options = read_options<RandomGeneratorOptions>(ini, "generator.random");
  expect_order(ini, "min_obstacles", options.min_obstacles, "max_obstacles", options.max_obstacles);
  expect_order(ini, "min_size", options.min_size, "max_size", options.max_size);
  const double diagonal =
      std::hypot(options.width - 2 * options.margin, options.height - 2 * options.margin);
  if (2 * options.margin >= std::min(options.width, options.height) ||
      diagonal < options.min_distance)
    throw usage_error(ini.where("generator.random"),
                      "start and goal cannot be min_distance apart within the margins",
                      "a larger floor or smaller min_distance and margin");
  return std::make_unique<RandomGenerator>(options);
}

}  // namespace slalom
