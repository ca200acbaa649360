// SPDX-License-Identifier: BSD-3-Clause
#include "descriptor_parameters.h"

/// The descriptors, in the order of definitions.md: id, version, name, unit, kind and range of the
/// values (value.h), and the parameters that the value depends on (parameters.h). The function of a
/// descriptor is slalom::descriptors::ID, in a source of the folders here.
#define SLALOM_DESCRIPTORS(DESCRIPTOR)                                                            \
  DESCRIPTOR(density, 1, "Density", "-", Ratio, between(0, 1), {resolution})                      \
  DESCRIPTOR(cspace_density, 1, "Configuration-space density", "-", Ratio, between(0, 1),         \
             {robot, resolution})                                                                 \
  DESCRIPTOR(clearness, 1, "Clearness", "-", Ratio, between(0, 1), {sensor_range, resolution})    \
  DESCRIPTOR(clearness_mean_distance, 1, "Mean distance to obstacles", "m", Amount, at_least(0),  \
             {resolution})                                                                        \
  DESCRIPTOR(confinement, 1, "Confinement", "-", Ratio, between(0, 1),                            \
             {sensor_range, resolution, confinement_method})                                      \
  DESCRIPTOR(confinement_path, 2, "Confinement along the shortest path", "-", Ratio,              \
             between(0, 1), {sensor_range, robot, resolution})                                    \
  DESCRIPTOR(bottleneck_width, 1, "Bottleneck width", "m", Amount, at_least(0),                   \
             {robot, resolution})                                                                 \
  DESCRIPTOR(narrow_fraction, 2, "Narrow-passage fraction", "-", Ratio, between(0, 1),            \
             {robot, resolution})                                                                 \
  DESCRIPTOR(clearance_mean, 1, "Mean clearance", "m", Amount, at_least(0), {robot, resolution})  \
  DESCRIPTOR(clearance_q05, 1, "Clearance, 5 % quantile", "m", Amount, at_least(0),               \
             {robot, resolution})                                                                 \
  DESCRIPTOR(detour_ratio, 2, "Detour ratio", "-", Ratio, at_least(1), {robot, resolution})       \
  DESCRIPTOR(turn_density, 3, "Turn density", "rad/m", Amount, at_least(0), {robot, resolution})  \
  DESCRIPTOR(trap_fraction, 1, "Local-minimum traps", "-", Ratio, between(0, 1),                  \
             {robot, resolution})                                                                 \
  DESCRIPTOR(obstacle_count, 1, "Obstacle components", "count", Count, at_least(0), {resolution}) \
  DESCRIPTOR(clustering, 1, "Clustering index", "-", Ratio, at_least(0), {quadrats, resolution})  \
  DESCRIPTOR(occupancy_entropy, 1, "Occupancy entropy", "bit", Amount, between(0, 1),             \
             {block, resolution})                                                                 \
  DESCRIPTOR(goal_visibility, 2, "Goal visibility", "-", Ratio, between(0, 1),                    \
             {robot, resolution})                                                                 \
  DESCRIPTOR(traversability, 3, "Traversability", "-", Ratio, at_least(0), {robot, resolution})   \
  DESCRIPTOR(barn_closest_distance, 2, "BARN: distance to closest obstacle", "cells", Amount,     \
             at_least(0), {averaged_path})                                                        \
  DESCRIPTOR(barn_visibility, 2, "BARN: average visibility", "cells", Amount, at_least(0),        \
             {averaged_path, barn_version})                                                       \
  DESCRIPTOR(barn_dispersion, 2, "BARN: dispersion", "-", Ratio, between(0, 16), {averaged_path}) \
  DESCRIPTOR(barn_characteristic_dimension, 2, "BARN: characteristic dimension", "cells", Amount, \
             at_least(0), {averaged_path})                                                        \
  DESCRIPTOR(barn_tortuosity, 2, "BARN: tortuosity", "-", Ratio, at_least(1), {averaged_path})    \
  DESCRIPTOR(dynamic_density, 1, "Moving-obstacle density", "-", Ratio, at_least(0), {})          \
  DESCRIPTOR(predicted_difficulty, 1, "Predicted difficulty", "logit", Amount, any(),             \
             {robot, resolution})

/// Descriptors of moving obstacles.
#define SLALOM_MOVER_DESCRIPTORS(DESCRIPTOR)                                                      \
  DESCRIPTOR(survivability, 2, "Survivability", "s", Amount, between(0, 12), {robot, resolution}) \
  DESCRIPTOR(dynamic_traversability, 2, "Dynamic traversability", "-", Ratio, at_least(0),        \
             {robot, resolution})                                                                 \
  DESCRIPTOR(crossing_flow, 1, "Flow of movers across the shortest path", "1/s", Amount,          \
             at_least(0), {robot, resolution})

namespace slalom {
namespace descriptors {

#define SLALOM_DECLARE(id, ...) Value id(const DescriptorContext& context);
SLALOM_DESCRIPTORS(SLALOM_DECLARE)
SLALOM_MOVER_DESCRIPTORS(SLALOM_DECLARE)
#undef SLALOM_DECLARE

}  // namespace descriptors

const std::vector<Descriptor>& all_descriptors() {
  using namespace descriptors;
#define SLALOM_ENTRY(id, version, name, unit, kind, range, ...) \
  {{#id, version, name, unit, Direction::None, QuantityKind::kind, Range::range}, __VA_ARGS__, id},
  static const std::vector<Descriptor> table = {SLALOM_DESCRIPTORS(SLALOM_ENTRY)
                                                    SLALOM_MOVER_DESCRIPTORS(SLALOM_ENTRY)};
#undef SLALOM_ENTRY
  return table;
}

const std::vector<std::string>& mover_descriptor_ids() {
#define SLALOM_ID(id, ...) #id,
  static const std::vector<std::string> ids = {SLALOM_MOVER_DESCRIPTORS(SLALOM_ID)};
#undef SLALOM_ID
  return ids;
}

}  // namespace slalom
