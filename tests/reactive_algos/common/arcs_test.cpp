// SPDX-License-Identifier: BSD-3-Clause
#include "common/arcs.h"
#include "common/motion.h"
#include "one_target.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace reactive {
namespace {

constexpr std::size_t kArcs = 4001;

/// Turns of both signs from none to some turns, with arcs of up to 2 m.
struct Arcs {
  std::vector<double> lengths, turns;
  Arcs() : lengths(padded(kArcs)), turns(padded(kArcs)) {
    for (std::size_t i = 0; i < kArcs; ++i) {
      const double t = (static_cast<double>(i) - 2000) / 2000;
      lengths[i] = 2 * std::cos(static_cast<double>(i));
      turns[i] = 20 * t * t * t;
    }
    turns[0] = 1e-6;  // of which the half is not told from no turn
    turns[1] = 3e-6;
  }
};

PoseBatch moved(const Arcs& arcs, const Pose& from) {
  PoseBatch poses;
  poses.assign(kArcs, from);
  move_along_arcs(arcs.lengths.data(), arcs.turns.data(), kArcs, poses);
  return poses;
}

TEST(MoveAlongArcs, EqualsIntegrationOfOnePose) {
  const Arcs arcs;
  const Pose from = {3, -2, 2.5};
  const PoseBatch poses = moved(arcs, from);
  for (std::size_t i = 0; i < kArcs; ++i) {
    const Pose expected = integrate(from, {arcs.lengths[i], arcs.turns[i]}, 1);
    // A few roundings of numbers up to 5, and of an angle up to 23 rad.
    EXPECT_NEAR(poses.x[i], expected.x, 1e-14) << i;
    EXPECT_NEAR(poses.y[i], expected.y, 1e-14) << i;
    EXPECT_NEAR(poses.cosine[i], std::cos(expected.phi), 1e-14) << i;
    EXPECT_NEAR(poses.sine[i], std::sin(expected.phi), 1e-14) << i;
  }
}

TEST(MoveAlongArcs, KeepsHeadingsOnTheUnitCircle) {
  const Arcs arcs;
  PoseBatch poses;
  poses.assign(kArcs, {0, 0, 1});
  for (int step = 0; step < 100; ++step)
    move_along_arcs(arcs.lengths.data(), arcs.turns.data(), kArcs, poses);
  // Each step adds a rounding error of about 2^-52.
  for (std::size_t i = 0; i < kArcs; ++i)
    EXPECT_NEAR(std::hypot(poses.cosine[i], poses.sine[i]), 1, 1e-13);
}

TEST(MoveAlongArcs, HasTheSameBitsWithEveryInstructionSet) {
  const Arcs arcs;
  const PoseBatch expected = moved(arcs, {3, -2, 2.5});
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
    const slalom::testing::OneTarget target(left & -left);
    const PoseBatch poses = moved(arcs, {3, -2, 2.5});
    EXPECT_EQ(poses.x, expected.x) << hwy::TargetName(left & -left);
    EXPECT_EQ(poses.y, expected.y) << hwy::TargetName(left & -left);
    EXPECT_EQ(poses.cosine, expected.cosine) << hwy::TargetName(left & -left);
    EXPECT_EQ(poses.sine, expected.sine) << hwy::TargetName(left & -left);
  }
}

}  // namespace
}  // namespace reactive
