// SPDX-License-Identifier: BSD-3-Clause
#include "crowdnav_cases.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

using mrpt::math::TPoint2D;

/// CrowdNav's rule is that with the velocities of people in the period before.
enum class Rule { PeriodBefore, Exact };

bool collides(const CrowdDisc& robot, const TPoint2D& velocity, const Crowd& crowd, Rule rule) {
  for (const PersonState& walker : crowd.states()) {
    const TPoint2D from = walker.disc.position - robot.position;
    const TPoint2D& other = rule == Rule::Exact ? walker.chosen : walker.disc.velocity;
    const TPoint2D to = from + (other - velocity) * kPeriod;
    if (nearest_on_segment({0, 0}, from, to).norm() < 2 * kDiscRadius) return true;
  }
  return false;
}

struct Counts {
  int successes = 0, collisions = 0, timeouts = 0;
  double time = 0;  ///< s, of successes
};

void run_case(const World& world, unsigned k, bool is_noticed, Rule rule, Counts& counts) {
  constexpr double kTimeLimit = 24;  // s
  const PeopleSettings settings = crowdnav_settings();
  const People people = people_of_case(k);
  Crowd crowd(world, people, settings);
  CrowdDisc robot{kRobotStart, {0, 0}, kDiscRadius};
  for (;;) {
    crowd.decide(RobotDisc{robot, std::vector<bool>(people.size(), is_noticed)});
    std::vector<CrowdDisc> seen;
    for (const PersonState& walker : crowd.states()) seen.push_back(walker.disc);
    const TPoint2D velocity = crowdnav_velocity(robot, seen);
    const TPoint2D next = robot.position + velocity * kPeriod;
    if (crowd.time() >= kTimeLimit) {
      ++counts.timeouts;
      return;
    }
    if (collides(robot, velocity, crowd, rule)) {
      ++counts.collisions;
      return;
    }
    if (distance_between(next, kRobotGoal) < kDiscRadius) {
      ++counts.successes;
      counts.time += crowd.time() + kPeriod;
      return;
    }
    crowd.move();
    robot = {next, velocity, kDiscRadius};
  }
}

/// The counts of RVO2 (1c25b27) compiled in double on the same starts; each of the 500 cases has
/// the same outcome and end time.
TEST(CrowdNav, HasTheOutcomesOfRvo2) {
  const World world = empty_world(12, 1);
  Counts counts;
  for (unsigned k = 0; k < 500; ++k) run_case(world, k, false, Rule::PeriodBefore, counts);
  EXPECT_EQ(counts.successes, 213);
  EXPECT_EQ(counts.collisions, 284);
  EXPECT_EQ(counts.timeouts, 3);
  EXPECT_NEAR(counts.time / counts.successes, 10.8615, 5e-5);
}

/// The same program with the motion of people in the period itself.
TEST(CrowdNav, HasOneMoreCollisionWithExactContact) {
  const World world = empty_world(12, 1);
  Counts counts;
  for (unsigned k = 0; k < 500; ++k) run_case(world, k, false, Rule::Exact, counts);
  EXPECT_EQ(counts.successes, 212);
  EXPECT_EQ(counts.collisions, 285);
  EXPECT_EQ(counts.timeouts, 3);
}

TEST(CrowdNav, HasNoCollisionsAmongPeopleWhoNoticeTheRobot) {
  const World world = empty_world(12, 1);
  Counts counts;
  for (unsigned k = 0; k < 500; ++k) run_case(world, k, true, Rule::Exact, counts);
  EXPECT_EQ(counts.successes, 500);
}

}  // namespace
}  // namespace slalom::testing
