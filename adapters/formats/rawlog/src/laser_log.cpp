// SPDX-License-Identifier: BSD-3-Clause
#include "rawlog_format.h"

#include <slalom/core/error.h>
#include <slalom/rawlog/laser_log.h>

#include <mrpt/math/wrap2pi.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;
using mrpt::obs::CActionCollection;
using mrpt::obs::CActionRobotMovement2D;
using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CSensoryFrame;

bool has_time(const CObservation& observation) {
  return observation.timestamp != INVALID_TIMESTAMP;
}

bool is_finite(const TPose2D& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.phi);
}

/// Processes the objects of a log in order, keeping the latest odometry.
class LaserLogReader {
 public:
  explicit LaserLogReader(const std::string& label) : label_(label) {}

  void add(const mrpt::serialization::CSerializable::Ptr& object) {
    if (const auto action = std::dynamic_pointer_cast<CActionCollection>(object)) {
      add_action(*action);
    } else if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(object)) {
      for (const auto& observation : *frame) add_observation(observation);
    } else if (const auto observation = std::dynamic_pointer_cast<CObservation>(object)) {
      add_observation(observation);
    }
  }

  std::vector<LoggedScan> scans() && { return std::move(scans_); }

 private:
  void add_action(const CActionCollection& actions) {
    const auto movement = actions.getBestMovementEstimation();
    if (!movement) return;
    const auto increment = movement->rawOdometryIncrementReading.asTPose();
    if (movement->estimationMethod != CActionRobotMovement2D::emOdometry || !is_finite(increment))
      return;
    odometry_ = odometry_.value_or(TPose2D()) + increment;
    moved_ = true;
  }

  void add_observation(const CObservation::Ptr& observation) {
    if (const auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(observation)) {
      if (label_.empty() || scan->sensorLabel == label_) add_scan(scan);
    } else if (const auto odometry = std::dynamic_pointer_cast<CObservationOdometry>(observation)) {
      add_odometry(*odometry);
    }
  }

  void add_odometry(const CObservationOdometry& odometry) {
    if (odometry.sensorLabel == kCommandLabel) return;  // of a recorded run: not measured
    const TPose2D pose = odometry.odometry.asTPose();
    if (!is_finite(pose)) return;
    if (odometry.hasVelocities)
      velocity_ = odometry.velocityLocal;
    else if (has_time(odometry))
      differentiate(pose, odometry.timestamp);
    odometry_ = pose;
  }

  void add_scan(const CObservation2DRangeScan::Ptr& scan) {
    if (moved_ && has_time(*scan)) differentiate(*odometry_, scan->timestamp);
    moved_ = false;
    LoggedScan logged;
    logged.scan = scan;
    if (has_time(*scan)) {
      if (!first_) first_ = scan->timestamp;
      logged.time = mrpt::Clock::toDouble(scan->timestamp) - mrpt::Clock::toDouble(*first_);
    }
    logged.odometry = odometry_;
    logged.velocity = velocity_;
    scans_.push_back(std::move(logged));
  }

  /// Computes the mean velocity since the last pose with a timestamp.
  void differentiate(const TPose2D& pose, mrpt::Clock::time_point time) {
    if (last_pose_) {
      const double dt = mrpt::Clock::toDouble(time) - mrpt::Clock::toDouble(last_time_);
      const TPose2D step = pose - *last_pose_;
      constexpr double kMinPeriod = 1e-3, kMaxPeriod = 10;  // s; ignored outside
      if (dt > kMinPeriod && dt < kMaxPeriod)
        velocity_ = TTwist2D(step.x / dt, step.y / dt, mrpt::math::wrapToPi(step.phi) / dt);
    }
    last_pose_ = pose;
    last_time_ = time;
  }

  std::string label_;
  std::vector<LoggedScan> scans_;
  std::optional<TPose2D> odometry_, last_pose_;
  std::optional<TTwist2D> velocity_;
  std::optional<mrpt::Clock::time_point> first_;
  mrpt::Clock::time_point last_time_;
  bool moved_ = false;
};

}  // namespace

std::vector<LoggedScan> read_laser_log(const LogObjects& log, const std::string& label) {
  LaserLogReader reader(label);
  for (const auto& object : log.objects) reader.add(object);
  std::vector<LoggedScan> scans = std::move(reader).scans();
  if (scans.empty())
    throw file_error(
        log.path, label.empty() ? "contains no 2D scan" : "contains no 2D scan of '" + label + "'",
        "a rawlog with CObservation2DRangeScan, or a bag with LaserScan");
  return scans;
}

std::vector<LoggedScan> read_laser_log(const std::string& path, const std::string& label) {
  return read_laser_log(load_log(path), label);
}

}  // namespace slalom
