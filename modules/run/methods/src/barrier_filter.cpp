// SPDX-License-Identifier: BSD-3-Clause

#include <slalom/core/geometry.h>
#include <slalom/core/math.h>
#include <slalom/methods/barrier_filter.h>
#include <slalom/methods/registry.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TVector2D;

/// The fraction of the robot's deceleration that is planned with.
constexpr double kBrakingFraction = 0.7;
/// m/s, of rounding: a disc that rotates does not come nearer to anything.
constexpr double kRounding = 1e-9;

/// A convex polygon and all points within `radius` of it.
struct RoundedPolygon {
  std::vector<TPoint2D> corners;  ///< counter-clockwise
  double radius = 0;
};

/// The points that the footprint covers while it moves ahead by `length` (backward if negative).
RoundedPolygon swept(const Footprint& footprint, double length) {
  const TVector2D move{length, 0};
  if (footprint.is_disc()) return {{{0, 0}, TPoint2D(0, 0) + move}, footprint.enclosing_radius()};
  const auto& corners = footprint.hull();
  const std::size_t n = corners.size();
  // Whether the edge from corner i looks in the direction of the motion.
  const auto is_leading = [&](std::size_t i) {
    return (corners[(i + 1) % n].y - corners[i].y) * length > 0;
  };
  RoundedPolygon result;
  for (std::size_t i = 0; i < n; ++i) {
    const bool before = is_leading((i + n - 1) % n), after = is_leading(i);
    result.corners.push_back(before ? corners[i] + move : corners[i]);
    if (before != after) result.corners.push_back(after ? corners[i] + move : corners[i]);
  }
  return result;
}

bool is_inside(const TPoint2D& p, const std::vector<TPoint2D>& corners) {
  if (corners.size() < 3) return false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const TPoint2D &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0) return false;
  }
  return true;
}

/// Distance h (m) of an obstacle point to the footprint, and its rate: dh/dt = v * by_v + vy *
/// by_vy + w * by_w.
struct Barrier {
  double h = 0, by_v = 0, by_vy = 0, by_w = 0;

  double rate(double v, double vy, double w) const { return v * by_v + vy * by_vy + w * by_w; }
};

Barrier barrier_of(const TPoint2D& obstacle, const RoundedPolygon& shape) {
  const TPoint2D nearest = nearest_on_border(obstacle, shape.corners);
  const bool inside = is_inside(obstacle, shape.corners);
  TVector2D outward = inside ? nearest - obstacle : obstacle - nearest;
  const double distance = outward.norm();
  outward = distance > 0 ? outward / distance : TVector2D(1, 0);
  // In the robot frame a fixed point moves at (-v + w y, -vy - w x).
  return {(inside ? -distance : distance) - shape.radius, -outward.x, -outward.y,
          outward.x * obstacle.y - outward.y * obstacle.x};
}

std::vector<TPoint2D> obstacle_points(const mrpt::obs::CObservation2DRangeScan& scan) {
  std::vector<TPoint2D> points;
  const std::size_t rays = scan.getScanSize();
  const auto last = static_cast<double>(std::max<std::size_t>(rays, 2) - 1);
  const double aperture = static_cast<double>(scan.aperture);
  for (std::size_t i = 0; i < rays; ++i) {
    const auto range = static_cast<double>(scan.getScanRange(i));
    if (!scan.getScanRangeValidity(i) || range >= static_cast<double>(scan.maxRange)) continue;
    const double angle = aperture * (static_cast<double>(i) / last - 0.5);
    points.emplace_back(range * math::cos(angle), range * math::sin(angle));
  }
  return points;
}

struct Interval {
  double low = 0, high = 0;

  double nearest(double value) const { return std::clamp(value, low, high); }
};

/// Intervals of the two inputs and of w.
struct Window {
  Interval first, second, w;

  std::vector<HalfPlane> half_planes() const {
    return {
        {{1, 0}, first.low}, {{-1, 0}, -first.high}, {{0, 1}, second.low}, {{0, -1}, -second.high}};
  }
};

class BarrierFilter : public Method {
 public:
  BarrierFilter(std::unique_ptr<Method> base, const BarrierFilterOptions& options,
                const RobotModel& robot, const SensorModel& sensor)
      : base_(std::move(base)),
        options_(options),
        robot_(robot),
        footprint_(robot.shape()),
        shape_(swept(footprint_, 0)),
        known_delay_(robot.delay + robot.delay_tau + sensor.latency) {}

  void check() override { base_->check(); }
  void reset(const NavigationTask& task) override {
    period_ = task.control_period;
    base_->reset(task);
  }
  void settle(const Observation& start) override { base_->settle(start); }
  bool uses_tracks() const override { return base_->uses_tracks(); }
  bool uses_map() const override { return base_->uses_map(); }
  bool is_paced() const override { return base_->is_paced(); }
  std::map<std::string, double> run_figures() const override { return base_->run_figures(); }
  void finish(const std::string& outcome) override { base_->finish(outcome); }

  Command step(const Observation& observation) override {
    const Command desired = base_->step(observation);
    std::string reason;
    if (!is_valid_command(desired, robot_, reason)) return desired;
    const Window window = reachable(observation);
    const std::vector<HalfPlane> half_planes =
        constraints(desired, window.w.nearest(desired.w), observation);
    const TPoint2D wanted = inputs_of(desired);
    // The robot does what it can of a command.
    const TPoint2D reached{window.first.nearest(wanted.x), window.second.nearest(wanted.y)};
    if (std::all_of(half_planes.begin(), half_planes.end(),
                    [&](const HalfPlane& h) { return h.excess(reached) >= -kRounding; }))
      return desired;
    std::vector<TPoint2D> allowed = all_inputs(desired);
    for (const HalfPlane& h : half_planes) allowed = clipped(allowed, h);
    if (allowed.empty()) return {};
    std::vector<TPoint2D> at_once = allowed;
    for (const HalfPlane& h : window.half_planes()) at_once = clipped(at_once, h);
    return command_of(nearest_on_border(wanted, at_once.empty() ? allowed : at_once), desired);
  }

 private:
  /// The unit of the second input: m per rad for w, so that both inputs are speeds of points of the
  /// footprint.
  double scale() const { return robot_.holonomic() ? 1 : footprint_.enclosing_radius(); }

  double reaction() const { return period_ + known_delay_; }  ///< s

  TPoint2D inputs_of(const Command& command) const {
    return {command.v, robot_.holonomic() ? command.vy : command.w * scale()};
  }
  Command command_of(const TPoint2D& inputs, const Command& desired) const {
    if (robot_.holonomic()) return {inputs.x, desired.w, inputs.y};
    return {inputs.x, inputs.y / scale(), 0};
  }

  /// The allowed speed of approach at a barrier of `h` m.
  double allowed_speed(double h) const {
    const double gain = std::min(options_.gain, 1 / period_);
    return std::min(gain * h, std::sqrt(2 * kBrakingFraction * robot_.max_accel_v * h));
  }

  /// The velocities that the robot can reach within the reaction time.
  Window reachable(const Observation& observation) const {
    const double dv = robot_.max_accel_v * reaction(), dw = robot_.max_accel_w * reaction();
    const Interval w{observation.w - dw, observation.w + dw};
    if (robot_.holonomic())
      return {
          {observation.v - dv, observation.v + dv}, {observation.vy - dv, observation.vy + dv}, w};
    return {{observation.v - dv, observation.v + dv}, {w.low * scale(), w.high * scale()}, w};
  }

  /// For the inputs, at the angular velocity `w` of a holonomic robot.
  std::vector<HalfPlane> constraints(const Command& desired, double w,
                                     const Observation& observation) const {
    std::vector<RoundedPolygon> shapes = {shape_};
    // A holonomic robot evades sideways; others turn, which the second shape makes them do in time.
    // A robot that must stop still moves: what is ahead of it stays.
    const double speed = std::abs(observation.v) > std::abs(desired.v) ? observation.v : desired.v;
    if (!robot_.holonomic()) shapes.push_back(swept(footprint_, speed * options_.look_ahead));
    const std::vector<TPoint2D> points = obstacle_points(*observation.scan);
    std::vector<HalfPlane> result;
    for (const RoundedPolygon& shape : shapes)
      for (const TPoint2D& point : points)
        result.push_back(constraint(barrier_of(point, shape), w, observation));
    return result;
  }

  HalfPlane constraint(const Barrier& barrier, double w, const Observation& observation) const {
    const double approach =
        std::max(0.0, -barrier.rate(observation.v, observation.vy, observation.w));
    const double h = std::max(0.0, barrier.h - options_.margin - approach * reaction());
    const double bound = -allowed_speed(h);
    if (robot_.holonomic()) return {{barrier.by_v, barrier.by_vy}, bound - barrier.by_w * w};
    return {{barrier.by_v, barrier.by_w / scale()}, bound};
  }

  /// The inputs within the robot's limits; of a holonomic robot a polygon in the disc of the
  /// speeds.
  std::vector<TPoint2D> all_inputs(const Command& desired) const {
    constexpr int kSides = 32;
    const double low = robot_.forward_only ? 0 : -robot_.max_v, high = robot_.max_v;
    std::vector<TPoint2D> polygon;
    if (robot_.holonomic()) {
      for (int i = 0; i < kSides; ++i) {
        const double angle = 2 * M_PI * i / kSides;
        polygon.emplace_back(high * math::cos(angle), high * math::sin(angle));
      }
      return clipped(polygon, {{1, 0}, low});
    }
    const double turn = robot_.max_w * scale();
    polygon = {{low, -turn}, {high, -turn}, {high, turn}, {low, turn}};
    if (robot_.min_turning_radius > 0) {
      const TVector2D forward{desired.v < 0 ? -1.0 : 1.0, 0};
      const TVector2D left{0, robot_.min_turning_radius / scale()};
      polygon = clipped(clipped(polygon, {forward - left, 0}), {forward + left, 0});
    }
    return polygon;
  }

  std::unique_ptr<Method> base_;
  BarrierFilterOptions options_;
  RobotModel robot_;
  Footprint footprint_;
  RoundedPolygon shape_;  ///< of the footprint
  double known_delay_;    ///< s
  double period_ = 0.1;   ///< s
};

}  // namespace

void BarrierFilterOptions::visit(OptionVisitor& v) {
  std::string filter = "cbf", base;
  v.option("filter", filter, "filter of another method", {"cbf"});
  v.option("base", base, "NAME of the section of that method");
  v.option("gain", gain, "1/s", "allowed speed of approach per distance to an obstacle",
           Range::positive());
  v.option("margin", margin, "m", "kept between footprint and obstacles", Range::between(0, 10));
  v.option("look_ahead", look_ahead, "s",
           "the footprint is extended by the path of the command within it", Range::between(0, 10));
}

MethodFactory barrier_filter(MethodFactory base, const BarrierFilterOptions& options) {
  return [base = std::move(base), options](const RobotModel& robot, const SensorModel& sensor) {
    return std::make_unique<BarrierFilter>(base(robot, sensor), options, robot, sensor);
  };
}

MethodFactory read_barrier_filter(const IniFile& ini, const std::string& section,
                                  MethodFactory base) {
  return barrier_filter(std::move(base), read_options<BarrierFilterOptions>(ini, section));
}

}  // namespace slalom
