// SPDX-License-Identifier: BSD-3-Clause
#include "departure.h"

#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/trajectory/path.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

Departure departure_at(const World& world, const Movers& movers, const RobotModel& robot,
                       const Sample& sample) {
  const double radius = robot.shape().enclosing_radius();
  const mrpt::math::TPoint2D position(sample.pose);
  Departure departure;
  departure.t = sample.t;
  departure.speed = math::hypot(sample.v, sample.vy);
  departure.goal_bearing = bearing_of(world.scenario().goal(), sample.pose);
  departure.obstacle_bearing = bearing_of_obstacle(world, sample.pose, radius / 2);
  departure.clearance = world.distance_field().clearance(position) - radius;
  for (const Mover& mover : movers) {
    const mrpt::math::TPoint2D center = mover.position(sample.t);
    const double gap = distance_between(center, position) - mover.radius - radius;
    if (!mover.present(sample.t) || gap >= departure.clearance) continue;
    departure.clearance = gap;
    departure.obstacle_bearing = bearing_of(center, sample.pose);
    departure.is_mover = true;
  }
  departure.clearance = std::max(0.0, departure.clearance);
  return departure;
}

std::string bearing_text(double bearing) {
  const std::string degrees = format_fixed(std::abs(bearing) * 180 / M_PI, 0);
  if (degrees == "0") return "straight ahead";
  if (degrees == "180") return "straight behind";
  return degrees + " degrees to the " + (bearing > 0 ? "left" : "right");
}

}  // namespace

double bearing_of_obstacle(const World& world, const mrpt::math::TPose2D& pose, double step) {
  constexpr int kDirections = 72;
  double nearest = std::numeric_limits<double>::infinity(), bearing = 0;
  for (int i = 0; i < kDirections; ++i) {
    const int step_count = (i % 2 == 0 ? 1 : -1) * ((i + 1) / 2);
    const double offset = step_count * 2 * M_PI / kDirections;
    const double clearance =
        world.distance_field().clearance({pose.x + step * math::cos(pose.phi + offset),
                                          pose.y + step * math::sin(pose.phi + offset)});
    if (clearance >= nearest - 1e-9) continue;
    nearest = clearance;
    bearing = offset;
  }
  return bearing;
}

double bearing_of(const mrpt::math::TPoint2D& point, const mrpt::math::TPose2D& pose) {
  return mrpt::math::wrapToPi(math::atan2(point.y - pose.y, point.x - pose.x) - pose.phi);
}

std::optional<Departure> find_departure(const World& world, const Movers& movers,
                                        const RobotModel& robot, const Trajectory& run,
                                        const Trajectory& reference) {
  Path path;
  for (const Sample& sample : reference.samples) path.emplace_back(sample.pose.x, sample.pose.y);
  const double radius = robot.shape().enclosing_radius();
  const auto first =
      std::find_if(run.samples.begin(), run.samples.end(), [&](const Sample& sample) {
        return distance_to_path(mrpt::math::TPoint2D(sample.pose), path) > radius;
      });
  if (first == run.samples.end()) return std::nullopt;
  return departure_at(world, movers, robot, *first);
}

std::string departure_text(const std::string& method, const std::string& reference,
                           const std::optional<Departure>& departure) {
  if (!departure) return method + " does not leave the path of " + reference;
  return method + " leaves the path of " + reference + " after " + format_fixed(departure->t, 2) +
         " s at " + format_fixed(departure->speed, 2) + " m/s; goal " +
         bearing_text(departure->goal_bearing) + ", nearest " +
         (departure->is_mover ? "moving obstacle " : "obstacle ") +
         bearing_text(departure->obstacle_bearing) + ", " + format_fixed(departure->clearance, 2) +
         " m away";
}

}  // namespace slalom
