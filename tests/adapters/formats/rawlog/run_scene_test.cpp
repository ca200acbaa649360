// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/rawlog/run_scene.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

/// Two cycles with scans of three rays of 2 m over 180 degrees, and a final sample.
RecordedRun short_run() {
  auto scan = std::make_shared<mrpt::obs::CObservation2DRangeScan>();
  scan->aperture = static_cast<float>(M_PI);
  scan->resizeScanAndAssign(3, 2, true);
  RecordedRun run;
  for (int i = 0; i < 3; ++i) {
    Sample sample;
    sample.pose = {1.0 + i, 5, M_PI / 2};
    run.trajectory.samples.push_back(sample);
    if (i == 2) continue;
    run.cycles.emplace_back();
    run.cycles.back().scan = scan;
  }
  return run;
}

TEST(RunScene, ScansEndWhereTheRaysDo) {
  const Path ends = scan_ends(short_run(), 1);
  ASSERT_EQ(ends.size(), 3U);
  EXPECT_NEAR(ends[0].x, 4, 1e-6);  // to the right of a robot that looks up
  EXPECT_NEAR(ends[0].y, 5, 1e-6);
  EXPECT_NEAR(ends[1].y, 7, 1e-6);
  EXPECT_NEAR(ends[2].x, 0, 1e-6);
}

TEST(RunScene, HasRaysTrailOutlineAndHeading) {
  RobotModel robot;
  robot.radius = 0.3;
  const SceneOptions scene = scene_at(short_run(), 1, robot, 100);
  EXPECT_EQ(scene.max_pixels, 100);
  ASSERT_EQ(scene.trajectories.size(), 6U);
  EXPECT_EQ(scene.trajectories[3].path.size(), 2U);  // the trail up to this sample
  const Path& outline = scene.trajectories[4].path;
  EXPECT_EQ(outline.front(), outline.back());
  for (const auto& corner : outline) EXPECT_NEAR(std::hypot(corner.x - 2, corner.y - 5), 0.3, 1e-9);
  EXPECT_NEAR(scene.trajectories[5].path.back().y, 5.3, 1e-9);
  EXPECT_EQ(scene_at(short_run(), 2, robot, 100).trajectories.size(), 3U);  // without a scan
}

TEST(RunScene, DrawsPolygons) {
  RobotModel robot;
  robot.footprint = "0.4,0.2; -0.4,0.2; -0.4,-0.2; 0.4,-0.2";
  EXPECT_EQ(scene_at(short_run(), 0, robot, 100).trajectories[4].path.size(), 5U);
}

}  // namespace
}  // namespace slalom
