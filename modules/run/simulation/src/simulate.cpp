// SPDX-License-Identifier: BSD-3-Clause
#include "mover_tracker.h"
#include "odometry.h"
#include "pose_history.h"
#include "run_movers.h"
#include "simulated_clock.h"
#include "termination_checker.h"

#include <slalom/core/error.h>
#include <slalom/core/pose.h>
#include <slalom/core/text.h>
#include <slalom/methods/registry.h>
#include <slalom/robot/vehicle.h>
#include <slalom/simulation/range_finder.h>
#include <slalom/simulation/run_observer.h>
#include <slalom/simulation/simulate.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace slalom {
namespace {

using mrpt::math::TPose2D;

std::string at(const TPose2D& pose, double time) {
  return "at (" + format_fixed(pose.x, 2) + ", " + format_fixed(pose.y, 2) + ") m after " +
         format_fixed(time, 2) + " s";
}

/// One run, from the start pose to its outcome.
class Run {
 public:
  Run(const World& world, const RunSetup& setup, std::uint64_t seed, Method& method,
      RunObserver* observer, PeopleAlone* alone)
      : world_(world),
        setup_(setup),
        options_(setup.simulation),
        seed_(seed),
        method_(method),
        observer_(observer),
        movers_(world, setup.robot.shape(), setup.people, options_.time_limit(), alone),
        sensor_(world, movers_.movers(), setup.sensor, seed),
        tracker_(movers_.movers(), setup.tracker, seed, movers_.scripted()),
        checker_(world, movers_, setup.robot, options_),
        vehicle_(make_vehicle(setup.robot)),
        odometry_(setup.odometry, seed, world.scenario().start()),
        history_(std::max(setup.sensor.latency, setup.tracker.latency)),
        steps_per_cycle_(static_cast<int>(std::llround(options_.control_period / options_.step))) {
    vehicle_->start_at(world.scenario().start());
    history_.add(0, pose());
  }

  SimulationResult execute() {
    update_people();
    if (checker_.touches(pose()))
      end(Outcome::UnsolvableScenario, "the robot touches an obstacle where it starts");
    else if (const Mover* mover = checker_.overlapping_mover(pose(), 0))
      end(Outcome::UnsolvableScenario,
          std::string(movers_.is_person(*mover) ? "person" : "moving obstacle") + " '" + mover->id +
              "' touches the robot where it starts");
    else
      begin();
    while (!finished_) cycle();
    update_people();  // a run that ended at an update as any other
    result_.hindrances = movers_.hindrances();
    result_.movers = movers_.take();
    if (started_) {
      announce();
      notify_method();
    }
    if (observer_ != nullptr) observer_->on_end(result_);
    return std::move(result_);
  }

 private:
  const TPose2D& pose() const { return vehicle_->getCurrentGTPose(); }
  double cycle_time() const { return cycle_ * options_.control_period; }

  void begin() {
    const Occupancy& cells = world_.occupancy();
    const KnownMap map = {cells.resolution(), cells.origin(),
                          static_cast<std::size_t>(cells.size_x()),
                          static_cast<std::size_t>(cells.size_y()), &cells.cells()};
    NavigationTask navigation_task = task();
    if (method_.uses_map()) navigation_task.map = &map;
    started_ = true;
    call_method([&] { method_.reset(navigation_task); });
  }

  void settle(const Observation& observation) {
    call_method([&] { method_.settle(observation); });
    announce();
  }

  /// The run begins for its observer, once.
  void announce() {
    if (!announced_ && observer_ != nullptr) observer_->on_start(task());
    announced_ = true;
  }

  /// Exceptions are ignored: the outcome is final.
  void notify_method() {
    try {
      method_.finish(to_string(result_.outcome));
      result_.figures = method_.run_figures();
    } catch (...) {
      return;
    }
  }

  NavigationTask task() const {
    NavigationTask task;
    task.start = world_.scenario().start();
    task.goal = world_.scenario().goal();
    task.goal_tolerance = options_.goal_tolerance;
    task.goal_heading = world_.scenario().goal_heading();
    task.goal_heading_tolerance = options_.goal_heading_tolerance;
    task.control_period = options_.control_period;
    task.seed = derive_seed(seed_, "method");
    return task;
  }

  /// Any exception of the method ends its run only.
  template <typename Call>
  void call_method(Call call) {
    try {
      call();
    } catch (const MethodTimeout& e) {
      end(Outcome::MethodDeadline, reason_of(e) + ", " + at(pose(), time_));
    } catch (const std::exception& e) {
      end(Outcome::MethodError, reason_of(e) + ", " + at(pose(), time_));
    } catch (...) {
      end(Outcome::MethodError, "the method threw an exception that is not a std::exception");
    }
  }

  void update_people() {
    if (movers_.is_due(time_)) movers_.update({pose(), vehicle_->v(), vehicle_->vy()});
  }

  /// One control period: sense, query the method, move.
  void cycle() {
    time_ = cycle_time();
    update_people();
    if (check_termination()) return;
    const Observation observation = observe();
    if (!announced_) settle(observation);
    if (!finished_) call_method([&] { query_method(observation); });
    if (finished_) return;
    record();
    if (observer_ != nullptr) observer_->on_cycle(observation, command_, pose());
    vehicle_->command(command_.v, command_.w, command_.vy);
    move();
    ++cycle_;
  }

  bool check_termination() {
    if (checker_.reached_goal(pose()))
      end(Outcome::Success, "goal reached " + at(pose(), time_));
    else if (checker_.is_time_over(time_))
      end(Outcome::Timeout, "goal not reached, " + at(pose(), time_));
    else if (checker_.is_stuck(result_.trajectory, time_, pose()))
      end(Outcome::Stuck,
          "no progress for " + format_number(checker_.stuck_time()) + " s " + at(pose(), time_));
    return finished_;
  }

  Observation observe() {
    clock_.set(time_);
    Observation observation;
    observation.time = time_;
    observation.odometry = odometry_.pose();
    observation.v = vehicle_->v();
    observation.w = vehicle_->w();
    observation.vy = vehicle_->vy();
    observation.goal_in_robot = inverse_compose(observation.odometry, world_.scenario().goal());
    const double scan_time = std::max(0.0, time_ - setup_.sensor.latency);
    sensor_.sense(history_.at(scan_time), scan_time, clock_.at(scan_time), observation);
    if (method_.uses_tracks()) {
      const double track_time = std::max(0.0, time_ - setup_.tracker.latency);
      observation.tracks = &tracker_.sense(history_.at(track_time), track_time);
    }
    return observation;
  }

  void query_method(const Observation& observation) {
    const double begin = setup_.clock();
    const Command command = method_.step(observation);
    const double elapsed = setup_.clock() - begin;
    if (!method_.is_paced()) result_.cycle_seconds.push_back(elapsed);
    std::string reason;
    if (!is_valid_command(command, setup_.robot, reason))
      end(Outcome::MethodInvalidCommand, reason + " " + at(pose(), time_));
    else if (setup_.deadline.cycle_deadline > 0 && elapsed > setup_.deadline.cycle_deadline)
      handle_missed_deadline();
    else
      command_ = command;
  }

  /// Applies the deadline policy; the late command is discarded.
  void handle_missed_deadline() {
    if (setup_.deadline.deadline_policy == DeadlinePolicy::Fail)
      end(Outcome::MethodDeadline, "no answer within " +
                                       format_number(setup_.deadline.cycle_deadline) +
                                       " s of a cycle, " + at(pose(), time_));
    else if (setup_.deadline.deadline_policy == DeadlinePolicy::Stop)
      command_ = {};
  }

  void move() {
    for (int step = 0; step < steps_per_cycle_ && !finished_; ++step) {
      const double begin = cycle_time() + step * options_.step;
      if (!checker_.is_in_time(begin + options_.step))
        return end(Outcome::Timeout, "goal not reached, " + at(pose(), time_));
      const TPose2D before = pose();
      vehicle_->advance(options_.step);
      check_step(before, begin);
    }
  }

  /// Checks the motion from `before` (at time `begin`) to the current pose.
  void check_step(const TPose2D& before, double begin) {
    TimedMotion motion{before, pose(), begin, begin + options_.step};
    double fraction = 1;
    const bool contact = checker_.find_contact(motion, fraction);
    const TPose2D& now = motion.to;
    time_ = begin + fraction * options_.step;
    traveled_ += fraction * vehicle_->step_length();
    odometry_.move(before, now);
    history_.add(time_, now);
    if (contact) {
      vehicle_->setCurrentGTPose(now);
      record_end();
      end(Outcome::Collision, checker_.describe_contact(result_.trajectory, at(now, time_)));
    } else if (checker_.left_workspace(now)) {
      end(Outcome::LeftWorkspace, "left " + at(now, time_));
    } else if (checker_.reached_goal(now)) {
      end(Outcome::Success, "goal reached " + at(now, time_));
    }
  }

  void record() {
    result_.trajectory.samples.push_back({time_, pose(), vehicle_->v(), vehicle_->w(), command_.v,
                                          command_.w, vehicle_->vy(), command_.vy, traveled_});
  }

  /// Records the final state, unless it coincides with the sample of the control cycle.
  void record_end() {
    const auto& samples = result_.trajectory.samples;
    if (samples.empty() || samples.back().t < time_) record();
  }

  void end(Outcome outcome, const std::string& detail) {
    record_end();
    result_.outcome = outcome;
    result_.detail = detail;
    finished_ = true;
  }

  const World& world_;
  const RunSetup& setup_;
  const SimulationOptions& options_;
  std::uint64_t seed_;
  Method& method_;
  RunObserver* observer_;
  SimulatedClock clock_;
  RunMovers movers_;
  RangeFinder sensor_;
  MoverTracker tracker_;
  TerminationChecker checker_;
  std::unique_ptr<Vehicle> vehicle_;
  Odometry odometry_;
  PoseHistory history_;
  int steps_per_cycle_;
  int cycle_ = 0;
  double time_ = 0;
  double traveled_ = 0;  ///< m, along the arcs of the motion steps
  Command command_;
  bool started_ = false, announced_ = false, finished_ = false;
  SimulationResult result_;
};

}  // namespace

SimulationResult simulate(const World& world, const RunSetup& setup, std::uint64_t seed,
                          Method& method, RunObserver* observer, PeopleAlone* alone) {
  const double ratio = setup.simulation.control_period / setup.simulation.step;
  if (!(ratio >= 1 - 1e-6 && ratio < 1e9))
    throw std::invalid_argument("simulate: the step must divide the control period");
  if (!world.scenario().people().empty())
    check_period(setup.people, setup.simulation, location_of("people"));
  return Run(world, setup, seed, method, observer, alone).execute();
}

}  // namespace slalom
