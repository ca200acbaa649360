// SPDX-License-Identifier: BSD-3-Clause
#include "../disc_path/disc_geometry.h"
#include "unsafe_departures.h"

#include <limits>

namespace slalom::arrival {
namespace {

using disc_path::cross;
using disc_path::dot;
using Vector = mrpt::math::TPoint2D;

/// Rounding errors of times (s) and of squared distances; intervals are widened by the former.
constexpr double kTimeTolerance = 1e-9;

constexpr std::size_t kSegmentsPerBox = 16;

/// The center of the robot relative to the mover is base + along * s + across * d, at the time s
/// since the departure d.
struct RelativeMotion {
  Vector base, along, across;
};

/// Collects the departures at which the set of unsafe pairs (d, s) can begin or end: on the
/// boundary of the disc or at the corners of the allowed pairs, 0 <= s <= duration and first <= d +
/// s <= last.
class Extremes {
 public:
  Extremes(const RelativeMotion& motion, double duration, const Interval& time, double distance)
      : motion_(motion), duration_(duration), time_(time), distance_(distance) {}

  std::optional<Interval> interval() {
    add_tangents();
    add_edges();
    add_corners();
    if (range_.first > range_.last) return std::nullopt;
    return Interval{range_.first - kTimeTolerance, range_.last + kTimeTolerance};
  }

 private:
  bool is_allowed(double departure, double s) const {
    return s >= -kTimeTolerance && s <= duration_ + kTimeTolerance &&
           departure + s >= time_.first - kTimeTolerance &&
           departure + s <= time_.last + kTimeTolerance;
  }

  void add(double departure, double s) {
    if (!is_allowed(departure, s)) return;
    range_.first = std::min(range_.first, departure);
    range_.last = std::max(range_.last, departure);
  }

  /// Departures whose motion touches the disc in passing: the distance of a line from the origin is
  /// that of the disc.
  void add_tangents() {
    const double speed = std::sqrt(dot(motion_.along, motion_.along));
    const double change = cross(motion_.across, motion_.along),
                 at_zero = cross(motion_.base, motion_.along);
    if (speed == 0 || change == 0) return;
    for (const double side : {-1.0, 1.0}) {
      const double departure = (side * distance_ * speed - at_zero) / change;
      const Vector at_departure = motion_.base + motion_.across * departure;
      add(departure, -dot(at_departure, motion_.along) / (speed * speed));
    }
  }

  /// Adds the intersection of the boundary of the disc with s = offset + slope * d.
  void add_edge(double offset, double slope) {
    const Vector constant = motion_.base + motion_.along * offset,
                 linear = motion_.across + motion_.along * slope;
    const double a = dot(linear, linear), b = dot(constant, linear),
                 c = dot(constant, constant) - distance_ * distance_;
    const double discriminant = b * b - a * c;
    if (a == 0 || discriminant < 0) return;
    for (const double side : {-1.0, 1.0}) {
      const double departure = (-b + side * std::sqrt(discriminant)) / a;
      add(departure, offset + slope * departure);
    }
  }

  void add_edges() {
    add_edge(0, 0);
    add_edge(duration_, 0);
    add_edge(time_.first, -1);
    add_edge(time_.last, -1);
  }

  void add_corners() {
    for (const double s : {0.0, duration_})
      for (const double time : {time_.first, time_.last}) {
        const Vector relative = motion_.base + motion_.along * s + motion_.across * (time - s);
        if (dot(relative, relative) < distance_ * distance_) add(time - s, s);
      }
  }

  RelativeMotion motion_;
  double duration_;
  Interval time_;
  double distance_;
  Interval range_{std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()};
};

/// Whether two motions along one axis, from a by da and from b by db, stay apart.
bool are_apart(double a, double da, double b, double db, double distance) {
  return std::min(a, a + da) > std::max(b, b + db) + distance ||
         std::max(a, a + da) < std::min(b, b + db) - distance;
}

/// Boxes around the center of the mover, one for each run of kSegmentsPerBox segments.
std::vector<Bounds> boxes_of(const std::vector<MoverSegment>& segments) {
  std::vector<Bounds> boxes;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Vector from = segments[i].from,
                 to = from + segments[i].velocity * (segments[i].end - segments[i].begin);
    if (i % kSegmentsPerBox == 0) boxes.push_back({from.x, from.y, from.x, from.y});
    Bounds& box = boxes.back();
    for (const Vector& p : {from, to})
      box = {std::min(box.x_min, p.x), std::min(box.y_min, p.y), std::max(box.x_max, p.x),
             std::max(box.y_max, p.y)};
  }
  return boxes;
}

bool is_apart(const Leg& leg, const Bounds& box, double distance) {
  const Vector displacement = leg.velocity * leg.duration;
  return are_apart(leg.from.x, displacement.x, box.x_min, box.x_max - box.x_min, distance) ||
         are_apart(leg.from.y, displacement.y, box.y_min, box.y_max - box.y_min, distance);
}

}  // namespace

MoverMotion::MoverMotion(std::vector<MoverSegment> segments, double distance)
    : segments_(std::move(segments)), boxes_(boxes_of(segments_)), distance_(distance) {}

Traffic traffic_of(const Movers& movers, double distance, double horizon) {
  Traffic traffic;
  for (const Mover& mover : movers)
    traffic.emplace_back(segments_of(mover, horizon), mover.radius + distance);
  return traffic;
}

std::optional<Interval> unsafe_departures(const Leg& leg, const MoverSegment& segment,
                                          double distance) {
  const Vector displacement = leg.velocity * leg.duration;
  const Vector mover_displacement = segment.velocity * (segment.end - segment.begin);
  if (are_apart(leg.from.x, displacement.x, segment.from.x, mover_displacement.x, distance) ||
      are_apart(leg.from.y, displacement.y, segment.from.y, mover_displacement.y, distance))
    return std::nullopt;
  // At the time d + s the robot is at from + velocity * s, the mover at from + velocity * (d + s -
  // begin).
  const RelativeMotion motion{leg.from - segment.from + segment.velocity * segment.begin,
                              leg.velocity - segment.velocity, segment.velocity * -1.0};
  return Extremes(motion, leg.duration, {segment.begin, segment.end}, distance).interval();
}

void MoverMotion::add_unsafe_departures(const Leg& leg, const Interval& window,
                                        std::vector<Interval>& unsafe) const {
  const auto first =
      std::partition_point(segments_.begin(), segments_.end(),
                           [&](const MoverSegment& segment) { return segment.end < window.first; });
  for (auto i = static_cast<std::size_t>(first - segments_.begin()); i < segments_.size();) {
    if (segments_[i].begin > window.last + leg.duration) return;
    const std::size_t box = i / kSegmentsPerBox, next = (box + 1) * kSegmentsPerBox;
    if (is_apart(leg, boxes_[box], distance_)) {
      i = next;
      continue;
    }
    for (; i < std::min(next, segments_.size()); ++i)
      if (const auto interval = unsafe_departures(leg, segments_[i], distance_))
        unsafe.push_back(*interval);
  }
}

std::vector<Interval> unsafe_departures(const Leg& leg, const Traffic& traffic,
                                        const Interval& window) {
  std::vector<Interval> unsafe;
  for (const MoverMotion& mover : traffic) mover.add_unsafe_departures(leg, window, unsafe);
  return unsafe;
}

std::vector<Interval> safe_intervals(const mrpt::math::TPoint2D& p, const Traffic& traffic,
                                     double horizon) {
  const Interval all{0, horizon};
  return gaps_between(unsafe_departures({p, {0, 0}, 0}, traffic, all), 0, horizon);
}

}  // namespace slalom::arrival
