// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/trajectory/path.h>

#include <functional>
#include <vector>

namespace slalom {

/// The midpoints of equal segments of the path, each at most `max_length` (m), from its start. At
/// most 100000 segments; none for a path of zero length.
std::vector<mrpt::math::TPoint2D> segment_midpoints(const Path& path, double max_length);

/// Fraction of the path's length where a value is below a limit, linear between the ends of those
/// segments. The value changes by at most 1 per m, as distances do: where it is far from the limit
/// it is not computed again.
double fraction_below(const Path& path, double max_length, double limit,
                      const std::function<double(const mrpt::math::TPoint2D&)>& value);

}  // namespace slalom
