// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/error.h>
#include <slalom/trajectory/trajectory_codec.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

Trajectory two_samples() {
  Trajectory trajectory;
  trajectory.samples.push_back({0, {1, 2, 3}, 4, 5, 6, 7, 8, 9, 10});
  trajectory.samples.push_back({0.1, {std::sqrt(2), 0, 0}, 0, 0, std::nan(""), 0, 0, 0});
  return trajectory;
}

TEST(TrajectoryCodec, RestoresEveryBit) {
  const Trajectory restored = trajectory_from_bytes(to_bytes(two_samples()), "test");
  EXPECT_EQ(restored.hash(), two_samples().hash());
  EXPECT_TRUE(trajectory_from_bytes(to_bytes({}), "test").samples.empty());
}

TEST(TrajectoryCodec, KeepsTheFormatOfResultFiles) {
  const std::string bytes = to_bytes(two_samples());
  ASSERT_EQ(bytes.size(), 1 + 8 + 2 * (11 * sizeof(double)));
  EXPECT_EQ(bytes.substr(0, 9), std::string("\4\2\0\0\0\0\0\0\0", 9));        // version, count
  EXPECT_EQ(bytes.substr(9 + 8, 8), std::string("\0\0\0\0\0\0\xf0\x3f", 8));  // x = 1
}

TEST(TrajectoryCodec, RejectsDamagedBytes) {
  const std::string bytes = to_bytes(two_samples());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(trajectory_from_bytes(bytes.substr(0, size), "test"), Error) << size;
  EXPECT_THROW(trajectory_from_bytes(bytes + 'x', "test"), Error);
  EXPECT_TRUE(throws_error(ErrorKind::File, "test", {"unsupported version"},
                           [&] { trajectory_from_bytes('\3' + bytes.substr(1), "test"); }));
}

}  // namespace
}  // namespace slalom
