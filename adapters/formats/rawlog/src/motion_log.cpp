// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/rawlog/motion_log.h>

#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>
#include <mrpt/math/wrap2pi.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace slalom {
namespace {

using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;
using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;

class MotionLogReader {
 public:
  explicit MotionLogReader(const MotionLabels& labels) { log_.labels = labels; }

  void add(const mrpt::serialization::CSerializable::Ptr& object) {
    if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object))
      for (const auto& observation : *frame) add_observation(observation);
    else if (const auto observation = std::dynamic_pointer_cast<CObservation>(object))
      add_observation(observation);
  }

  MotionLog log() && {
    const auto earlier = [](const auto& a, const auto& b) { return a.time < b.time; };
    std::stable_sort(log_.commands.begin(), log_.commands.end(), earlier);
    std::stable_sort(log_.odometry.begin(), log_.odometry.end(), earlier);
    std::stable_sort(log_.scans.begin(), log_.scans.end(), earlier);
    return std::move(log_);
  }

 private:
  void add_observation(const CObservation::Ptr& observation) {
    if (observation->timestamp == INVALID_TIMESTAMP) return;
    if (const auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(observation))
      add_scan(scan);
    else if (const auto odometry = std::dynamic_pointer_cast<CObservationOdometry>(observation))
      add_odometry(*odometry);
  }

  void add_scan(const CObservation2DRangeScan::Ptr& scan) {
    if (!log_.labels.scan.empty() && scan->sensorLabel != log_.labels.scan) return;
    if (!log_.scans.empty()) {
      const CObservation2DRangeScan& first = *log_.scans.front().scan;
      if (scan->sensorLabel != first.sensorLabel || scan->getScanSize() != first.getScanSize())
        return;
    }
    log_.scans.push_back({seconds(*scan), scan});
  }

  void add_odometry(const CObservationOdometry& odometry) {
    const std::string& label = odometry.sensorLabel;
    if (!contains(log_.odometry_labels, label)) log_.odometry_labels.push_back(label);
    if (label == log_.labels.command && odometry.hasVelocities)
      add_velocity(log_.commands, seconds(odometry), odometry.velocityLocal);
    if (label != log_.labels.odometry) return;
    if (odometry.hasVelocities)
      add_velocity(log_.odometry, seconds(odometry), odometry.velocityLocal);
    else
      add_difference(seconds(odometry), odometry.odometry.asTPose());
  }

  /// The mean velocity since the last pose is that of the middle of the interval, except for terms
  /// of second order.
  void add_difference(double time, const TPose2D& pose) {
    if (last_pose_ && time > last_time_) {
      const double dt = time - last_time_;
      const TPose2D step = pose - *last_pose_;
      add_velocity(log_.odometry, 0.5 * (time + last_time_),
                   {step.x / dt, step.y / dt, mrpt::math::wrapToPi(step.phi) / dt});
    }
    last_pose_ = pose;
    last_time_ = time;
  }

  static void add_velocity(std::vector<LoggedVelocity>& velocities, double time,
                           const TTwist2D& velocity) {
    if (std::isfinite(velocity.vx) && std::isfinite(velocity.omega))
      velocities.push_back({time, velocity.vx, velocity.omega});
  }

  double seconds(const CObservation& observation) {
    const double time = mrpt::Clock::toDouble(observation.timestamp);
    if (!first_) first_ = time;
    return time - *first_;
  }

  MotionLog log_;
  std::optional<double> first_;  ///< s
  std::optional<TPose2D> last_pose_;
  double last_time_ = 0;
};

}  // namespace

MotionLog read_motion_log(const LogObjects& log, const MotionLabels& labels) {
  MotionLogReader reader(labels);
  for (const auto& object : log.objects) reader.add(object);
  return std::move(reader).log();
}

MotionLog read_motion_log(const std::string& path, const MotionLabels& labels) {
  return read_motion_log(load_log(path), labels);
}

}  // namespace slalom
