#include "dwa/dwa.h"

namespace dwa {

using namespace reactive;

const Dwa::Settings& Dwa::settings() {
  static constexpr Settings kSettings = {
      {{"alpha", "0.8", "-", "weight of the heading, Eq. (13)"}, &Parameters::alpha},
      {{"beta", "0.2", "-", "weight of the free way"}, &Parameters::beta},
      {{"gamma", "0.3", "-", "weight of the speed"}, &Parameters::gamma},
      {{"margin", "0.05", "m", "added to the robot's radius"}, &Parameters::margin, 0, 10},
      {{"horizon", "2", "m", "a free way of this length is as good as any"},
       &Parameters::horizon,
       0.1,
       100},
      {{"v_samples", "13", "-", "speeds in the window"}, &Parameters::v_samples, 2, 1000},
      {{"w_samples", "41", "-", "turning speeds in the window"}, &Parameters::w_samples, 3, 1000},
      {{"turn_in_place", "1.6", "rad", "a way farther aside is turned to without driving"},
       &Parameters::turn_in_place,
       0.1,
       kPi},
      {{"memory", "6", "m", "half the side of the local map"}, &Parameters::memory, 1, 50},
      {{"guidance", "0", "-", "0: to the goal; 1: along a navigation function of the local map"},
       &Parameters::guidance,
       0,
       1},
      {{"look_ahead", "1.5", "m", "with guidance: how far along the way to aim"},
       &Parameters::look_ahead,
       0.1,
       50}};
  return kSettings;
}

Window dynamic_window(const Speeds& now, const Robot& robot, double period) {
  const Speeds lowest = approached(now, {0, -robot.max_w}, robot, period);
  const Speeds highest = approached(now, {robot.max_v, robot.max_w}, robot, period);
  return {limited(lowest, robot), limited(highest, robot)};
}

bool can_stop(const Speeds& speeds, double free_way, const Robot& robot, double period) {
  // The command holds for a period before the robot can brake.
  const double way = free_way - speeds.v * period;
  if (speeds.v > stopping_speed(way, robot)) return false;
  const double turn = speeds.v > 0 ? std::abs(speeds.w) * way / speeds.v : HUGE_VAL;
  return std::abs(speeds.w) * std::abs(speeds.w) <=
             2 * kBrakingShare * robot.max_accel_w * std::max(0.0, turn) ||
         speeds.w == 0;
}

double heading_term(const Pose& pose, const Speeds& speeds, const Point& target, const Robot& robot,
                    double period) {
  Pose then = moved(pose, speeds, period);
  then.phi += 0.5 * speeds.w * std::abs(speeds.w) / robot.max_accel_w;
  const Point seen = to_robot(then, target);
  return 1 - std::abs(std::atan2(seen.y, seen.x)) / kPi;
}

Dwa::Dwa(const Parameters& parameters, const Robot& robot)
    : parameters_(parameters),
      robot_(robot),
      map_({parameters.memory, 0.05, 0.8 + robot.radius}, robot),
      guide_({robot.radius + parameters.margin, 2 * robot.radius + parameters.margin, 2.0},
             robot.radius + 0.01),
      turn_(parameters.turn_in_place, 0.5) {}

void Dwa::reset(const Task& task) {
  task_ = task;
  map_.clear();
  turn_.reset();
}

Waypoint Dwa::target(const Observation& observation) {
  const Point goal = to_world(observation.pose, observation.goal);
  if (parameters_.guidance < 0.5) return {goal, true, true};
  return guide_.find(map_, observation.pose, goal, parameters_.look_ahead);
}

void Dwa::evaluate(const Observation& observation, const Point& target, double top_speed) {
  const auto rows = static_cast<int>(parameters_.v_samples);
  const auto columns = static_cast<int>(parameters_.w_samples);
  const Window window = dynamic_window(observation.measured, robot_, task_.control_period);
  const double top = std::max(window.low.v, std::min(window.high.v, top_speed));
  const double radius =
      radius_to_keep(map_.clearance(), observation.pose, robot_, parameters_.margin);
  candidates_.clear();
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < columns; ++k) {
      Candidate c;
      c.speeds = {window.low.v + (top - window.low.v) * i / (rows - 1),
                  window.low.w + (window.high.w - window.low.w) * k / (columns - 1)};
      const double way =
          free_arc(map_.clearance(), observation.pose, c.speeds, radius, parameters_.horizon);
      c.admissible = can_stop(c.speeds, way, robot_, task_.control_period);
      c.clearance = way / parameters_.horizon;
      c.velocity = c.speeds.v / robot_.max_v;
      c.heading = heading_term(observation.pose, c.speeds, target, robot_, task_.control_period);
      candidates_.push_back(c);
    }
}

/// Eq. (13), smoothed over the neighbours in the window: what is not admissible beside a pair of
/// speeds makes it worse, so that the robot keeps aside of obstacles.
double Dwa::smoothed(std::size_t v, std::size_t w) const {
  const auto columns = static_cast<std::size_t>(parameters_.w_samples);
  const auto rows = candidates_.size() / columns;
  double sum = 0, weight = 0;
  for (std::size_t i = v > 0 ? v - 1 : v; i <= std::min(v + 1, rows - 1); ++i)
    for (std::size_t k = w > 0 ? w - 1 : w; k <= std::min(w + 1, columns - 1); ++k) {
      const Candidate& c = candidates_[i * columns + k];
      const double share = i == v && k == w ? 2 : 1;
      weight += share;
      if (c.admissible)
        sum += share * (parameters_.alpha * c.heading + parameters_.beta * c.clearance +
                        parameters_.gamma * c.velocity);
    }
  return sum / weight;
}

Speeds Dwa::best() const {
  const auto columns = static_cast<std::size_t>(parameters_.w_samples);
  Speeds best{0, 0};
  double best_value = -1;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    if (!candidates_[i].admissible) continue;
    const double value = smoothed(i / columns, i % columns);
    if (value <= best_value) continue;
    best_value = value;
    best = candidates_[i].speeds;
  }
  return best;
}

Speeds Dwa::step(const Observation& observation) {
  map_.update(observation);
  const Waypoint waypoint = target(observation);
  const Point seen = to_robot(observation.pose, waypoint.position);
  const double bearing = std::atan2(seen.y, seen.x);
  if (turn_.wanted(bearing)) return limited(turn_.speeds(bearing, robot_), robot_);
  const double left = std::hypot(observation.goal.x, observation.goal.y);
  evaluate(observation, waypoint.position,
           stopping_speed(left + 0.5 * task_.goal_tolerance, robot_));
  return limited(best(), robot_);
}

}  // namespace dwa
