// SPDX-License-Identifier: BSD-3-Clause
#include "roots.h"

#include <slalom/core/math.h>

namespace slalom::disc_path {
namespace {

bool may_leave(const Root& from, const Vector& normal) {
  return from.turn * cross(from.arrival, normal) >= -kAngleTolerance &&
         from.turn * cross(normal, from.last_departure) >= -kAngleTolerance &&
         dot(from.arrival, normal) > -kAngleTolerance;
}

}  // namespace

bool Window::contains(const Vector& p) const {
  constexpr double e = kPositionTolerance;
  if (p.y < row - e || p.y > row + 1 + e || p.x < run.first - e || p.x > run.last + e) return false;
  // The tolerance is a distance: across a flat ray it is larger in x.
  return !has_limits || (p.x >= low.at(p.y) - e * (1 + std::abs(low.b)) &&
                         p.x <= high.at(p.y) + e * (1 + std::abs(high.b)));
}

Roots::Roots(SearchSpace& space, Queue& queue) : space_(space), queue_(queue) {
  Root start;
  start.center = start.at = space.start;
  roots_.push_back(start);
}

/// Finds the point where a path that leaves in this direction leaves the circle; false if it may
/// not.
bool Roots::departs(const Root& from, const Vector& direction, Departure& departure) const {
  departure = {from.at, from.length};
  if (from.turn == 0) return true;
  const Vector normal = left(direction) * -from.turn;
  if (!may_leave(from, normal)) return false;
  departure.at = from.center + normal * from.radius;
  departure.length += from.radius * turned_angle(from.arrival, normal, from.turn);
  return true;
}

void Roots::offer_goal(int root) {
  const Root& from = (*this)[root];
  Departure departure{from.at, from.length};
  double rest = norm(space_.goal - from.at);
  constexpr double kSamePoint = 1e-12;
  if (from.turn != 0 && rest >= kSamePoint) {
    const auto tangent = common_tangent(from.center, from.turn * from.radius, space_.goal, 0);
    if (!tangent || !departs(from, tangent->direction, departure)) return;
    rest = tangent->length;
  }
  const double length = departure.length + rest;
  if (length >= best_length_ || !space_.is_sweep_free(departure.at, space_.goal)) return;
  best_length_ = length;
  best_departure_ = departure.at;
  queue_.push(length, Kind::Goal, root);
}

void Roots::offer_arcs(int root, double low, double high, const Window& window) {
  const auto [begin, end] =
      space_.arcs.near(window.row, low - kPositionTolerance, high + kPositionTolerance);
  for (const int* arc = begin; arc != end; ++arc)
    for (const int turn : {-1, 1}) offer(root, *arc, turn, window);
}

/// The tests are ordered by their cost.
void Roots::offer(int root, int index, int turn, const Window& window) {
  const Root& from = (*this)[root];
  if (from.arc == index) return;
  Arc& arc = space_.arcs[index];
  const Vector center = arc.center();
  const double radius = space_.radius;
  const auto tangent = common_tangent(from.center, from.turn * from.radius, center, turn * radius);
  if (!tangent) return;
  const Vector normal = left(tangent->direction) * -turn;
  const double along_x = normal.x * arc.out_x, along_y = normal.y * arc.out_y;
  if (along_x < -kAngleTolerance || along_y < -kAngleTolerance) return;
  Departure departure;
  if (!departs(from, tangent->direction, departure)) return;
  const Vector at = center + normal * radius;
  if (!window.contains(at)) return;
  const double length = departure.length + tangent->length;
  if (length + norm(space_.goal - at) >= best_length_) return;
  const double angle = std::clamp(math::atan2(along_y, along_x), 0.0, M_PI / 2);
  const Interval* part = exposed_part(arc, angle);
  if (part == nullptr) return;
  const int local_turn = turn * arc.out_x * arc.out_y;  // +1: angles grow
  const Label label{local_turn * angle, length - radius * local_turn * angle, part->first,
                    static_cast<int>(roots_.size()), arc.labels[turn > 0]};
  if (is_dominated(label.next, label) || !space_.is_sweep_free(at, departure.at)) return;
  mark_beaten(label.next, label);
  arc.labels[turn > 0] = static_cast<int>(labels_.size());
  labels_.push_back(label);

  Root next;
  next.center = center;
  next.radius = radius;
  next.turn = turn;
  next.arrival = next.last_departure = normal;
  const double last = local_turn > 0 ? part->second : part->first;
  if (local_turn * (last - angle) >= 0)
    next.last_departure = {math::cos(last) * arc.out_x, math::sin(last) * arc.out_y};
  next.at = at;
  next.left_parent_at = departure.at;
  next.length = length;
  next.parent = root;
  next.arc = index;
  queue_.push(length + norm(space_.goal - at), Kind::Root, label.root);
  roots_.push_back(next);
}

const Interval* Roots::exposed_part(Arc& arc, double angle) {
  if (!arc.is_exposure_known) {
    arc.exposed = exposed_parts(space_.occupied, arc, space_.radius, space_.checked_radius);
    arc.is_exposure_known = true;
  }
  for (const Interval& part : arc.exposed)
    if (angle >= part.first - kAngleTolerance && angle <= part.second + kAngleTolerance)
      return &part;
  return nullptr;
}

bool Roots::is_dominated(int label, const Label& candidate) const {
  constexpr double kSame = 1e-12;
  for (; label >= 0; label = labels_[static_cast<std::size_t>(label)].next) {
    const Label& known = labels_[static_cast<std::size_t>(label)];
    if (known.exposed_from == candidate.exposed_from && known.alpha <= candidate.alpha + kSame &&
        known.base <= candidate.base + kSame)
      return true;
  }
  return false;
}

void Roots::mark_beaten(int label, const Label& better) {
  for (; label >= 0; label = labels_[static_cast<std::size_t>(label)].next) {
    const Label& known = labels_[static_cast<std::size_t>(label)];
    if (known.exposed_from == better.exposed_from && known.alpha >= better.alpha &&
        known.base >= better.base)
      roots_[static_cast<std::size_t>(known.root)].is_beaten = true;
  }
}

}  // namespace slalom::disc_path
