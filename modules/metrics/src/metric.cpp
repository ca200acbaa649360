#include "families.h"

#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>
#include <slalom/metrics/metric.h>

namespace slalom {

const std::vector<std::shared_ptr<const Metric>>& all_metrics() {
  static const std::vector<MetricPtr> metrics = {
      make_success(),
      make_optimality(),
      make_optimality_area(),
      make_safety(),
      make_safety_area(),
      make_optisafe(),
      make_spl(),
      make_soft_spl(),
      make_barn_score(),
      make_path_length(),
      make_path_excess(),
      make_time_to_goal(),
      make_par2_time(),
      make_time_ratio(),
      make_min_clearance(),
      make_mean_clearance(),
      make_risk_time_ratio(),
      make_inverse_clearance(),
      make_impact_speed(),
      make_min_time_to_collision(),
      make_progress(),
      make_final_distance(),
      make_closest_distance(),
      make_mean_speed(),
      make_time_stopped(),
      make_cumulative_heading_change(),
      make_angle_over_length(),
      make_bending_energy(),
      make_max_curvature(),
      make_path_irregularity(),
      make_rms_linear_acceleration(),
      make_rms_angular_acceleration(),
      make_rms_linear_jerk(),
      make_rms_angular_jerk(),
      make_sparc(),
      make_log_dimensionless_jerk(),
      make_command_variation_v(),
      make_command_variation_w(),
      make_oscillation_count(),
      make_frechet_to_reference(),
      make_hausdorff_to_reference(),
  };
  return metrics;
}

const Metric& metric(const std::string& id) {
  std::vector<std::string> ids;
  for (const MetricPtr& candidate : all_metrics()) {
    ids.push_back(candidate->info().id);
    if (ids.back() == id) return *candidate;
  }
  const std::string nearest = nearest_name(id, ids);
  throw usage_error("metric", "unknown id '" + id + "'",
                    nearest.empty() ? "one of " + join(ids, ", ") : "'" + nearest + "'");
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
                                  double goal_tolerance, double safe_distance) {
  MetricContext context{world,    robot,          trajectory,    outcome, references,
                        max_time, goal_tolerance, safe_distance, {}};
  const Footprint footprint = robot.shape();
  context.clearances.reserve(trajectory.samples.size());
  for (const Sample& sample : trajectory.samples)
    context.clearances.push_back(footprint_clearance(world, footprint, sample.pose));
  return context;
}

}  // namespace slalom
