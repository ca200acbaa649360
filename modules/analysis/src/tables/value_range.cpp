#include <slalom/analysis/cell.h>

#include <optional>

namespace slalom {
namespace {

/// By docs/definitions.md. Clearances have none: a collision ends slightly inside an obstacle.
struct KnownRange {
  const char* id;
  ValueRange range;
};
constexpr ValueRange kFraction{0.0, 1.0}, kAtLeast0{0.0, std::nullopt},
    kAtLeast1{1.0, std::nullopt};
constexpr KnownRange kKnownRanges[] = {
    {"success", kFraction},
    {"optimality", kFraction},
    {"optimality_area", kAtLeast0},
    {"safety", kAtLeast0},
    {"safety_area", kAtLeast0},
    {"optisafe", kFraction},
    {"spl", kFraction},
    {"soft_spl", kFraction},
    {"barn_score_v2", {0.0, 0.5}},
    {"path_length", kAtLeast0},
    {"path_excess", kAtLeast0},
    {"time_to_goal", kAtLeast0},
    {"par2_time", kAtLeast0},
    {"time_ratio", kAtLeast0},
    {"risk_time_ratio", kFraction},
    {"inverse_clearance", kAtLeast0},
    {"impact_speed", kAtLeast0},
    {"min_time_to_collision", kAtLeast0},
    {"progress", {std::nullopt, 1.0}},
    {"final_distance", kAtLeast0},
    {"closest_distance", kAtLeast0},
    {"mean_speed", kAtLeast0},
    {"time_stopped", kAtLeast0},
    {"cumulative_heading_change", kAtLeast0},
    {"angle_over_length", kAtLeast0},
    {"bending_energy", kAtLeast0},
    {"max_curvature", kAtLeast0},
    {"path_irregularity", kAtLeast0},
    {"rms_linear_acceleration", kAtLeast0},
    {"rms_angular_acceleration", kAtLeast0},
    {"rms_linear_jerk", kAtLeast0},
    {"rms_angular_jerk", kAtLeast0},
    {"sparc", {std::nullopt, 0.0}},
    {"command_variation_v", kAtLeast0},
    {"command_variation_w", kAtLeast0},
    {"oscillation_count", kAtLeast0},
    {"frechet_to_reference", kAtLeast0},
    {"hausdorff_to_reference", kAtLeast0},
    {"mover_collision", kFraction},
    {"contact_mover", kAtLeast0},
    {"mover_contact_speed", kAtLeast0},
    {"stood_at_contact", kFraction},
    {"mover_time_to_collision", kAtLeast0},
    {"personal_space_time", kAtLeast0},
    {"personal_space_depth", {0.0, 1.2}},
    {"intimate_space_time", kAtLeast0},
    {"frozen_time", kAtLeast0},
    {"arrival_ratio", kAtLeast1},
    {"cycle_time_mean", kAtLeast0},
    {"cycle_time_p50", kAtLeast0},
    {"cycle_time_p95", kAtLeast0},
    {"cycle_time_p99", kAtLeast0},
    {"cycle_time_max", kAtLeast0},
    {"deadline_miss_ratio", kFraction},
    {"density", kFraction},
    {"cspace_density", kFraction},
    {"clearness", kFraction},
    {"clearness_mean_distance", kAtLeast0},
    {"confinement", kFraction},
    {"confinement_path", kFraction},
    {"bottleneck_width", kAtLeast0},
    {"narrow_fraction", kFraction},
    {"clearance_mean", kAtLeast0},
    {"clearance_q05", kAtLeast0},
    {"detour_ratio", kAtLeast1},
    {"turn_density", kAtLeast0},
    {"trap_fraction", kFraction},
    {"obstacle_count", kAtLeast0},
    {"clustering", kAtLeast0},
    {"occupancy_entropy", kFraction},
    {"goal_visibility", kFraction},
    {"traversability", kAtLeast0},
    {"barn_closest_distance", kAtLeast0},
    {"barn_visibility", kAtLeast0},
    {"barn_dispersion", kAtLeast0},
    {"barn_characteristic_dimension", kAtLeast0},
    {"barn_tortuosity", kAtLeast0},
    {"dynamic_density", kAtLeast0},
    {"survivability", {0.0, 12.0}},
    {"dynamic_traversability", kAtLeast0},
    {"crossing_flow", kAtLeast0},
};

}  // namespace

ValueRange range_of(const std::string& id) {
  for (const KnownRange& known : kKnownRanges)
    if (id == known.id) return known.range;
  return {};
}

}  // namespace slalom
