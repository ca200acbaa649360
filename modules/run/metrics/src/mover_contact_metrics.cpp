// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"
#include "mover_encounters.h"

#include <slalom/core/math.h>
#include <slalom/scenario/touched_mover.h>
#include <slalom/trajectory/standing.h>

#include <cmath>

namespace slalom {
namespace {

/// NA with the reason unless the run ended in contact with a mover.
std::optional<Value> na_unless_touched(const MetricContext& context) {
  if (const auto na = na_without_movers(context)) return na;
  if (context.outcome != Outcome::Collision)
    return Value::na("outcome: " + to_string(context.outcome));
  if (touched_mover(context) != nullptr) return std::nullopt;
  return Value::na("contact with a static obstacle");
}

}  // namespace

const Mover* touched_mover(const MetricContext& context) {
  if (context.outcome != Outcome::Collision || context.trajectory.samples.empty()) return nullptr;
  const Sample& last = context.trajectory.samples.back();
  const Footprint footprint = context.robot.shape();
  return touched_mover(context.world, context.movers, mrpt::math::TPoint2D(last.pose),
                       footprint.enclosing_radius(), footprint.corners_at(last.pose),
                       run_time(context, last));
}

namespace metrics {

Value mover_collision(const MetricContext& context) {
  if (const auto na = na_without_movers(context)) return *na;
  if (const auto na = na_without_verdict(context)) return *na;
  return Value::of(touched_mover(context) != nullptr ? 1 : 0);
}

/// Its index in the scenario, which is the id of its tracks.
Value contact_mover(const MetricContext& context) {
  if (const auto na = na_unless_touched(context)) return *na;
  return Value::of(static_cast<double>(touched_mover(context) - context.movers.data()));
}

/// Speed of the robot in a contact with a mover, whatever its direction.
Value mover_contact_speed(const MetricContext& context) {
  if (const auto na = na_unless_touched(context)) return *na;
  const Sample& last = context.trajectory.samples.back();
  return Value::of(math::hypot(last.v, last.vy));
}

/// 1 if the robot had stood before a contact with a mover, so that the mover ran into it.
Value stood_at_contact(const MetricContext& context) {
  if (const auto na = na_unless_touched(context)) return *na;
  const Trajectory& trajectory = context.trajectory;
  const Sample& last = trajectory.samples.back();
  return Value::of(has_stood(trajectory, last.t, last.pose, context.robot.shape().is_disc()) ? 1
                                                                                             : 0);
}

}  // namespace metrics
}  // namespace slalom
