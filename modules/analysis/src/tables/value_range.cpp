#include <slalom/analysis/cell.h>

namespace slalom {
namespace {

bool is_one_of(const std::string& id, std::initializer_list<const char*> ids) {
  for (const char* other : ids) {
    if (id == other) return true;
  }
  return false;
}

}  // namespace

ValueRange range_of(const std::string& id) {
  if (is_one_of(id, {"success", "spl", "soft_spl", "optisafe", "risk_time_ratio",
                     "deadline_miss_ratio", "density", "clearness", "confinement"})) {
    return {0.0, 1.0};
  }
  if (id == "barn_score_v2") return {0.0, 0.5};
  if (id == "progress") return {std::nullopt, 1.0};
  if (id == "sparc") return {std::nullopt, 0.0};
  if (is_one_of(id, {"optimality",
                     "safety",
                     "optimality_area",
                     "safety_area",
                     "path_length",
                     "time_to_goal",
                     "par2_time",
                     "time_ratio",
                     "arrival_ratio",
                     "inverse_clearance",
                     "impact_speed",
                     "min_time_to_collision",
                     "final_distance",
                     "closest_distance",
                     "mean_speed",
                     "time_stopped",
                     "cumulative_heading_change",
                     "angle_over_length",
                     "bending_energy",
                     "max_curvature",
                     "path_irregularity",
                     "rms_linear_acceleration",
                     "rms_angular_acceleration",
                     "rms_linear_jerk",
                     "rms_angular_jerk",
                     "command_variation_v",
                     "command_variation_w",
                     "oscillation_count",
                     "frechet_to_reference",
                     "hausdorff_to_reference",
                     "cycle_time_mean",
                     "cycle_time_p50",
                     "cycle_time_p95",
                     "cycle_time_p99",
                     "cycle_time_max"})) {
    return {0.0, std::nullopt};
  }
  return {};
}

}  // namespace slalom
