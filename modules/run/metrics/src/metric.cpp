// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/metrics/metric.h>

namespace slalom {

const Metric& metric(const std::string& id) {
  for (const Metric& candidate : all_metrics())
    if (candidate.info.id == id) return candidate;
  throw usage_error("metric", "unknown id '" + id + "'", expected_name(id, metric_ids()));
}

std::vector<std::string> metric_ids() {
  std::vector<std::string> ids;
  for (const Metric& each : all_metrics()) ids.push_back(each.info.id);
  return ids;
}

double footprint_clearance(const World& world, const Footprint& footprint,
                           const mrpt::math::TPose2D& pose) {
  const DistanceField& field = world.distance_field();
  return footprint.is_disc() ? field.clearance({pose.x, pose.y}) - footprint.enclosing_radius()
                             : field.outline_clearance(footprint.corners_at(pose));
}

MetricContext make_metric_context(const World& world, const RobotModel& robot,
                                  const Trajectory& trajectory, Outcome outcome,
                                  const References& references, double max_time,
                                  double goal_tolerance, double safe_distance,
                                  const Movers* movers) {
  MetricContext context{world,         robot,
                        trajectory,    outcome,
                        references,    movers != nullptr ? *movers : world.scenario().movers(),
                        max_time,      goal_tolerance,
                        safe_distance, {}};
  const Footprint footprint = robot.shape();
  context.clearances.reserve(trajectory.samples.size());
  for (const Sample& sample : trajectory.samples)
    context.clearances.push_back(footprint_clearance(world, footprint, sample.pose));
  return context;
}

}  // namespace slalom
