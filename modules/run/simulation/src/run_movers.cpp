// SPDX-License-Identifier: BSD-3-Clause
#include "run_movers.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {

RunMovers::RunMovers(const World& world, const Footprint& footprint, const PeopleSettings& settings,
                     double max_time, PeopleAlone* alone)
    : scenario_(world.scenario()),
      settings_(settings),
      scripted_(scenario_.movers().size()),
      alone_(alone),
      record_(scenario_.people(), max_time, scenario_.movers()) {
  if (scenario_.people().empty()) return;
  if (alone_ == nullptr) {
    own_alone_ = std::make_unique<PeopleAlone>(world, settings);
    alone_ = own_alone_.get();
  }
  crowd_.emplace(alone_->start());
  robot_.disc.radius = footprint.enclosing_radius();
  for (const Person& person : scenario_.people())
    robot_.noticed.push_back(notices_robot(scenario_.hash(), person.id, settings.notices));
  is_noticed_ =
      std::find(robot_.noticed.begin(), robot_.noticed.end(), true) != robot_.noticed.end();
}

Hindrances RunMovers::hindrances() const {
  Hindrances hindrances;
  if (!crowd_) return hindrances;
  for (const PersonState& state : crowd_->states()) hindrances.push_back(state.hindrance);
  if (settings_.until_arrival > 0) add_delays(hindrances);
  if (!is_noticed_) return hindrances;
  const std::vector<double>& alone = alone_->covered(crowd_->updates());
  for (std::size_t i = 0; i < hindrances.size(); ++i)
    hindrances[i].deficit = (alone[i] - crowd_->covered(i)) / scenario_.people()[i].speed;
  return hindrances;
}

/// The people go on, and the robot stands where they saw it last.
void RunMovers::add_delays(Hindrances& hindrances) const {
  const double until = crowd_->time() + settings_.until_arrival;
  RobotDisc standing = robot_;
  standing.disc.velocity = {0, 0};
  Crowd crowd = *crowd_;
  for (; crowd.time() <= until; crowd.move())
    crowd.decide(is_noticed_ ? std::make_optional(standing) : std::nullopt);
  const Arrivals with = arrivals_in(crowd, until), alone = alone_->arrivals(until),
                 beside = alone_->arrivals_beside(until);
  for (std::size_t i = 0; i < hindrances.size(); ++i) {
    if (with[i] && alone[i]) hindrances[i].delay = *with[i] - *alone[i];
    if (alone[i] && beside[i]) hindrances[i].delay_floor = std::abs(*beside[i] - *alone[i]);
  }
}

double RunMovers::max_speed() const {
  double fastest = 0;
  for (const Person& person : scenario_.people())
    fastest = std::max(fastest, person.speed * settings_.haste);
  return fastest;
}

bool RunMovers::is_due(double time) const {
  constexpr double kRounding = 1e-9;  // s, of times, which are sums and multiples of steps
  return crowd_ && crowd_->time() <= time + kRounding;
}

void RunMovers::update(const SeenRobot& robot) {
  const math::SinCos heading = math::sin_cos(robot.pose.phi);
  robot_.disc.position = mrpt::math::TPoint2D(robot.pose);
  robot_.disc.velocity = {robot.v * heading.cos - robot.vy * heading.sin,
                          robot.v * heading.sin + robot.vy * heading.cos};
  crowd_->decide(is_noticed_ ? std::make_optional(robot_) : std::nullopt);
  record_.add(*crowd_);
  crowd_->move();
  record_.add(*crowd_);
}

}  // namespace slalom
