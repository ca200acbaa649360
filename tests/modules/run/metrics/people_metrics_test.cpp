// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <slalom/metrics/mover_metrics.h>

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

/// A run among the mover "cart" and people, all of whom stand: anna at (4, 5), bob at (6, 5).
struct RunAmongPeople : MeasuredRun {
  explicit RunAmongPeople(const Path& points, Hindrances some = {})
      : MeasuredRun(points), hindrances(std::move(some)) {
    movers = {{"cart", 0.3, {{0, {2, 8}}}, MoverEnd::Stop},
              {"anna", 0.3, {{0, {4, 5}}}, MoverEnd::Stop},
              {"bob", 0.3, {{0, {6, 5}}}, MoverEnd::Stop}};
  }
  Value measured(const std::string& id) const {
    MetricContext context = make_metric_context(world, robot, trajectory, outcome, references, 60,
                                                0.2, safe_distance, &movers);
    context.hindrances = hindrances;
    return metric(id).compute(context);
  }
  Movers movers;
  Hindrances hindrances;
};

const Path kAway{{2, 2}, {8, 2}};

TEST(PeopleMetrics, AreNaWithoutPeople) {
  const MeasuredRun run({{2, 5}, {8, 5}});
  for (const std::string& id : people_metric_ids()) EXPECT_EQ(run.reason(id), "no people") << id;
}

TEST(PeopleMetrics, AreNaOfARunThatWasNotStarted) {
  RunAmongPeople run(kAway, {{true, 1, 0.1, 1}, {}});
  run.outcome = Outcome::UnsolvableScenario;
  for (const std::string& id : people_metric_ids())
    EXPECT_EQ(run.measured(id).reason(), "outcome: unsolvable_scenario") << id;
}

TEST(PeopleHindrance, IsTheSumOverAllPeople) {
  // One gains by the robot.
  const RunAmongPeople run(kAway, {{true, 20, 0.75, 4}, {true, 5, -0.25, 1}});
  EXPECT_EQ(run.measured("people_hindrance"), Value::of(0.5));
  EXPECT_EQ(RunAmongPeople(kAway, {{}, {}}).measured("people_hindrance"), Value::of(0));
}

TEST(PeopleHindered, IsTheShareOfThoseWhoLoseMoreThanHalfASecond) {
  const auto share = [](const Hindrances& hindrances) {
    return RunAmongPeople(kAway, hindrances).measured("people_hindered");
  };
  EXPECT_EQ(share({{true, 20, 0.5, 4}, {}}), Value::of(0));
  EXPECT_EQ(share({{true, 20, 0.51, 4}, {}}), Value::of(0.5));
  EXPECT_EQ(share({{true, 20, 0.51, 4}, {true, 90, 5, 4}, {}, {}}), Value::of(0.5));
}

TEST(PeopleSpeedChange, IsTheMeanOverTheUpdatesWithTheRobotInReach) {
  const RunAmongPeople run(kAway, {{true, 20, 0.75, 4}, {true, 5, -0.25, 1}, {}});
  EXPECT_EQ(run.measured("people_speed_change"), Value::of(5.0 / 25));
  EXPECT_EQ(RunAmongPeople(kAway, {{true, 0, 0, 0}, {}}).measured("people_speed_change").reason(),
            "nobody who notices the robot had it in reach");
}

TEST(PeopleDeficit, IsTheMeanOverAllPeople) {
  Hindrances hindrances(4);
  hindrances[0].deficit = 3;
  hindrances[2].deficit = -1;
  EXPECT_EQ(RunAmongPeople(kAway, hindrances).measured("people_deficit"), Value::of(0.5));
}

TEST(PeopleDelay, IsTheMeanOverThoseWhoArriveInBoth) {
  Hindrances hindrances(4);
  hindrances[0].delay = 3;
  hindrances[2].delay = -1;
  hindrances[2].delay_floor = 0.5;
  const RunAmongPeople run(kAway, hindrances);
  EXPECT_EQ(run.measured("people_delay"), Value::of(1));
  EXPECT_EQ(run.measured("people_delay_floor"), Value::of(0.5));
  EXPECT_EQ(RunAmongPeople(kAway, {{}, {}}).measured("people_delay").reason(),
            "nobody arrives with and without the robot, or until_arrival is 0");
}

TEST(PeopleOverlap, IsTheDeepestOneAtAnyTimeOfTheRun) {
  RunAmongPeople run(kAway, {{}, {}});
  EXPECT_EQ(run.measured("people_overlap"), Value::of(0));
  run.trajectory.samples.back().t = 6;
  // Anna, of 0.3 m, passes bob, of 0.3 m, at 0.4 m, between two updates; the cart is no person.
  run.movers[0].waypoints = {{0, {6, 5}}};
  run.movers[1].waypoints = {{0, {5, 5.4}}, {1, {6.5, 5.4}}, {2, {9, 5.4}}};
  EXPECT_NEAR(run.measured("people_overlap").number(), 0.2, 1e-12);
  // After the run.
  run.movers[1].waypoints = {{0, {5, 8}}, {6.5, {5, 8}}, {8, {6, 5}}};
  EXPECT_EQ(run.measured("people_overlap"), Value::of(0));
  // Before she appears.
  run.movers[1].waypoints = {{3, {6, 5.5}}, {4, {6, 8}}};
  EXPECT_NEAR(run.measured("people_overlap").number(), 0.1, 1e-12);
}

TEST(ContactBlame, IsOnTheRobotIfThePersonHadNoticedIt) {
  // The robot, of 0.25 m, ends at anna, at bob, at the cart, and in the open.
  const Path at_anna{{2, 5}, {3.45, 5}}, at_bob{{8, 5}, {6.55, 5}}, at_cart{{2, 5}, {2, 7.45}};
  const auto blame = [](const Path& path, Outcome outcome = Outcome::Collision) {
    RunAmongPeople run(path, {{true, 1, 0.1, 1}, {}});
    run.outcome = outcome;
    return run.measured("contact_blame");
  };
  EXPECT_EQ(blame(at_anna), Value::of(1));
  EXPECT_EQ(blame(at_bob), Value::of(0));
  EXPECT_EQ(blame(at_cart).reason(), "no contact with a person");
  EXPECT_EQ(blame({{2, 5}, {2, 0.25}}).reason(), "no contact with a person") << "with the wall";
  EXPECT_EQ(blame(at_anna, Outcome::Timeout).reason(), "outcome: timeout");
}

}  // namespace
}  // namespace slalom::testing
