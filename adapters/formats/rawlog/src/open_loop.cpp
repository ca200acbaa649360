// SPDX-License-Identifier: BSD-3-Clause
#include "rawlog_format.h"

#include <slalom/core/distance.h>
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/methods/registry.h>
#include <slalom/rawlog/open_loop.h>
#include <slalom/scenario/geometry.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr double kStep = 0.01;  // s

/// Simulates the robot, in the frame of its pose at the time of the command.
class Rollout {
 public:
  Rollout(const RobotModel& robot, const Velocity& velocity)
      : robot_(robot), shape_(robot.shape()), vehicle_(make_vehicle(robot)) {
    vehicle_->start_at({});
    vehicle_->command(velocity.v, velocity.w, velocity.vy);
    for (double t = 0; t < settling_time(); t += kStep) vehicle_->advance(kStep);
    start_ = vehicle_->getCurrentGTPose();
  }

  /// Whether a point enters the footprint while `command` is applied for `duration` (s).
  bool collides(const Command& command, double duration, const std::vector<TPoint2D>& points) {
    vehicle_->command(command.v, command.w, command.vy);
    for (double t = 0; t < duration - 0.5 * kStep; t += kStep) {
      vehicle_->advance(kStep);
      if (in_contact(points)) return true;
    }
    return false;
  }

  bool in_contact(const std::vector<TPoint2D>& points) const {
    const TPose2D pose = vehicle_->getCurrentGTPose() - start_;
    const Polygon outline{shape_.corners_at(pose)};
    return std::any_of(points.begin(), points.end(), [&](const TPoint2D& p) {
      return shape_.is_disc() ? distance_between(p, pose) < robot_.radius : contains(outline, p);
    });
  }

  /// Time (s) after which the velocity has converged to the command.
  double settling_time() const {
    constexpr double kTimeConstants = 10;
    return robot_.delay + kTimeConstants * robot_.delay_tau +
           2 * std::max(robot_.max_v / robot_.max_accel_v, robot_.max_w / robot_.max_accel_w) +
           kStep;
  }

 private:
  RobotModel robot_;
  Footprint shape_;
  std::unique_ptr<Vehicle> vehicle_;
  TPose2D start_;
};

Observation observe(const LoggedScan& logged, const OpenLoopSetup& setup) {
  Observation observation;
  observation.odometry = logged.odometry.value_or(TPose2D());
  const auto velocity = logged.velocity.value_or(mrpt::math::TTwist2D());
  observation.v = velocity.vx;
  observation.w = velocity.omega;
  observation.vy = setup.robot.holonomic() ? velocity.vy : 0;
  observation.goal_in_robot = {setup.goal_ahead, 0};
  return observation;
}

NavigationTask task_of(const Observation& observation, const OpenLoopSetup& setup) {
  NavigationTask task;
  task.start = observation.odometry;
  task.goal = {task.start.x + setup.goal_ahead * math::cos(task.start.phi),
               task.start.y + setup.goal_ahead * math::sin(task.start.phi)};
  task.goal_tolerance = setup.goal_tolerance;
  task.control_period = setup.control_period;
  return task;
}

/// Returns the method's command; `problem` is set if it is not valid.
Command query_method(Method& method, const Observation& observation, const OpenLoopSetup& setup,
                     std::string& problem) try {
  method.reset(task_of(observation, setup));
  method.settle(observation);
  const Command command = method.step(observation);
  is_valid_command(command, setup.robot, problem);
  return command;
} catch (const std::exception& error) {
  problem = reason_of(error);
  return {};
}

/// The scan with the pose that the method takes it to have.
mrpt::obs::CObservation2DRangeScan as_seen(mrpt::obs::CObservation2DRangeScan scan,
                                           const SensorModel& sensor) {
  if (!sensor.lasers.empty() && sensor.lasers.front().raw) scan.sensorPose = {};
  return scan;
}

/// The number of rays of the campaign's sensor outside the scan's field of view.
int count_uncovered(const mrpt::obs::CObservation2DRangeScan& scan, const SensorModel& sensor) {
  const double yaw = scan.sensorPose.yaw(), half = 0.5 * scan.aperture + 1e-6;
  int uncovered = 0;
  for (int i = 0; i < sensor.rays; ++i) {
    const double angle = sensor.aperture() * (static_cast<double>(i) / (sensor.rays - 1) - 0.5);
    uncovered += std::abs(std::remainder(angle - yaw, 2 * M_PI)) > half ? 1 : 0;
  }
  return uncovered;
}

}  // namespace

mrpt::obs::CObservation2DRangeScan resample_scan(const mrpt::obs::CObservation2DRangeScan& scan,
                                                 const SensorModel& sensor) {
  const std::vector<float> ranges = merged_ranges({&scan}, sensor);
  mrpt::obs::CObservation2DRangeScan resampled;
  resampled.aperture = static_cast<float>(sensor.aperture());
  resampled.maxRange = static_cast<float>(sensor.max_range);
  resampled.sensorLabel = "range_finder";
  std::vector<char> valid;
  for (const float range : ranges) valid.push_back(range < resampled.maxRange ? 1 : 0);
  resampled.loadFromVectors(valid.size(), ranges.data(), valid.data());
  return resampled;
}

ContactPrediction predict_contact(const RobotModel& robot, double control_period,
                                  const Velocity& velocity, const Command& command,
                                  const std::vector<TPoint2D>& points) {
  ContactPrediction prediction;
  Rollout braked(robot, velocity), held(robot, velocity);
  prediction.in_contact = braked.in_contact(points);
  if (prediction.in_contact) return prediction;
  prediction.stopping = braked.collides(command, control_period, points) ||
                        braked.collides({}, braked.settling_time(), points);
  prediction.one_second = held.collides(command, 1.0, points);
  return prediction;
}

std::vector<OpenLoopAnswer> replay_open_loop(const std::vector<LoggedScan>& scans,
                                             const OpenLoopSetup& setup, Method& method) {
  constexpr double kTaskInterval =
      3;  // s; large enough for navigators to treat the tasks as separate
  std::vector<OpenLoopAnswer> answers;
  mrpt::Clock::setActiveClock(mrpt::Clock::Simulated);
  for (const LoggedScan& logged : scans) {
    const auto now = logged_time(kTaskInterval * static_cast<double>(answers.size()));
    mrpt::Clock::setSimulatedTime(now);
    auto scan = resample_scan(as_seen(*logged.scan, setup.sensor), setup.sensor);
    scan.timestamp = now;
    Observation observation = observe(logged, setup);
    observation.scan = &scan;
    OpenLoopAnswer answer;
    answer.time = logged.time;
    answer.uncovered_rays = count_uncovered(as_seen(*logged.scan, setup.sensor), setup.sensor);
    answer.command = query_method(method, observation, setup, answer.problem);
    if (answer.problem.empty())
      answer.prediction = predict_contact(setup.robot, setup.control_period,
                                          {observation.v, observation.w, observation.vy},
                                          answer.command, scan_points(*logged.scan));
    answers.push_back(std::move(answer));
  }
  return answers;
}

}  // namespace slalom
