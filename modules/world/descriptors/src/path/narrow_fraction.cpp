// SPDX-License-Identifier: BSD-3-Clause
#include "along_path.h"

#include <slalom/descriptors/descriptor.h>

namespace slalom::descriptors {

/// Fraction of P*'s length where 2 d is less than 1.5 times the robot's width. d is sampled every
/// quarter of a cell and interpolated linearly.
Value narrow_fraction(const DescriptorContext& context) {
  constexpr double kNarrow = 1.5;          // robot widths
  constexpr double kSegmentLength = 0.25;  // cells
  const KnownPath& shortest = context.shortest();
  if (shortest.path.empty()) return Value::na(shortest.reason);
  if (!(shortest.length > 0)) return Value::na("start and goal coincide");
  const double narrow = kNarrow * context.robot_radius();
  const DistanceField& field = context.world.distance_field();
  return Value::of(fraction_below(
      shortest.path, kSegmentLength * context.world.occupancy().resolution(), narrow - 1e-9,
      [&](const mrpt::math::TPoint2D& point) { return field.clearance(point); }));
}

}  // namespace slalom::descriptors
