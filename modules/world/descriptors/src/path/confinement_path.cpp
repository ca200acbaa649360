// SPDX-License-Identifier: BSD-3-Clause
#include "../clearance/confined_fraction.h"
#include "along_path.h"

#include <slalom/descriptors/descriptor.h>

namespace slalom::descriptors {

/// Mean along P* of the fraction of directions in which a ray hits O within R, at the midpoints of
/// segments of at most a cell's length.
Value confinement_path(const DescriptorContext& context) {
  const KnownPath& shortest = context.shortest();
  if (shortest.path.empty()) return Value::na(shortest.reason);
  double sum = 0;
  int points = 0;
  for (const mrpt::math::TPoint2D& point :
       segment_midpoints(shortest.path, context.world.occupancy().resolution()))
    sum += confined_fraction(context.world, point, context.sensor_range,
                             fractional_part(++points * kGoldenRatio));
  if (points == 0) return Value::na("start and goal coincide");
  return Value::of(sum / points);
}

}  // namespace slalom::descriptors
