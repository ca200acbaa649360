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

}  // namespace slalom
