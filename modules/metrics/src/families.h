#pragma once

#include <slalom/metrics/metric.h>

namespace slalom {

/// The close families of metrics, one source file each; all_metrics() lists them.
using MetricPtr = std::shared_ptr<const Metric>;

MetricPtr make_success();
MetricPtr make_optimality();
MetricPtr make_optimality_area();
MetricPtr make_safety();
MetricPtr make_safety_area();
MetricPtr make_optisafe();
MetricPtr make_spl();
MetricPtr make_soft_spl();
MetricPtr make_barn_score();
MetricPtr make_path_length();
MetricPtr make_path_excess();
MetricPtr make_time_to_goal();
MetricPtr make_par2_time();
MetricPtr make_time_ratio();
MetricPtr make_min_clearance();
MetricPtr make_mean_clearance();
MetricPtr make_risk_time_ratio();
MetricPtr make_inverse_clearance();
MetricPtr make_impact_speed();
MetricPtr make_min_time_to_collision();
MetricPtr make_progress();
MetricPtr make_final_distance();
MetricPtr make_closest_distance();
MetricPtr make_mean_speed();
MetricPtr make_time_stopped();
MetricPtr make_cumulative_heading_change();
MetricPtr make_angle_over_length();
MetricPtr make_bending_energy();
MetricPtr make_max_curvature();
MetricPtr make_path_irregularity();
MetricPtr make_rms_linear_acceleration();
MetricPtr make_rms_angular_acceleration();
MetricPtr make_rms_linear_jerk();
MetricPtr make_rms_angular_jerk();
MetricPtr make_sparc();
MetricPtr make_log_dimensionless_jerk();
MetricPtr make_command_variation_v();
MetricPtr make_command_variation_w();
MetricPtr make_oscillation_count();
MetricPtr make_frechet_to_reference();
MetricPtr make_hausdorff_to_reference();

}  // namespace slalom
