// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <slalom/metrics/mover_metrics.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace slalom::testing {
namespace {

using mrpt::math::TPoint2D;

constexpr double kMoverRadius = 0.3, kReach = 0.25 + kMoverRadius;  // the robot's radius: 0.25 m

/// From `from` at 0 s straight to `to` at `seconds`.
Mover walker(const TPoint2D& from, const TPoint2D& to, double seconds,
             MoverEnd after = MoverEnd::Stop) {
  return {"walker", kMoverRadius, {{0, from}, {seconds, to}}, after};
}

/// A robot that stands at (4, 5) for 20 s, sampled `hz` times per second.
struct StandingRun : MeasuredRun {
  explicit StandingRun(Movers movers, double hz = 10) : MeasuredRun(Path{}, {}, named(movers)) {
    for (int i = 0; i <= std::lround(20 * hz); ++i) {
      Sample sample;
      sample.t = i / hz;
      sample.pose = {4, 5, 0};
      trajectory.samples.push_back(sample);
    }
  }
  static const Movers& named(Movers& movers) {
    for (std::size_t i = 0; i < movers.size(); ++i) movers[i].id = std::to_string(i);
    return movers;
  }
};

TEST(MoverMetrics, AreNaWithoutMovers) {
  const MeasuredRun run({{2, 5}, {8, 5}});
  for (const std::string& id : mover_metric_ids())
    EXPECT_EQ(run.reason(id), "no moving obstacles") << id;
}

TEST(MoverMetrics, AreTheLastOfTheTableWithThoseAboutPeople) {
  std::vector<std::string> ids = mover_metric_ids();
  ids.insert(ids.end(), people_metric_ids().begin(), people_metric_ids().end());
  ASSERT_LT(ids.size(), all_metrics().size());
  for (std::size_t i = 0; i < ids.size(); ++i)
    EXPECT_EQ(ids[i], all_metrics()[all_metrics().size() - ids.size() + i].info.id);
}

TEST(ArrivalRatio, IsTheTimeOverTheLowerBoundOfTheEarliestArrival) {
  StandingRun run({walker({1, 1}, {1, 2}, 20)});  // for 20 s
  run.references.arrival = EarliestArrival{{8, 10}, {}};
  EXPECT_DOUBLE_EQ(run.number("arrival_ratio"), 20.0 / 8);
  run.references.arrival->certificate.lower_bound = 0;
  EXPECT_EQ(run.reason("arrival_ratio"), "the start is in the goal region");
  run.references.arrival.reset();
  EXPECT_EQ(run.reason("arrival_ratio"), "the earliest arrival was not computed");
  run.references.arrival_reason = "there is none";
  EXPECT_EQ(run.reason("arrival_ratio"), "there is none");
  run.references.shortest.reset();
  run.references.shortest_reason = "no path";
  EXPECT_EQ(run.reason("arrival_ratio"), "no path");
  run.outcome = Outcome::Timeout;
  EXPECT_EQ(run.reason("arrival_ratio"), "outcome: timeout");
}

TEST(BoundViolation, IsARunThatIsFasterThanTheEarliestArrival) {
  StandingRun run({walker({1, 1}, {1, 2}, 20)});
  run.trajectory.samples.front().pose = {2, 5, 0};  // to (4, 5), and 4 m remain of 6
  const auto violation = [&](double earliest) {
    run.references.arrival = EarliestArrival{{earliest, 30}, {}};
    return bound_violation(make_metric_context(run.world, run.robot, run.trajectory, run.outcome,
                                               run.references, 60, 0.2));
  };
  EXPECT_EQ(violation(20), "");
  EXPECT_EQ(
      violation(20.5),
      "the run is faster than possible: 20 s, earliest arrival among the moving obstacles 20.5 s");
}

TEST(PersonalSpaceTime, IsThatOfTheChordThroughTheSpace) {
  // Passes at a distance h of the centers, with 0.8 m/s.
  for (const double h : {0.6, 0.9, 1.1, 1.5}) {
    for (const double hz : {1.0, 10.0, 3.7}) {
      const StandingRun run({walker({-4, 5 + h}, {12, 5 + h}, 20)}, hz);
      const double personal = kReach + 1.2, intimate = kReach + 0.45;
      EXPECT_NEAR(run.number("personal_space_time"),
                  2 * std::sqrt(personal * personal - h * h) / 0.8, 1e-9);
      EXPECT_NEAR(run.number("intimate_space_time"),
                  h < intimate ? 2 * std::sqrt(intimate * intimate - h * h) / 0.8 : 0, 1e-9);
      EXPECT_NEAR(run.number("personal_space_depth"), 1.2 - (h - kReach), 1e-9);
      EXPECT_NEAR(run.number("min_mover_clearance"), h - kReach, 1e-9);
    }
  }
}

TEST(PersonalSpaceTime, CountsTheTimeOfTwoMoversOnce) {
  const Mover one = walker({-4, 6}, {12, 6}, 20), other = walker({-4, 4}, {12, 4}, 20);
  const double alone = StandingRun({one}).number("personal_space_time");
  EXPECT_NEAR(StandingRun({one, other}).number("personal_space_time"), alone, 1e-9);
  // The second follows 2 s behind: it enters while the first is near.
  Mover later = other;
  for (Waypoint& waypoint : later.waypoints) waypoint.t += 2;
  EXPECT_NEAR(StandingRun({one, later}).number("personal_space_time"), alone + 2, 1e-9);
}

TEST(PersonalSpaceTime, IsZeroFarFromMovers) {
  const StandingRun run({walker({-9, 1}, {-9, 9}, 20)});
  EXPECT_EQ(run.number("personal_space_time"), 0);
  EXPECT_EQ(run.number("personal_space_depth"), 0);
  EXPECT_EQ(run.reason("mover_time_to_collision"), "never on a collision course");
}

TEST(PersonalSpaceTime, IsThatInWhichTheMoverIsPresent) {
  // Waits at 1 m from 3 s on, and vanishes at 7.25 s.
  const Mover guest{"guest", kMoverRadius, {{3, {4, 6}}, {7.25, {4, 6}}}, MoverEnd::Vanish};
  EXPECT_NEAR(StandingRun({guest}).number("personal_space_time"), 4.25, 1e-9);
  const Mover late{"late", kMoverRadius, {{21, {4, 6}}}, MoverEnd::Stop};
  EXPECT_EQ(StandingRun({late}).number("personal_space_time"), 0);
  EXPECT_EQ(StandingRun({late}).reason("min_mover_clearance"), "no mover was present");
}

TEST(PersonalSpaceTime, FollowsEveryRoundOfALoop) {
  // To and fro between 0.3 m and 2.3 m from the robot with 0.5 m/s: within 1.2 m for 0.9 m of the
  // way there and of the way back in each round of 8 s; the rounds begin nearest to the robot.
  const Mover pacing{"pacing",
                     kMoverRadius,
                     {{0, {4, 5.3 + kReach}}, {4, {4, 7.3 + kReach}}, {8, {4, 5.3 + kReach}}},
                     MoverEnd::Loop};
  EXPECT_NEAR(StandingRun({pacing}).number("personal_space_time"), 2.5 * 3.6, 1e-9);
}

TEST(MoverTimeToCollision, IsTheGapOverTheClosingSpeed) {
  // The robot at 1 m/s along x, the mover at 0.5 m/s towards it; nearest at the last sample.
  MeasuredRun run({{2, 5}, {2.1, 5}}, {}, {walker({8, 5}, {3, 5}, 10)});
  for (Sample& sample : run.trajectory.samples) sample.v = 1;
  EXPECT_NEAR(run.number("mover_time_to_collision"), (7.95 - 2.1 - kReach) / 1.5, 1e-9);
}

TEST(MoverTimeToCollision, OfAMoverInFrontAtTheSameSpeedIsNa) {
  MeasuredRun run({{2, 5}, {2.1, 5}}, {}, {walker({4, 5}, {14, 5}, 10)});
  for (Sample& sample : run.trajectory.samples) sample.v = 1;
  EXPECT_EQ(run.reason("mover_time_to_collision"), "never on a collision course");
}

double any_number(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6;
}

RC_GTEST_PROP(MoverTimeToCollision, IsTheFirstTimeAtWhichTheyTouch, ()) {
  const TPoint2D from(any_number(-9, 17), any_number(1, 9)),
      to(any_number(-9, 17), any_number(1, 9));
  MeasuredRun run({{4, 5}}, {}, {walker(from, to, 8)});
  RC_PRE(std::hypot(from.x - 4, from.y - 5) > kReach);
  Sample& sample = run.trajectory.samples[0];
  sample.pose.phi = any_number(-M_PI, M_PI);
  sample.v = any_number(-1, 1);
  sample.vy = any_number(-1, 1);
  const double c = std::cos(sample.pose.phi), s = std::sin(sample.pose.phi);
  const TPoint2D velocity(sample.v * c - sample.vy * s, sample.v * s + sample.vy * c);
  const auto gap = [&](double t) {
    const TPoint2D d = TPoint2D(4, 5) + velocity * t - (from + (to - from) * (t / 8));
    return std::hypot(d.x, d.y) - kReach;
  };
  const double found = run.number("mover_time_to_collision");
  const double until = std::isnan(found) ? 100 : found;
  for (int i = 0; i < 1000; ++i) RC_ASSERT(gap(i * until / 1000) > -1e-9);
  if (!std::isnan(found)) RC_ASSERT(std::abs(gap(found)) < 1e-8);
}

/// A run downward at 0.6 m/s that ends as a collision.
struct MoverCrash : MeasuredRun {
  explicit MoverCrash(const Mover& mover, const TPoint2D& end = {4, 1.5})
      : MeasuredRun({end + TPoint2D(0, 0.06), end}, {}, {mover}) {
    outcome = Outcome::Collision;
    for (Sample& sample : trajectory.samples) {
      sample.pose.phi = -M_PI / 2;
      sample.v = 0.6;
    }
  }
};

TEST(MoverCollision, IsAttributedToWhatIsAtTheRobot) {
  const MoverCrash at_mover(walker({4, 1.5 - kReach}, {4, 1.5 - kReach}, 1));
  EXPECT_EQ(at_mover.number("mover_collision"), 1);
  EXPECT_EQ(at_mover.number("contact_mover"), 0);
  EXPECT_NEAR(at_mover.number("mover_contact_speed"), 0.6, 1e-12);
  EXPECT_EQ(at_mover.number("stood_at_contact"), 0);
  EXPECT_EQ(at_mover.reason("impact_speed"), "contact with a mover");
  // The same mover, but the robot ends at the wall.
  const MoverCrash at_wall(walker({4, 3}, {4, 3}, 1), {4, 0.25});
  EXPECT_EQ(at_wall.number("mover_collision"), 0);
  EXPECT_EQ(at_wall.reason("mover_contact_speed"), "contact with a static obstacle");
  EXPECT_NEAR(at_wall.number("impact_speed"), 0.6, 1e-9);
}

TEST(MoverCollision, IsNotThatOfAMoverThatIsAbsent) {
  const TPoint2D place(4, 1.5 - kReach);
  EXPECT_EQ(MoverCrash(walker(place, place, 0.05, MoverEnd::Vanish)).number("mover_collision"), 0);
}

TEST(MoverCollision, IsZeroWithoutACollisionAndNaWithoutAVerdict) {
  MoverCrash run(walker({4, 1.5 - kReach}, {4, 1.5 - kReach}, 1));
  run.outcome = Outcome::Timeout;
  EXPECT_EQ(run.number("mover_collision"), 0);
  EXPECT_EQ(run.reason("mover_contact_speed"), "outcome: timeout");
  run.outcome = Outcome::InfrastructureError;
  EXPECT_EQ(run.reason("mover_collision"), "outcome: infrastructure_error");
}

TEST(MoverCollision, OfAPolygonIsThatOfItsOutline) {
  // Its front is 0.5 m ahead, its side 0.2 m: a mover 0.8 m ahead touches, one at the side does
  // not.
  const auto collision = [](const TPoint2D& mover) {
    MoverCrash run(walker(mover, mover, 1));
    run.robot.footprint = "0.5,0.2; -0.5,0.2; -0.5,-0.2; 0.5,-0.2";
    return run.number("mover_collision");
  };
  EXPECT_EQ(collision({4, 0.7}), 1);
  EXPECT_EQ(collision({6.5, 1.5}), 0);  // 2 m from its side; the wall is 1 m from its front
}

TEST(ContactMover, IsTheIndexOfTheNearestMoverInTheScenario) {
  const Mover aside = walker({1, 8}, {1, 8}, 1);
  StandingRun run({aside, aside, walker({10, 5}, {4 + kReach, 5}, 20)});
  EXPECT_EQ(run.reason("contact_mover"), "outcome: success");
  run.outcome = Outcome::Collision;
  EXPECT_EQ(run.number("contact_mover"), 2);
  run.trajectory.samples.back().pose = {4, 0.25, 0};
  EXPECT_EQ(run.reason("contact_mover"), "contact with a static obstacle");
}

TEST(StoodAtContact, IsOneIfTheMoverRanIntoTheRobot) {
  StandingRun run({walker({10, 5}, {4 + kReach, 5}, 20)});
  run.outcome = Outcome::Collision;
  EXPECT_EQ(run.number("mover_collision"), 1);
  EXPECT_EQ(run.number("stood_at_contact"), 1);
  EXPECT_EQ(run.number("mover_contact_speed"), 0);
}

TEST(FrozenTime, IsThatStoppedWhileAMoverIsNear) {
  // At rest for 20 s; the mover is nearer than 3.6 m + kReach = 4.15 m for 2 * 4.15 m at 1 m/s.
  // Each of the samples every 0.01 s represents 0.01 s.
  const StandingRun run({walker({-6, 5}, {14, 5}, 20)}, 100);
  EXPECT_NEAR(run.number("frozen_time"), 8.3, 0.02);
  StandingRun moving({walker({-6, 5}, {14, 5}, 20)}, 100);
  for (Sample& sample : moving.trajectory.samples) sample.v = 0.5;
  EXPECT_EQ(moving.number("frozen_time"), 0);
}

}  // namespace
}  // namespace slalom::testing
