#include "judge.h"

#include <slalom/core/text.h>
#include <slalom/simulation/judge_trajectory.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace slalom {
namespace {

using mrpt::math::TPose2D;
using mrpt::math::wrapToPi;

/// What lies a share of the way from one sample to the next; its command is in force until then.
Sample between(const Sample& from, const Sample& to, double share) {
  Sample sample = from;
  const auto mix = [share](double a, double b) { return a + share * (b - a); };
  sample.t = mix(from.t, to.t);
  sample.pose = {mix(from.pose.x, to.pose.x), mix(from.pose.y, to.pose.y),
                 wrapToPi(from.pose.phi + share * wrapToPi(to.pose.phi - from.pose.phi))};
  sample.v = mix(from.v, to.v);
  sample.w = mix(from.w, to.w);
  sample.vy = mix(from.vy, to.vy);
  return sample;
}

/// Steps from sample to sample that are short enough to be judged one by one.
int steps_between(const Sample& from, const Sample& to) {
  constexpr double kStep = 0.01, kTurn = 0.05;  // m, rad
  constexpr double kMost = 1e6;
  const double way = std::hypot(to.pose.x - from.pose.x, to.pose.y - from.pose.y);
  const double turn = std::abs(wrapToPi(to.pose.phi - from.pose.phi));
  return static_cast<int>(std::clamp(std::ceil(std::max(way / kStep, turn / kTurn)), 1.0, kMost));
}

/// The walk along one log.
class LogJudge {
 public:
  LogJudge(const World& world, const RobotModel& robot, const SimulationOptions& options,
           const Trajectory& log)
      : goal_(world.scenario().goal()),
        options_(options),
        judge_(world, robot, options_),
        log_(log) {}

  SimulationResult judge() {
    const Sample& first = log_.samples.front();
    add(first);
    if (judge_.touches(first.pose))
      end(Outcome::UnsolvableScenario, "the robot touches an obstacle where the log begins");
    else
      look_around(first);
    for (std::size_t i = 1; i < log_.samples.size() && !over_; ++i) {
      follow(log_.samples[i - 1], log_.samples[i]);
      if (over_) break;
      add(log_.samples[i]);
      look_around(log_.samples[i]);
    }
    if (!over_) end(Outcome::Timeout, "the log ends " + metres_left() + " before the goal");
    return std::move(result_);
  }

 private:
  double time(const Sample& sample) const { return sample.t - log_.samples.front().t; }
  void add(const Sample& sample) { result_.trajectory.samples.push_back(sample); }

  /// What is judged at the instants of the log.
  void look_around(const Sample& now) {
    if (judge_.reached_goal(now.pose))
      end(Outcome::Success, "goal reached");
    else if (judge_.is_time_over(time(now)))
      end(Outcome::Timeout, "goal not reached");
    else if (judge_.is_stuck(result_.trajectory, now.t, now.pose))
      end(Outcome::Stuck, "no progress for " + format_number(options_.stuck_time) + " s");
  }

  /// What happens on the way from one sample to the next.
  void follow(const Sample& from, const Sample& to) {
    const int steps = steps_between(from, to);
    Sample before = from;
    for (int k = 1; k <= steps && !over_; ++k) {
      const Sample after = k == steps ? to : between(from, to, static_cast<double>(k) / steps);
      step(before, after);
      before = after;
    }
  }

  void step(const Sample& before, const Sample& after) {
    TPose2D pose = after.pose;
    double share = 1;
    if (judge_.meets_obstacle(before.pose, pose, share)) {
      Sample contact = between(before, after, share);
      contact.pose = pose;
      end_at(contact, Outcome::Collision, "contact");
    } else if (judge_.left_workspace(pose)) {
      end_at(after, Outcome::LeftWorkspace, "left the workspace");
    } else if (judge_.reached_goal(pose)) {
      end_at(after, Outcome::Success, "goal reached");
    } else if (!judge_.is_in_time(time(after))) {
      end_at(before, Outcome::Timeout, "goal not reached");
    }
  }

  /// Samples stay in the order of time: one at the instant of another is left out.
  void end_at(const Sample& sample, Outcome outcome, const std::string& what) {
    if (sample.t > result_.trajectory.samples.back().t) add(sample);
    end(outcome, what);
  }

  void end(Outcome outcome, const std::string& what) {
    const Sample& last = result_.trajectory.samples.back();
    result_.outcome = outcome;
    result_.detail = what + " at (" + format_fixed(last.pose.x, 2) + ", " +
                     format_fixed(last.pose.y, 2) + ") m after " + format_fixed(time(last), 2) +
                     " s";
    over_ = true;
  }

  std::string metres_left() const {
    const TPose2D& pose = log_.samples.back().pose;
    return format_fixed(std::hypot(pose.x - goal_.x, pose.y - goal_.y), 2) + " m";
  }

  mrpt::math::TPoint2D goal_;
  SimulationOptions options_;
  Judge judge_;
  const Trajectory& log_;
  bool over_ = false;
  SimulationResult result_;
};

}  // namespace

SimulationResult judge_trajectory(const World& world, const RobotModel& robot,
                                  const SimulationOptions& options, const Trajectory& log) {
  if (log.samples.empty()) throw std::invalid_argument("judge_trajectory: no samples");
  return LogJudge(world, robot, options, log).judge();
}

}  // namespace slalom
