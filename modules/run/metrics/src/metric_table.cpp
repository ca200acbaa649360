// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/metrics/metric.h>
#include <slalom/metrics/mover_metrics.h>

/// The metrics, in the order of definitions.md: id, version, name, unit, better direction, kind
/// and range of the values (value.h). The function of a metric is slalom::metrics::ID, in a source
/// of this folder.
#define SLALOM_METRICS(METRIC)                                                                    \
  METRIC(success, 1, "Success", "-", Up, Rate, between(0, 1))                                     \
  METRIC(optimality, 3, "Optimality", "-", Up, Ratio, between(0, 1))                              \
  METRIC(optimality_area, 2, "Optimality area", "m", Down, Amount, at_least(0))                   \
  METRIC(safety, 2, "Safety", "-", Up, Ratio, at_least(0))                                        \
  METRIC(safety_area, 2, "Safety area", "m", Down, Amount, at_least(0))                           \
  METRIC(optisafe, 3, "Optimality and safety", "-", Up, Ratio, between(0, 1))                     \
  METRIC(spl, 3, "Success weighted by path length", "-", Up, Score, between(0, 1))                \
  METRIC(soft_spl, 3, "Soft success weighted by path length", "-", Up, Ratio, between(0, 1))      \
  METRIC(barn_score_v2, 2, "BARN challenge score", "-", Up, Score, between(0, 0.5))               \
  METRIC(path_length, 2, "Path length", "m", Down, Amount, at_least(0))                           \
  METRIC(path_excess, 3, "Path excess", "-", Down, Ratio, at_least(0))                            \
  METRIC(time_to_goal, 1, "Time to goal", "s", Down, Amount, at_least(0))                         \
  METRIC(par2_time, 1, "Time, failures penalized", "s", Down, Amount, at_least(0))                \
  METRIC(time_ratio, 2, "Time ratio", "-", Down, Ratio, at_least(0))                              \
  METRIC(min_clearance, 1, "Minimum clearance", "m", Up, Amount, any())                           \
  METRIC(mean_clearance, 1, "Mean clearance", "m", Up, Amount, any())                             \
  METRIC(risk_time_ratio, 1, "Time at risk", "-", Down, Ratio, between(0, 1))                     \
  METRIC(inverse_clearance, 1, "Inverse clearance", "1/m", Down, Amount, between(0, 100))         \
  METRIC(impact_speed, 1, "Impact speed", "m/s", Down, Amount, at_least(0))                       \
  METRIC(min_time_to_collision, 1, "Minimum time to collision", "s", Up, Amount, at_least(0))     \
  METRIC(progress, 2, "Progress", "-", Up, Ratio, at_most(1))                                     \
  METRIC(final_distance, 1, "Final distance to the goal", "m", Down, Amount, at_least(0))         \
  METRIC(closest_distance, 1, "Closest distance to the goal", "m", Down, Amount, at_least(0))     \
  METRIC(mean_speed, 2, "Mean speed", "m/s", Up, Amount, at_least(0))                             \
  METRIC(time_stopped, 1, "Time stopped", "s", Down, Amount, at_least(0))                         \
  METRIC(cumulative_heading_change, 1, "Heading change", "rad", Down, Amount, at_least(0))        \
  METRIC(angle_over_length, 2, "Angle over length", "rad/m", Down, Amount, at_least(0))           \
  METRIC(bending_energy, 1, "Bending energy", "1/m^2", Down, Amount, at_least(0))                 \
  METRIC(max_curvature, 1, "Maximum curvature", "1/m", Down, Amount, at_least(0))                 \
  METRIC(path_irregularity, 3, "Path irregularity", "rad/m", Down, Amount, at_least(0))           \
  METRIC(rms_linear_acceleration, 1, "Linear acceleration", "m/s^2", Down, Amount, at_least(0))   \
  METRIC(rms_angular_acceleration, 1, "Angular acceleration", "rad/s^2", Down, Amount,            \
         at_least(0))                                                                             \
  METRIC(rms_linear_jerk, 1, "Linear jerk", "m/s^3", Down, Amount, at_least(0))                   \
  METRIC(rms_angular_jerk, 1, "Angular jerk", "rad/s^3", Down, Amount, at_least(0))               \
  METRIC(sparc, 1, "Spectral arc length", "-", Up, Ratio, at_most(-1))                            \
  METRIC(log_dimensionless_jerk, 1, "Log dimensionless jerk", "-", Up, Ratio, any())              \
  METRIC(command_variation_v, 1, "Linear command variation", "m/s", Down, Amount, at_least(0))    \
  METRIC(command_variation_w, 1, "Angular command variation", "rad/s", Down, Amount, at_least(0)) \
  METRIC(oscillation_count, 1, "Oscillations", "count", Down, Count, at_least(0))                 \
  METRIC(frechet_to_reference, 2, "Frechet distance to P*", "m", Down, Amount, at_least(0))       \
  METRIC(hausdorff_to_reference, 2, "Hausdorff distance to P*", "m", Down, Amount, at_least(0))

/// Metrics about the heading of a goal.
#define SLALOM_GOAL_HEADING_METRICS(METRIC) \
  METRIC(goal_heading_error, 1, "Heading error at the goal", "rad", Down, Amount, between(0, M_PI))

/// Metrics about moving obstacles.
#define SLALOM_MOVER_METRICS(METRIC)                                                               \
  METRIC(mover_collision, 1, "Collision with a mover", "-", Down, Rate, between(0, 1))             \
  METRIC(contact_mover, 1, "Mover in contact", "-", None, Count, at_least(0))                      \
  METRIC(mover_contact_speed, 1, "Speed at the contact with a mover", "m/s", Down, Amount,         \
         at_least(0))                                                                              \
  METRIC(stood_at_contact, 1, "Stood at the contact with a mover", "-", Up, Rate, between(0, 1))   \
  METRIC(min_mover_clearance, 1, "Minimum clearance from movers", "m", Up, Amount, any())          \
  METRIC(mover_time_to_collision, 1, "Minimum time to collision with movers", "s", Up, Amount,     \
         at_least(0))                                                                              \
  METRIC(personal_space_time, 1, "Time in personal space", "s", Down, Amount, at_least(0))         \
  METRIC(personal_space_depth, 1, "Depth of the intrusion into personal space", "m", Down, Amount, \
         between(0, 1.2))                                                                          \
  METRIC(intimate_space_time, 1, "Time in intimate space", "s", Down, Amount, at_least(0))         \
  METRIC(frozen_time, 1, "Time frozen", "s", Down, Amount, at_least(0))                            \
  METRIC(arrival_ratio, 1, "Arrival ratio", "-", Down, Ratio, at_least(1))

/// Metrics about people.
#define SLALOM_PEOPLE_METRICS(METRIC)                                                           \
  METRIC(people_hindrance, 1, "Hindrance of people", "s", Down, Amount, any())                  \
  METRIC(people_hindered, 1, "Hindered people", "-", Down, Ratio, between(0, 1))                \
  METRIC(people_speed_change, 1, "Speed change of people", "m/s", Down, Amount, at_least(0))    \
  METRIC(people_deficit, 1, "Deficit of people", "s", Down, Amount, any())                      \
  METRIC(people_delay, 1, "Delay of people", "s", Down, Amount, any())                          \
  METRIC(people_delay_floor, 1, "Floor of the delay of people", "s", None, Amount, at_least(0)) \
  METRIC(people_overlap, 1, "Overlap of people", "m", None, Amount, at_least(0))                \
  METRIC(contact_blame, 1, "Blame for the contact with a person", "-", Down, Rate, between(0, 1))

namespace slalom {
namespace metrics {

#define SLALOM_DECLARE(id, ...) Value id(const MetricContext& context);
SLALOM_METRICS(SLALOM_DECLARE)
SLALOM_GOAL_HEADING_METRICS(SLALOM_DECLARE)
SLALOM_MOVER_METRICS(SLALOM_DECLARE)
SLALOM_PEOPLE_METRICS(SLALOM_DECLARE)
#undef SLALOM_DECLARE

}  // namespace metrics

const std::vector<Metric>& all_metrics() {
#define SLALOM_ENTRY(id, version, name, unit, direction, kind, range) \
  {{#id, version, name, unit, Direction::direction, QuantityKind::kind, Range::range}, metrics::id},
  static const std::vector<Metric> table = {
      SLALOM_METRICS(SLALOM_ENTRY) SLALOM_GOAL_HEADING_METRICS(SLALOM_ENTRY)
          SLALOM_MOVER_METRICS(SLALOM_ENTRY) SLALOM_PEOPLE_METRICS(SLALOM_ENTRY)};
#undef SLALOM_ENTRY
  return table;
}

const std::vector<std::string>& reached_metric_ids() {
  static const std::vector<std::string> ids = {"optimality",
                                               "optimality_area",
                                               "safety",
                                               "safety_area",
                                               "optisafe",
                                               "path_excess",
                                               "time_to_goal",
                                               "time_ratio",
                                               "path_irregularity",
                                               "arrival_ratio",
                                               "frechet_to_reference",
                                               "hausdorff_to_reference"};
  return ids;
}

const std::vector<std::string>& mover_metric_ids() {
#define SLALOM_ID(id, ...) #id,
  static const std::vector<std::string> ids = {SLALOM_MOVER_METRICS(SLALOM_ID)};
#undef SLALOM_ID
  return ids;
}

const std::vector<std::string>& people_metric_ids() {
#define SLALOM_ID(id, ...) #id,
  static const std::vector<std::string> ids = {SLALOM_PEOPLE_METRICS(SLALOM_ID)};
#undef SLALOM_ID
  return ids;
}

const std::vector<std::string>& goal_heading_metric_ids() {
#define SLALOM_ID(id, ...) #id,
  static const std::vector<std::string> ids = {SLALOM_GOAL_HEADING_METRICS(SLALOM_ID)};
#undef SLALOM_ID
  return ids;
}

}  // namespace slalom
