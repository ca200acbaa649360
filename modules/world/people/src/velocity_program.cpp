// SPDX-License-Identifier: BSD-3-Clause
#include "vectors.h"

#include <slalom/people/velocity_program.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

using VelocityBounds = std::vector<VelocityBound>;

/// Sine of the angle below which two lines count as parallel.
constexpr double kParallel = 1e-5;
/// m/s: two parallel bounds that leave only a line, as of people who touch opposite walls, count as
/// kept in spite of rounding.
constexpr double kRounding = 1e-12;

enum class Objective { Nearest, Farthest };

struct Program {
  const VelocityBounds& bounds;
  double max_speed;
  TPoint2D wanted;  ///< Farthest: the direction, of length 1
  Objective objective;
};

/// The best velocity on the line of bound i within the bounds before it.
std::optional<TPoint2D> best_on_line(const Program& program, std::size_t i) {
  const VelocityBound& line = program.bounds[i];
  const TPoint2D direction(line.normal.y, -line.normal.x), foot = line.normal * line.least;
  const double disc = program.max_speed * program.max_speed - line.least * line.least;
  if (disc < 0) return std::nullopt;
  double high = std::sqrt(disc), low = -high;
  for (std::size_t j = 0; j < i; ++j) {
    const VelocityBound& bound = program.bounds[j];
    const double slope = dot(bound.normal, direction);
    const double rest = bound.least - dot(bound.normal, foot);  // slope * along >= rest
    if (std::abs(slope) <= kParallel) {
      if (rest > kRounding) return std::nullopt;
      continue;
    }
    if (slope > 0)
      low = std::max(low, rest / slope);
    else
      high = std::min(high, rest / slope);
    if (low > high) return std::nullopt;
  }
  if (program.objective == Objective::Farthest)
    return foot + direction * (dot(program.wanted, direction) > 0 ? high : low);
  return foot + direction * std::clamp(dot(direction, program.wanted - foot), low, high);
}

TPoint2D best_in_disc(const Program& program) {
  const double max_speed = program.max_speed;
  if (program.objective == Objective::Farthest) return program.wanted * max_speed;
  const double speed2 = dot(program.wanted, program.wanted);
  return speed2 > max_speed * max_speed ? program.wanted * (max_speed / std::sqrt(speed2))
                                        : program.wanted;
}

/// Adds one bound after the other. Returns the number of those that are kept; v is best for them.
std::size_t solve(const Program& program, TPoint2D& v) {
  v = best_in_disc(program);
  for (std::size_t i = 0; i < program.bounds.size(); ++i) {
    if (!(dot(program.bounds[i].normal, v) < program.bounds[i].least)) continue;
    const auto better = best_on_line(program, i);
    if (!better) return i;
    v = *better;
  }
  return program.bounds.size();
}

/// The velocities that violate bound j at most as much as bound i.
std::optional<VelocityBound> at_most_as(const VelocityBound& j, const VelocityBound& i) {
  const TPoint2D normal = j.normal - i.normal;
  const double length = norm(normal);
  if (length <= kParallel) return std::nullopt;
  return VelocityBound{normal * (1 / length), (j.least - i.least) / length};
}

/// Minimizes the greatest violation of the soft bounds; v keeps all those before `begin`.
TPoint2D least_violation(const VelocityBounds& bounds, std::size_t hard, std::size_t begin,
                         double max_speed, TPoint2D v) {
  double worst = 0;
  VelocityBounds among;
  for (std::size_t i = begin; i < bounds.size(); ++i) {
    if (!(bounds[i].least - dot(bounds[i].normal, v) > worst)) continue;
    among.assign(bounds.begin(), bounds.begin() + static_cast<std::ptrdiff_t>(hard));
    for (std::size_t j = hard; j < i; ++j)
      if (const auto bound = at_most_as(bounds[j], bounds[i])) among.push_back(*bound);
    TPoint2D better;
    if (solve({among, max_speed, bounds[i].normal, Objective::Farthest}, better) == among.size())
      v = better;
    worst = bounds[i].least - dot(bounds[i].normal, v);
  }
  return v;
}

}  // namespace

TPoint2D best_velocity(const VelocityBounds& bounds, std::size_t hard, double max_speed,
                       const TPoint2D& wanted) {
  TPoint2D v;
  const std::size_t kept = solve({bounds, max_speed, wanted, Objective::Nearest}, v);
  if (kept == bounds.size()) return v;
  if (kept < hard) return {0, 0};
  return least_violation(bounds, hard, kept, max_speed, v);
}

}  // namespace slalom
