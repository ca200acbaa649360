// SPDX-License-Identifier: BSD-3-Clause
#include "mover_contact.h"

#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/core/pose.h>
#include <slalom/scenario/geometry.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// Overlap (m) below which there is no contact, for rounding errors; as with static obstacles.
constexpr double kMoverTolerance = 1e-9;
/// Gap (m) below which a polygon is in contact: bounds the number of advances along a mover.
constexpr double kPolygonGap = 1e-6;
constexpr double kNoContact = 2;  // a fraction beyond the motion

double turn_of(const TimedMotion& motion) {
  return std::abs(mrpt::math::wrapToPi(motion.to.phi - motion.from.phi));
}

}  // namespace

MoverContact::MoverContact(const Movers& movers, const Footprint& footprint, double added_speed)
    : movers_(movers), footprint_(footprint), max_speed_(added_speed) {
  for (const Mover& mover : movers)
    for (std::size_t i = 1; i < mover.waypoints.size(); ++i) {
      const Waypoint &a = mover.waypoints[i - 1], &b = mover.waypoints[i];
      max_speed_ = std::max(max_speed_, distance_between(a.position, b.position) / (b.t - a.t));
    }
}

/// Distance (m) between robot and mover, if the mover were present; negative when discs overlap, 0
/// when a polygon does.
double MoverContact::gap(const TPose2D& pose, const Mover& mover, double t) const {
  const TPoint2D center = mover.position(t);
  if (footprint_.is_disc())
    return distance_between(center, pose) - footprint_.enclosing_radius() - mover.radius;
  return std::max(0.0, distance(center, Polygon{footprint_.corners_at(pose)}) - mover.radius);
}

const Mover* MoverContact::find_overlap(const TPose2D& pose, double t) const {
  const double limit = footprint_.is_disc() ? -kMoverTolerance : kPolygonGap;
  for (const Mover& mover : movers_)
    if (mover.present(t) && gap(pose, mover, t) < limit) return &mover;
  return nullptr;
}

double MoverContact::smallest_gap(const TimedMotion& motion) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Mover& mover : movers_)
    smallest = std::min(smallest, gap(motion.to, mover, motion.end));
  return smallest;
}

const Mover* MoverContact::find_contact(const TimedMotion& motion, double& fraction) {
  if (movers_.empty()) return nullptr;
  free_travel_ -= distance_between(motion.from, motion.to) +
                  max_speed_ * (motion.end - motion.begin) +
                  (footprint_.is_disc() ? 0 : footprint_.enclosing_radius() * turn_of(motion));
  if (free_travel_ > 0) return nullptr;
  const Mover* first = nullptr;
  fraction = 1;
  for (const Mover& mover : movers_) {
    double at = 0;
    if (find_contact(motion, mover, at) && (first == nullptr || at < fraction)) {
      first = &mover;
      fraction = at;
    }
  }
  free_travel_ = smallest_gap(motion);
  return first;
}

/// One straight motion of the mover after another.
bool MoverContact::find_contact(const TimedMotion& motion, const Mover& mover,
                                double& fraction) const {
  const double duration = motion.end - motion.begin;
  for (double t = motion.begin; t < motion.end;) {
    const double next = std::min(mover.next_change(t), motion.end);
    const double from = (t - motion.begin) / duration, to = (next - motion.begin) / duration;
    const TimedMotion part{interpolate(motion.from, motion.to, from),
                           interpolate(motion.from, motion.to, to), t, next};
    double at = 0;
    if (mover.present(0.5 * (t + next)) && find_straight_contact(part, mover, at)) {
      fraction = std::min(1.0, from + at * (to - from));
      return true;
    }
    t = next;
  }
  return false;
}

bool MoverContact::find_straight_contact(const TimedMotion& motion, const Mover& mover,
                                         double& fraction) const {
  fraction = footprint_.is_disc() ? disc_contact(motion, mover) : polygon_contact(motion, mover);
  return fraction <= 1;
}

/// The first root of |p + f d| = R in [0, 1], p and d the position and motion of the robot relative
/// to the mover.
double MoverContact::disc_contact(const TimedMotion& motion, const Mover& mover) const {
  const TPoint2D p = TPoint2D(motion.from) - mover.position(motion.begin);
  const TPoint2D end = TPoint2D(motion.to) - mover.position(motion.end), d = end - p;
  const double reach = footprint_.enclosing_radius() + mover.radius;
  const double a = d.x * d.x + d.y * d.y, b = p.x * d.x + p.y * d.y;
  const double nearest = a > 0 ? std::clamp(-b / a, 0.0, 1.0) : 0.0;
  const TPoint2D closest = p + d * nearest;
  if (!(math::hypot(closest.x, closest.y) < reach - kMoverTolerance)) return kNoContact;
  const double start_gap = math::hypot(p.x, p.y) - reach;
  if (start_gap <= 0) return 0;
  // c is computed as a product: the difference of squares would lose the digits of a small gap.
  const double c = start_gap * (math::hypot(p.x, p.y) + reach);
  return c / (-b + std::sqrt(std::max(0.0, b * b - a * c)));
}

/// No point of the robot moves by more than the relative motion and the turn times the enclosing
/// radius: it can advance by that part of the motion that is as long as the gap.
double MoverContact::polygon_contact(const TimedMotion& motion, const Mover& mover) const {
  const TPoint2D moved = mover.position(motion.end) - mover.position(motion.begin);
  const TPoint2D relative = TPoint2D(motion.to) - TPoint2D(motion.from) - moved;
  const double length =
      math::hypot(relative.x, relative.y) + footprint_.enclosing_radius() * turn_of(motion);
  for (double at = 0; at <= 1;) {
    const double now = motion.begin + at * (motion.end - motion.begin);
    const double clearance = gap(interpolate(motion.from, motion.to, at), mover, now);
    if (clearance < kPolygonGap) return at;
    if ((1 - at) * length <= clearance) return kNoContact;
    at += clearance / length;
  }
  return kNoContact;
}

}  // namespace slalom
