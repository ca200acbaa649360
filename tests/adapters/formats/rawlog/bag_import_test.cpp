// SPDX-License-Identifier: BSD-3-Clause
#include "message_bytes.h"
#include "recorded_runs.h"

#include <slalom/rawlog/identification.h>
#include <slalom/rawlog/laser_log.h>
#include <slalom/rawlog/motion_log.h>
#include <slalom/rawlog/open_loop.h>

#include <mrpt/obs/CObservationOdometry.h>

#include <cmath>
#include <error_text.h>
#include <limits>

namespace slalom {
namespace {

using testing::kSecond;
using testing::Layout;
using testing::McapWriter;
using testing::pose_numbers;

constexpr Layout kCdr = Layout::CdrLittle;

class BagImport : public testing::RecordedRunTest {
 protected:
  void add_scan(std::int64_t stamp, const std::vector<float>& ranges, float angle_min = -1,
                float increment = 1, const std::string& topic = "/scan") {
    add(topic, "sensor_msgs/LaserScan", stamp,
        testing::scan_bytes(kCdr, stamp, "laser", angle_min, increment, 10, ranges));
  }
  void add_odometry(std::int64_t stamp, const std::vector<double>& pose, double v = 0, double w = 0,
                    const std::string& child = "base_link") {
    add("/odom", "nav_msgs/Odometry", stamp,
        testing::odometry_bytes(kCdr, stamp, child, pose, v, w));
  }
  void add_command(std::int64_t time, double v, double w, const std::string& topic = "/cmd_vel") {
    add(topic, "geometry_msgs/Twist", time, testing::twist_bytes(kCdr, v, w));
  }
  void add_frame(const std::string& parent, const std::string& child,
                 const std::vector<double>& pose, std::int64_t stamp = kSecond,
                 const std::string& topic = "/tf_static") {
    add(topic, "tf2_msgs/TFMessage", stamp,
        testing::transform_bytes(kCdr, stamp, parent, child, pose));
  }
  /// Recorded `delay` after the stamp.
  void add(const std::string& topic, const std::string& type, std::int64_t time,
           const std::string& data) {
    writer_.add({topic, type, time + delay_, data});
  }

  LogObjects import(const BagSelection& selection = {}) {
    testing::write_bytes(path("a.mcap"), writer_.bytes());
    return import_bag(path("a.mcap"), selection);
  }
  ::testing::AssertionResult refuses(std::initializer_list<std::string> words,
                                     const BagSelection& selection = {}) {
    return throws_error(ErrorKind::File, path("a.mcap"), words, [&] { import(selection); });
  }
  static bool has_note(const LogObjects& log, std::initializer_list<std::string> words) {
    for (const std::string& note : log.notes)
      if (mentions(note, words)) return true;
    return false;
  }

  McapWriter writer_;
  std::int64_t delay_ = 0;  // ns
};

TEST_F(BagImport, AScanHasItsPointsWhereTheRobotSeesThem) {
  add_frame("base_link", "laser", pose_numbers(0.5, 0, M_PI / 2));
  add_scan(kSecond, {1, 2, 3}, 0, float(M_PI / 2));  // ahead, left and behind of the laser
  const LogObjects log = import();
  const auto points = scan_points(*read_laser_log(log)[0].scan);
  ASSERT_EQ(points.size(), 3U);
  const std::vector<std::pair<double, double>> expected = {{0.5, 1}, {-1.5, 0}, {0.5, -3}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(points[i].x, expected[i].first, 1e-5) << i;
    EXPECT_NEAR(points[i].y, expected[i].second, 1e-5) << i;
  }
  EXPECT_TRUE(has_note(log, {"laser", "(0.500, 0.000", "yaw 1.571", "base_link"}));
}

TEST_F(BagImport, ALaserThatIsUpsideDownOrTurnsClockwiseIsNotMirrored) {
  add_frame("base_link", "laser", {0, 0, 0, 1, 0, 0, 0});  // half a turn about x
  add_scan(kSecond, {1, 2, 3});                            // at -1, 0, 1 rad: to the right first
  auto points = scan_points(*read_laser_log(import())[0].scan);
  EXPECT_NEAR(points[0].y, std::sin(1), 1e-5);  // upside down: at the left
  EXPECT_NEAR(points[2].y, 3 * std::sin(-1), 1e-5);
  writer_ = McapWriter();
  add_scan(kSecond, {1, 2, 3}, 1, -1);
  points = scan_points(*read_laser_log(import())[0].scan);
  EXPECT_NEAR(points[0].y, std::sin(1), 1e-5);
  EXPECT_NEAR(points[2].y, 3 * std::sin(-1), 1e-5);
}

TEST_F(BagImport, RangesThatAreNoReturnAreLeftOut) {
  const float inf = std::numeric_limits<float>::infinity();
  add_scan(kSecond, {1, inf, -inf, NAN, 0, 0.01F, -1, 11, 2}, -1, 0.25F);  // valid: 0.05 to 10 m
  const auto points = scan_points(*read_laser_log(import())[0].scan);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(std::hypot(points[0].x, points[0].y), 1, 1e-5);
  EXPECT_NEAR(std::hypot(points[1].x, points[1].y), 2, 1e-5);
  EXPECT_NEAR(std::atan2(points[1].y, points[1].x), 1, 1e-5);
}

TEST_F(BagImport, AScanOfMoreThanATurnIsRefused) {
  add_scan(kSecond, std::vector<float>(10, 1), 0, 1);
  EXPECT_TRUE(refuses({"byte", "9 rad", "a turn"}));
}

TEST_F(BagImport, ObservationsAreInTheOrderOfTheirStamps) {
  delay_ = 20'000'000;
  add_scan(3 * kSecond, {1, 1});
  add_odometry(2 * kSecond, pose_numbers(2, 0, 0), 1);
  add_scan(2 * kSecond, {2, 2});
  add_odometry(3 * kSecond, pose_numbers(3, 0, 0), 1);
  const auto scans = read_laser_log(import());
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scans[0].odometry->x, 2);
  EXPECT_EQ(scans[1].odometry->x, 3);
  EXPECT_NEAR(scans[1].time, 1, 1e-6);
  EXPECT_EQ(scans[1].velocity->vx, 1);
}

TEST_F(BagImport, CommandsWithoutStampsAreOnTheClockOfTheOthers) {
  delay_ = 1'700'000'000 * kSecond;  // simulated time
  for (int i = 0; i < 5; ++i) add_odometry((900 + i) * kSecond, pose_numbers(i, 0, 0), 1);
  add_command(902 * kSecond + kSecond / 2, 0.5, 0.25);
  const LogObjects log = import();
  const auto motion = read_motion_log(log);
  ASSERT_EQ(motion.commands.size(), 1U);
  EXPECT_NEAR(motion.commands[0].time, 2.5, 1e-6);
  EXPECT_EQ(motion.commands[0].v, 0.5);
  EXPECT_EQ(motion.commands[0].w, 0.25);
  EXPECT_TRUE(has_note(log, {"commands", "no stamps", "clock"}));
}

TEST_F(BagImport, WithoutOdometryTheTransformFromOdomIsUsed) {
  for (int i = 0; i < 4; ++i)
    add_frame("odom", "base_footprint", pose_numbers(2 * i, 0, 0), i * kSecond, "/tf");
  add_frame("base_footprint", "base_link", pose_numbers(0, 0, 0));
  add_scan(3 * kSecond, {1, 1});
  const LogObjects log = import();
  const auto scans = read_laser_log(log);
  EXPECT_EQ(scans[0].odometry->x, 6);
  EXPECT_NEAR(scans[0].velocity->vx, 2, 1e-9);
  EXPECT_TRUE(has_note(log, {"transform from 'odom' to 'base_footprint'"}));
}

TEST_F(BagImport, OdometryIsThatOfTheRobotsCenter) {
  add_frame("imu", "base_link", pose_numbers(1, 0, M_PI / 2));
  add_odometry(kSecond, pose_numbers(5, 5, M_PI / 2), 2, 3, "imu");
  const auto log = read_motion_log(import());
  const auto odometry =
      std::dynamic_pointer_cast<mrpt::obs::CObservationOdometry>(import().objects.front());
  EXPECT_NEAR(odometry->odometry.x(), 5, 1e-9);
  EXPECT_NEAR(odometry->odometry.y(), 6, 1e-9);  // 1 m ahead, which is y
  EXPECT_NEAR(std::abs(odometry->odometry.phi()), M_PI, 1e-9);
  // (2, 0) m/s plus 3 rad/s at (1, 0) m is (2, 3) m/s; seen from a frame turned by 90 degrees.
  EXPECT_NEAR(odometry->velocityLocal.vx, 3, 1e-9);
  EXPECT_NEAR(odometry->velocityLocal.vy, -2, 1e-9);
}

TEST_F(BagImport, TwistsThatAreNeverFilledAreNotVelocities) {
  for (int i = 0; i < 3; ++i) add_odometry(i * kSecond, pose_numbers(0.5 * i, 0, 0));
  const LogObjects log = import();
  const auto motion = read_motion_log(log);
  ASSERT_EQ(motion.odometry.size(), 2U);
  EXPECT_NEAR(motion.odometry[0].v, 0.5, 1e-9);
  EXPECT_TRUE(has_note(log, {"twists of '/odom' are zero"}));
}

TEST_F(BagImport, ALaserWithoutATransformIsNamed) {
  add_scan(kSecond, {1, 1});
  EXPECT_TRUE(has_note(import(), {"laser 'laser'", "no transform from 'base_link'", "center"}));
  const LogObjects centered = import({"", "", "", "laser"});
  EXPECT_EQ(centered.notes, std::vector<std::string>{"1 scan of '/scan', 0 poses, 0 commands"});
}

TEST_F(BagImport, SeveralTopicsOfATypeAreListed) {
  add_scan(kSecond, {1, 1});
  add_scan(kSecond, {1, 1, 1}, -1, 1, "/scan_rear");
  EXPECT_TRUE(refuses({"/scan, /scan_rear", "--scan"}));
  const auto scans = read_laser_log(import({"/scan_rear", "", "", ""}), "/scan_rear");
  ASSERT_EQ(scans.size(), 1U);
  EXPECT_EQ(scans[0].scan->getScanSize(), 3U);
  add_command(kSecond, 0, 0);
  add_command(kSecond, 0, 0, "/cmd_vel_nav");
  EXPECT_TRUE(refuses({"/cmd_vel, /cmd_vel_nav", "--command"}, {"/scan", "", "", ""}));
}

TEST_F(BagImport, TopicsAndFramesThatAreMissingAreRefused) {
  add_scan(kSecond, {1, 1});
  add_command(kSecond, 0, 0);
  EXPECT_TRUE(refuses({"no topic '/scam'", "'/scan'"}, {"/scam", "", "", ""}));
  EXPECT_TRUE(refuses({"'/cmd_vel' is of type geometry_msgs/Twist", "sensor_msgs/LaserScan"},
                      {"/cmd_vel", "", "", ""}));
  EXPECT_TRUE(refuses({"no topic '/odom'", "nav_msgs/Odometry"}, {"", "/odom", "", ""}));
  EXPECT_TRUE(refuses({"no frame 'base'", "transforms"}, {"", "", "", "base"}));
  add_frame("base_link", "laser", pose_numbers(0, 0, 0));
  EXPECT_TRUE(refuses({"no frame 'lasr'", "'laser'"}, {"", "", "", "lasr"}));
  writer_ = McapWriter();
  add("/image", "sensor_msgs/Image", 0, "");
  EXPECT_TRUE(refuses({"no message that can be used", "sensor_msgs/LaserScan"}));
}

TEST_F(BagImport, ARawlogOfItIsTheSameLog) {
  add_frame("base_link", "laser", pose_numbers(0.25, 0.5, 1));
  for (int i = 0; i < 10; ++i) {
    add_odometry(i * kSecond, pose_numbers(i, 0, 0), 1, 0.5);
    add_scan(i * kSecond + 1, {1, 2, NAN});
    add_command(i * kSecond, 0.5, 0);
  }
  const LogObjects log = import();
  write_rawlog(log, path("a.rawlog"));
  const LogObjects read = load_log(path("a.rawlog"));
  ASSERT_EQ(read.objects.size(), 30U);
  const auto a = read_laser_log(log), b = read_laser_log(read);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].time, b[i].time);
    EXPECT_EQ(a[i].odometry->x, b[i].odometry->x);
    EXPECT_EQ(scan_points(*a[i].scan).size(), 2U);
    EXPECT_EQ(scan_points(*a[i].scan)[1].x, scan_points(*b[i].scan)[1].x);
  }
  EXPECT_TRUE(throws_error(ErrorKind::Usage, path("a.rawlog"), {"not a bag", "--scan"}, [&] {
    load_log(path("a.rawlog"), {"/scan", "", "", ""});
  }));
}

/// A robot that follows its commands after 0.2 s exactly.
TEST_F(BagImport, TheDelayOfARobotIsIdentified) {
  std::vector<std::pair<std::int64_t, double>> commands;
  for (int i = 0; i < 60; ++i) commands.emplace_back(i * kSecond, 0.1 * (7 * i % 6));
  for (const auto& [time, v] : commands) add_command(time, v, 0.05 * double(time / kSecond % 7));
  for (std::int64_t time = 0; time < 60 * kSecond; time += kSecond / 50) {
    const std::int64_t in_force = (time - kSecond / 5) / kSecond;
    const bool moves = time >= kSecond / 5;
    add_odometry(time, pose_numbers(0, 0, 0), moves ? commands[std::size_t(in_force)].second : 0,
                 moves ? 0.05 * double(in_force % 7) : 0);
  }
  const auto found = identify(read_motion_log(import()), {});
  EXPECT_NEAR(found.at("delay").value.number(), 0.2, 0.021);  // odometry each 0.02 s
}

}  // namespace
}  // namespace slalom
