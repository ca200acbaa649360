// SPDX-License-Identifier: BSD-3-Clause
#include "gzip.h"
#include "manifest_text.h"
#include "rawlog_format.h"
#include "run_entries.h"

#include <slalom/core/text.h>
#include <slalom/core/version.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/rawlog/run_recorder.h>

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::Clock;
using mrpt::math::TPose2D;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationComment;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CObservationRobotPose;

/// Avoids CPose2D's constructor, which changes the last bits of an angle.
mrpt::poses::CPose2D exact_pose(const TPose2D& pose) {
  mrpt::poses::CPose2D exact;
  exact.x(pose.x);
  exact.y(pose.y);
  exact.phi(pose.phi);
  return exact;
}

std::string result_text(const SimulationResult& result) {
  Manifest lines = entries_of(result);
  std::string samples;
  for (const Sample& sample : result.trajectory.samples) {
    const auto numbers = sample.numbers();
    samples += format_numbers({numbers.begin(), numbers.end()}) + "\n";
  }
  lines[keys::kTrajectory] = samples;
  return manifest_to_text(lines);
}

class RawlogRecorder : public RunObserver {
 public:
  RawlogRecorder(std::string path, const RunManifest& manifest)
      : path_(std::move(path)), manifest_(entries_of(manifest)) {}

  void on_start(const NavigationTask& task) override {
    started_ = Clock::now();
    add_task(manifest_, task);
    write_comment(manifest_to_text(manifest_), 0);
    has_manifest_ = true;
  }

  void on_cycle(const Observation& observation, const Command& command,
                const TPose2D& pose) override {
    write_scan(*observation.scan);
    for (const CObservation2DRangeScan* scan : observation.lasers) write_scan(*scan);
    write_odometry(kOdometryLabel, observation.time, observation.odometry,
                   {observation.v, observation.vy, observation.w});
    write_ground_truth(observation.time, pose);
    write_odometry(kCommandLabel, observation.time, observation.odometry,
                   {command.v, command.vy, command.w});
  }

  void on_end(const SimulationResult& result) override {
    if (!has_manifest_) write_comment(manifest_to_text(manifest_), 0);
    const auto& samples = result.trajectory.samples;
    if (!samples.empty()) write_ground_truth(samples.back().t, samples.back().pose);
    write_comment(result_text(result), samples.empty() ? 0 : samples.back().t);
    write_file_atomically(path_, file_.finish());
  }

 private:
  void write_comment(const std::string& text, double time) {
    CObservationComment comment;
    comment.timestamp = logged_time(time);
    comment.text = text;
    write(comment);
  }

  void write_scan(CObservation2DRangeScan scan) {
    scan.timestamp = logged_start() + (scan.timestamp - started_);
    write(scan);
  }

  void write_odometry(const char* label, double time, const TPose2D& pose,
                      const mrpt::math::TTwist2D& velocity) {
    CObservationOdometry odometry;
    odometry.sensorLabel = label;
    odometry.timestamp = logged_time(time);
    odometry.odometry = exact_pose(pose);
    odometry.hasVelocities = true;
    odometry.velocityLocal = velocity;
    write(odometry);
  }

  void write_ground_truth(double time, const TPose2D& pose) {
    CObservationRobotPose truth;
    truth.sensorLabel = kTruthLabel;
    truth.timestamp = logged_time(time);
    truth.pose.mean = mrpt::poses::CPose3D(mrpt::poses::CPose2D(pose));
    write(truth);
  }

  void write(const mrpt::serialization::CSerializable& object) {
    mrpt::io::CMemoryStream bytes;
    mrpt::serialization::archiveFrom(bytes).WriteObject(&object);
    file_.write(bytes.getRawBufferData(), bytes.getTotalBytesCount());
  }

  std::string path_;
  Manifest manifest_;
  bool has_manifest_ = false;
  Clock::time_point started_;  ///< depends on previous runs in this process
  GzipWriter file_;
};

}  // namespace

RunManifest make_run_manifest(const std::string& campaign_ini, const Scenario& scenario,
                              const std::string& method, int repetition, std::uint64_t seed) {
  RunManifest manifest;
  manifest.campaign_ini = campaign_ini;
  manifest.scenario_name = scenario.name();
  manifest.scenario_hash = scenario.hash();
  manifest.scenario_yaml = scenario_to_yaml(scenario);
  manifest.method = method;
  manifest.repetition = repetition;
  manifest.seed = seed;
  manifest.more = {{"version.slalom", version()},
                   {"version.mrpt", mrpt_version()},
                   {"version.compiler", compiler_version()}};
  return manifest;
}

std::unique_ptr<RunObserver> make_rawlog_recorder(const std::string& path,
                                                  const RunManifest& manifest) {
  return std::make_unique<RawlogRecorder>(path, manifest);
}

}  // namespace slalom
