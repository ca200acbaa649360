#pragma once

#include <slalom/trajectory/path.h>

#include <functional>
#include <vector>

namespace slalom {

/// The midpoints of equal segments of the path, each at most `max_length` (m), from its start. At
/// most 100000 segments; none for a path of zero length.
std::vector<mrpt::math::TPoint2D> segment_midpoints(const Path& path, double max_length);

/// The end points of those segments, one more than segments.
std::vector<mrpt::math::TPoint2D> segment_ends(const Path& path, double max_length);

/// Fraction of the path's length where a value is below a limit; linear between the ends of
/// segments.
double fraction_below(const Path& path, double max_length, double limit,
                      const std::function<double(const mrpt::math::TPoint2D&)>& value);

}  // namespace slalom
