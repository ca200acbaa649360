// SPDX-License-Identifier: BSD-3-Clause
#include "message_bytes.h"

#include <slalom/bags/ros_messages.h>

#include <gtest/gtest.h>

#include <cmath>
#include <error_text.h>

namespace slalom {
namespace {

using testing::ByteList;
using testing::Layout;

constexpr std::array<Layout, 3> kLayouts = {Layout::Packed, Layout::CdrLittle, Layout::CdrBig};

/// Decodes `bytes` of a topic of `type`.
template <typename Decode>
auto decode(const Decode& function, const std::string& type, Layout layout,
            const std::string& bytes) {
  const BagTopic topic{"/topic", type, layout == Layout::Packed ? "ros1" : "cdr"};
  const BagPlace place{"a.bag", "byte", 17};
  return function(BagMessage{topic, 0, bytes, place});
}

/// A PoseStamped at 1.000000002 s in frame "ab" at x = 1, with qw = 1. CDR (OMG formal/2002-06-51,
/// section 15.3; RTPS, formal/2019-04-03, section 10.2): the text has its zero, and the double is
/// at a multiple of 8 after the four bytes of the representation. ROS 1: the number of the header
/// first.
TEST(RosMessages, AreDecodedFromTheBytesOfTheSpecifications) {
  const std::string zero(8, '\0'), one_little("\0\0\0\0\0\0\xf0\x3f", 8),
      one_big("\x3f\xf0\0\0\0\0\0\0", 8);
  const std::string little = std::string(
                                 "\0\1\0\0"
                                 "\1\0\0\0"
                                 "\2\0\0\0"
                                 "\3\0\0\0ab\0\0",
                                 20) +
                             one_little + zero + zero + zero + zero + zero + one_little;
  const std::string big = std::string(
                              "\0\0\0\0"
                              "\0\0\0\1"
                              "\0\0\0\2"
                              "\0\0\0\3"
                              "ab\0\0",
                              20) +
                          one_big + zero + zero + zero + zero + zero + one_big;
  const std::string ros1 = std::string(
                               "\7\0\0\0"
                               "\1\0\0\0"
                               "\2\0\0\0"
                               "\2\0\0\0"
                               "ab",
                               18) +
                           one_little + zero + zero + zero + zero + zero + one_little;
  for (const auto& [layout, bytes] :
       {std::pair{Layout::CdrLittle, little}, {Layout::CdrBig, big}, {Layout::Packed, ros1}}) {
    const auto pose = decode(decode_pose, "geometry_msgs/PoseStamped", layout, bytes);
    EXPECT_EQ(pose.header.stamp, 1'000'000'002);
    EXPECT_EQ(pose.header.frame, "ab");
    EXPECT_EQ(pose.pose.x, 1);
    EXPECT_EQ(pose.pose.y, 0);
    EXPECT_EQ(pose.pose.qw, 1);
    EXPECT_TRUE(pose.pose.is_valid());
  }
}

TEST(RosMessages, ScansOdometryAndCommandsAreTheSameInEachEncoding) {
  for (const Layout layout : kLayouts)
    for (const std::string frame : {"laser", "lasers", "a_laser"}) {  // any alignment
      const auto scan = decode(decode_scan, "sensor_msgs/LaserScan", layout,
                               testing::scan_bytes(layout, 5, frame, -1.5F, 0.5F, 8, {1, 2, 3}));
      EXPECT_EQ(scan.header.frame, frame);
      EXPECT_EQ(scan.angle_min, -1.5);
      EXPECT_EQ(scan.angle_increment, 0.5);
      EXPECT_EQ(scan.range_min, double(0.05F));
      EXPECT_EQ(scan.range_max, 8);
      EXPECT_EQ(scan.ranges, (std::vector<float>{1, 2, 3}));
      const auto odometry =
          decode(decode_odometry, "nav_msgs/Odometry", layout,
                 testing::odometry_bytes(layout, 6, frame, testing::pose_numbers(3, 4, 0.5), 7, 8));
      EXPECT_EQ(odometry.header.stamp, 6);
      EXPECT_EQ(odometry.child_frame, frame);
      EXPECT_EQ(odometry.pose.y, 4);
      EXPECT_NEAR(odometry.pose.yaw(), 0.5, 1e-15);
      EXPECT_EQ(odometry.twist.vx, 7);
      EXPECT_EQ(odometry.twist.wz, 8);
      const auto transforms = decode(decode_transforms, "tf2_msgs/TFMessage", layout,
                                     testing::transform_bytes(layout, 7, "/base", "/" + frame,
                                                              testing::pose_numbers(1, 2, 3)));
      ASSERT_EQ(transforms.size(), 1U);
      EXPECT_EQ(transforms[0].header.frame, "base");  // tf of ROS 1 wrote a slash
      EXPECT_EQ(transforms[0].child_frame, frame);
      EXPECT_EQ(transforms[0].pose.y, 2);
      const auto stamped =
          decode(decode_twist, "geometry_msgs/TwistStamped", layout,
                 ByteList(layout).header(9, frame).doubles({1, 2, 3, 4, 5, 6}).bytes());
      EXPECT_EQ(stamped.header->stamp, 9);
      EXPECT_EQ(stamped.vx, 1);
      EXPECT_EQ(stamped.vy, 2);
      EXPECT_EQ(stamped.wz, 6);
    }
  const auto twist = decode(decode_twist, "geometry_msgs/Twist", Layout::CdrLittle,
                            testing::twist_bytes(Layout::CdrLittle, 0.5, -1));
  EXPECT_FALSE(twist.header);
  EXPECT_EQ(twist.wz, -1);
}

TEST(RosMessages, GridsAndPathsAreTheSameInEachEncoding) {
  for (const Layout layout : kLayouts) {
    const auto pose = testing::pose_numbers(1, 2, 0);
    ByteList bytes(layout);
    bytes.header(3, "map").add(std::int32_t{1}).add(std::uint32_t{2});
    bytes.add(0.05F).add(std::uint32_t{3}).add(std::uint32_t{2}).doubles(pose);
    const std::string head = bytes.bytes();
    bytes.add(std::uint32_t{6}).raw(std::string("\xff\0\x64\0\0\0", 6));
    const auto grid = decode(decode_grid, "nav_msgs/OccupancyGrid", layout, bytes.bytes());
    EXPECT_EQ(grid.width, 3U);
    EXPECT_EQ(grid.height, 2U);
    EXPECT_EQ(grid.resolution, double(0.05F));
    EXPECT_EQ(grid.origin.y, 2);
    EXPECT_EQ(grid.cells, (std::vector<std::int8_t>{-1, 0, 100, 0, 0, 0}));
    EXPECT_TRUE(throws_error(ErrorKind::File, "a.bag: byte 17", {"0 cells", "3 x 2"}, [&] {
      decode(decode_grid, "nav_msgs/OccupancyGrid", layout, head + std::string(4, '\0'));
    }));
    ByteList path(layout);
    path.header(3, "map").add(std::uint32_t{2});
    for (int i = 0; i < 2; ++i) path.header(i, "map").doubles(testing::pose_numbers(i, 0, 0));
    const auto poses = decode(decode_path, "nav_msgs/Path", layout, path.bytes()).poses;
    ASSERT_EQ(poses.size(), 2U);
    EXPECT_EQ(poses[1].pose.x, 1);
  }
}

TEST(RosMessages, OfAnotherTypeOrEncodingAreRefused) {
  const std::string bytes = testing::twist_bytes(Layout::CdrLittle, 1, 1);
  EXPECT_TRUE(throws_error(ErrorKind::File, "a.bag: byte 17",
                           {"/topic", "a/b", "sensor_msgs/LaserScan"},
                           [&] { decode(decode_scan, "a/b", Layout::CdrLittle, bytes); }));
  const BagTopic topic{"/topic", "geometry_msgs/Twist", "json"};
  const BagPlace place{"a.bag", "byte", 17};
  EXPECT_TRUE(throws_error(ErrorKind::File, "a.bag: byte 17", {"json", "cdr"}, [&] {
    decode_twist({topic, 0, bytes, place});
  }));
  std::string other = bytes;
  other[1] = 7;  // XCDR2
  EXPECT_TRUE(throws_error(ErrorKind::File, "a.bag: byte 17", {"plain CDR"}, [&] {
    decode(decode_twist, "geometry_msgs/Twist", Layout::CdrLittle, other);
  }));
}

TEST(RosMessages, ThatAreCutAreRefused) {
  for (const Layout layout : kLayouts) {
    const std::string bytes = testing::scan_bytes(layout, 5, "laser", -1, 1, 8, {1, 2, 3});
    for (std::size_t size = 0; size < bytes.size() - 4; ++size)  // without the intensities
      EXPECT_TRUE(throws_error(ErrorKind::File, "a.bag: byte 17", {"expected"}, [&, n = size] {
        decode(decode_scan, "sensor_msgs/LaserScan", layout, bytes.substr(0, n));
      })) << size;
  }
}

TEST(RosMessages, PosesWithoutAQuaternionAreNotValid) {
  RosPose pose;
  EXPECT_TRUE(pose.is_valid());
  pose.qw = 0;
  EXPECT_FALSE(pose.is_valid());
  pose = {};
  pose.x = NAN;
  EXPECT_FALSE(pose.is_valid());
}

}  // namespace
}  // namespace slalom
