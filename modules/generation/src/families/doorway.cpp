// SPDX-License-Identifier: BSD-3-Clause
#include "family.h"
#include "walls.h"

#include <slalom/core/distance.h>
#include <slalom/generation/doorway.h>

#include <algorithm>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

class DoorwayGenerator : public Generator {
 public:
  explicit DoorwayGenerator(const DoorwayOptions& options) : options_(options) {}

  std::string name() const override { return DoorwayOptions::kFamily; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const double w = options_.width, h = options_.height, half_wall = options_.wall / 2;
    const double door = uniform_real(engine, options_.min_door, options_.max_door);
    const double middle = uniform_real(engine, door / 2, h - door / 2);
    const Bounds left = {0, 0, w / 2 - half_wall, h}, right = {w / 2 + half_wall, 0, w, h};
    const StartGoal ends = sample_start_goal(engine, left, right, options_.start_goal);
    const auto start = start_pose(engine, ends);
    Primitives walls;
    if (middle - door / 2 > 0)
      walls.polygons.push_back(rectangle(left.x_max, 0, right.x_min, middle - door / 2));
    if (middle + door / 2 < h)
      walls.polygons.push_back(rectangle(left.x_max, middle + door / 2, right.x_min, h));
    Movers movers = sample_movers(
        engine, options_.movers, MoverEnd::Stop, ends.start, options_.start_goal.clear_radius,
        [&](double radius, double speed) {
          return walk(engine, ends.start, middle, radius, speed);
        },
        options_.people);
    return with_moving(
        Scenario::continuous(scenario_name, {0, 0, w, h}, std::move(walls), start, ends.goal),
        std::move(movers), options_.people);
  }

 private:
  std::vector<Waypoint> walk(RandomEngine& engine, const TPoint2D& start, double middle,
                             double radius, double speed) const {
    const double m = radius + kWallMargin, beside = options_.wall / 2 + m;
    const double w = options_.width, h = options_.height;
    // The disc is inside one room, which is convex, up to where it is right before the door.
    const auto anywhere = [&](double x_min, double x_max) {
      const double x = uniform_real(engine, x_min, x_max);
      return TPoint2D{x, uniform_real(engine, m, h - m)};
    };
    const TPoint2D from = anywhere(w / 2 + beside, w - m), to = anywhere(m, w / 2 - beside);
    const double y = std::clamp(middle, m, h - m);
    const TPoint2D entry{w / 2 + beside, y}, exit{w / 2 - beside, y};
    const double apart = distance_to_segment(start, exit, to);
    if (apart < radius + options_.start_goal.clear_radius) return {};
    return walk_along({from, entry, exit, to}, speed, uniform_real(engine, 0, options_.max_wait));
  }

  DoorwayOptions options_;
};

}  // namespace

void DoorwayOptions::visit(OptionVisitor& v) {
  v.option("width", width, "m", "width of both rooms together", Range::positive());
  v.option("height", height, "m", "height of the rooms", Range::positive());
  v.option("min_door", min_door, "m", "minimum clear width of the door", Range::positive());
  v.option("max_door", max_door, "m", "maximum clear width of the door", Range::positive());
  v.option("wall", wall, "m", "thickness of the wall", Range::positive());
  v.option("max_wait", max_wait, "s", "latest time at which a moving obstacle begins to walk",
           Range::between(0, 3600));
  movers.visit(v);
  v.option("people", people, "moving obstacles are people, who react and do not wait");
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const DoorwayOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(DoorwayOptions::kFamily, context);
  const auto options = checks.scaled(given);
  checks.expect_order("min_door", options.min_door, "max_door", options.max_door);
  checks.expect(options.max_door <= options.height, "max_door", "is higher than the rooms",
                "at most height");
  checks.expect_valid(options.movers);
  checks.expect_movers_fit(options.movers, options.min_door);
  checks.expect_start_goal_fit(options.start_goal, options.width, options.height);
  checks.expect(2 * options.start_goal.margin + options.wall / 2 < options.width / 2, "margin",
                "leaves no room for the start", "less than a quarter of width");
  return std::make_unique<DoorwayGenerator>(options);
}

}  // namespace slalom
