// SPDX-License-Identifier: BSD-3-Clause
#include "run_movers.h"
#include "termination_checker.h"

#include <slalom/core/distance.h>
#include <slalom/core/text.h>
#include <slalom/simulation/evaluate_trajectory.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace slalom {
namespace {

using mrpt::math::TPose2D;
using mrpt::math::wrapToPi;

/// The interpolated sample at `fraction` between two samples; the command is that of `from`.
Sample between(const Sample& from, const Sample& to, double fraction) {
  Sample sample = from;
  const auto mix = [fraction](double a, double b) { return a + fraction * (b - a); };
  sample.t = mix(from.t, to.t);
  sample.pose = {mix(from.pose.x, to.pose.x), mix(from.pose.y, to.pose.y),
                 wrapToPi(from.pose.phi + fraction * wrapToPi(to.pose.phi - from.pose.phi))};
  sample.v = mix(from.v, to.v);
  sample.w = mix(from.w, to.w);
  sample.vy = mix(from.vy, to.vy);
  sample.traveled = mix(from.traveled, to.traveled);
  return sample;
}

/// The people's motion along a log.
RunMovers run_movers_along(const World& world, const RobotModel& robot,
                           const SimulationOptions& options, const Trajectory& log,
                           const PeopleSettings& people) {
  constexpr double kRounding = 1e-9;  // s
  const double limit =
      options.max_time ? *options.max_time : std::max(options.time_limit(), log.duration());
  RunMovers movers(world, robot.shape(), people, limit);
  const std::vector<Sample>& samples = log.samples;
  const auto time = [&](std::size_t i) { return samples[i].t - samples.front().t; };
  for (std::size_t i = 0; i < samples.size() && time(i) <= limit + kRounding; ++i)
    while (movers.is_due(time(i))) {
      const double early = time(i) - movers.time();
      const Sample seen =
          i == 0 || early <= kRounding
              ? samples[i]
              : between(samples[i - 1], samples[i], 1 - early / (samples[i].t - samples[i - 1].t));
      movers.update({seen.pose, seen.v, seen.vy});
    }
  return movers;
}

/// Number of steps between two samples such that each is short enough for collision checking.
int steps_between(const Sample& from, const Sample& to) {
  constexpr double kStep = 0.01, kTurn = 0.05;  // m, rad
  constexpr double kMaxSteps = 1e6;
  const double distance = distance_between(to.pose, from.pose);
  const double turn = std::abs(wrapToPi(to.pose.phi - from.pose.phi));
  return static_cast<int>(
      std::clamp(std::ceil(std::max(distance / kStep, turn / kTurn)), 1.0, kMaxSteps));
}

/// Evaluates one log.
class LogEvaluator {
 public:
  LogEvaluator(const World& world, const RobotModel& robot, const SimulationOptions& options,
               const Trajectory& log, const PeopleSettings& people)
      : world_(world),
        robot_(robot),
        people_(people),
        scenario_(world.scenario()),
        options_(options),
        movers_(run_movers_along(world, robot, options_, log, people)),
        checker_(world, movers_, robot, options_),
        log_(log) {}

  SimulationResult run() {
    const Sample& first = log_.samples.front();
    add(first);
    if (checker_.left_workspace(first.pose))
      end(Outcome::UnsolvableScenario, "the log begins outside of the workspace");
    else if (checker_.touches(first.pose))
      end(Outcome::UnsolvableScenario, "the robot touches an obstacle where the log begins");
    else if (const Mover* mover = checker_.overlapping_mover(first.pose, 0))
      end(Outcome::UnsolvableScenario,
          std::string(movers_.is_person(*mover) ? "person" : "moving obstacle") + " '" + mover->id +
              "' touches the robot where the log begins");
    else
      check_sample(first);
    for (std::size_t i = 1; i < log_.samples.size() && !finished_; ++i) {
      check_motion(log_.samples[i - 1], log_.samples[i]);
      if (finished_) break;
      add(log_.samples[i]);
      check_sample(log_.samples[i]);
    }
    if (!finished_) end(Outcome::Timeout, "the log ends " + remaining() + " before the goal");
    result_.movers = movers_.take();
    if (!scenario_.people().empty())
      movers_along(world_, robot_, options_, result_.trajectory, people_, &result_.hindrances);
    return std::move(result_);
  }

 private:
  double time(const Sample& sample) const { return sample.t - log_.samples.front().t; }
  void add(const Sample& sample) { result_.trajectory.samples.push_back(sample); }

  /// Checks the conditions that apply at samples of the log.
  void check_sample(const Sample& now) {
    if (checker_.reached_goal(now.pose))
      end(Outcome::Success, "goal reached");
    else if (checker_.is_time_over(time(now)))
      end(Outcome::Timeout, "goal not reached");
    else if (checker_.is_stuck(result_.trajectory, now.t, now.pose))
      end(Outcome::Stuck, "no progress for " + format_number(checker_.stuck_time()) + " s");
  }

  /// Checks the motion between two consecutive samples.
  void check_motion(const Sample& from, const Sample& to) {
    const int steps = steps_between(from, to);
    Sample before = from;
    for (int k = 1; k <= steps && !finished_; ++k) {
      const Sample after = k == steps ? to : between(from, to, static_cast<double>(k) / steps);
      check_step(before, after);
      before = after;
    }
  }

  /// A step beyond the time limit is cut there: a gap in the log may be long.
  void check_step(const Sample& before, const Sample& end_of_step) {
    const bool is_late = !checker_.is_in_time(time(end_of_step));
    const Sample after = is_late ? at_time_limit(before, end_of_step) : end_of_step;
    TimedMotion motion{before.pose, after.pose, time(before), time(after)};
    const TPose2D& pose = motion.to;
    double fraction = 1;
    if (checker_.find_contact(motion, fraction)) {
      Sample last = between(before, after, fraction);
      last.pose = pose;
      add_later(last);
      finish(Outcome::Collision, checker_.describe_contact(result_.trajectory, where()));
    } else if (checker_.left_workspace(pose)) {
      end_at(after, Outcome::LeftWorkspace, "left the workspace");
    } else if (checker_.reached_goal(pose)) {
      end_at(after, Outcome::Success, "goal reached");
    } else if (is_late) {
      end_at(after, Outcome::Timeout, "goal not reached");
    }
  }

  Sample at_time_limit(const Sample& before, const Sample& after) const {
    const double left = std::max(options_.time_limit() - time(before), 0.0);
    return between(before, after, left / (after.t - before.t));
  }

  /// Samples are strictly ordered by time: one at the time of the last is omitted.
  void add_later(const Sample& sample) {
    if (sample.t > result_.trajectory.samples.back().t) add(sample);
  }

  void end_at(const Sample& sample, Outcome outcome, const std::string& what) {
    add_later(sample);
    end(outcome, what);
  }

  void end(Outcome outcome, const std::string& what) { finish(outcome, what + " " + where()); }

  void finish(Outcome outcome, const std::string& detail) {
    result_.outcome = outcome;
    result_.detail = detail;
    finished_ = true;
  }

  /// The last sample.
  std::string where() const {
    const Sample& last = result_.trajectory.samples.back();
    return "at (" + format_fixed(last.pose.x, 2) + ", " + format_fixed(last.pose.y, 2) +
           ") m after " + format_fixed(time(last), 2) + " s";
  }

  std::string remaining() const {
    const TPose2D& pose = log_.samples.back().pose;
    const std::string distance = format_fixed(distance_between(pose, scenario_.goal()), 2) + " m";
    const std::optional<double>& heading = scenario_.goal_heading();
    if (!heading) return distance;
    return distance + " and " + format_fixed(std::abs(wrapToPi(pose.phi - *heading)), 2) + " rad";
  }

  const World& world_;
  const RobotModel& robot_;
  const PeopleSettings& people_;
  const Scenario& scenario_;
  SimulationOptions options_;
  RunMovers movers_;
  TerminationChecker checker_;
  const Trajectory& log_;
  bool finished_ = false;
  SimulationResult result_;
};

}  // namespace

SimulationResult evaluate_trajectory(const World& world, const RobotModel& robot,
                                     const SimulationOptions& options, const Trajectory& log,
                                     const PeopleSettings& people) {
  if (log.samples.empty()) throw std::invalid_argument("evaluate_trajectory: no samples");
  return LogEvaluator(world, robot, options, log, people).run();
}

Movers movers_along(const World& world, const RobotModel& robot, const SimulationOptions& options,
                    const Trajectory& log, const PeopleSettings& people, Hindrances* hindrances) {
  RunMovers movers = run_movers_along(world, robot, options, log, people);
  if (hindrances != nullptr) *hindrances = movers.hindrances();
  return movers.take();
}

}  // namespace slalom
