// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/evaluate_log.h>
#include <slalom/campaign/measure.h>
#include <slalom/core/text.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace slalom {
namespace {

/// A trajectory along a wall with a clearance of 0.6 m.
Trajectory trajectory_along_wall() {
  Trajectory trajectory;
  for (int i = 0; i < 3; ++i) {
    Sample sample;
    sample.t = i;
    sample.pose = {2.0 + i, 0.85, 0};
    trajectory.samples.push_back(sample);
  }
  return trajectory;
}

TEST(MeasureRun, ComputesTheEnabledMetricsWithTheCampaignOptions) {
  const World room(Scenario::continuous("room", {0, 0, 10, 10}, {}, {2, 0.85, 0}, {8, 5}), 0.05);
  CampaignOptions options;
  options.metrics = {"risk_time_ratio", "par2_time"};
  const auto measured = [&] {
    return measure_run(options, room, find_references(options, nullptr, room),
                       trajectory_along_wall(), Outcome::Timeout, {}, {});
  };
  EXPECT_EQ(measured().size(), 2U);
  EXPECT_EQ(measured().at("risk_time_ratio").value, Value::of(0));
  options.safe_distance = 0.7;
  EXPECT_EQ(measured().at("risk_time_ratio").value, Value::of(1));
  options.simulation.max_time = 10;
  EXPECT_EQ(measured().at("par2_time").value, Value::of(20));
}

/// A corridor of 1.2 m, and somebody of 0.3 m who stands in its middle until 5 s and leaves it
/// then: 0.3 m beside a person are no room for a robot of 0.2 m.
World corridor(PersonEnd end) {
  Person person{"anna", 0.3, 1, {5, 0.6}, {{9.4, 0.6}}, 0, end};
  if (end == PersonEnd::Stay) person.route = {{5, 0.6}};
  return World(Scenario::continuous("corridor", {0, 0, 10, 1.2}, {}, {1, 0.6, 0}, {9, 0.6})
                   .with_people({person}),
               0.05);
}

TEST(FindReferences, HaveTheArrivalAmongPeopleWhoDoNotNoticeTheRobot) {
  CampaignOptions options;
  options.robot.radius = 0.2;
  options.robot.max_v = 2;
  options.people.notices = 0;
  const World leaving = corridor(PersonEnd::Vanish);
  const References among = find_references(options, nullptr, leaving);
  // Anna, at 1 m/s, is at her goal, up to the tolerance of 0.3 m, after 4.1 s, 4.1 m from the
  // start; the robot, of 2 m/s, cannot pass her, and has 0.2 m to touch the goal at 9 m.
  ASSERT_TRUE(among.arrival);
  EXPECT_GT(among.arrival->certificate.lower_bound, (9 - 0.2 - 1) / 2.0);
  EXPECT_GE(among.arrival->certificate.upper_bound, among.arrival->certificate.lower_bound);
  EXPECT_LT(among.arrival->certificate.upper_bound, 6);

  const References blocked = find_references(options, nullptr, corridor(PersonEnd::Stay));
  EXPECT_FALSE(blocked.arrival);
  EXPECT_NE(blocked.unsolvable_reason(), "") << "she stands in the way for ever";

  // People who notice the robot may stand aside: nothing is proved.
  options.people.notices = 1;
  const References open = find_references(options, nullptr, corridor(PersonEnd::Stay));
  EXPECT_FALSE(open.arrival);
  EXPECT_EQ(open.unsolvable_reason(), "");
}

/// A log along y = 5 at 1 m/s up to the wall at x = 10.
Trajectory log_to_the_wall() {
  Trajectory log;
  for (int i = 0; i <= 80; ++i) {
    Sample sample;
    sample.t = 0.1 * i;
    sample.pose = {2 + 0.1 * i, 5, 0};
    sample.v = 1;
    log.samples.push_back(sample);
  }
  return log;
}

TEST(MeasureRun, AttributesACollisionAsItsDetailDoes) {
  CampaignOptions options;
  options.metrics = {"mover_collision"};
  int with_mover = 0;
  // A mover crosses y = 5 at x = 7 m with 1 m/s at these times, the robot is there at 5 s: the
  // smallest distance of the centers is the difference of the times over sqrt 2, in m.
  for (const double at : {2.0, 3.0, 4.0, 4.8, 5.0, 5.2, 6.0, 7.0}) {
    const Mover crossing{
        "crossing", 0.3, {{at - 1.9, {7, 3.1}}, {at + 1.9, {7, 6.9}}}, MoverEnd::Vanish};
    for (const char* footprint : {"", "0.3,0.2; -0.3,0.2; -0.3,-0.2; 0.3,-0.2"}) {
      options.robot.footprint = footprint;
      const World room(Scenario::continuous("room", {0, 0, 10, 10}, {}, {2, 5, 0}, {5, 9})
                           .with_movers({crossing}),
                       0.05);
      const EvaluatedLog measured =
          evaluate_log(options, nullptr, room, log_to_the_wall(), std::nullopt);
      ASSERT_EQ(measured.run.outcome, Outcome::Collision);
      const bool named =
          starts_with(measured.run.detail, "contact with moving obstacle 'crossing'");
      EXPECT_EQ(measured.metrics.at("mover_collision").value, Value::of(named ? 1 : 0))
          << at << " " << measured.run.detail;
      with_mover += named ? 1 : 0;
    }
  }
  EXPECT_EQ(with_mover, 6);  // three times, for both footprints
}

TEST(MeasureRun, NamesInATieTheMoverThatTheDetailNames) {
  CampaignOptions options;
  options.metrics = {"mover_collision", "contact_mover"};
  std::set<std::string> named;
  // The robot, of 0.25 m, stands at the wall y = 0 and touches it, until two movers reach it at the
  // same time, from the left and from the right; as far as numbers can say.
  for (int i = 0; i < 50; ++i) {
    const double x = 3 + 0.0837 * i, y = 0.25 + 0.0071 * i, v = 0.3 + 0.013 * i;
    Trajectory log;
    for (const double t : {0.0, 20.0}) {
      log.samples.emplace_back();
      log.samples.back().t = t;
      log.samples.back().pose = {x, 0.25, 0};
    }
    const auto from = [&](const char* id, double direction) {
      return Mover{id, 0.3, {{0, {x + direction * 9 * v, y}}, {10, {x - direction * v, y}}}};
    };
    const World room(Scenario::continuous("room", {-10, 0, 20, 10}, {}, {x, 0.25, 0}, {8, 9})
                         .with_movers({from("left", -1), from("right", 1)}),
                     0.05);
    const EvaluatedLog measured = evaluate_log(options, nullptr, room, log, std::nullopt);
    ASSERT_EQ(measured.run.outcome, Outcome::Collision);
    EXPECT_EQ(measured.metrics.at("mover_collision").value, Value::of(1));
    const double index = measured.metrics.at("contact_mover").value.number();
    const std::string id = room.scenario().movers().at(static_cast<std::size_t>(index)).id;
    EXPECT_TRUE(starts_with(measured.run.detail, "contact with moving obstacle '" + id + "'"))
        << i << ": " << measured.run.detail;
    named.insert(id);
  }
  EXPECT_EQ(named.size(), 2U) << "rounding errors decide";
}

TEST(FindReferences, HaveTheEarliestArrivalAmongMoversAtTheMaximumSpeed) {
  const Scenario room = Scenario::continuous("room", {0, 0, 10, 10}, {}, {2, 5, 0}, {8, 5});
  CampaignOptions options;
  options.robot.max_v = 0.5;
  options.simulation.goal_tolerance = 0.3;
  const auto find = [&](const Movers& movers) {
    return find_references(options, nullptr, {room.with_movers(movers), 0.05});
  };
  EXPECT_FALSE(find({}).arrival.has_value());
  EXPECT_EQ(find({}).arrival_reason, "");
  const References apart = find({{"aside", 0.3, {{0, {5, 9}}}}});
  ASSERT_TRUE(apart.arrival.has_value());
  EXPECT_NEAR(apart.arrival->certificate.lower_bound, (6 - 0.3) / 0.5, 1e-9);
  EXPECT_NEAR(apart.arrival->certificate.upper_bound, (6 - 0.3) / 0.5, 1e-6);
  options.simulation.max_time = 11;
  EXPECT_EQ(find({{"aside", 0.3, {{0, {5, 9}}}}}).unsolvable_reason(),
            "the goal cannot be reached within 11 s, even without moving obstacles");
}

TEST(TimeLimit, FollowsFromTheShortestPathAndFromArrivalsAmongMovers) {
  CampaignOptions options;
  options.robot.max_v = 0.1;
  // Around the end of a wall: two times 5 m, and the quarter of a circle around its corners.
  Primitives walls;
  walls.polygons = {{{{4.9, 0}, {5.1, 0}, {5.1, 6}, {4.9, 6}}}};
  const Scenario around = Scenario::continuous("around", {0, 0, 10, 10}, walls, {2, 2, 0}, {8, 2});
  const World world(around, 0.05);
  const References references = find_references(options, nullptr, world);
  const double length = references.shortest->exact_length;
  EXPECT_GT(length, 2 * std::hypot(2.9 - 0.25, 4.0));
  EXPECT_EQ(time_limit(options, references), 4 * length / 0.1);
  EXPECT_EQ(time_limit(options, find_earliest(options, world)), 4 * length / 0.1);
  EXPECT_EQ(lack_of_time(options, world, references), "");
  options.robot.max_v = 1;
  EXPECT_EQ(time_limit(options, references), 60);

  // A mover stands in the doorway for 30 s.
  options.robot.radius = 0.2;
  const Mover guard{"guard", 0.3, {{0, {5, 0.6}}, {30, {5, 0.6}}}, MoverEnd::Vanish};
  const World doorway(Scenario::continuous("corridor", {0, 0, 10, 1.2}, {}, {1, 0.6, 0}, {9, 0.6})
                          .with_movers({guard}),
                      0.05);
  const References among = find_references(options, nullptr, doorway);
  ASSERT_TRUE(among.arrival);
  EXPECT_GT(among.arrival->certificate.lower_bound, 30);
  EXPECT_EQ(time_limit(options, among), 4 * among.arrival->certificate.lower_bound);
  EXPECT_EQ(time_limit(options, find_earliest(options, doorway)), time_limit(options, among));
}

TEST(TimeLimit, TooLittleTimeIsProvedUpToTheToleranceOfTheGoal) {
  CampaignOptions options;
  options.robot.max_v = 0.26;
  const World hall(Scenario::continuous("hall", {0, 0, 30, 4}, {}, {1, 2, 0}, {27.8, 2}), 0.05);
  const References references = find_references(options, nullptr, hall);
  // At speed 102.3 s; until then, at 1 m/s^2, half of that distance is lost.
  const double earliest = (26.8 - options.simulation.goal_tolerance) / 0.26 + 0.26 / 2;
  options.simulation.max_time = 60;
  EXPECT_EQ(lack_of_time(options, hall, references),
            "nobody can arrive within 60 s: the shortest path takes at least 102.4 s at 0.26 m/s");
  options.simulation.max_time = earliest + 0.01;
  EXPECT_EQ(lack_of_time(options, hall, references), "");
  options.simulation.max_time = earliest - 0.01;
  EXPECT_NE(lack_of_time(options, hall, references), "");
  options.robot.max_accel_v = 0.0005;  // never at its speed: s = a t^2 / 2
  options.simulation.max_time = 326;
  EXPECT_NE(lack_of_time(options, hall, references), "");
  options.simulation.max_time = 327;
  EXPECT_EQ(lack_of_time(options, hall, references), "") << std::sqrt(2 * 26.6 / 0.0005);
}

}  // namespace
}  // namespace slalom
