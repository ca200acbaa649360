// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/distance.h>
#include <slalom/generation/walkers.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace slalom {
namespace {

/// A room of 10 m x 8 m with posts.
Scenario posts(std::uint64_t seed, int count) {
  RandomEngine engine(seed);
  Primitives obstacles;
  for (int i = 0; i < count; ++i) {
    const double x = uniform_real(engine, 2, 9);
    obstacles.discs.push_back({{x, uniform_real(engine, 1, 7)}, uniform_real(engine, 0.1, 0.6)});
  }
  return Scenario::continuous("posts", {0, 0, 10, 8}, obstacles, {1, 4, 0}, {9.5, 4});
}

/// From the border and from the discs, as they are, not as cells.
double clearance(const Scenario& scenario, const mrpt::math::TPoint2D& at) {
  const Bounds& b = scenario.bounds();
  double least = std::min({at.x - b.x_min, b.x_max - at.x, at.y - b.y_min, b.y_max - at.y});
  for (const Disc& disc : scenario.primitives().discs)
    least = std::min(least, distance_between(at, disc.center) - disc.radius);
  return least;
}

RC_GTEST_PROP(WalkersProperty, KeepOffWallsAndTheStartAtAllTimes, ()) {
  const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(1, 1'000'000));
  const World world(posts(seed, *rc::gen::inRange(0, 12)), 0.05);
  WalkerOptions options;
  options.count = *rc::gen::inRange(1, 6);
  options.max_radius = 0.2 + *rc::gen::inRange(0, 20) / 100.0;
  options.max_speed = 0.3 + *rc::gen::inRange(0, 300) / 100.0;
  RandomEngine engine(seed), same(seed);
  const Movers walkers = sample_walkers(world, 0.25, options, engine);
  RC_ASSERT(walkers == sample_walkers(world, 0.25, options, same));
  RC_ASSERT(world.scenario().with_movers(walkers).movers().size() ==
            static_cast<std::size_t>(options.count));
  for (const Mover& walker : walkers) {
    RC_ASSERT(walker.radius >= options.min_radius && walker.radius <= options.max_radius);
    RC_ASSERT(distance_between(walker.position(0), mrpt::math::TPoint2D(1, 4)) >=
              walker.radius + 0.25 + 1);
    const double end = walker.waypoints.back().t;
    for (double t = 0; t < 2.5 * end; t += 0.037) {
      RC_ASSERT(walker.present(t));
      RC_ASSERT(clearance(world.scenario(), walker.position(t)) >= walker.radius);
      const auto velocity = walker.velocity(t);
      const double speed = std::hypot(velocity.x, velocity.y);
      RC_ASSERT(speed > options.min_speed - 1e-9 && speed < options.max_speed + 1e-9);
    }
  }
}

TEST(Walkers, EachDependsOnlyOnThoseBeforeIt) {
  const World world(posts(7, 5), 0.05);
  WalkerOptions options;
  options.count = 3;
  RandomEngine engine(4), same(4);
  const Movers three = sample_walkers(world, 0.25, options, engine);
  options.count = 2;
  EXPECT_EQ(sample_walkers(world, 0.25, options, same), Movers(three.begin(), three.begin() + 2));
}

TEST(Walkers, WithoutRoomAreAnErrorThatNamesTheScenario) {
  const World world(posts(7, 5), 0.05);
  WalkerOptions options;
  options.count = 1;
  options.min_radius = options.max_radius = 4;  // half the height of the room
  EXPECT_TRUE(throws_error(ErrorKind::Job, "posts: no path for a walker of radius 4.00 m",
                           {"smaller walkers"}, [&] {
                             RandomEngine engine(1);
                             sample_walkers(world, 0.25, options, engine);
                           }));
}

}  // namespace
}  // namespace slalom
