// SPDX-License-Identifier: BSD-3-Clause
#include "family.h"

#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/generation/crossing.h>

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Distance (m) from p, which is inside, along the unit vector u to the border of the rectangle.
double distance_to_border(const TPoint2D& p, const TPoint2D& u, const Bounds& bounds) {
  const auto along = [](double from, double direction, double low, double high) {
    if (direction == 0) return std::numeric_limits<double>::infinity();
    return ((direction > 0 ? high : low) - from) / direction;
  };
  return std::min(along(p.x, u.x, bounds.x_min, bounds.x_max),
                  along(p.y, u.y, bounds.y_min, bounds.y_max));
}

class CrossingGenerator : public Generator {
 public:
  explicit CrossingGenerator(const CrossingOptions& options) : options_(options) {}

  std::string name() const override { return CrossingOptions::kFamily; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const Bounds workspace = {0, 0, options_.width, options_.height};
    const StartGoal ends = sample_start_goal(engine, workspace, options_.start_goal);
    const auto start = start_pose(engine, ends);
    Movers movers = sample_movers(
        engine, options_.movers, MoverEnd::Loop, ends.start, options_.start_goal.clear_radius,
        [&](double radius, double speed) { return crossing_walk(engine, ends, radius, speed); },
        options_.people);
    return with_moving(Scenario::continuous(scenario_name, workspace, {}, start, ends.goal),
                       std::move(movers), options_.people);
  }

 private:
  std::vector<Waypoint> crossing_walk(RandomEngine& engine, const StartGoal& ends, double radius,
                                      double speed) const {
    const double m = radius + kWallMargin;
    const Bounds inside = {m, m, options_.width - m, options_.height - m};
    const TPoint2D straight = ends.goal - ends.start;
    const TPoint2D crossed = ends.start + straight * uniform_real(engine, 0, 1);
    const double turn = mrpt::DEG2RAD(options_.max_turn_deg);
    const double direction =
        math::atan2(straight.y, straight.x) + M_PI / 2 + uniform_real(engine, -turn, turn);
    const TPoint2D u{math::cos(direction), math::sin(direction)};
    const double left = distance_to_border(crossed, u, inside),
                 right = distance_to_border(crossed, u * -1.0, inside);
    constexpr double kMinLength = 1;  // m
    if (!(std::min(left, right) >= 0) || left + right < kMinLength) return {};
    const TPoint2D end = crossed + u * left, other_end = crossed - u * right;
    const TPoint2D first = crossed + u * uniform_real(engine, -right, left);
    const bool is_left_first = uniform_int(engine, 0, 1) == 0;
    return walk_along(
        {first, is_left_first ? end : other_end, is_left_first ? other_end : end, first}, speed);
  }

  CrossingOptions options_;
};

}  // namespace

void CrossingOptions::visit(OptionVisitor& v) {
  v.option("width", width, "m", "width of the room", Range::positive());
  v.option("height", height, "m", "height of the room", Range::positive());
  v.option("max_turn_deg", max_turn_deg, "deg",
           "maximum angle between a moving obstacle's path and the normal of the robot's",
           Range::between(0, 80));
  movers.visit(v);
  v.option("people", people, "moving obstacles are people, who react");
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const CrossingOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(CrossingOptions::kFamily, context);
  const auto options = checks.scaled(given);
  checks.expect_valid(options.movers);
  checks.expect_start_goal_fit(options.start_goal, options.width, options.height);
  checks.expect_movers_fit(options.movers, std::min(options.width, options.height));
  return std::make_unique<CrossingGenerator>(options);
}

}  // namespace slalom
