#include "common.h"
#include "mover_encounters.h"
#include "touched_mover.h"

#include <slalom/scenario/geometry.h>
#include <slalom/trajectory/standing.h>

#include <cmath>

namespace slalom {
namespace {

/// Distance (m) of the mover from the footprint.
double gap_at(const MetricContext& context, const Sample& sample, const Mover& mover) {
  const auto center = mover.position(run_time(context, sample));
  const Footprint footprint = context.robot.shape();
  if (footprint.is_disc()) return distance_between(center, sample.pose) - reach_of(context, mover);
  return distance(center, Polygon{footprint.corners_at(sample.pose)}) - mover.radius;
}

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
  double nearest = context.clearances.back();
  const Mover* touched = nullptr;
  for (const Mover& mover : context.world.scenario().movers()) {
    if (!mover.present(run_time(context, last))) continue;
    const double gap = gap_at(context, last, mover);
    if (gap >= nearest) continue;
    nearest = gap;
    touched = &mover;
  }
  return touched;
}

namespace metrics {

Value mover_collision(const MetricContext& context) {
  if (const auto na = na_without_movers(context)) return *na;
  if (const auto na = na_without_verdict(context)) return *na;
  return Value::of(touched_mover(context) != nullptr ? 1 : 0);
}

/// Speed of the robot in a contact with a mover, whatever its direction.
Value mover_contact_speed(const MetricContext& context) {
  if (const auto na = na_unless_touched(context)) return *na;
  const Sample& last = context.trajectory.samples.back();
  return Value::of(std::hypot(last.v, last.vy));
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
