// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/falsification/clusters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

namespace slalom {
namespace {

FailureFacts facts_of(Outcome outcome, ObstacleSide side, EndMotion motion) {
  FailureFacts facts;
  facts.outcome = outcome;
  facts.side = side;
  facts.motion = motion;
  facts.obstacles = 2;
  facts.bottleneck_width = 3;
  return facts;
}

std::vector<FailureFacts> made_up_failures() {
  std::vector<FailureFacts> failures;
  const auto add = [&failures](int count, const FailureFacts& facts) {
    failures.insert(failures.end(), static_cast<std::size_t>(count), facts);
  };
  add(14, facts_of(Outcome::Collision, ObstacleSide::Front, EndMotion::Fast));
  add(10, facts_of(Outcome::Collision, ObstacleSide::Side, EndMotion::Slow));
  add(4, facts_of(Outcome::Collision, ObstacleSide::Back, EndMotion::Slow));
  add(8, facts_of(Outcome::Stuck, ObstacleSide::Front, EndMotion::Turning));
  add(2, facts_of(Outcome::Stuck, ObstacleSide::Front, EndMotion::Stopped));
  return failures;
}

std::vector<std::size_t> range(std::size_t first, std::size_t end) {
  std::vector<std::size_t> indexes(end - first);
  std::iota(indexes.begin(), indexes.end(), first);
  return indexes;
}

TEST(Clusters, AreTheOutcomesAndTheFactsThatEnoughFailuresShare) {
  const auto clusters = cluster_failures(made_up_failures());
  ASSERT_EQ(clusters.size(), 3u);
  // Only 4 collisions are behind, so that collisions are not divided by the side, but by motion.
  EXPECT_EQ(clusters[0].name,
            "collision, below half of the maximum speed, faces the goal, 2 to 3 obstacles needed, "
            "bottleneck of 2 to 4 robot widths");
  EXPECT_EQ(clusters[0].members, range(14, 28));
  EXPECT_EQ(clusters[1].name,
            "collision, nearest obstacle in front, above half of the maximum speed, faces the "
            "goal, 2 to 3 obstacles needed, bottleneck of 2 to 4 robot widths");
  EXPECT_EQ(clusters[1].members, range(0, 14));
  // Neither motion has ten members, so the name leaves motion out.
  EXPECT_EQ(clusters[2].name,
            "stuck, nearest obstacle in front, faces the goal, 2 to 3 obstacles needed, bottleneck "
            "of 2 to 4 robot widths");
  EXPECT_EQ(clusters[2].members, range(28, 38));
}

TEST(Clusters, KeepRareValuesTogetherIfThereAreEnough) {
  std::vector<FailureFacts> failures(
      12, facts_of(Outcome::Collision, ObstacleSide::Front, EndMotion::Fast));
  for (int i = 0; i < 5; ++i) {
    failures.push_back(facts_of(Outcome::Collision, ObstacleSide::Side, EndMotion::Fast));
    failures.push_back(facts_of(Outcome::Collision, ObstacleSide::Back, EndMotion::Fast));
  }
  const auto clusters = cluster_failures(failures);
  ASSERT_EQ(clusters.size(), 2u);
  EXPECT_EQ(clusters[0].members, range(0, 12));
  EXPECT_EQ(clusters[1].members, range(12, 22));
}

TEST(Clusters, DoNotDependOnTheOrderOfFailures) {
  std::vector<FailureFacts> failures = made_up_failures();
  const auto partition = [](const std::vector<FailureCluster>& clusters) {
    std::multiset<std::pair<std::string, std::size_t>> sizes;
    for (const FailureCluster& cluster : clusters)
      sizes.insert({cluster.name, cluster.members.size()});
    return sizes;
  };
  const auto expected = partition(cluster_failures(failures));
  std::mt19937 engine(1);
  for (int i = 0; i < 20; ++i) {
    std::shuffle(failures.begin(), failures.end(), engine);
    EXPECT_EQ(partition(cluster_failures(failures)), expected);
  }
}

TEST(Clusters, ContainEachFailureOnce) {
  const std::vector<FailureFacts> failures = made_up_failures();
  std::multiset<std::size_t> members;
  for (const FailureCluster& cluster : cluster_failures(failures))
    members.insert(cluster.members.begin(), cluster.members.end());
  EXPECT_EQ(members.size(), failures.size());
  EXPECT_EQ(std::set<std::size_t>(members.begin(), members.end()).size(), failures.size());
}

TEST(Clusters, OfNothingAreNone) {
  EXPECT_TRUE(cluster_failures({}).empty());
}

/// A disc at (5, 5) with radius 0.5 m in a workspace of 10 m x 10 m, the goal at (9, 5).
World one_disc() {
  Primitives obstacles;
  obstacles.discs = {{{5, 5}, 0.5}};
  return {Scenario::continuous("disc", {0, 0, 10, 10}, obstacles, {1, 5, 0}, {9, 5}), 0.05};
}

Trajectory ending_at(const mrpt::math::TPose2D& pose, double speed) {
  Sample sample;
  sample.pose = pose;
  sample.v = speed;
  return {{sample}};
}

TEST(Clusters, TellCollisionsWithPeopleFromThoseWithMovers) {
  const Scenario empty = Scenario::continuous("empty", {0, 0, 10, 10}, {}, {1, 5, 0}, {9, 5});
  const Mover scripted{"m", 0.25, {{0, {3, 5}}}, MoverEnd::Stop};
  const World world(
      empty.with_movers({scripted}).with_people({{"anna", 0.25, 1, {7, 5}, {{7, 5}}}}), 0.05);
  // All that moved in the run: the movers of the scenario, then its people.
  const Movers movers = {scripted, {"anna", 0.25, {{0, {7, 5}}}, MoverEnd::Stop}};
  const auto measure = [&](double x) {
    return measure_end(world, movers, RobotModel(), Outcome::Collision, ending_at({x, 5, 0}, 0.5));
  };
  const FailureFacts with_mover = measure(2.5), with_person = measure(6.5);
  EXPECT_EQ(facts_in_words(with_mover)[0], "collision with a moving obstacle");
  EXPECT_EQ(facts_in_words(with_person)[0], "collision with a person");
  EXPECT_EQ(with_person.side, ObstacleSide::Front);
}

TEST(Clusters, MeasureWhereTheObstacleIsAndTheSpeedOfACollision) {
  const World world = one_disc();
  const RobotModel robot;  // of 1 m/s
  const auto measure = [&](const mrpt::math::TPose2D& pose, double speed) {
    return measure_end(world, world.scenario().movers(), robot, Outcome::Collision,
                       ending_at(pose, speed));
  };
  const FailureFacts front = measure({4.25, 5, 0}, 0.9);  // 0.25 m left of the disc, heading to it
  EXPECT_EQ(front.side, ObstacleSide::Front);
  EXPECT_EQ(front.motion, EndMotion::Fast);
  EXPECT_TRUE(front.faces_goal);
  const FailureFacts side = measure({4.25, 5, M_PI / 2}, 0.3);
  EXPECT_EQ(side.side, ObstacleSide::Side);
  EXPECT_EQ(side.motion, EndMotion::Slow);
  const FailureFacts back = measure({4.25, 5, M_PI}, 0.3);
  EXPECT_EQ(back.side, ObstacleSide::Back);
  EXPECT_FALSE(back.faces_goal);
}

TEST(Clusters, OfCollisionsWithMoversSaySo) {
  const Scenario disc = one_disc().scenario();
  // The mover touches a robot at (8, 5) from the left, at (7.45, 5).
  const World world(disc.with_movers({{"m", 0.3, {{0, {7.45, 5}}, {9, {7.45, 5}}}}}), 0.05);
  const RobotModel robot;
  const auto measure = [&](double x, Outcome outcome) {
    return measure_end(world, world.scenario().movers(), robot, outcome, ending_at({x, 5, 0}, 0.3));
  };
  const FailureFacts with_mover = measure(8, Outcome::Collision);
  EXPECT_EQ(with_mover.side, ObstacleSide::Back);
  EXPECT_EQ(facts_in_words(with_mover).front(), "collision with a moving obstacle");
  EXPECT_EQ(facts_in_words(measure(4.25, Outcome::Collision)).front(), "collision");
  EXPECT_EQ(facts_in_words(measure(8, Outcome::Timeout)).front(), "timeout");
}

/// 10 s, sampled every 0.1 s.
Trajectory drive(double v, double w, double turn_every) {
  Trajectory trajectory;
  for (int i = 0; i <= 100; ++i) {
    Sample sample;
    sample.t = 0.1 * i;
    const double phase = std::fmod(sample.t, 2 * turn_every);
    sample.pose = {2 + v * (phase < turn_every ? phase : 2 * turn_every - phase), 5, w * sample.t};
    trajectory.samples.push_back(sample);
  }
  return trajectory;
}

TEST(Clusters, MeasureTheMotionOfARunThatGetsStuck) {
  const World world = one_disc();
  const RobotModel robot;  // radius 0.25 m
  const auto motion = [&](const Trajectory& trajectory) {
    return measure_end(world, world.scenario().movers(), robot, Outcome::Stuck, trajectory).motion;
  };
  EXPECT_EQ(motion(drive(0, 0, 1)), EndMotion::Stopped);
  EXPECT_EQ(motion(drive(0, 0.3, 1)), EndMotion::Stopped) << "1.5 rad in 5 s are below pi / 2";
  EXPECT_EQ(motion(drive(0, 0.4, 1)), EndMotion::Turning);
  EXPECT_EQ(motion(drive(0.5, 0, 1)), EndMotion::Driving) << "2.5 m in 5 s";
}

}  // namespace
}  // namespace slalom
