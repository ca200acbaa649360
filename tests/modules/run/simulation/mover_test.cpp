// SPDX-License-Identifier: BSD-3-Clause
#include "mover_contact.h"
#include "mover_tracker.h"
#include "test_runs.h"

#include <slalom/core/distance.h>
#include <slalom/references/earliest_arrival.h>
#include <slalom/references/exact_shortest.h>
#include <slalom/references/footprint_contact.h>
#include <slalom/simulation/evaluate_trajectory.h>
#include <slalom/simulation/mover_scan.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

using namespace testing;
using mrpt::math::TPose2D;

Mover mover_from(double x, double y, double vx, double vy, double radius = 0.3) {
  return {"m", radius, {{0, {x, y}}, {50, {x + 50 * vx, y + 50 * vy}}}, MoverEnd::Stop};
}

World world_with(const TPose2D& start, const Movers& movers) {
  const World empty = square_world(start, {9, 9});
  return {empty.scenario().with_movers(movers), 0.05};
}

RobotModel disc_robot() {
  RobotModel robot;
  robot.radius = 0.2;
  return robot;
}

TEST(MoverContact, IsAtTheTimeOfTheClosedForm) {
  // The gap of 2 - 0.5 m closes at 0.75 m/s: 2 s.
  const Movers head_on{mover_from(4, 2, -0.5, 0)};
  MoverContact contact(head_on, Footprint::disc(0.2));
  double fraction = 0;
  EXPECT_EQ(contact.find_contact({{2, 2, 0}, {3, 2, 0}, 0, 4}, fraction), &head_on[0]);
  EXPECT_NEAR(4 * fraction, 2, 1e-9);
  // Centers aside by 0.3 m: contact where they are sqrt(0.25 - 0.09) = 0.4 m apart along x.
  const Movers aside{mover_from(4, 2.3, -0.5, 0)};
  MoverContact oblique(aside, Footprint::disc(0.2));
  EXPECT_NE(oblique.find_contact({{2, 2, 0}, {3, 2, 0}, 0, 4}, fraction), nullptr);
  EXPECT_NEAR(4 * fraction, 1.6 / 0.75, 1e-9);
}

TEST(MoverContact, IsFoundWithMoversThatGetFasterIfTheSpeedWasStated) {
  // It waits 2 m away, then comes at 5 m/s.
  const auto find = [](double added_speed) {
    Movers movers{{"m", 0.3, {{0, {4, 2}}, {1, {4, 2}}}}};
    MoverContact contact(movers, Footprint::disc(0.2), added_speed);
    double fraction = 0;
    EXPECT_EQ(contact.find_contact({{2, 2, 0}, {2, 2, 0}, 0, 1}, fraction), nullptr);
    movers[0].waypoints.push_back({2, {-1, 2}});
    const bool found = contact.find_contact({{2, 2, 0}, {2, 2, 0}, 1, 2}, fraction) != nullptr;
    EXPECT_NEAR(found ? fraction : 0.3, (2 - 0.5) / 5, 1e-9);
    return found;
  };
  EXPECT_TRUE(find(5));
  EXPECT_FALSE(find(0)) << "speeds of the waypoints that there are";
}

TEST(MoverContact, EqualsADenseSearchForRandomMotions) {
  RandomEngine random(3);
  int contacts = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto position = [&] {
      return mrpt::math::TPoint2D(uniform_real(random, -1.5, 1.5), uniform_real(random, -1.5, 1.5));
    };
    const Movers movers{{"m", 0.3, {{0, position()}, {0.7, position()}, {1.6, position()}}}};
    const TPose2D from(position().x, position().y, 0), to(position().x, position().y, 0);
    MoverContact contact(movers, Footprint::disc(0.2));
    double fraction = 1, expected = 2;
    const bool found = contact.find_contact({from, to, 0, 2}, fraction) != nullptr;
    for (int i = 0; i <= 20000 && expected > 1; ++i) {
      const TPose2D pose = interpolate(from, to, i / 20000.0);
      const auto center = movers[0].position(2 * i / 20000.0);
      if (std::hypot(pose.x - center.x, pose.y - center.y) < 0.5) expected = i / 20000.0;
    }
    contacts += found ? 1 : 0;
    // The search may miss a touch that is shorter than its step, and never invents one.
    if (expected <= 1) {
      EXPECT_TRUE(found) << trial;
      EXPECT_NEAR(fraction, expected, 1.001 / 20000) << trial;
    }
    if (found && expected > 1) {
      const TPose2D pose = interpolate(from, to, fraction);
      const auto center = movers[0].position(2 * fraction);
      EXPECT_NEAR(std::hypot(pose.x - center.x, pose.y - center.y), 0.5, 1e-9) << trial;
    }
  }
  EXPECT_GT(contacts, 100);
}

TEST(MoverContact, OfAPolygonIsWhereItsOutlineMeetsTheDisc) {
  // The front at 0.4 m: the gap of 2 - 0.7 m closes at 1 m/s.
  const Movers movers{mover_from(4, 2, -0.5, 0)};
  MoverContact contact(movers, Footprint::parse("0.4,0.2; -0.4,0.2; -0.4,-0.2; 0.4,-0.2"));
  double fraction = 0;
  EXPECT_NE(contact.find_contact({{2, 2, 0}, {4, 2, 0}, 0, 4}, fraction), nullptr);
  EXPECT_NEAR(4 * fraction, 1.3, 1e-5);
  // Turned by a quarter, the front is the side at 0.2 m.
  MoverContact turned(movers, Footprint::parse("0.4,0.2; -0.4,0.2; -0.4,-0.2; 0.4,-0.2"));
  EXPECT_NE(turned.find_contact({{2, 2, M_PI / 2}, {4, 2, M_PI / 2}, 0, 4}, fraction), nullptr);
  EXPECT_NEAR(4 * fraction, 1.5, 1e-5);
}

TEST(MoverContact, OfAConcavePolygonIsBetweenItsArms) {
  // The disc of 0.3 m fits between the arms, 0.8 m apart: it meets the body at 0.1 m, not the tips
  // at 0.9 m. The gap of 2 - 0.4 m closes at 1 m/s.
  const Movers movers{mover_from(4, 2, -0.5, 0)};
  MoverContact contact(movers,
                       Footprint::parse("0.9,0.5; 0.9,0.4; 0.1,0.4; 0.1,-0.4; 0.9,-0.4; 0.9,-0.5; "
                                        "-0.2,-0.5; -0.2,0.5"));
  double fraction = 0;
  EXPECT_NE(contact.find_contact({{2, 2, 0}, {4, 2, 0}, 0, 4}, fraction), nullptr);
  EXPECT_NEAR(4 * fraction, 1.6, 1e-5);
}

TEST(MoverContact, ConcernsOnlyMoversThatArePresent) {
  Mover late = mover_from(2, 2, 0, 0);
  late.waypoints = {{1, {2, 2}}, {3, {2, 2}}};
  late.after = MoverEnd::Vanish;
  const Movers movers{late};
  const Footprint robot = Footprint::disc(0.2);
  double fraction = 0;
  const TPose2D there(2, 2, 0);
  EXPECT_EQ(MoverContact(movers, robot).find_contact({there, there, 0, 1}, fraction), nullptr);
  EXPECT_NE(MoverContact(movers, robot).find_contact({there, there, 0, 2}, fraction), nullptr);
  EXPECT_NEAR(fraction, 0.5, 1e-12);  // it appears
  EXPECT_EQ(MoverContact(movers, robot).find_contact({there, there, 3, 9}, fraction), nullptr);
}

TEST(Movers, EndARunAtTheExactTimeAndPlace) {
  // The robot stands; the mover reaches it after (3 - 0.5) / 1.25 s = 2 s.
  const World world = world_with({5, 5, 0}, {mover_from(8, 5, -1.25, 0)});
  FunctionMethod still = constant_method(0, 0);
  const SimulationResult result = run(world, still, {}, disc_robot());
  EXPECT_EQ(result.outcome, Outcome::Collision);
  EXPECT_NEAR(result.trajectory.samples.back().t, 2, 1e-9);
  EXPECT_EQ(result.detail,
            "contact with moving obstacle 'm' at (5.00, 5.00) m after 2.00 s, the robot had stood "
            "for 0.5 s");
}

TEST(Movers, AreToldFromWallsInTheDetail) {
  const World world = world_with({5, 5, 0}, {mover_from(7, 5, 0, 0)});
  FunctionMethod ahead = constant_method(0.5, 0);
  RobotModel robot = disc_robot();
  const SimulationResult hit = run(world, ahead, {}, robot);
  EXPECT_EQ(hit.outcome, Outcome::Collision);
  EXPECT_NEAR(hit.trajectory.samples.back().pose.x, 6.5, 1e-8);  // 7 - 0.3 - 0.2
  EXPECT_NE(hit.detail.find("contact with moving obstacle 'm' at (6.50, 5.00) m"),
            std::string::npos);
  EXPECT_NE(hit.detail.find(", the robot at 0.50 m/s"), std::string::npos);
  const SimulationResult wall = run(square_world({5, 5, 0}, {9, 9}), ahead, {}, robot);
  EXPECT_EQ(wall.detail.find("mover"), std::string::npos);
}

TEST(Movers, ThatTouchTheStartMakeAScenarioUnsolvable) {
  FunctionMethod still = constant_method(0, 0);
  const SimulationResult result =
      run(world_with({5, 5, 0}, {mover_from(5.4, 5, 1, 0)}), still, {}, disc_robot());
  EXPECT_EQ(result.outcome, Outcome::UnsolvableScenario);
  EXPECT_EQ(result.detail, "moving obstacle 'm' touches the robot where it starts");
  const SimulationResult beside =
      run(world_with({5, 5, 0}, {mover_from(5.6, 5, 1, 0)}), still, {}, disc_robot());
  EXPECT_NE(beside.outcome, Outcome::UnsolvableScenario);
}

TEST(Movers, EndARecordedTrajectoryWhereTheyEndedTheRun) {
  const World world = world_with({5, 5, 0}, {mover_from(8, 5.1, -0.5, 0)});
  FunctionMethod ahead = constant_method(0.5, 0);
  const SimulationResult original = run(world, ahead, {}, disc_robot());
  ASSERT_EQ(original.outcome, Outcome::Collision);
  Trajectory log = original.trajectory;
  Sample after = log.samples.back();
  after.t += 0.1;
  after.pose.x += 0.05;
  log.samples.push_back(after);
  const SimulationResult back = evaluate_trajectory(world, disc_robot(), {}, log);
  EXPECT_EQ(back.outcome, Outcome::Collision);
  EXPECT_NEAR(back.trajectory.samples.back().t, original.trajectory.samples.back().t, 1e-6);
  EXPECT_EQ(back.detail, original.detail);
}

/// The range to a disc by a fine search along the ray.
double searched_range(const TPose2D& pose, double angle, const Mover& mover, double t,
                      double max_range) {
  for (double s = 0; s < max_range; s += 1e-3) {
    const auto center = mover.position(t);
    if (std::hypot(pose.x + s * std::cos(pose.phi + angle) - center.x,
                   pose.y + s * std::sin(pose.phi + angle) - center.y) <= mover.radius)
      return s;
  }
  return max_range;
}

TEST(MoverScan, EqualsASearchAlongEveryRay) {
  RandomEngine random(5);
  for (const double aperture : {M_PI / 2, M_PI, 1.5 * M_PI, 2 * M_PI}) {
    const ScanGeometry geometry{61, aperture, 4};
    for (int trial = 0; trial < 12; ++trial) {
      const Movers movers{mover_from(uniform_real(random, -3, 3), uniform_real(random, -3, 3),
                                     uniform_real(random, -1, 1), uniform_real(random, -1, 1),
                                     uniform_real(random, 0.1, 0.8))};
      const TPose2D pose(0.1, -0.2, uniform_real(random, -3, 3));
      std::vector<float> ranges(61, 4.0F);
      MoverScan(movers, geometry).add_to(pose, 0.5, ranges.data());
      for (int i = 0; i < geometry.count; ++i) {
        const double expected = searched_range(pose, geometry.angle(i), movers[0], 0.5, 4);
        const double range = ranges[static_cast<std::size_t>(i)];
        if (expected < 4 || range >= 4) {
          EXPECT_NEAR(range, expected, 1.1e-3) << trial << " " << i;
        } else {  // the search missed a chord that is shorter than its step
          const double angle = pose.phi + geometry.angle(i);
          const mrpt::math::TPoint2D hit(pose.x + range * std::cos(angle),
                                         pose.y + range * std::sin(angle));
          EXPECT_NEAR(distance_between(hit, movers[0].position(0.5)), movers[0].radius, 1e-5);
        }
      }
    }
  }
}

TEST(MoverScan, IsInClosedForm) {
  // Straight ahead at 3 - 0.5 m; a ray at angle a meets the disc at 3 cos a - sqrt(0.25 - 9 sin^2
  // a).
  const ScanGeometry geometry{5, 0.2, 8};
  const Movers movers{mover_from(3, 0, 0, 0, 0.5)};
  std::vector<float> ranges{8, 1, 8, 8, 8};
  MoverScan(movers, geometry).add_to({0, 0, 0}, 0, ranges.data());
  const auto expected = [](double a) {
    return 3 * std::cos(a) - std::sqrt(0.25 - 9 * std::sin(a) * std::sin(a));
  };
  EXPECT_FLOAT_EQ(ranges[0], static_cast<float>(expected(0.1)));
  EXPECT_EQ(ranges[1], 1);  // a wall is nearer
  EXPECT_FLOAT_EQ(ranges[2], 2.5F);
  EXPECT_FLOAT_EQ(ranges[3], static_cast<float>(expected(0.05)));
  EXPECT_FLOAT_EQ(ranges[4], static_cast<float>(expected(0.1)));
}

TEST(MoverScan, IsZeroWithinAMoverAndUnchangedByAbsentOnes) {
  Mover gone = mover_from(0.2, 0, 0, 0, 0.5);
  gone.after = MoverEnd::Vanish;
  const Movers movers{gone};
  const ScanGeometry geometry{3, M_PI, 8};
  std::vector<float> ranges(3, 8.0F);
  const MoverScan scan(movers, geometry);
  scan.add_to({0, 0, 0}, 51, ranges.data());
  EXPECT_EQ(ranges, std::vector<float>(3, 8.0F));
  scan.add_to({0, 0, 0}, 50, ranges.data());
  EXPECT_EQ(ranges, std::vector<float>(3, 0.0F));
}

TEST(Movers, AreScannedWhereTheyWereAtTheInstantOfTheScan) {
  // Towards the standing robot at 1 m/s, seen 0.3 s late: 3 - 0.3 - (t - 0.3).
  for (const double latency : {0.0, 0.3}) {
    SensorModel sensor;
    sensor.rays = 181;
    sensor.latency = latency;
    sensor.max_range = 8;
    FunctionMethod method([&](const Observation& o) {
      const double t = std::max(0.0, o.time - latency);
      EXPECT_NEAR(o.scan->getScanRange(90), 2.7 - t, 1e-5) << o.time;
      return Command{0, 0};
    });
    SimulationOptions options;
    options.max_time = 1.5;
    simulate(world_with({5, 5, 0}, {mover_from(8, 5, -1, 0)}),
             {disc_robot(), sensor, {}, options, {}}, 1, method);
  }
}

TEST(MoverContact, IsNotFoundAlongThePlanOfTheEarliestArrival) {
  RandomEngine random(7);
  int waits = 0, arrivals = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const auto position = [&] {
      return mrpt::math::TPoint2D(uniform_real(random, 2, 8), uniform_real(random, 2, 8));
    };
    Movers movers;
    for (int i = 0; i < 12; ++i) {
      const mrpt::math::TPoint2D first = position();
      const MoverEnd after = i % 2 == 0 ? MoverEnd::Loop : MoverEnd::Vanish;
      movers.push_back({std::to_string(i), 0.3, {{0, first}, {5, position()}, {9, first}}, after});
    }
    const World world = world_with({1, 1, 0}, movers);
    const PlanningProblem problem{world, 0.2, {1, 1}, world.scenario().goal()};
    std::string reason;
    const auto shortest = exact_shortest_path(problem, reason);
    const auto arrival = earliest_arrival(problem, *shortest, {1, 0.2, 60}, reason);
    ASSERT_TRUE(arrival.has_value()) << reason;
    MoverContact contact(movers, Footprint::disc(0.2));
    const auto footprint = make_footprint_contact(world, Footprint::disc(0.2));
    for (std::size_t i = 1; i < arrival->plan.size(); ++i) {
      const auto &a = arrival->plan[i - 1], &b = arrival->plan[i];
      TPose2D from(a.position.x, a.position.y, 0), to(b.position.x, b.position.y, 0);
      double fraction = 1;
      ASSERT_EQ(contact.find_contact({from, to, a.t, b.t}, fraction), nullptr) << trial << " " << i;
      ASSERT_FALSE(footprint->find_contact(from, to, fraction)) << trial << " " << i;
      waits += distance_between(from, to) == 0 ? 1 : 0;
    }
    arrivals += arrival->plan.empty() ? 0 : 1;
  }
  EXPECT_GT(arrivals, 15);
  EXPECT_GT(waits, 3);
}

TEST(MoverTracker, MeasuresInTheRobotFrame) {
  const Movers movers{mover_from(9, 9, 0, 0), mover_from(4, 2, -0.5, 0), mover_from(2, 10.5, 1, 0)};
  MoverTracker tracker(movers, {}, 1);
  // From (2, 2) with heading +y: x forward is +y, y left is -x. The first one is 9.9 m away.
  const std::vector<Track>& tracks = tracker.sense({2, 2, M_PI / 2}, 1);
  ASSERT_EQ(tracks.size(), 1U) << "the others are beyond 8 m";
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_NEAR(tracks[0].position.x, 0, 1e-12);
  EXPECT_NEAR(tracks[0].position.y, -1.5, 1e-12);
  EXPECT_NEAR(tracks[0].velocity.x, 0, 1e-12);
  EXPECT_NEAR(tracks[0].velocity.y, 0.5, 1e-12);
  EXPECT_EQ(tracks[0].radius, 0.3);
  TrackerModel wide;
  wide.range = 20;
  EXPECT_EQ(MoverTracker(movers, wide, 1).sense({2, 2, M_PI / 2}, 1).size(), 3U);
}

TEST(MoverTracker, OmitsMoversThatAreAbsent) {
  Mover late = mover_from(2, 2, 0, 0);
  late.waypoints = {{1, {2, 2}}, {3, {2, 2}}};
  late.after = MoverEnd::Vanish;
  const Movers movers{late};
  MoverTracker tracker(movers, {}, 1);
  EXPECT_EQ(tracker.sense({2, 3, 0}, 0.5).size(), 0U);
  EXPECT_EQ(tracker.sense({2, 3, 0}, 2).size(), 1U);
  EXPECT_EQ(tracker.sense({2, 3, 0}, 3.5).size(), 0U);
}

TEST(MoverTracker, AddsNoiseOfTheConfiguredDeviationAndDropouts) {
  const Movers movers{mover_from(4, 2, -0.5, 0)};
  const TrackerModel model{8, 0.1, 0.2, 0.25, 0};
  MoverTracker tracker(movers, model, 5), again(movers, model, 5);
  constexpr int kCycles = 8000;
  double squares[4] = {};
  int n = 0;
  for (int i = 0; i < kCycles; ++i) {
    const std::vector<Track>& tracks = tracker.sense({2, 2, 0}, 0);
    const std::vector<Track>& same = again.sense({2, 2, 0}, 0);
    ASSERT_EQ(tracks.size(), same.size()) << "the same seed";
    if (tracks.empty()) continue;
    EXPECT_EQ(tracks[0].position, same[0].position);
    const double errors[] = {tracks[0].position.x - 2, tracks[0].position.y,
                             tracks[0].velocity.x + 0.5, tracks[0].velocity.y};
    for (int k = 0; k < 4; ++k) squares[k] += errors[k] * errors[k];
    ++n;
  }
  // A deviation's own deviation is sigma / sqrt(2 n): four of it.
  for (int k = 0; k < 4; ++k) {
    const double sigma = k < 2 ? 0.1 : 0.2;
    EXPECT_NEAR(std::sqrt(squares[k] / n), sigma, 4 * sigma / std::sqrt(2.0 * n)) << k;
  }
  EXPECT_NEAR(n, 0.75 * kCycles, 4 * std::sqrt(0.25 * 0.75 * kCycles));
}

/// The tracks of each cycle of a run at 0.5 m/s along x, for a method that declares them.
class TrackingMethod : public Method {
 public:
  explicit TrackingMethod(bool declares) : declares_(declares) {}
  void reset(const NavigationTask&) override {}
  Command step(const Observation& o) override {
    EXPECT_EQ(o.tracks != nullptr, declares_);
    if (o.tracks != nullptr && !o.tracks->empty()) distances.push_back(o.tracks->at(0).position.x);
    return {0.5, 0};
  }
  bool uses_tracks() const override { return declares_; }
  std::vector<double> distances;

 private:
  bool declares_;
};

TEST(Tracks, AreGivenToMethodsThatDeclareThem) {
  const World world = world_with({2, 5, 0}, {mover_from(8, 5, -0.5, 0)});
  RunSetup setup;
  setup.robot = disc_robot();
  setup.simulation.max_time = 3;
  TrackingMethod with(true), without(false), late(true);
  const SimulationResult result = simulate(world, setup, 1, with);
  EXPECT_EQ(simulate(world, setup, 1, without).trajectory.hash(), result.trajectory.hash());
  ASSERT_EQ(with.distances.size(), 30U);
  for (std::size_t i = 0; i < 30; ++i) {
    const double t = 0.1 * static_cast<double>(i);
    EXPECT_NEAR(with.distances[i], 8 - 0.5 * t - result.trajectory.samples[i].pose.x, 1e-9);
  }
  // Tracks of 0.2 s age are those of two cycles before.
  setup.tracker.latency = 0.2;
  simulate(world, setup, 1, late);
  for (std::size_t i = 2; i < 30; ++i) EXPECT_NEAR(late.distances[i], with.distances[i - 2], 1e-9);
}

}  // namespace
}  // namespace slalom
