// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "test_runs.h"

#include <slalom/core/distance.h>
#include <slalom/people/run_alone.h>
#include <slalom/simulation/evaluate_trajectory.h>

#include <gtest/gtest.h>

#include <string>

namespace slalom::testing {
namespace {

using mrpt::math::TPoint2D;

RunSetup setup_of(double notices, PeopleModel model = PeopleModel::Speed) {
  RunSetup setup;
  setup.robot.radius = 0.2;
  setup.people.notices = notices;
  setup.people.model = model;
  return setup;
}

Scenario with_people(People people, const Primitives& obstacles = {}) {
  return Scenario::continuous("people", {0, 0, 10, 10}, obstacles, {5, 5, 0}, {9, 9})
      .with_people(std::move(people));
}

/// Walks from the right to the left at 1.25 m/s, over the place of the robot.
Person passer_by() {
  return {"anna", 0.3, 1.25, {8, 5}, {{2, 5}}, 0, PersonEnd::Stay};
}

/// A room with two pillars, and people who cross it.
Scenario busy_room() {
  const Primitives pillars{{{{3, 3}, 0.4}, {{7, 6}, 0.5}}, {}};
  People people;
  for (int i = 0; i < 4; ++i) {
    const double y = 1.5 + 2 * i;
    people.push_back(
        {"a" + std::to_string(i), 0.25, 1.2, {1, y}, {{9, 9 - y}}, 0, PersonEnd::Stay});
    people.push_back(
        {"b" + std::to_string(i), 0.25, 1.4, {9, y}, {{1, y}}, 0.3 * i, PersonEnd::Return});
  }
  people[0].after = PersonEnd::Vanish;
  people[3].begin = 1000;
  return with_people(people, pillars)
      .with_movers({{"cart", 0.3, {{0, {5, 1}}, {20, {5, 9}}}, MoverEnd::Vanish}});
}

/// Whether both are at the same places, to the bit, at all updates up to `end` (s).
::testing::AssertionResult same_motion(const Mover& a, const Mover& b, double end) {
  for (int k = 0; 0.1 * k <= end; ++k) {
    const double t = k * 0.1;
    const TPoint2D p = a.position(t), q = b.position(t);
    if (a.present(t) != b.present(t) || p.x != q.x || p.y != q.y)
      return ::testing::AssertionFailure() << a.id << " differs at " << t << " s";
  }
  return ::testing::AssertionSuccess();
}

TEST(People, WhoDoNotNoticeTheRobotWalkAsIfThereWereNone) {
  const World world(busy_room(), 0.05);
  for (const PeopleModel model : {PeopleModel::Speed, PeopleModel::Orca}) {
    RunSetup setup = setup_of(0, model);
    setup.simulation.max_time = 20;
    const Movers alone = run_alone(world, world.scenario().people(), setup.people, 20);
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      RandomMethod random(setup.robot);
      const SimulationResult result = simulate(world, setup, seed, random);
      ASSERT_EQ(result.movers.size(), alone.size() + 1);
      EXPECT_EQ(result.movers[0], world.scenario().movers()[0]);
      EXPECT_EQ(result.hindrances, Hindrances(alone.size()));
      EXPECT_NO_THROW(check_movers("run", result.movers));
      for (std::size_t i = 0; i < alone.size(); ++i)
        EXPECT_TRUE(same_motion(result.movers[i + 1], alone[i], result.trajectory.duration()));
    }
  }
}

TEST(People, EndARunAtTheExactTimeAndPlace) {
  // The robot stands; the person reaches it after (3 - 0.5) / 1.25 s = 2 s.
  const World world(with_people({passer_by()}), 0.05);
  FunctionMethod still = constant_method(0, 0);
  const SimulationResult result = simulate(world, setup_of(0), 1, still);
  EXPECT_EQ(result.outcome, Outcome::Collision);
  EXPECT_NEAR(result.trajectory.samples.back().t, 2, 1e-9);
  EXPECT_EQ(result.detail,
            "contact with person 'anna' at (5.00, 5.00) m after 2.00 s, the robot had stood for "
            "0.5 s");
}

TEST(People, WhoNoticeTheRobotWalkAroundItWhenItStands) {
  for (const PeopleModel model : {PeopleModel::Speed, PeopleModel::Orca}) {
    const World world(with_people({passer_by()}), 0.05);
    FunctionMethod still = constant_method(0, 0);
    RunSetup setup = setup_of(1, model);
    setup.simulation.max_time = setup.simulation.stuck_time = 20;
    const SimulationResult result = simulate(world, setup, 1, still);
    EXPECT_EQ(result.outcome, Outcome::Timeout) << result.detail;
    EXPECT_LT(distance_between(result.movers.at(0).position(20), TPoint2D(2, 5)), 0.3);
  }
}

TEST(People, WhoNoticeTheRobotAreTouchedOnlyByARobotThatMoves) {
  const World world(busy_room().with_movers({}), 0.05);
  int contacts = 0;
  for (const PeopleModel model : {PeopleModel::Speed, PeopleModel::Orca})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      RunSetup setup = setup_of(1, model);
      RandomMethod random(setup.robot);
      const SimulationResult result = simulate(world, setup, seed, random);
      if (result.detail.find("contact with person") == std::string::npos) continue;
      ++contacts;
      EXPECT_NE(result.detail.find(", to blame: the robot, which was noticed"), std::string::npos)
          << result.detail;
      EXPECT_EQ(result.detail.find("had stood"), std::string::npos) << result.detail;
    }
  EXPECT_GT(contacts, 5);
}

TEST(People, AreScannedAndTracked) {
  // Seen from the standing robot: 3 - 0.3 - 1.25 t ahead.
  class Watcher : public Method {
   public:
    void reset(const NavigationTask&) override {}
    bool uses_tracks() const override { return true; }
    Command step(const Observation& o) override {
      EXPECT_NEAR(o.scan->getScanRange(90), 2.7 - 1.25 * o.time, 1e-5) << o.time;
      EXPECT_EQ(o.tracks->size(), 1U);
      EXPECT_EQ(o.tracks->at(0).id, 1) << "after the one mover, which is out of range";
      EXPECT_NEAR(o.tracks->at(0).position.x, 3 - 1.25 * o.time, 1e-9);
      EXPECT_NEAR(o.tracks->at(0).velocity.x, o.time > 0 ? -1.25 : 0, 1e-9);
      ++steps;
      return {};
    }
    int steps = 0;
  } watcher;
  RunSetup setup = setup_of(0);
  setup.sensor.rays = 181;
  setup.sensor.max_range = 8;
  setup.tracker.range = 4;
  const World world(
      with_people({passer_by()}).with_movers({{"post", 0.2, {{0, {0.5, 0.5}}}, MoverEnd::Stop}}),
      0.05);
  simulate(world, setup, 1, watcher);
  EXPECT_EQ(watcher.steps, 21);  // they touch at 2 s
}

TEST(People, HaveTracksWithTheVelocityOfTheirLastPeriodOrOfTheComingOne) {
  for (const bool intention : {false, true}) {
    std::vector<Track> tracks;  // in the axes of the world: the robot's heading is 0
    class Watcher : public FunctionMethod {
     public:
      using FunctionMethod::FunctionMethod;
      bool uses_tracks() const override { return true; }
    } watcher([&](const Observation& o) {
      tracks.push_back(o.tracks->at(0));
      return Command{};
    });
    const Person eve{"eve", 0.3, 1.25, {8, 8}, {{2, 8}}, 0, PersonEnd::Stay};
    const Person ben{"ben", 0.3, 1.25, {2, 7.9}, {{8, 8}}, 0, PersonEnd::Stay};
    RunSetup setup = setup_of(0, PeopleModel::Orca);
    setup.tracker.intention = intention;
    setup.simulation.max_time = 3;
    const double period = setup.simulation.control_period;
    ASSERT_EQ(setup.people.period, period);
    simulate(World(with_people({eve, ben}), 0.05), setup, 1, watcher);
    ASSERT_GT(tracks.size(), 20U);
    if (!intention) {
      EXPECT_EQ(tracks[0].velocity, TPoint2D(0, 0));
    }
    for (std::size_t k = 1; k < tracks.size(); ++k) {
      const TPoint2D moved = (tracks[k].position - tracks[k - 1].position) * (1 / period);
      EXPECT_NEAR((moved - tracks[intention ? k - 1 : k].velocity).norm(), 0, 1e-9) << k;
    }
  }
}

TEST(People, WaitUntilARobotThatTheyNoticeHasLeftTheirPlace) {
  Person here = passer_by();
  here.start = {4.8, 5};
  const World world(with_people({here}), 0.05);
  FunctionMethod ahead = constant_method(0.5, 0);
  const SimulationResult unseen = simulate(world, setup_of(0), 1, ahead);
  EXPECT_EQ(unseen.outcome, Outcome::UnsolvableScenario);
  EXPECT_EQ(unseen.detail, "person 'anna' touches the robot where it starts");
  RunSetup setup = setup_of(1);
  setup.simulation.max_time = 5;
  const SimulationResult seen = simulate(world, setup, 1, ahead);
  EXPECT_NE(seen.outcome, Outcome::UnsolvableScenario);
  // The centers are 0.5 m apart when the robot has gone ahead by 0.3 m.
  EXPECT_FALSE(seen.movers.at(0).present(0.5));
  EXPECT_TRUE(seen.movers.at(0).present(2));
}

TEST(People, WalkAgainAsTheyDidAlongARecordedTrajectory) {
  const World world(busy_room(), 0.05);
  int collisions = 0;
  double hindrance = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const RunSetup setup = setup_of(0.5, seed % 2 == 0 ? PeopleModel::Speed : PeopleModel::Orca);
    RandomMethod random(setup.robot);
    const SimulationResult result = simulate(world, setup, seed, random);
    Hindrances hindrances;
    EXPECT_EQ(movers_along(world, setup.robot, setup.simulation, result.trajectory, setup.people,
                           &hindrances),
              result.movers);
    EXPECT_EQ(hindrances, result.hindrances);
    for (const Hindrance& one : hindrances) hindrance += one.time;
    collisions += result.outcome == Outcome::Collision ? 1 : 0;
  }
  EXPECT_GT(collisions, 3);
  EXPECT_GT(hindrance, 1);
}

/// In a corridor of 1 m a robot of 0.2 m that stands at 5 m lets nobody of 0.3 m pass.
TEST(People, AreBehindWhereTheyWouldBeWithoutTheRobot) {
  const Person held_up{"anna", 0.3, 1.25, {1, 0.5}, {{9, 0.5}}, 0, PersonEnd::Stay};
  const Person in_front{"ben", 0.3, 1.25, {6, 0.5}, {{9.5, 0.5}}, 0, PersonEnd::Stay};
  const World world(Scenario::continuous("corridor", {0, 0, 10, 1}, {}, {5, 0.5, 0}, {9.7, 0.5})
                        .with_people({held_up, in_front}),
                    0.05);
  FunctionMethod still = constant_method(0, 0);
  RunSetup setup = setup_of(1);
  setup.simulation.max_time = 20;
  setup.simulation.stuck_time = 100;
  const SimulationResult result = simulate(world, setup, 1, still);
  ASSERT_EQ(result.outcome, Outcome::Timeout) << result.detail;
  // Alone anna is at her goal by then, but for the room that ben needs in front of it; now she is
  // before the robot.
  const double place = result.movers.at(0).position(20).x;
  EXPECT_LE(place, 5 - 0.2 - 0.3);
  PeopleAlone alone(world, setup.people);
  const double without = alone.covered(200)[0];
  EXPECT_GT(without, 7);
  EXPECT_NEAR(result.hindrances.at(0).deficit, (without - (place - 1)) / 1.25, 0.05);
  EXPECT_NEAR(result.hindrances.at(1).deficit, 0, 0.5) << "ben walks away from the robot";
  setup.people.notices = 0;
  for (const Hindrance& one : simulate(world, setup, 1, still).hindrances)
    EXPECT_EQ(one.deficit, 0);
}

TEST(People, ArriveLaterThanWithoutTheRobot) {
  // Carla walks 8 m at 1.25 m/s, up to the tolerance of 0.3 m; anna has to go around the robot.
  const Person carla{"carla", 0.3, 1.25, {1, 9}, {{9, 9}}, 0, PersonEnd::Stay};
  const World world(with_people({passer_by(), carla}), 0.05);
  FunctionMethod still = constant_method(0, 0);
  RunSetup setup = setup_of(1);
  setup.simulation.max_time = 2;
  for (const Hindrance& one : simulate(world, setup, 1, still).hindrances)
    EXPECT_FALSE(one.delay || one.delay_floor) << "they are not asked for";
  setup.people.until_arrival = 30;
  const SimulationResult result = simulate(world, setup, 1, still);
  const Hindrance &anna = result.hindrances.at(0), &other = result.hindrances.at(1);
  ASSERT_TRUE(anna.delay && other.delay);
  EXPECT_GT(*anna.delay, 0);
  EXPECT_LT(*anna.delay, 10);
  EXPECT_EQ(*other.delay, 0) << "out of reach of the robot";
  EXPECT_LE(*anna.delay_floor, setup.people.period) << "far from the other one";
  // A crowd with the robot where it stands arrives as late.
  Crowd crowd(world, world.scenario().people(), setup.people);
  const RobotDisc robot{{{5, 5}, {0, 0}, 0.2}, {true, true}};
  for (; !crowd.states()[0].arrival; crowd.move()) crowd.decide(robot);
  PeopleAlone alone(world, setup.people);
  EXPECT_EQ(*anna.delay, *crowd.states()[0].arrival - *alone.arrivals(30)[0]);
  Hindrances again;
  movers_along(world, setup.robot, setup.simulation, result.trajectory, setup.people, &again);
  EXPECT_EQ(again, result.hindrances);
  // Who does not arrive in time has none.
  setup.people.until_arrival = 0.1;
  EXPECT_FALSE(simulate(world, setup, 1, still).hindrances.at(0).delay);
}

TEST(People, AreNotHinderedByWhatARecordedTrajectoryDoesAfterTheRun) {
  const World world(with_people({passer_by()}), 0.05);
  const RunSetup setup = setup_of(1);
  FunctionMethod towards = constant_method(0.5, 0);
  const SimulationResult original = simulate(world, setup, 1, towards);
  ASSERT_EQ(original.outcome, Outcome::Collision) << "with the wall";
  EXPECT_GT(original.hindrances.at(0).time, 0);
  Trajectory log = original.trajectory;
  for (int k = 1; k <= 100; ++k) {
    Sample after = original.trajectory.samples.back();
    after.t += k;
    after.pose = {3, 5, 0};
    log.samples.push_back(after);
  }
  EXPECT_EQ(evaluate_trajectory(world, setup.robot, setup.simulation, log, setup.people).hindrances,
            original.hindrances);
}

TEST(People, EndARecordedTrajectoryWhereTheyEndedTheRun) {
  const World world(with_people({passer_by()}), 0.05);
  FunctionMethod ahead = constant_method(0.5, 0);
  const SimulationResult original = simulate(world, setup_of(0), 1, ahead);
  ASSERT_EQ(original.outcome, Outcome::Collision);
  Trajectory log = original.trajectory;
  Sample after = log.samples.back();
  after.t += 0.1;
  after.pose.x += 0.05;
  log.samples.push_back(after);
  const RunSetup setup = setup_of(0);
  const SimulationResult back =
      evaluate_trajectory(world, setup.robot, setup.simulation, log, setup.people);
  EXPECT_EQ(back.outcome, Outcome::Collision);
  EXPECT_NEAR(back.trajectory.duration(), original.trajectory.duration(), 1e-6);
  EXPECT_EQ(back.detail, original.detail);
  const SimulationResult noticed = evaluate_trajectory(world, setup.robot, setup.simulation, log);
  EXPECT_NE(noticed.outcome, Outcome::Collision) << "they walk around it";
}

TEST(People, OfOneCrowdAreTheSameInEachRun) {
  const World world(busy_room(), 0.05);
  const RunSetup setup = setup_of(1);
  PeopleAlone alone(world, setup.people);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    RandomMethod random(setup.robot);
    const SimulationResult result = simulate(world, setup, seed, random);
    const SimulationResult same = simulate(world, setup, seed, random, nullptr, &alone);
    EXPECT_EQ(same.movers, result.movers);
    EXPECT_EQ(same.trajectory.hash(), result.trajectory.hash());
    EXPECT_EQ(same.detail, result.detail);
  }
}

TEST(People, DecideAtTheBeginningOfControlCycles) {
  const World world(with_people({passer_by()}), 0.05);
  FunctionMethod still = constant_method(0, 0);
  RunSetup setup = setup_of(0);
  setup.simulation.control_period = 0.25;
  setup.simulation.step = 0.05;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "people",
                           {"0.1 s is not a multiple of the control period",
                            "expected a multiple of control_period (0.25 s)"},
                           [&] { simulate(world, setup, 1, still); }));
  EXPECT_NO_THROW(simulate(square_world({5, 5, 0}, {9, 9}), setup, 1, still));
  setup.people.period = 0.5;
  EXPECT_NEAR(simulate(world, setup, 1, still).trajectory.duration(), 2, 1e-9);
}

TEST(People, WhoStartInAWallAreRefused) {
  const World world(with_people({passer_by()}, {{{{8.4, 5}, 0.2}}, {}}), 0.05);
  FunctionMethod still = constant_method(0, 0);
  EXPECT_TRUE(throws_error(ErrorKind::File, "people: person 'anna'", {"starts in a wall"},
                           [&] { simulate(world, setup_of(0), 1, still); }));
}

}  // namespace
}  // namespace slalom::testing
