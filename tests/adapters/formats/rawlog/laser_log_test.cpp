// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_runs.h"

#include <slalom/rawlog/laser_log.h>

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <error_text.h>
#include <map>

namespace slalom {
namespace {

using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;

const std::string kDatasets = "/usr/share/mrpt/datasets/";

class LaserLog : public testing::RecordedRunTest {
 protected:
  static mrpt::Clock::time_point at(double seconds) {
    return mrpt::Clock::fromDouble(1e9 + seconds);
  }

  static CObservation2DRangeScan::Ptr scan(double time, const std::string& label) {
    auto scan = CObservation2DRangeScan::Create();
    scan->resizeScanAndAssign(5, 2.0F, true);
    scan->timestamp = at(time);
    scan->sensorLabel = label;
    return scan;
  }
  static CObservationOdometry::Ptr odometry(double time, double x, double phi) {
    auto odometry = CObservationOdometry::Create();
    odometry->timestamp = at(time);
    odometry->odometry = mrpt::poses::CPose2D(x, 0, phi);
    return odometry;
  }
};

TEST_F(LaserLog, ReadsObservationsInOrderWithTheLatestOdometry) {
  mrpt::obs::CRawlog log;
  log.insert(scan(0, "front"));
  log.insert(odometry(0.5, 1, 0));
  log.insert(scan(1, "front"));
  log.insert(odometry(1.5, 3, 0.2));  // 2 m and 0.2 rad in 1 s
  log.insert(scan(2, "rear"));
  ASSERT_TRUE(log.saveToRawLogFile(path("log.rawlog")));
  const auto scans = read_laser_log(path("log.rawlog"));
  ASSERT_EQ(scans.size(), 3U);
  EXPECT_FALSE(scans[0].odometry.has_value());
  EXPECT_NEAR(scans[1].time, 1, 1e-6);
  EXPECT_EQ(scans[1].odometry->x, 1);
  EXPECT_FALSE(scans[1].velocity.has_value());
  EXPECT_NEAR(scans[2].velocity->vx, 2, 1e-6);
  EXPECT_NEAR(scans[2].velocity->omega, 0.2, 1e-6);
  EXPECT_EQ(read_laser_log(path("log.rawlog"), "rear").size(), 1U);
  EXPECT_TRUE(throws_error(ErrorKind::File, path("log.rawlog"), {"no 2D scan", "'left'"},
                           [&] { read_laser_log(path("log.rawlog"), "left"); }));
}

TEST_F(LaserLog, AccumulatesActions) {
  mrpt::obs::CRawlog log;
  for (int i = 0; i < 3; ++i) {
    mrpt::obs::CActionRobotMovement2D movement;
    movement.computeFromOdometry(mrpt::poses::CPose2D(0.5, 0, 0), {});
    mrpt::obs::CActionCollection actions;
    actions.insert(movement);
    log.insert(actions);
    mrpt::obs::CSensoryFrame frame;
    frame.insert(scan(i, "front"));
    log.insert(frame);
  }
  ASSERT_TRUE(log.saveToRawLogFile(path("log.rawlog")));
  const auto scans = read_laser_log(path("log.rawlog"));
  ASSERT_EQ(scans.size(), 3U);
  EXPECT_NEAR(scans[2].odometry->x, 1.5, 1e-9);
  EXPECT_NEAR(scans[2].velocity->vx, 0.5, 1e-6);  // 0.5 m between scans 1 s apart
}

TEST_F(LaserLog, ReadsLogsOfMrpt) {
  const std::map<std::string, std::size_t> logs = {
      {"localization_demo.rawlog", 37},
      {"2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog", 225}};
  for (const auto& [name, frames] : logs) {
    const auto scans = read_laser_log(kDatasets + name);
    // One scan in each sensory frame: every second of 74 and of 449 objects.
    EXPECT_EQ(scans.size(), frames) << name;
    EXPECT_TRUE(scans.back().odometry.has_value()) << name;
    for (const LoggedScan& logged : scans) ASSERT_GT(logged.scan->getScanSize(), 100U) << name;
  }
}

TEST_F(LaserLog, ReadsRecordedRuns) {
  auto method = testing::constant_method(0.4, 0);
  const auto simulated = testing::simulate_run(path("run.rawlog"), method, {});
  const auto scans = read_laser_log(path("run.rawlog"));
  ASSERT_EQ(scans.size(), simulated.cycles.size());
  // A cycle has its scan before its odometry, and the command, which is not odometry, after it: the
  // robot accelerates to the 0.4 m/s that it is commanded from the beginning.
  EXPECT_FALSE(scans[0].velocity);
  for (std::size_t cycle : {1U, 2U, 3U}) {
    ASSERT_TRUE(scans[cycle].velocity);
    EXPECT_EQ(scans[cycle].velocity->vx, simulated.cycles[cycle - 1].observation.v) << cycle;
    EXPECT_LT(scans[cycle].velocity->vx, 0.4);
  }
}

TEST_F(LaserLog, RejectsALogWithoutScans) {
  const std::string log = kDatasets + "RO-SLAM_demo.rawlog";
  EXPECT_TRUE(throws_error(ErrorKind::File, log, {"no 2D scan"}, [&] { read_laser_log(log); }));
}

}  // namespace
}  // namespace slalom
