// SPDX-License-Identifier: BSD-3-Clause
#include "cones.h"

namespace slalom::disc_path {
namespace {

/// Length of the shortest path from a via [low, high] on the line y = row to b: a lower bound for
/// all paths through that interval (reflected, as in Anya: the path must touch the line).
double length_through(const Vector& a, Vector b, double row, double low, double high) {
  if ((a.y < row) == (b.y < row)) b.y = 2 * row - b.y;
  const double span = b.y - a.y;
  const double straight = span != 0 ? a.x + (b.x - a.x) * ((row - a.y) / span) : b.x;
  const Vector via(std::clamp(straight, low, std::max(low, high)), row);
  return norm(a - via) + norm(b - via);
}

/// A horizontal ray has no slope: through p, all but horizontal, so that it bounds nothing beyond
/// the line of p. A vertical one would cut off what is visible.
Line flat_line(const Vector& p, int sign) {
  const double slope = sign * 1e7;
  return {p.x - slope * p.y, slope};
}

/// The row of cells that begins at a line.
int row_beyond(int line, int direction) {
  return direction > 0 ? line : line - 1;
}

}  // namespace

/// The tangent of the root's circle through a point, as a line; false if none goes in `direction`.
bool ConeExpansion::tangent_ray(const Root& root, const Vector& through, int direction,
                                Line& ray) const {
  constexpr double kMinLength = 1e-9, kMinRise = 1e-12;
  const auto tangent = common_tangent(root.center, root.turn * root.radius, through, 0);
  if (!tangent || tangent->length < kMinLength) return false;
  if (tangent->direction.y * direction < kMinRise) return false;
  ray.b = tangent->direction.x / tangent->direction.y;
  ray.a = through.x - ray.b * through.y;
  return true;
}

double ConeExpansion::least_length(const Cone& cone, double low, double high) const {
  const Root& from = roots_[cone.root];
  return from.length + length_through(from.at, space_.goal, cone.row, low, high);
}

void ConeExpansion::expand_start() {
  const Vector& at = space_.start;
  const auto look = [&](int row, int direction) {
    const Run* seen = nullptr;
    for (const double x : {std::floor(at.x), std::ceil(at.x) - 1}) {
      const Run* run = space_.open.find(static_cast<int>(x), row);
      if (run != nullptr && run != seen) see_run(0, row, direction, *run, {});
      seen = run;
    }
  };
  const int row = static_cast<int>(std::floor(at.y));
  look(row, +1);
  look(at.y == row ? row - 1 : row, -1);
  expand_pending();
}

/// Rays leave at right angles to the arc's normal, which stays in one quadrant: all go up, or all
/// down. The arc is cut at the lines between rows.
void ConeExpansion::expand_arc(int index) {
  const Root root = roots_[index];
  const Arc& arc = space_.arcs[root.arc];
  const int out_x = arc.out_x;
  const int direction = root.turn * out_x;
  const double end_y = root.center.y + root.radius * root.last_departure.y;
  Vector from = root.arrival;
  for (bool is_last = false; !is_last;) {
    const double y = root.center.y + root.radius * from.y;
    const double line =
        direction > 0 ? std::floor(y + kAngleTolerance) + 1 : std::ceil(y - kAngleTolerance) - 1;
    const double sine = (line - root.center.y) / root.radius;
    is_last = (line - end_y) * direction >= -kAngleTolerance || std::abs(sine) >= 1;
    const Vector to =
        is_last ? root.last_departure : Vector(out_x * std::sqrt(1 - sine * sine), sine);
    expand_piece(index, from, to, row_beyond(static_cast<int>(line), -direction), direction);
    from = to;
  }
  expand_pending();
}

/// The limits are ordered by the turn and not by x: for arcs of 1e-8 rad, x is rounding errors.
ConeExpansion::Limits ConeExpansion::limits_of(const Root& root, const Vector& from,
                                               const Vector& to, double line, int direction) const {
  const auto ray = [&](const Vector& normal, Line& out) {
    const Vector d = left(normal) * root.turn, at = root.center + normal * root.radius;
    if (d.y * direction < kAngleTolerance)
      return std::copysign(std::numeric_limits<double>::infinity(), d.x > 0 ? 1 : -1);
    out.b = d.x / d.y;
    out.a = at.x - out.b * at.y;
    return out.at(line);
  };
  Limits limits;
  limits.low_x = ray(from, limits.low);
  limits.high_x = ray(to, limits.high);
  if (root.turn * direction > 0) {  // turning left and going up, the last ray is the low one
    std::swap(limits.low, limits.high);
    std::swap(limits.low_x, limits.high_x);
  }
  return limits;
}

void ConeExpansion::expand_piece(int index, const Vector& from, const Vector& to, int row,
                                 int direction) {
  const Vector sum = from + to;
  const double size = norm(sum);
  if (size < kAngleTolerance) return;
  const Root& root = roots_[index];
  const Limits limits = limits_of(root, from, to, direction > 0 ? row + 1 : row, direction);
  const double middle = root.center.x + sum.x * (root.radius / size);
  constexpr double kNear = 1e-6;  // the cell that holds the middle, or two near their border
  const Run* seen = nullptr;
  for (const double x : {std::floor(middle), std::ceil(middle) - 1, std::floor(middle + kNear),
                         std::floor(middle - kNear)}) {
    const Run* run = space_.open.find(static_cast<int>(x), row);
    if (run == nullptr || run == seen) continue;
    seen = run;
    see_run(index, row, direction, *run, limits);
  }
}

/// From a root within a row: all of a run is visible.
void ConeExpansion::see_run(int index, int row, int direction, const Run& run,
                            const Limits& limits) {
  const Window window{row, run, false, {}, {}};
  if (window.contains(space_.goal)) roots_.offer_goal(index);
  roots_.offer_arcs(index, run.first, run.last, window);
  const int line = direction > 0 ? row + 1 : row;
  Cone cone{index, line, direction, limits.low, limits.high};
  double low = limits.low_x, high = limits.high_x;
  const Root& root = roots_[index];
  if (low < run.first) {
    const Vector end(run.first - kPositionTolerance, line);
    if (!tangent_ray(root, end, direction, cone.low) && std::isinf(low))
      cone.low = flat_line(end, -direction);
    low = run.first;
  }
  if (high > run.last) {
    const Vector end(run.last + kPositionTolerance, line);
    if (!tangent_ray(root, end, direction, cone.high) && std::isinf(high))
      cone.high = flat_line(end, direction);
    high = run.last;
  }
  if (high >= low - kPositionTolerance) arrive(cone, low, std::max(low, high));
}

void ConeExpansion::arrive(const Cone& cone, double low, double high) {
  const double f = least_length(cone, low, high);
  if (f >= roots_.best_length()) return;
  if (queue_.is_near_top(f))
    pending_.push_back(cone);
  else
    queue_.push(f, cone);
}

void ConeExpansion::expand(const Cone& cone) {
  pending_.push_back(cone);
  expand_pending();
}

void ConeExpansion::expand_pending() {
  while (!pending_.empty()) {
    const Cone cone = pending_.back();
    pending_.pop_back();
    if (!roots_[cone.root].is_beaten) advance(cone);
  }
}

/// Passes rows without new limits while one run holds all of a row's part of the cone. Returns
/// false if the cone ended or was queued.
bool ConeExpansion::pass_full_rows(Cone& cone) {
  constexpr int kStepsPerCheck = 8;
  for (int step = 1;; ++step) {
    const int row = row_beyond(cone.row, cone.direction), far = cone.row + cone.direction;
    const double low = std::min(cone.low.at(cone.row), cone.low.at(far));
    const double high = std::max(cone.high.at(cone.row), cone.high.at(far));
    if (!(low >= 0 && high < space_.occupied.size_x())) return true;
    const Run* run = space_.open.find(static_cast<int>(low), row);
    if (run == nullptr || run->last < high) return true;
    if (space_.goal.y >= row - kPositionTolerance && space_.goal.y <= row + 1 + kPositionTolerance)
      return true;
    roots_.offer_arcs(cone.root, low, high, {row, *run, true, cone.low, cone.high});
    cone.row = far;
    const double from = cone.low.at(far), to = cone.high.at(far);
    if (to < from - kPositionTolerance) return false;
    if (step % kStepsPerCheck != 0) continue;
    const double f = least_length(cone, from, to);
    if (f >= roots_.best_length()) return false;
    if (queue_.is_near_top(f)) continue;
    queue_.push(f, cone);
    return false;
  }
}

void ConeExpansion::advance(Cone cone) {
  constexpr double kMinWidth = 1e-9;
  if (!pass_full_rows(cone)) return;
  const int row = row_beyond(cone.row, cone.direction);
  const double low = cone.low.at(cone.row), high = cone.high.at(cone.row);
  const int first = low > 0 ? static_cast<int>(std::min<double>(low, space_.occupied.size_x())) : 0;
  const std::vector<Run>& runs = space_.open.runs(row);
  for (auto run = space_.open.first_after(first, row); run != runs.end(); ++run) {
    if (std::max(run->first, first) >= high - kMinWidth) break;
    if (run->last > low + kMinWidth) enter(cone, row, *run);
  }
}

void ConeExpansion::enter(const Cone& cone, int row, const Run& run) {
  const int far = cone.row + cone.direction;
  const double near_low = cone.low.at(cone.row), near_high = cone.high.at(cone.row);
  const double first = run.first - kPositionTolerance, last = run.last + kPositionTolerance;
  Cone next{cone.root, far, cone.direction, cone.low, cone.high};
  const Root root = roots_[cone.root];  // a copy: offers add roots
  if (run.first > near_low) tangent_ray(root, Vector(first, cone.row), cone.direction, next.low);
  if (run.last < near_high) tangent_ray(root, Vector(last, cone.row), cone.direction, next.high);
  const Window window{row, run, true, next.low, next.high};
  if (window.contains(space_.goal)) roots_.offer_goal(cone.root);
  double low = next.low.at(far), high = next.high.at(far);
  const double seen_low = std::clamp(std::min(near_low, low), 1.0 * run.first, 1.0 * run.last);
  const double seen_high = std::clamp(std::max(near_high, high), 1.0 * run.first, 1.0 * run.last);
  if (seen_high >= seen_low - kPositionTolerance)
    roots_.offer_arcs(cone.root, seen_low, seen_high, window);
  if (low < run.first) {
    tangent_ray(root, Vector(first, far), cone.direction, next.low);
    low = run.first;
  }
  if (high > run.last) {
    tangent_ray(root, Vector(last, far), cone.direction, next.high);
    high = run.last;
  }
  if (high >= low - kPositionTolerance) arrive(next, low, std::max(low, high));
}

}  // namespace slalom::disc_path
