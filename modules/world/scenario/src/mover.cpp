// SPDX-License-Identifier: BSD-3-Clause
#include "content_checks.h"

#include <slalom/core/distance.h>
#include <slalom/core/hash.h>
#include <slalom/scenario/mover.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

bool same_position(const Waypoint& a, const Waypoint& b) {
  return a.position.x == b.position.x && a.position.y == b.position.y;
}

void check_waypoint(const std::string& where, const std::vector<Waypoint>& waypoints,
                    std::size_t i) {
  const Waypoint& w = waypoints[i];
  const std::string which = "waypoint " + std::to_string(i);
  if (!in_range(w.t) || !in_range(w.position))
    throw file_error(where, which + " is out of range",
                     "a time and a position within +-" + format_number(kMaxNumber));
  if (i == 0) return;
  const Waypoint& before = waypoints[i - 1];
  if (!(w.t - before.t >= kMinSegmentDuration))
    throw file_error(
        where, which + " is at " + format_number(w.t) + " s, not after the one before it",
        "increasing times, at least " + format_number(kMinSegmentDuration) + " s apart");
  if (!(distance_between(before.position, w.position) <= kMaxSpeed * (w.t - before.t)))
    throw file_error(where, which + " is too far from the one before it",
                     "a speed of at most " + format_number(kMaxSpeed) + " m/s");
}

void check_mover(const std::string& where, const Mover& mover) {
  check_radius(where, mover.radius);
  if (mover.waypoints.empty()) throw file_error(where, "no waypoints", "at least one");
  for (std::size_t i = 0; i < mover.waypoints.size(); ++i)
    check_waypoint(where, mover.waypoints, i);
  if (mover.after == MoverEnd::Loop &&
      (mover.waypoints.size() < 2 ||
       !same_position(mover.waypoints.front(), mover.waypoints.back())))
    throw file_error(where, "the path that loops is not closed",
                     "the last waypoint at the position of the first");
}

}  // namespace

/// A place on the path between two waypoints.
struct Mover::Place {
  const Waypoint &from, &to;
  double
      time;  ///< s, of the waypoints; of a later round it may be before `from` by a rounding error
};

/// Nothing before the first waypoint and, unless the path is repeated, from the last one on.
std::optional<Mover::Place> Mover::place_at(double t) const {
  const double first = waypoints.front().t, last = waypoints.back().t;
  if (t < first || (after != MoverEnd::Loop && t >= last)) return std::nullopt;
  double time = t, reached = t;
  if (t >= last) {
    // The time of a later round is rounded: a waypoint counts as reached a little before it, so
    // that its segment is not taken for the one before. Far above the rounding of a million
    // seconds, far below a segment.
    constexpr double kRounding = 1e-9;  // s
    time = first + std::fmod(t - first, last - first);
    if (time + kRounding >= last) time -= last - first;
    reached = time + kRounding;
  }
  const auto next =
      std::upper_bound(waypoints.begin(), waypoints.end(), reached,
                       [](double at, const Waypoint& waypoint) { return at < waypoint.t; });
  return Place{*(next - 1), *next, time};
}

bool Mover::present(double t) const {
  return t >= waypoints.front().t && (after != MoverEnd::Vanish || t <= waypoints.back().t);
}

TPoint2D Mover::position(double t) const {
  const auto place = place_at(t);
  if (!place) return (t < waypoints.front().t ? waypoints.front() : waypoints.back()).position;
  const auto& [a, b, time] = *place;
  return a.position + (b.position - a.position) * ((time - a.t) / (b.t - a.t));
}

TPoint2D Mover::velocity(double t) const {
  const auto place = place_at(t);
  if (!place) return {0, 0};
  return (place->to.position - place->from.position) * (1 / (place->to.t - place->from.t));
}

double Mover::next_change(double t) const {
  if (const auto place = place_at(t))
    return place->time == t ? place->to.t : t + (place->to.t - place->time);
  return t < waypoints.front().t ? waypoints.front().t : std::numeric_limits<double>::infinity();
}

bool Mover::operator==(const Mover& other) const {
  return id == other.id && radius == other.radius && after == other.after &&
         std::equal(waypoints.begin(), waypoints.end(), other.waypoints.begin(),
                    other.waypoints.end(), [](const Waypoint& a, const Waypoint& b) {
                      return a.t == b.t && same_position(a, b);
                    });
}

std::vector<MoverSegment> segments_of(const Mover& mover, double horizon) {
  std::vector<MoverSegment> segments;
  for (double t = 0; t < horizon;) {
    const double next = std::min(mover.next_change(t), horizon);
    // In the middle it is certain to which segment a time belongs.
    const double middle = (t + next) / 2;
    if (mover.present(middle)) {
      const TPoint2D velocity = mover.velocity(middle);
      segments.push_back({t, next, mover.position(middle) + velocity * (t - middle), velocity});
    }
    t = next;
  }
  return segments;
}

void check_movers(const std::string& name, const Movers& movers) {
  std::set<std::string> ids;
  for (std::size_t i = 0; i < movers.size(); ++i)
    check_mover(checked_element(name, "moving obstacle", i, movers[i].id, ids), movers[i]);
}

void set_speed(Mover& mover, double speed) {
  constexpr double kShortest = 2 * kMinSegmentDuration;  // for rounding
  for (std::size_t i = 1; i < mover.waypoints.size(); ++i) {
    const Waypoint& before = mover.waypoints[i - 1];
    Waypoint& now = mover.waypoints[i];
    now.t = before.t + std::max(kShortest, distance_between(before.position, now.position) / speed);
  }
}

void add_content(Hasher& hasher, const Movers& movers) {
  hasher.add("movers").add(static_cast<std::uint64_t>(movers.size()));
  for (const Mover& mover : movers) {
    hasher.add(mover.id).add(mover.radius).add(to_string(mover.after));
    hasher.add(static_cast<std::uint64_t>(mover.waypoints.size()));
    for (const Waypoint& w : mover.waypoints) hasher.add(w.t).add(w.position.x).add(w.position.y);
  }
}

}  // namespace slalom
