// SPDX-License-Identifier: BSD-3-Clause
#include "straight_path_family.h"

#include <mrpt/core/bits_math.h>

#include <algorithm>

namespace slalom {

double sample_side(RandomEngine& engine) {
  return uniform_int(engine, 0, 1) == 0 ? -1 : 1;
}

double sample_angle(RandomEngine& engine, const StartAngleOptions& options) {
  const double side = sample_side(engine);
  const double angle = uniform_real(engine, options.min_angle_deg, options.max_angle_deg);
  return wrap_angle(mrpt::DEG2RAD(side * angle));
}

StraightPath sample_straight_path(RandomEngine& engine, const StraightPathOptions& o) {
  const double to_place = uniform_real(engine, o.min_start_distance, o.max_start_distance);
  const double to_goal =
      std::max(to_place + o.goal_distance, o.start_goal.min_distance + kRounding);
  const double x =
      uniform_real(engine, o.start_goal.margin, o.length - o.start_goal.margin - to_goal);
  const double y = uniform_real(engine, room_beside(o), o.height - room_beside(o));
  const double angle = sample_angle(engine, o.angle);
  return {{x, y, angle}, {x + to_place, y}, {x + to_goal, y}};
}

void expect_valid(const FamilyChecks& checks, const StartAngleOptions& options) {
  checks.expect_order("min_angle_deg", options.min_angle_deg, "max_angle_deg",
                      options.max_angle_deg);
}

void expect_valid(const FamilyChecks& checks, const StraightPathOptions& o) {
  checks.expect_order("min_start_distance", o.min_start_distance, "max_start_distance",
                      o.max_start_distance);
  expect_valid(checks, o.angle);
  const double room = o.length - 2 * o.start_goal.margin;
  checks.expect(o.start_goal.min_distance < room, "min_distance",
                "start and goal cannot be min_distance apart within the margins",
                "less than " + format_number(room));
  checks.expect(o.max_start_distance + o.goal_distance <= room, "max_start_distance",
                "start and goal do not fit within the margins",
                "at most " + format_number(room - o.goal_distance));
  checks.expect(o.start_goal.margin <= room_beside(o), "margin",
                "leaves no room for the straight path", "at most three eighths of height");
}

void StartAngleOptions::visit(OptionVisitor& v) {
  v.option("min_angle_deg", min_angle_deg, "deg", "minimum angle between start heading and axis",
           Range::between(0, 180));
  v.option("max_angle_deg", max_angle_deg, "deg", "maximum angle between start heading and axis",
           Range::between(0, 180));
}

void StraightPathOptions::visit(OptionVisitor& v) {
  v.option("length", length, "m", "length of the workspace, along the straight path",
           Range::positive());
  v.option("height", height, "m", "height of the workspace, across the straight path",
           Range::positive());
  v.option("min_start_distance", min_start_distance, "m",
           "minimum distance of the start from the place ahead", Range::positive());
  v.option("max_start_distance", max_start_distance, "m",
           "maximum distance of the start from the place ahead", Range::positive());
  v.option("goal_distance", goal_distance, "m", "distance of the goal from the place ahead",
           Range::positive());
  angle.visit(v);
  start_goal.visit(v);
}

}  // namespace slalom
