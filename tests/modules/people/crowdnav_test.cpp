// SPDX-License-Identifier: BSD-3-Clause
#include "crowd_runs.h"

#include <slalom/core/math.h>
#include <slalom/people/orca.h>

#include <gtest/gtest.h>

#include <random>

namespace slalom::testing {
namespace {

using mrpt::math::TPoint2D;

/// The setting of the test cases of CrowdNav (Chen et al. 2019; vita-epfl/CrowdNav, 20d6780).
constexpr double kPeriod = 0.25, kDiscRadius = 0.3, kCircle = 4;
const TPoint2D kRobotStart(0, -kCircle), kRobotGoal(0, kCircle);

PeopleSettings crowdnav_settings() {
  PeopleSettings settings;
  settings.model = PeopleModel::Orca;
  settings.period = kPeriod;
  settings.horizon = 5;
  settings.sight = 10;
  settings.margin = 0.01;
  settings.haste = 1;
  settings.turn = 0;
  settings.keep_apart = false;
  return settings;
}

/// numpy's numbers in [0, 1), from its legacy generator.
double uniform(std::mt19937& random) {
  const auto high = static_cast<double>(random() >> 5);
  const auto low = static_cast<double>(random() >> 6);
  return (high * 67108864.0 + low) / 9007199254740992.0;
}

People people_of_case(unsigned k) {
  std::mt19937 random(1000 + k);
  People people;
  while (people.size() < 5) {
    const math::SinCos angle = math::sin_cos(uniform(random) * M_PI * 2);
    const double dx = uniform(random) - 0.5, dy = uniform(random) - 0.5;
    const TPoint2D start(kCircle * angle.cos + dx, kCircle * angle.sin + dy);
    const auto is_near = [&](const TPoint2D& a, const TPoint2D& b) {
      return distance_between(start, a) < 0.8 || distance_between(start, b) < 0.8;
    };
    bool bad = is_near(kRobotStart, kRobotGoal);
    for (const Person& person : people) bad = bad || is_near(person.start, person.route[0]);
    if (bad) continue;
    people.push_back(walker(people.size(), start, {start * -1.0}, PersonEnd::Stay, 1));
    people.back().radius = kDiscRadius;
  }
  return people;
}

TPoint2D robot_velocity(const CrowdDisc& robot, const Crowd& crowd,
                        const PeopleSettings& settings) {
  Surroundings around;
  around.self = robot;
  around.rank = -1;
  around.max_speed = 1;
  const TPoint2D offset = kRobotGoal - robot.position;
  around.wanted = offset.norm() > 1 ? offset * (1 / offset.norm()) : offset;
  int rank = 0;
  for (const Walker& walker : crowd.walkers())
    around.neighbors.push_back({walker.disc, rank++, 0.5, true, false});
  sort_by_place(around, settings.side);
  return orca_velocity(around, settings);
}

/// CrowdNav's rule is that with the velocities of people in the period before.
enum class Rule { PeriodBefore, Exact };

bool collides(const CrowdDisc& robot, const TPoint2D& velocity, const Crowd& crowd, Rule rule) {
  for (const Walker& walker : crowd.walkers()) {
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
    const TPoint2D velocity = robot_velocity(robot, crowd, settings);
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

TEST(CrowdNav, HasNoCollisionsAmongPeopleWhoNoticeTheRobot) {
  const World world = empty_world(12, 1);
  Counts counts;
  for (unsigned k = 0; k < 500; ++k) run_case(world, k, true, Rule::Exact, counts);
  EXPECT_EQ(counts.successes, 500);
}

}  // namespace
}  // namespace slalom::testing
