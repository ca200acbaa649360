// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/bags/frame_tree.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slalom {
namespace {

RosTransform transform(const std::string& parent, const std::string& child, double x, double y,
                       double yaw) {
  RosTransform transform;
  transform.header.frame = parent;
  transform.child_frame = child;
  transform.pose = {x, y, 0, 0, 0, std::sin(yaw / 2), std::cos(yaw / 2)};
  return transform;
}

TEST(FrameTree, ComposesTheFramesBetweenTwo) {
  FrameTree tree;
  tree.add(transform("base", "mast", 1, 0, M_PI / 2));
  tree.add(transform("mast", "laser", 2, 0, 0));
  tree.add(transform("footprint", "base", 0, 0.5, 0));
  std::vector<std::string> moving;
  const auto pose = tree.pose_in("base", "laser", moving);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->x(), 1, 1e-12);  // 2 m along the mast, which points to the left
  EXPECT_NEAR(pose->y(), 2, 1e-12);
  EXPECT_NEAR(pose->yaw(), M_PI / 2, 1e-12);
  const auto inverse = tree.pose_in("laser", "base", moving);
  EXPECT_NEAR(inverse->x(), -2, 1e-12);  // the base is behind the laser by 2, to its left by 1
  EXPECT_NEAR(inverse->y(), 1, 1e-12);
  EXPECT_NEAR(tree.pose_in("footprint", "laser", moving)->y(), 2.5, 1e-12);
  EXPECT_TRUE(moving.empty());
  EXPECT_FALSE(tree.pose_in("base", "camera", moving));
}

TEST(FrameTree, NamesFramesThatMoveBetweenTwo) {
  FrameTree tree;
  tree.add(transform("base", "laser", 1, 0, 0));
  tree.add(transform("odom", "base", 0, 0, 0));
  tree.add(transform("odom", "base", 1, 0, 0));
  std::vector<std::string> moving;
  tree.pose_in("base", "laser", moving);
  EXPECT_TRUE(moving.empty());
  tree.add(transform("base", "laser", 1, 0, 0.1));
  EXPECT_EQ(tree.pose_in("base", "laser", moving)->yaw(), 0);
  EXPECT_EQ(moving, std::vector<std::string>{"laser"});
}

TEST(FrameTree, LeavesOutWhatIsNoTransform) {
  FrameTree tree;
  RosTransform zero = transform("base", "laser", 1, 0, 0);
  zero.pose.qw = 0;
  tree.add(zero);
  tree.add(transform("base", "laser", std::numeric_limits<double>::infinity(), 0, 0));
  EXPECT_FALSE(tree.has("laser"));
}

TEST(FrameTree, CirclesEnd) {
  FrameTree tree;
  tree.add(transform("a", "b", 1, 0, 0));
  tree.add(transform("b", "a", 1, 0, 0));
  tree.add(transform("c", "c", 1, 0, 0));
  std::vector<std::string> moving;
  EXPECT_TRUE(tree.pose_in("a", "b", moving));
  EXPECT_FALSE(tree.pose_in("a", "c", moving));
}

}  // namespace
}  // namespace slalom
