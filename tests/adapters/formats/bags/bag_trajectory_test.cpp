// SPDX-License-Identifier: BSD-3-Clause
#include "message_bytes.h"

#include <slalom/bags/bag_trajectory.h>

#include <gtest/gtest.h>

#include <cmath>
#include <error_text.h>
#include <temporary_folder.h>

namespace slalom {
namespace {

using testing::kSecond;
using testing::Layout;
using testing::pose_numbers;

constexpr Layout kCdr = Layout::CdrLittle;

class BagTrajectory : public ::testing::Test {
 protected:
  void add_odometry(double time, const std::vector<double>& pose, double v, double w) {
    const auto stamp = std::int64_t(1e9 * time);
    writer_.add({"/odom", "nav_msgs/Odometry", stamp + 5,
                 testing::odometry_bytes(kCdr, stamp, "base_link", pose, v, w)});
  }
  void add_pose(double time, const std::vector<double>& pose) {
    const auto stamp = std::int64_t(1e9 * time);
    writer_.add({"/amcl_pose", "geometry_msgs/PoseWithCovarianceStamped", stamp,
                 testing::ByteList(kCdr)
                     .header(stamp, "map")
                     .doubles(pose)
                     .doubles(std::vector<double>(36))
                     .bytes()});
  }
  void add_frame(double time, const std::string& parent, const std::string& child,
                 const std::vector<double>& pose) {
    const auto stamp = std::int64_t(1e9 * time);
    writer_.add({"/tf", "tf2_msgs/TFMessage", stamp,
                 testing::transform_bytes(kCdr, stamp, parent, child, pose)});
  }
  TrajectoryFile load(const std::string& topic = "") {
    testing::write_bytes(path_, writer_.bytes());
    return load_bag_trajectory(path_, topic, false);
  }
  ::testing::AssertionResult refuses(const std::string& topic,
                                     std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::File, path_, words, [&] { load(topic); });
  }

  TemporaryFolder folder_;
  const std::string path_ = folder_ / "a.mcap";
  testing::McapWriter writer_;
};

TEST_F(BagTrajectory, OfOdometryHasItsTwistsAndStamps) {
  for (int i = 3; i >= 0; --i) add_odometry(7 + 0.5 * i, pose_numbers(i, 1, 0.25), 2, 0.5);
  const TrajectoryFile file = load();
  ASSERT_EQ(file.trajectory.samples.size(), 4U);
  const Sample& last = file.trajectory.samples[3];
  EXPECT_EQ(last.t, 8.5);
  EXPECT_EQ(last.pose.x, 3);
  EXPECT_EQ(last.pose.y, 1);
  EXPECT_NEAR(last.pose.phi, 0.25, 1e-15);
  EXPECT_EQ(last.v, 2);
  EXPECT_EQ(last.w, 0.5);
  EXPECT_EQ(file.notes[0], "poses of '/odom' in frame 'odom'");
}

TEST_F(BagTrajectory, OfPosesHasTheirDifferencesAsVelocities) {
  for (int i = 0; i < 4; ++i) add_pose(i, pose_numbers(0.5 * i, 0, 0));
  add_pose(4, {0, 0, 0, 0, 0, 0, 0});  // no quaternion
  const TrajectoryFile file = load();
  ASSERT_EQ(file.trajectory.samples.size(), 4U);
  EXPECT_NEAR(file.trajectory.samples[2].v, 0.5, 1e-9);
  EXPECT_EQ(file.notes[1], "1 message without a pose left out");
}

TEST_F(BagTrajectory, OfFramesComposesTheTransformsBetweenThem) {
  add_frame(0, "base_footprint", "base_link", pose_numbers(0.5, 0, 0));
  add_frame(0, "map", "odom", pose_numbers(10, 0, M_PI / 2));
  for (int i = 0; i < 4; ++i) add_frame(1 + i, "odom", "base_footprint", pose_numbers(i, 0, 0));
  add_frame(3, "map", "odom", pose_numbers(20, 0, M_PI / 2));  // a correction
  const auto samples = load("/tf:map.base_link").trajectory.samples;
  ASSERT_EQ(samples.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(samples[i].t, 1 + double(i));
    EXPECT_NEAR(samples[i].pose.x, i < 2 ? 10 : 20, 1e-9) << i;
    EXPECT_NEAR(samples[i].pose.y, double(i) + 0.5, 1e-9) << i;
    EXPECT_NEAR(samples[i].pose.phi, M_PI / 2, 1e-9) << i;
  }
  EXPECT_TRUE(refuses("/tf:map.camera", {"no transforms from 'map' to 'camera'", "info"}));
  EXPECT_TRUE(refuses("/tf:map", {"no transforms", "FRAME.FRAME"}));
  EXPECT_TRUE(refuses("/tf:map.map", {"in itself"}));
  EXPECT_TRUE(refuses("", {"has no poses", "/tf:map.base_link"}));
}

TEST_F(BagTrajectory, SeveralTopicsWithPosesAreListed) {
  add_pose(0, pose_numbers(0, 0, 0));
  add_pose(1, pose_numbers(1, 0, 0));
  add_odometry(0, pose_numbers(5, 0, 0), 1, 0);
  add_odometry(1, pose_numbers(6, 0, 0), 1, 0);
  EXPECT_TRUE(refuses("", {"/amcl_pose, /odom", "--topic"}));
  EXPECT_EQ(load("/odom").trajectory.samples[0].pose.x, 5);
  EXPECT_TRUE(refuses("/odometry", {"no topic '/odometry'", "'/odom'"}));
}

}  // namespace
}  // namespace slalom
