// SPDX-License-Identifier: BSD-3-Clause
#include "common/motion.h"
#include "dwa_local_planner/footprint.h"
#include "dwa_local_planner/jackal.h"
#include "dwa_local_planner/oscillation.h"
#include "dwa_local_planner/recovery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dwa_local_planner {
namespace {

using reactive::Costmap;
using reactive::Inflation;
using reactive::Point;
using reactive::Pose;
using reactive::Robot;
using reactive::RollingMemory;

TEST(Footprint, IsThePaddedPolygonOrA16CornerDisc) {
  const Footprint footprint(jackal(), 0.01);
  EXPECT_NEAR(footprint.inscribed_radius(), 0.175, 1e-12);
  EXPECT_NEAR(footprint.circumscribed_radius(), std::hypot(0.22, 0.175), 1e-12);
  const Footprint larger = footprint.scaled(2);
  EXPECT_NEAR(larger.inscribed_radius(), 0.35, 1e-12);
  const Footprint disc(Robot(), 0);
  EXPECT_NEAR(disc.circumscribed_radius(), 0.25, 1e-12);
  EXPECT_NEAR(disc.inscribed_radius(), 0.25 * std::cos(M_PI / 16), 1e-12);
}

TEST(Footprint, HasTheHighestCostUnderItsOutline) {
  // Against all points of the outline, 1 mm apart, with a tolerance of a cell for the line of
  // cells.
  const Footprint footprint(jackal(), 0);
  std::vector<Point> points;
  for (int i = 0; i < 40; ++i) points.push_back({2 * std::sin(3.1 * i), 2 * std::cos(1.7 * i)});
  const Costmap map = costmap_of(points);
  int touching = 0, costly = 0;
  for (int i = 0; i < 300; ++i) {
    const Pose pose{1.5 * std::sin(2.3 * i), 1.5 * std::cos(5.9 * i), 0.7 * i};
    int low = 0, high = 0;
    const auto corners = jackal().footprint;
    for (std::size_t k = 0; k < 4; ++k) {
      const Point a = reactive::to_world(pose, corners[k]);
      const Point b = reactive::to_world(pose, corners[(k + 1) % 4]);
      for (double f = 0; f <= 1; f += 0.002) {
        const Point p{a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)};
        for (const double dx : {-0.05, 0.0, 0.05})
          for (const double dy : {-0.05, 0.0, 0.05})
            high = std::max<int>(high, map.cost(Point{p.x + dx, p.y + dy}));
      }
      low = std::max<int>(low, map.cost(a));
    }
    const int cost = footprint.cost(map, pose);
    ASSERT_GE(cost, low) << i;
    ASSERT_LE(cost, high) << i;
    touching += cost == Inflation::kLethal ? 1 : 0;
    costly += cost > 0 ? 1 : 0;
  }
  EXPECT_GT(touching, 20);
  EXPECT_GT(costly, touching + 20);
}

TEST(Footprint, OfARectangleFitsWhereItsDiscDoesNot) {
  // A corridor 0.44 m wide: obstacle cells 0.2 m and more to both sides.
  std::vector<Point> points;
  for (double x = -1; x < 1; x += 0.05)
    for (const double y : {-0.23, 0.23}) points.push_back({x, y});
  const Costmap map = costmap_of(points);
  EXPECT_LT(Footprint(jackal(), 0.01).cost(map, {0, 0, 0}), Inflation::kLethal);
  EXPECT_EQ(Footprint(jackal(), 0.01).cost(map, {0, 0, 0.5 * M_PI}), Inflation::kLethal)
      << "across";
  Robot disc;
  disc.radius = jackal().radius;
  EXPECT_EQ(Footprint(disc, 0.01).cost(map, {0, 0, 0}), Inflation::kLethal);
}

TEST(OscillationCritic, AllowsOneReversalUntilTheRobotHasMoved) {
  OscillationCritic critic(0.05, 0.2, 0.1);
  critic.commanded({0, 0.5}, {});
  EXPECT_TRUE(critic.allows({0, -0.5}));
  critic.commanded({0, -0.5}, {});
  EXPECT_FALSE(critic.allows({0, 0.5}));
  EXPECT_TRUE(critic.allows({0.3, 0}));
  critic.commanded({0, -0.5}, {0, 0, -0.15});
  EXPECT_FALSE(critic.allows({0, 0.5}));
  critic.commanded({0, -0.5}, {0, 0, -0.21});
  EXPECT_TRUE(critic.allows({0, 0.5})) << "turned by 0.2 rad";
  critic.commanded({0.3, 0}, {});
  critic.commanded({-0.3, 0}, {});
  EXPECT_FALSE(critic.allows({0.3, 0}));
  critic.commanded({-0.3, 0}, {-0.06, 0, 0});
  EXPECT_TRUE(critic.allows({0.3, 0})) << "moved by 0.05 m";
}

TEST(Recovery, RunsTheBehaviorsOfMoveBaseInTheirOrder) {
  Parameters parameters = limited_parameters();
  parameters.backup_allowed = true;
  Robot robot = jackal();
  robot.forward_only = false;
  const Footprint footprint(robot, 0);
  Recovery recovery(parameters, robot, footprint);
  const Costmap map = costmap_of({});
  RollingMemory memory(10, 0.05);
  memory.update({}, std::vector<double>(181, 2.0), {});  // a half circle of 2 m
  EXPECT_FALSE(recovery.step(map, {}));
  // Clears what is outside of a square of 3 m.
  recovery.start({}, memory);
  EXPECT_FALSE(recovery.step(map, {}));
  EXPECT_FALSE(memory.points().empty());
  for (const Point& p : memory.points()) EXPECT_LE(std::max(std::abs(p.x), std::abs(p.y)), 1.5);
  // A turn.
  recovery.start({}, memory);
  Pose pose;
  double turned = 0;
  for (int i = 0; i < 200; ++i) {
    const auto command = recovery.step(map, pose);
    if (!command) break;
    EXPECT_EQ(command->v, 0);
    pose = reactive::integrate(pose, *command, 0.1);
    turned += command->w * 0.1;
  }
  EXPECT_NEAR(turned, 2 * M_PI, 0.15);
  // Back.
  recovery.start({}, memory);
  pose = {};
  for (int i = 0; i < 100; ++i) {
    const auto command = recovery.step(map, pose);
    if (!command) break;
    pose = reactive::integrate(pose, *command, 0.1);
  }
  EXPECT_NEAR(pose.x, -0.3, 0.011);
  // Clears what is outside of a square of four times the circumscribed radius, 0.267 m.
  memory.update({}, std::vector<double>(181, 1.0), {});
  recovery.start({}, memory);
  EXPECT_FALSE(recovery.step(map, {}));
  EXPECT_TRUE(memory.points().empty());
  recovery.start({}, memory);
  EXPECT_GT(recovery.step(map, {})->w, 0) << "another turn";
}

TEST(Recovery, DoesNotTurnOrBackUpIntoAnObstacle) {
  Parameters parameters = limited_parameters();
  parameters.backup_allowed = true;
  Robot robot = jackal();
  robot.forward_only = false;
  RollingMemory memory(10, 0.05);
  Recovery recovery(parameters, robot, Footprint(robot, 0));
  const Costmap map = costmap_of({{0, 0.23}, {-0.35, 0}});
  for (int i = 0; i < 5; ++i) {
    recovery.start({}, memory);
    EXPECT_FALSE(recovery.step(map, {})) << i;
  }
  // A robot that cannot reverse does not back up, one without recovery does nothing.
  Recovery forward(parameters, jackal(), Footprint(jackal(), 0));
  parameters.recovery_behavior_enabled = 0;
  Recovery none(parameters, robot, Footprint(robot, 0));
  for (int i = 0; i < 10; ++i) {
    forward.start({}, memory);
    const auto command = forward.step(costmap_of({}), {});
    EXPECT_EQ(command ? command->v : 0, 0);
    none.start({}, memory);
    EXPECT_FALSE(none.step(costmap_of({}), {}));
  }
}

}  // namespace
}  // namespace dwa_local_planner
