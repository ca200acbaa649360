#pragma once

#include <slalom/metrics/metric.h>

namespace slalom {

/// The mover with which a run collided: the one at the robot in the last sample; null if a static
/// obstacle is nearer, or the run did not end in a collision.
const Mover* touched_mover(const MetricContext& context);

}  // namespace slalom
