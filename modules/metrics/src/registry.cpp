#include <slalom/metrics/metric.h>
#include <slalom/metrics/mover_metrics.h>

/// The metrics, in the order of definitions.md: id, version, name, unit, better direction. The
/// function of a metric is slalom::metrics::ID, in a source of this folder.
#define SLALOM_METRICS(METRIC)                                                 \
  METRIC(success, 1, "Success", "-", Up)                                       \
  METRIC(optimality, 3, "Optimality", "-", Up)                                 \
  METRIC(optimality_area, 2, "Optimality area", "m", Down)                     \
  METRIC(safety, 2, "Safety", "-", Up)                                         \
  METRIC(safety_area, 2, "Safety area", "m", Down)                             \
  METRIC(optisafe, 3, "Optimality and safety", "-", Up)                        \
  METRIC(spl, 3, "Success weighted by path length", "-", Up)                   \
  METRIC(soft_spl, 3, "Soft success weighted by path length", "-", Up)         \
  METRIC(barn_score_v2, 2, "BARN challenge score", "-", Up)                    \
  METRIC(path_length, 2, "Path length", "m", Down)                             \
  METRIC(path_excess, 3, "Path excess", "-", Down)                             \
  METRIC(time_to_goal, 1, "Time to goal", "s", Down)                           \
  METRIC(par2_time, 1, "Time, failures penalized", "s", Down)                  \
  METRIC(time_ratio, 2, "Time ratio", "-", Down)                               \
  METRIC(min_clearance, 1, "Minimum clearance", "m", Up)                       \
  METRIC(mean_clearance, 1, "Mean clearance", "m", Up)                         \
  METRIC(risk_time_ratio, 1, "Time at risk", "-", Down)                        \
  METRIC(inverse_clearance, 1, "Inverse clearance", "1/m", Down)               \
  METRIC(impact_speed, 1, "Impact speed", "m/s", Down)                         \
  METRIC(min_time_to_collision, 1, "Minimum time to collision", "s", Up)       \
  METRIC(progress, 2, "Progress", "-", Up)                                     \
  METRIC(final_distance, 1, "Final distance to the goal", "m", Down)           \
  METRIC(closest_distance, 1, "Closest distance to the goal", "m", Down)       \
  METRIC(mean_speed, 2, "Mean speed", "m/s", Up)                               \
  METRIC(time_stopped, 1, "Time stopped", "s", Down)                           \
  METRIC(cumulative_heading_change, 1, "Heading change", "rad", Down)          \
  METRIC(angle_over_length, 2, "Angle over length", "rad/m", Down)             \
  METRIC(bending_energy, 1, "Bending energy", "1/m^2", Down)                   \
  METRIC(max_curvature, 1, "Maximum curvature", "1/m", Down)                   \
  METRIC(path_irregularity, 3, "Path irregularity", "rad/m", Down)             \
  METRIC(rms_linear_acceleration, 1, "Linear acceleration", "m/s^2", Down)     \
  METRIC(rms_angular_acceleration, 1, "Angular acceleration", "rad/s^2", Down) \
  METRIC(rms_linear_jerk, 1, "Linear jerk", "m/s^3", Down)                     \
  METRIC(rms_angular_jerk, 1, "Angular jerk", "rad/s^3", Down)                 \
  METRIC(sparc, 1, "Spectral arc length", "-", Up)                             \
  METRIC(log_dimensionless_jerk, 1, "Log dimensionless jerk", "-", Up)         \
  METRIC(command_variation_v, 1, "Linear command variation", "m/s", Down)      \
  METRIC(command_variation_w, 1, "Angular command variation", "rad/s", Down)   \
  METRIC(oscillation_count, 1, "Oscillations", "count", Down)                  \
  METRIC(frechet_to_reference, 2, "Frechet distance to P*", "m", Down)         \
  METRIC(hausdorff_to_reference, 2, "Hausdorff distance to P*", "m", Down)

/// Those about moving obstacles.
#define SLALOM_MOVER_METRICS(METRIC)                                                       \
  METRIC(mover_collision, 1, "Collision with a mover", "-", Down)                          \
  METRIC(contact_mover, 1, "Mover in contact", "-", None)                                  \
  METRIC(mover_contact_speed, 1, "Speed at the contact with a mover", "m/s", Down)         \
  METRIC(stood_at_contact, 1, "Stood at the contact with a mover", "-", Up)                \
  METRIC(min_mover_clearance, 1, "Minimum clearance from movers", "m", Up)                 \
  METRIC(mover_time_to_collision, 1, "Minimum time to collision with movers", "s", Up)     \
  METRIC(personal_space_time, 1, "Time in personal space", "s", Down)                      \
  METRIC(personal_space_depth, 1, "Depth of the intrusion into personal space", "m", Down) \
  METRIC(intimate_space_time, 1, "Time in intimate space", "s", Down)                      \
  METRIC(frozen_time, 1, "Time frozen", "s", Down)                                         \
  METRIC(arrival_ratio, 1, "Arrival ratio", "-", Down)

namespace slalom {
namespace metrics {

#define SLALOM_DECLARE(id, ...) Value id(const MetricContext& context);
SLALOM_METRICS(SLALOM_DECLARE)
SLALOM_MOVER_METRICS(SLALOM_DECLARE)
#undef SLALOM_DECLARE

}  // namespace metrics

const std::vector<Metric>& all_metrics() {
#define SLALOM_ENTRY(id, version, name, unit, direction) \
  {{#id, version, name, unit, Direction::direction}, metrics::id},
  static const std::vector<Metric> table = {SLALOM_METRICS(SLALOM_ENTRY)
                                                SLALOM_MOVER_METRICS(SLALOM_ENTRY)};
#undef SLALOM_ENTRY
  return table;
}

const std::vector<std::string>& mover_metric_ids() {
#define SLALOM_ID(id, ...) #id,
  static const std::vector<std::string> ids = {SLALOM_MOVER_METRICS(SLALOM_ID)};
#undef SLALOM_ID
  return ids;
}

}  // namespace slalom
