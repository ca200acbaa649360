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
MetricPtr make_spl();
MetricPtr make_path_length();
MetricPtr make_time_to_goal();
MetricPtr make_min_clearance();
MetricPtr make_mean_clearance();

}  // namespace slalom
