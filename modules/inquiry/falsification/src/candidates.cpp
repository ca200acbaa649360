// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/scenario_sources.h>
#include <slalom/core/error.h>
#include <slalom/falsification/candidates.h>
#include <slalom/generation/maze.h>
#include <slalom/generation/poisson_forest.h>
#include <slalom/generation/random_generator.h>
#include <slalom/generation/rooms.h>
#include <slalom/generation/scene.h>
#include <slalom/generation/traps.h>

#include <algorithm>

namespace slalom {
namespace {

RandomGeneratorOptions random_room(double side, int min_obstacles, int max_obstacles) {
  RandomGeneratorOptions options;
  options.width = options.height = side;
  options.obstacles.min_obstacles = min_obstacles;
  options.obstacles.max_obstacles = max_obstacles;
  options.start_goal.min_distance = side / 2;
  return options;
}

PoissonForestOptions forest(double side, double spacing) {
  PoissonForestOptions options;
  options.width = options.height = side;
  options.spacing = spacing;
  options.start_goal.min_distance = side / 2;
  return options;
}

MazeOptions maze(double passage) {
  MazeOptions options;
  options.columns = options.rows = 6;
  options.passage = passage;
  options.start_goal.min_distance = 4;
  return options;
}

RoomsOptions rooms() {
  RoomsOptions options;
  options.width = 12;
  options.height = 10;
  options.door_width = 0.9;
  return options;
}

TrapsOptions traps() {
  TrapsOptions options;
  options.width = 12;
  options.height = 8;
  options.start_goal.min_distance = 6;
  return options;
}

/// Whether start and goal have the clearance that judge_geometry() requires at least, by the
/// obstacles themselves: occupied cells only come closer. It costs much less.
bool may_be_fair(const Scenario& scenario, double radius, const FairnessOptions& fairness) {
  const double needed = radius * fairness.min_bottleneck;
  const mrpt::math::TPoint2D start(scenario.start().x, scenario.start().y);
  const double at_start = std::max(needed, radius + fairness.min_start_clearance);
  const Scene scene(scenario);
  return std::none_of(scene.obstacles.begin(), scene.obstacles.end(), [&](const auto& obstacle) {
    return distance(start, obstacle) < at_start || distance(scenario.goal(), obstacle) < needed;
  });
}

/// The world with the walkers and people of the setup; null if there is no room for one. They have
/// random streams of their own: the static obstacles are those of a search without them.
std::unique_ptr<World> populated(const FalsificationSetup& setup, std::unique_ptr<World> world,
                                 std::uint64_t seed, std::uint64_t index) {
  if (setup.walkers.count == 0 && setup.people.count == 0) return world;
  const double radius = setup.run.robot.shape().enclosing_radius();
  RandomEngine walkers(derive_seed(seed, "walkers", index));
  RandomEngine people(derive_seed(seed, "people", index));
  try {
    const Scenario walked = with_walkers(*world, radius, setup.walkers, walkers);
    return std::make_unique<World>(
        walked.with_people(sample_people(*world, radius, setup.people, people)),
        setup.run.simulation.resolution);
  } catch (const Error&) {
    return nullptr;
  }
}

/// "walkers", "people", both or none.
std::string moving_ones(const FalsificationSetup& setup) {
  if (setup.people.count == 0) return setup.walkers.count == 0 ? "" : "walkers";
  return setup.walkers.count == 0 ? "people" : "walkers and people";
}

}  // namespace

CandidateMix::CandidateMix(const RobotModel& robot)
    : scale_(robot.shape().enclosing_radius() / kUnscaledRadius) {
  GeneratorContext context;
  context.length_scale = scale_;
  families_.push_back(make_generator(random_room(8, 4, 20), context));
  families_.push_back(make_generator(random_room(12, 6, 40), context));
  families_.push_back(make_generator(forest(8, 1.6), context));
  families_.push_back(make_generator(forest(10, 1.2), context));
  families_.push_back(make_generator(maze(1.2), context));
  families_.push_back(make_generator(maze(0.9), context));
  families_.push_back(make_generator(rooms(), context));
  families_.push_back(make_generator(traps(), context));
}

Scenario CandidateMix::draw(RandomEngine& engine) const {
  if (uniform_int(engine, 0, 1) == 0) return draw_micro_world(engine, scale_);
  const int family = uniform_int(engine, 0, static_cast<int>(families_.size()) - 1);
  const Generator& generator = *families_[static_cast<std::size_t>(family)];
  return generator.generate(generator.name(), engine);
}

std::unique_ptr<World> draw_fair_world(const CandidateMix& mix, const FalsificationSetup& setup,
                                       const FairnessOptions& fairness, std::uint64_t seed,
                                       std::uint64_t index) {
  constexpr int kMaxAttempts = 1000;
  RandomEngine engine(derive_seed(seed, "candidate", index));
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    Scenario drawn = mix.draw(engine);
    if (!may_be_fair(drawn, setup.run.robot.shape().enclosing_radius(), fairness)) continue;
    auto world = std::make_unique<World>(std::move(drawn), setup.run.simulation.resolution);
    if (!has_fair_geometry(*world, setup.run.robot, fairness)) continue;
    world = populated(setup, std::move(world), seed, index);
    if (world) return world;
  }
  const std::string who = moving_ones(setup);
  throw job_error("search",
                  "none of " + std::to_string(kMaxAttempts) +
                      " random scenarios meets the geometric conditions" +
                      (who.empty() ? "" : " and has room for the " + who),
                  "weaker conditions" + (who.empty() ? "" : ", or fewer or smaller " + who));
}

}  // namespace slalom
