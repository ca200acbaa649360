// SPDX-License-Identifier: BSD-3-Clause
#include "manifest_reader.h"
#include "rawlog_format.h"
#include "rawlog_objects.h"

#include <slalom/core/error.h>
#include <slalom/core/pose.h>
#include <slalom/rawlog/run_reader.h>

#include <mrpt/math/wrap2pi.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <array>
#include <cmath>
#include <sstream>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationComment;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CObservationRobotPose;

RunManifest run_manifest(const ManifestReader& lines) {
  RunManifest manifest;
  if (lines.text(keys::kFormat) != kFormatVersion)
    throw lines.invalid(keys::kFormat, std::string("format version ") + kFormatVersion);
  manifest.campaign_ini = lines.text(keys::kCampaignIni);
  manifest.scenario_name = lines.text(keys::kScenarioName);
  manifest.scenario_hash = lines.text(keys::kScenarioHash);
  manifest.scenario_yaml = lines.text(keys::kScenarioYaml);
  manifest.method = lines.text(keys::kMethod);
  manifest.repetition = lines.integer<int>(keys::kRepetition);
  manifest.seed = lines.integer<std::uint64_t>(keys::kSeed);
  manifest.more =
      lines.without({keys::kFormat, keys::kCampaignIni, keys::kScenarioName, keys::kScenarioHash,
                     keys::kScenarioYaml, keys::kMethod, keys::kRepetition, keys::kSeed,
                     keys::kStart, keys::kGoal, keys::kGoalTolerance, keys::kGoalHeading,
                     keys::kControlPeriod, keys::kTaskSeed});
  return manifest;
}

NavigationTask task_of(const ManifestReader& lines) {
  NavigationTask task;
  const auto start = lines.numbers<3>(keys::kStart);
  const auto goal = lines.numbers<2>(keys::kGoal);
  task.start = {start[0], start[1], start[2]};
  task.goal = {goal[0], goal[1]};
  task.goal_tolerance = lines.number(keys::kGoalTolerance);
  if (lines.has(keys::kGoalHeading)) {
    const auto heading = lines.numbers<2>(keys::kGoalHeading);
    task.goal_heading = heading[0];
    task.goal_heading_tolerance = heading[1];
  }
  task.control_period = lines.number(keys::kControlPeriod);
  task.seed = lines.integer<std::uint64_t>(keys::kTaskSeed);
  return task;
}

Trajectory trajectory_of(const ManifestReader& lines) {
  Trajectory trajectory;
  std::istringstream rows(lines.text(keys::kTrajectory));
  for (std::string row; std::getline(rows, row);) {
    std::array<double, Sample::kNumbers> numbers{};
    if (!parse_numbers(row, numbers.size(), numbers.data()))
      throw lines.invalid(keys::kTrajectory, std::to_string(numbers.size()) + " numbers per line");
    trajectory.samples.push_back(Sample::from_numbers(numbers));
  }
  if (trajectory.hash() != lines.text(keys::kTrajectoryHash))
    throw lines.invalid(keys::kTrajectory, "a trajectory that matches its hash");
  return trajectory;
}

/// Reads the objects of a log in order and checks their class and label.
class RunLog {
 public:
  explicit RunLog(const std::string& path) : path_(path), objects_(read_objects(path)) {}

  std::size_t size() const { return objects_.size(); }

  template <typename Class>
  std::shared_ptr<const Class> next(const char* label) {
    return get<Class>(next_++, label);
  }

  /// Whether the object `ahead` of the next one has this class.
  template <typename Class>
  bool has(std::size_t ahead) const {
    const std::size_t index = next_ + ahead;
    return index < size() && std::dynamic_pointer_cast<const Class>(objects_[index]) != nullptr;
  }

  ManifestReader first_comment() {
    if (!has<CObservationComment>(0))
      throw file_error(
          path_, "was not recorded by Slalom",
          "a rawlog of [record]; slalom-replay openloop passes the scans of any log to "
          "a method, slalom-scenarios import makes a scenario of it");
    return comment(next_++);
  }
  ManifestReader last_comment() const { return comment(size() - 1); }

  /// An error at the last object.
  Error unexpected(const std::string& expected) const { return unexpected(next_ - 1, expected); }

 private:
  template <typename Class>
  std::shared_ptr<const Class> get(std::size_t index, const char* label) const {
    auto object =
        index < objects_.size() ? std::dynamic_pointer_cast<const Class>(objects_[index]) : nullptr;
    if (!object || (label != nullptr && object->sensorLabel != label))
      throw unexpected(index,
                       CLASS_ID(Class)->className +
                           (label == nullptr ? std::string() : std::string(" '") + label + "'"));
    return object;
  }

  ManifestReader comment(std::size_t index) const {
    return {manifest_from_text(get<CObservationComment>(index, nullptr)->text, path_), path_};
  }

  Error unexpected(std::size_t index, const std::string& expected) const {
    return file_error(path_ + ": object " + std::to_string(index + 1), "unexpected object",
                      expected);
  }

  std::string path_;
  std::vector<mrpt::serialization::CSerializable::Ptr> objects_;
  std::size_t next_ = 0;
};

void check_ground_truth(const RunLog& log, const CObservationRobotPose& truth,
                        const Sample& sample) {
  constexpr double kTolerance = 1e-6;  // m, rad; MRPT stores the orientation as a quaternion
  const auto& pose = truth.pose.mean;
  const bool matches = std::abs(pose.x() - sample.pose.x) < kTolerance &&
                       std::abs(pose.y() - sample.pose.y) < kTolerance &&
                       std::abs(mrpt::math::wrapToPi(pose.yaw() - sample.pose.phi)) < kTolerance;
  if (!matches || truth.timestamp != logged_time(sample.t))
    throw log.unexpected("the pose and time of the trajectory");
}

bool is_finite(const CObservationOdometry& odometry) {
  const auto& pose = odometry.odometry;
  const auto& velocity = odometry.velocityLocal;
  return odometry.hasVelocities && std::isfinite(pose.x()) && std::isfinite(pose.y()) &&
         std::isfinite(pose.phi()) && std::isfinite(velocity.vx) && std::isfinite(velocity.vy) &&
         std::isfinite(velocity.omega);
}

/// The next scan; `first` is that of the same laser in the first cycle, null in the first one.
std::shared_ptr<const CObservation2DRangeScan> next_scan(RunLog& log,
                                                         const CObservation2DRangeScan* first) {
  auto scan = log.next<CObservation2DRangeScan>(nullptr);
  const std::size_t rays = scan->getScanSize();
  if (rays < 2 || (first != nullptr && first->getScanSize() != rays))
    throw log.unexpected("a scan with the same number of rays as the others");
  for (std::size_t i = 0; i < rays; ++i)
    if (!std::isfinite(scan->getScanRange(i))) throw log.unexpected("a scan with finite ranges");
  return scan;
}

std::shared_ptr<const CObservationOdometry> next_odometry(RunLog& log, const char* label) {
  auto odometry = log.next<CObservationOdometry>(label);
  if (!is_finite(*odometry)) throw log.unexpected("finite numbers");
  return odometry;
}

RecordedCycle next_cycle(RunLog& log, const RecordedRun& run, std::size_t lasers,
                         const TPoint2D& goal) {
  const Sample& sample = run.trajectory.samples[run.cycles.size()];
  RecordedCycle cycle;
  const RecordedCycle* first = run.cycles.empty() ? nullptr : &run.cycles.front();
  cycle.scan = next_scan(log, first == nullptr ? nullptr : first->scan.get());
  for (std::size_t i = 0; i < lasers; ++i)
    cycle.lasers.push_back(next_scan(log, first == nullptr ? nullptr : first->lasers[i].get()));
  const auto odometry = next_odometry(log, kOdometryLabel);
  cycle.stamp = odometry->timestamp;
  const auto& pose = odometry->odometry;
  const auto& velocity = odometry->velocityLocal;
  const TPose2D odometry_pose(pose.x(), pose.y(), pose.phi());
  cycle.observation = {sample.t,        odometry_pose, velocity.vx,
                       velocity.omega,  velocity.vy,   inverse_compose(odometry_pose, goal),
                       cycle.scan.get()};
  for (const auto& scan : cycle.lasers) cycle.observation.lasers.push_back(scan.get());
  check_ground_truth(log, *log.next<CObservationRobotPose>(kTruthLabel), sample);
  const auto command = next_odometry(log, kCommandLabel)->velocityLocal;
  cycle.command = {command.vx, command.omega, command.vy};
  if (command.vx != sample.command_v || command.omega != sample.command_w ||
      command.vy != sample.command_vy)
    throw log.unexpected("the command of the trajectory");
  return cycle;
}

Outcome outcome_of(const ManifestReader& lines) {
  if (const auto outcome = from_name<Outcome>(lines.text(keys::kOutcome))) return *outcome;
  throw lines.invalid(keys::kOutcome, "success, collision, timeout, ...");
}

/// The number of scans after the first one of a cycle.
std::size_t count_lasers(const RunLog& log) {
  std::size_t scans = 0;
  while (log.has<CObservation2DRangeScan>(scans)) ++scans;
  return scans == 0 ? 0 : scans - 1;
}

/// The number of cycles in a log: four objects each and the scans of the lasers, between the
/// manifest and the last ground-truth pose with the result.
std::size_t count_cycles(const RunLog& log, const RecordedRun& run, std::size_t lasers,
                         const std::string& path) {
  const std::size_t samples = run.trajectory.samples.size();
  const std::size_t others = samples == 0 ? 2 : 3;
  const std::size_t objects = 4 + lasers;
  const std::size_t cycles = log.size() < others ? 0 : (log.size() - others) / objects;
  const bool complete = log.size() == others + objects * cycles;
  if (!complete || cycles > samples || samples > cycles + 1 || (cycles > 0 && !run.task))
    throw file_error(path, "has missing or extra objects", "a run recorded by Slalom");
  return cycles;
}

}  // namespace

RecordedRun read_run(const std::string& path) {
  RunLog log(path);
  RecordedRun run;
  const ManifestReader manifest = log.first_comment();
  run.manifest = run_manifest(manifest);
  if (manifest.has(keys::kStart)) run.task = task_of(manifest);
  const ManifestReader result = log.last_comment();
  run.trajectory = trajectory_of(result);
  run.detail = result.text(keys::kDetail);
  run.outcome = outcome_of(result);
  const std::size_t lasers = count_lasers(log), cycles = count_cycles(log, run, lasers, path);
  while (run.cycles.size() < cycles)
    run.cycles.push_back(next_cycle(log, run, lasers, run.task->goal));
  if (!run.trajectory.samples.empty())
    check_ground_truth(log, *log.next<CObservationRobotPose>(kTruthLabel),
                       run.trajectory.samples.back());
  return run;
}

}  // namespace slalom
