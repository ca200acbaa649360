// SPDX-License-Identifier: BSD-3-Clause
#include "crowdnav_cases.h"

#include <slalom/simulation/simulate.h>

#include <gtest/gtest.h>

#include <map>

namespace slalom::testing {
namespace {

using mrpt::math::TPoint2D;

/// The robot of CrowdNav, which gets people as tracks. Its heading stays 0.
class OrcaRobot : public Method {
 public:
  void reset(const NavigationTask&) override {}
  bool uses_tracks() const override { return true; }
  Command step(const Observation& o) override {
    const CrowdDisc robot{TPoint2D(o.odometry), {o.v, o.vy}, kDiscRadius};
    std::vector<CrowdDisc> people;
    for (const Track& track : *o.tracks)
      people.push_back({robot.position + track.position, track.velocity, track.radius});
    const TPoint2D velocity = crowdnav_velocity(robot, people);
    return {velocity.x, 0, velocity.y};
  }
};

/// The setup of docs/reference/testbeds.md.
RunSetup crowdnav_setup() {
  RunSetup setup;
  setup.robot.kinematics = Kinematics::Holonomic;
  setup.robot.radius = kDiscRadius;
  setup.robot.max_accel_v = 1000;
  setup.robot.forward_only = false;
  setup.simulation.control_period = kPeriod;
  setup.simulation.max_time = 24;
  setup.simulation.goal_tolerance = kDiscRadius;
  setup.sensor.rays = 3;
  setup.tracker.range = 50;
  setup.people = crowdnav_settings();
  setup.people.notices = 0;
  return setup;
}

std::map<Outcome, int> outcomes(const RunSetup& setup) {
  std::map<Outcome, int> counts;
  for (unsigned k = 0; k < 500; ++k) {
    const Scenario scenario = Scenario::continuous("case", {-12, -12, 12, 12}, {},
                                                   {kRobotStart.x, kRobotStart.y, 0}, kRobotGoal)
                                  .with_people(people_of_case(k));
    OrcaRobot robot;
    ++counts[simulate(World(scenario, 0.5), setup, 1, robot).outcome];
  }
  return counts;
}

/// The counts of RVO2 (1c25b27) on the tracks of runs. The test of CrowdNav without runs has 212,
/// 285 and 3 with exact contact.
TEST(CrowdNavRuns, HaveItsOutcomesWithTracksOfTheLastPeriod) {
  std::map<Outcome, int> counts = outcomes(crowdnav_setup());
  EXPECT_EQ(counts[Outcome::Success], 212);
  EXPECT_EQ(counts[Outcome::Collision], 286);
}

TEST(CrowdNavRuns, SucceedNearlyTwiceAsOftenWhenTracksHaveTheIntention) {
  RunSetup setup = crowdnav_setup();
  setup.tracker.intention = true;
  std::map<Outcome, int> counts = outcomes(setup);
  EXPECT_EQ(counts[Outcome::Success], 401);
  EXPECT_EQ(counts[Outcome::Collision], 98);
}

}  // namespace
}  // namespace slalom::testing
