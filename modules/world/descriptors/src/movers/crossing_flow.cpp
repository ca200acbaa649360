// SPDX-License-Identifier: BSD-3-Clause
#include "horizon.h"

#include <slalom/descriptors/descriptor.h>

namespace slalom::descriptors {
namespace {

using mrpt::math::TPoint2D;

/// Whether p is to the left of the line from a to b, or on it.
bool is_left(const TPoint2D& a, const TPoint2D& b, const TPoint2D& p) {
  const TPoint2D along = b - a, to = p - a;
  return along.x * to.y - along.y * to.x >= 0;
}

/// A common end of two segments counts for one of them.
bool cross(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c, const TPoint2D& d) {
  return is_left(a, b, c) != is_left(a, b, d) && is_left(c, d, a) != is_left(c, d, b);
}

}  // namespace

/// How often centers of movers cross P* in the first 12 s, per s.
Value crossing_flow(const DescriptorContext& context) {
  const Movers& movers = context.world.scenario().movers();
  if (movers.empty()) return Value::na(kNoMovers);
  const KnownPath& shortest = context.shortest();
  if (shortest.path.empty()) return Value::na(shortest.reason);
  const Path& path = shortest.path;
  int crossings = 0;
  for (const Mover& mover : movers)
    for (const MoverSegment& segment : segments_of(mover, kMoverHorizon)) {
      const TPoint2D end = segment.from + segment.velocity * (segment.end - segment.begin);
      for (std::size_t i = 1; i < path.size(); ++i)
        crossings += cross(segment.from, end, path[i - 1], path[i]) ? 1 : 0;
    }
  return Value::of(crossings / kMoverHorizon);
}

}  // namespace slalom::descriptors
