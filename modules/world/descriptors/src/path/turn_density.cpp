// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/descriptors/descriptor.h>

#include <cmath>
#include <optional>

namespace slalom::descriptors {

/// Sum of |heading change| along P* / L*.
Value turn_density(const DescriptorContext& context) {
  const KnownPath& shortest = context.shortest();
  if (shortest.path.empty()) return Value::na(shortest.reason);
  if (!(shortest.length > 0)) return Value::na("start and goal coincide");
  double turned = 0;
  std::optional<mrpt::math::TPoint2D> before;
  for (std::size_t i = 1; i < shortest.path.size(); ++i) {
    const mrpt::math::TPoint2D leg = shortest.path[i] - shortest.path[i - 1];
    if (!(leg.norm() > 0)) continue;
    if (before)
      turned += std::abs(math::atan2(before->x * leg.y - before->y * leg.x,
                                     before->x * leg.x + before->y * leg.y));
    before = leg;
  }
  return Value::of(turned / shortest.length);
}

}  // namespace slalom::descriptors
