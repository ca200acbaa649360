#pragma once

#include <slalom/trajectory/path.h>

#include <functional>
#include <vector>

namespace slalom {

/// The middles of equal pieces of the path, none longer than `longest` (m), in order from its
/// start. At most 100000 pieces; none of a path of no length.
std::vector<mrpt::math::TPoint2D> piece_middles(const Path& path, double longest);

/// The ends of those pieces, one more than there are pieces.
std::vector<mrpt::math::TPoint2D> piece_ends(const Path& path, double longest);

/// Share of the path's length at which a value is below a limit: linear between the ends of pieces.
double share_below(const Path& path, double longest, double limit,
                   const std::function<double(const mrpt::math::TPoint2D&)>& value);

}  // namespace slalom
