// SPDX-License-Identifier: BSD-3-Clause
#include "straight_path_family.h"
#include "walls.h"

#include <slalom/generation/sudden_obstacle.h>

#include <algorithm>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// The way of a mover in the frame of its place: x along the straight path, y toward the wall.
struct Way {
  double wall_end = 0;  ///< x of it
  TPoint2D hidden;      ///< where it waits, behind the wall's end
  double walk = 0;      ///< m, from there until it reaches the lane
};

Way way_of(const SuddenObstacleOptions& o, double radius) {
  Way way;
  way.wall_end = -(radius + kWallMargin);
  way.hidden = {2 * way.wall_end, o.wall_distance + o.wall + kWallMargin + radius};
  way.walk = -way.hidden.x + way.hidden.y - (o.lane + radius);
  return way;
}

class SuddenObstacleGenerator : public Generator {
 public:
  explicit SuddenObstacleGenerator(const SuddenObstacleOptions& options) : options_(options) {}

  std::string name() const override { return SuddenObstacleOptions::kFamily; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const SuddenObstacleOptions& o = options_;
    const StraightPath path = sample_straight_path(engine, o);
    const TPoint2D& place = path.place;
    const double side = sample_side(engine);
    const double radius = uniform_real(engine, o.min_radius, o.max_radius);
    const double speed = uniform_real(engine, o.min_speed, o.max_speed);
    const double appearance = uniform_real(engine, o.min_appearance, o.max_appearance);
    const Way way = way_of(o, radius);
    const double low = place.y + side * o.wall_distance, high = low + side * o.wall;
    Primitives walls;
    walls.polygons = {
        rectangle(0, std::min(low, high), place.x + way.wall_end, std::max(low, high))};
    const double reached = (place.x - path.start.x - appearance) / o.robot_speed;
    const double y = place.y + side * way.hidden.y;
    const Mover mover{"mover_0", radius,
                      walk_along({{place.x + way.hidden.x, y}, {place.x, y}, place}, speed,
                                 std::max(0.0, reached - way.walk / speed)),
                      MoverEnd::Stop};
    return Scenario::continuous(scenario_name, {0, 0, o.length, o.height}, std::move(walls),
                                path.start, path.goal)
        .with_movers({mover});
  }

 private:
  SuddenObstacleOptions options_;
};

void expect_time(const FamilyChecks& checks, const SuddenObstacleOptions& o) {
  const double drive = o.robot_speed * way_of(o, o.max_radius).walk / o.min_speed;
  checks.expect(o.max_appearance + drive <= o.min_start_distance, "min_start_distance",
                "leaves the moving obstacle no time to reach the lane",
                "at least " + format_number(o.max_appearance + drive));
}

void expect_space(const FamilyChecks& checks, const SuddenObstacleOptions& o) {
  const double across = way_of(o, o.max_radius).hidden.y + o.max_radius + kWallMargin;
  checks.expect(across <= room_beside(o), "wall_distance",
                "leaves no room for the moving obstacle behind the wall",
                "at most " + format_number(room_beside(o) - across + o.wall_distance));
  checks.expect(3 * (o.max_radius + kWallMargin) <= o.start_goal.margin + o.min_start_distance,
                "max_radius", "leaves no room for the moving obstacle behind the wall",
                "less than a third of margin and min_start_distance");
  checks.expect(o.lane <= o.wall_distance, "lane", "contains the wall", "at most wall_distance");
  checks.expect(o.start_goal.clear_radius <= o.wall_distance, "clear_radius", "reaches the wall",
                "at most wall_distance");
  checks.expect(o.start_goal.clear_radius + o.max_radius <= o.goal_distance, "goal_distance",
                "places the goal within clear_radius of the moving obstacle",
                "at least " + format_number(o.start_goal.clear_radius + o.max_radius));
}

}  // namespace

SuddenObstacleOptions::SuddenObstacleOptions() {
  length = 12;
  min_start_distance = 5, max_start_distance = 7;
  angle.max_angle_deg = 0;
}

void SuddenObstacleOptions::visit(OptionVisitor& v) {
  StraightPathOptions::visit(v);
  v.option("min_radius", min_radius, "m", "minimum radius of the moving obstacle",
           Range::positive());
  v.option("max_radius", max_radius, "m", "maximum radius of the moving obstacle",
           Range::positive());
  v.option("min_speed", min_speed, "m/s", "minimum speed of the moving obstacle",
           Range::between(0.01, 10));
  v.option("max_speed", max_speed, "m/s", "maximum speed of the moving obstacle",
           Range::between(0.01, 10));
  v.option("min_appearance", min_appearance, "m",
           "minimum distance of the robot from the place when the moving obstacle reaches the lane",
           Range::positive());
  v.option("max_appearance", max_appearance, "m",
           "maximum distance of the robot from the place when the moving obstacle reaches the lane",
           Range::positive());
  v.option("robot_speed", robot_speed, "m/s",
           "speed of a robot that drives straight; that of the evaluated one: max_v",
           Range::positive());
  v.option("lane", lane, "m", "half width of the lane along the straight path", Range::at_least(0));
  v.option("wall_distance", wall_distance, "m", "distance of the wall from the straight path",
           Range::positive());
  v.option("wall", wall, "m", "thickness of the wall", Range::positive());
}

std::unique_ptr<Generator> make_generator(const SuddenObstacleOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(SuddenObstacleOptions::kFamily, context);
  const auto o = checks.scaled(given);
  expect_valid(checks, o);
  checks.expect_order("min_radius", o.min_radius, "max_radius", o.max_radius);
  checks.expect_order("min_speed", o.min_speed, "max_speed", o.max_speed);
  checks.expect_order("min_appearance", o.min_appearance, "max_appearance", o.max_appearance);
  expect_space(checks, o);
  expect_time(checks, o);
  return std::make_unique<SuddenObstacleGenerator>(o);
}

}  // namespace slalom
