// SPDX-License-Identifier: BSD-3-Clause
#include "isolated_trials.h"
#include "planted_methods.h"

#include <slalom/falsification/candidates.h>
#include <slalom/falsification/fairness.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// A wall across the workspace with a door of this width (m), on multiples of the cell.
Scenario door(double width) {
  Primitives obstacles;
  const double low = 3 - width / 2, high = 3 + width / 2;
  obstacles.polygons = {{{{2.975, -1}, {3.025, -1}, {3.025, low}, {2.975, low}}},
                        {{{2.975, high}, {3.025, high}, {3.025, 7}, {2.975, 7}}}};
  return Scenario::continuous("door", {0, 0, 6, 6}, obstacles, {1, 3, 0}, {5, 3});
}

GeometryReport judge(const Scenario& scenario, const FairnessOptions& options = {}) {
  return judge_geometry(World(scenario, 0.05), RobotModel(), options);
}

TEST(Fairness, TheBottleneckIsCertified) {
  // A robot of 0.5 m. A closed polygon also occupies the cells that it only touches: the door is up
  // to 0.1 m narrower. Its axis is half a cell from cell centers, which costs another 0.05 m, and
  // the certificate 2 * 0.0354 m.
  for (const double width : {0.8, 1.0, 1.2}) {
    const double bottleneck = judge(door(width)).bottleneck * 0.5;
    EXPECT_LE(bottleneck, width);
    EXPECT_GE(bottleneck, width - 0.15 - 0.0708 - 1e-9);
  }
}

TEST(Fairness, ANarrowPassageIsUnfairUnlessSwitchedOff) {
  EXPECT_NE(judge(door(0.7)).violation.find("bottleneck"), std::string::npos);
  EXPECT_EQ(judge(door(1.0)).violation, "");
  FairnessOptions options;
  options.min_bottleneck = 0;
  EXPECT_EQ(judge(door(0.7), options).violation, "");
}

TEST(Fairness, AStartAtAnObstacleIsUnfairUnlessSwitchedOff) {
  Primitives obstacles;
  obstacles.discs = {{{1, 3.6}, 0.27}};  // 0.33 m from the center, 0.08 m or less from the robot
  const Scenario scenario =
      Scenario::continuous("start", {0, 0, 6, 6}, obstacles, {1, 3, 0}, {5, 3});
  FairnessOptions options;
  options.min_bottleneck = 0;
  const GeometryReport report = judge(scenario, options);
  EXPECT_LE(report.start_clearance, 0.08);
  EXPECT_GE(report.start_clearance, 0.08 - 0.0708);
  EXPECT_NE(report.violation.find("clearance at the start"), std::string::npos);
  options.min_start_clearance = 0;
  EXPECT_EQ(judge(scenario, options).violation, "");
}

TEST(Fairness, AGoalAtTheStartIsUnfairUnlessSwitchedOff) {
  const Scenario scenario = Scenario::continuous("near", {0, 0, 6, 6}, {}, {3, 3, 0}, {3.5, 3});
  EXPECT_NE(judge(scenario).violation.find("distance to the goal"), std::string::npos);
  FairnessOptions options;
  options.min_distance = 0;
  EXPECT_EQ(judge(scenario, options).violation, "");
}

Trial squeeze_trial(const FalsificationSetup& setup) {
  const auto method = setup.method.make(setup.run.robot, setup.run.sensor);
  return run_trial(World(passage(), 0.05), setup, *method);
}

TEST(Fairness, TheFastDecisionIsThatOfTheReport) {
  RandomEngine engine(5);
  const RobotModel robot;
  const CandidateMix mix(robot);
  std::size_t fair = 0;
  for (int i = 0; i < 60; ++i) {
    const World world(mix.draw(engine), 0.05);
    FairnessOptions options;
    const double bottleneck = judge_geometry(world, robot, options).bottleneck;
    // Also at the bottleneck itself, with the tolerance for rounding of 1e-9.
    for (const double least : {0.0, 1.5, 3.0, bottleneck, bottleneck + 0.9e-9, bottleneck + 1.1e-9,
                               std::nextafter(bottleneck + 1e-9, 0.0), bottleneck + 1e-9}) {
      options.min_bottleneck = least;
      const bool expected = judge_geometry(world, robot, options).violation.empty();
      EXPECT_EQ(has_fair_geometry(world, robot, options), expected) << i << ": " << least;
      fair += expected ? 1 : 0;
    }
  }
  EXPECT_GT(fair, 100U);
  EXPECT_LT(fair, 480U - 100U);
}

TEST(Fairness, AWitnessProvesThatTheScenarioCanBeSolved) {
  FalsificationSetup setup = planted_setup("squeeze");
  const Trial failure = squeeze_trial(setup);
  EXPECT_TRUE(judge_failure(setup, passage(), failure, {}).fair());
  setup.witnesses = {planted("squeeze"), planted("none")};
  EXPECT_EQ(judge_failure(setup, passage(), failure, {}).witness, "base");
  setup.witnesses = {planted("squeeze")};
  EXPECT_FALSE(judge_failure(setup, passage(), failure, {}).fair());
  FairnessOptions options;
  options.witness = NeedsWitness::Never;
  EXPECT_TRUE(judge_failure(setup, passage(), failure, options).fair());
}

TEST(Fairness, AMethodsOwnFailureNeedsNoWitnessUnlessOneIsNamed) {
  FalsificationSetup setup = planted_setup("squeeze");
  setup.witnesses.clear();
  Trial failure = squeeze_trial(setup);
  FairnessOptions options;
  EXPECT_FALSE(judge_failure(setup, passage(), failure, options).fair());
  options.witness = NeedsWitness::NotForOwn;
  ASSERT_EQ(failure.outcome, Outcome::Collision);
  EXPECT_TRUE(judge_failure(setup, passage(), failure, options).fair());
  const Scenario still = passage();
  Mover mover;
  mover.id = "cart";
  mover.radius = 0.1;
  mover.waypoints = {{0, {0, 0}}};
  const Scenario moving = still.with_movers({mover});
  for (const Outcome outcome : {Outcome::Collision, Outcome::MethodCrash, Outcome::LeftWorkspace})
    EXPECT_FALSE(needs_witness(options, still, outcome)) << to_string(outcome);
  for (const Outcome outcome : {Outcome::Stuck, Outcome::Timeout})
    EXPECT_TRUE(needs_witness(options, still, outcome)) << to_string(outcome);
  EXPECT_TRUE(needs_witness(options, moving, Outcome::Collision));
  EXPECT_FALSE(needs_witness(options, moving, Outcome::MethodCrash));
}

TEST(Fairness, AScenarioInWhichNobodyCanArriveInTimeIsUnfair) {
  FalsificationSetup setup = planted_setup("squeeze");
  const Trial failure = squeeze_trial(setup);
  FairnessOptions options;
  options.witness = NeedsWitness::Never;
  ASSERT_TRUE(judge_failure(setup, passage(), failure, options).fair());
  setup.run.simulation.max_time = 1;
  const std::vector<std::string> violations =
      judge_failure(setup, passage(), failure, options).violations;
  EXPECT_TRUE(std::any_of(violations.begin(), violations.end(), [](const std::string& violation) {
    return violation.find("nobody can arrive within 1 s: ") == 0;
  }));
}

/// A method that drives straight on, whatever is ahead.
class Straight : public Method {
 public:
  void reset(const NavigationTask& /*task*/) override {}
  Command step(const Observation& /*observation*/) override { return {1.5, 0}; }
};

FalsificationSetup straight_setup() {
  FalsificationSetup setup;
  setup.run.simulation.max_time = 40;
  setup.run.robot.max_v = 2;
  setup.run.robot.max_accel_v = 4;
  setup.method = {"straight", [](const auto&...) { return std::make_unique<Straight>(); }, "test"};
  setup.unnoticed_witness = true;
  return setup;
}

/// She crosses the way of the robot: 0.04 m ahead of it, if she does not notice it, and otherwise
/// she hesitates and is touched.
Person hesitating() {
  return {"anna", 0.25, 0.9, {3.8, 3.4}, {{6.6, 8.9}}};
}

Scenario crossing(const Person& person) {
  return Scenario::continuous("crossing", {0, 0, 10, 10}, {}, {1, 5, 0}, {9, 5})
      .with_people({person});
}

FairnessReport judge_run(const FalsificationSetup& setup, const Scenario& scenario) {
  return judge_failure(setup, scenario, run_alone(setup, scenario, 0), {});
}

TEST(Fairness, AmongPeopleTheMethodIsAWitnessIfTheyDoNotNoticeIt) {
  FalsificationSetup setup = straight_setup();
  const Trial failure = run_alone(setup, crossing(hesitating()), 0);
  EXPECT_EQ(failure.detail.find("contact with person 'anna'"), 0U) << failure.detail;
  const FairnessReport report = judge_run(setup, crossing(hesitating()));
  EXPECT_TRUE(report.fair());
  EXPECT_EQ(report.witness, "straight among people who do not notice it");
  setup.unnoticed_witness = false;
  EXPECT_EQ(judge_run(setup, crossing(hesitating())).violations,
            (std::vector<std::string>{"no witness is named"}));
}

TEST(Fairness, AFailureAmongPeopleThatNobodyAvoidsIsNotProvedSolvable) {
  const FalsificationSetup setup = straight_setup();
  // In the middle of the way, where she stays.
  const Scenario blocked = crossing({"anna", 0.25, 0.9, {5, 5}, {{5, 5}}});
  EXPECT_EQ(judge_run(setup, blocked).violations,
            (std::vector<std::string>{"not proved solvable: no witness reaches the goal, nor "
                                      "straight among people who do not notice it"}));
  // The run of the method would be the same where nobody notices the robot.
  FalsificationSetup unnoticed = setup;
  unnoticed.run.people.notices = 0;
  EXPECT_TRUE(unnoticed.witnesses_in(blocked).empty());
  EXPECT_TRUE(setup.witnesses_in(blocked.with_people({})).empty());
}

TEST(Fairness, PeopleAreObstaclesAtTheStartIfTheyAreThere) {
  // 0.65 m from the robot's center, of 0.25 m radius as the robot.
  Person anna{"anna", 0.25, 1, {1, 5.65}, {{5, 9}}};
  EXPECT_NEAR(judge(crossing(anna)).start_clearance, 0.15, 1e-12);
  EXPECT_EQ(judge(crossing(anna)).violation, "");
  anna.start.y = 5.55;
  EXPECT_NE(judge(crossing(anna)).violation.find("clearance at the start 0.050 m"),
            std::string::npos);
  anna.begin = 1;
  EXPECT_EQ(judge(crossing(anna)).violation, "");
}

TEST(Fairness, APersonWithoutAWayIsUnfairUnlessSwitchedOff) {
  const RobotModel robot;
  const auto judged = [&](const Scenario& scenario, const FairnessOptions& options) {
    const World world(scenario, 0.05);
    const std::string violation = judge_geometry(world, robot, options).violation;
    EXPECT_EQ(has_fair_geometry(world, robot, options), violation.empty());
    return violation;
  };
  const Person anna{"anna", 0.6, 1, {1, 1}, {{5, 1}}};  // through a door of 1.1 m
  const Scenario scenario = door(1.1).with_people({anna});
  FairnessOptions options;
  EXPECT_EQ(judged(scenario, options), "person 'anna' has no way to its goal");
  options.people_walk = false;
  EXPECT_EQ(judged(scenario, options), "");
}

TEST(Fairness, ARunThatANewProcessDoesNotRepeatIsUnfair) {
  const FalsificationSetup setup = planted_setup("squeeze");
  Trial failure = squeeze_trial(setup);
  failure.trajectory_hash.back() = failure.trajectory_hash.back() == '0' ? '1' : '0';
  const FairnessReport report = judge_failure(setup, passage(), failure, {});
  EXPECT_FALSE(report.repeatable);
  ASSERT_EQ(report.violations.size(), 1U);
  EXPECT_NE(report.violations[0].find("does not repeat"), std::string::npos);
  FairnessOptions options;
  options.repeatable = false;
  EXPECT_TRUE(judge_failure(setup, passage(), failure, options).fair());
}

TEST(Fairness, TrialsAreReadAsTheyWereWritten) {
  const Trial trial = squeeze_trial(planted_setup("squeeze"));
  EXPECT_LE(trial.clearance, 0.01);
  EXPECT_EQ(trial.waypoints.size(), kWaypoints);
  const std::string bytes = to_bytes(trial);
  EXPECT_EQ(to_bytes(trial_from_bytes(bytes, "test")), bytes);
  EXPECT_THROW(trial_from_bytes(bytes.substr(1), "test"), Error);
  EXPECT_THROW(trial_from_bytes(bytes + "x", "test"), Error);
}

}  // namespace
}  // namespace slalom
