// SPDX-License-Identifier: BSD-3-Clause
#include "family.h"

#include <slalom/generation/random_generator.h>

namespace slalom {
namespace {

class RandomGenerator : public Generator {
 public:
  explicit RandomGenerator(const RandomGeneratorOptions& options) : options_(options) {}

  std::string name() const override { return "random"; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const Bounds workspace = {0, 0, options_.width, options_.height};
    const StartGoal start_goal = sample_start_goal(engine, workspace, options_.start_goal);
    Primitives obstacles = scatter_obstacles(engine, options_.obstacles, workspace, start_goal,
                                             options_.start_goal.clear_radius);
    const auto start = start_pose(engine, start_goal);
    return Scenario::continuous(scenario_name, workspace, std::move(obstacles), start,
                                start_goal.goal);
  }

 private:
  RandomGeneratorOptions options_;
};

}  // namespace

void RandomGeneratorOptions::visit(OptionVisitor& v) {
  v.option("width", width, "m", "width of the workspace", Range::positive());
  v.option("height", height, "m", "height of the workspace", Range::positive());
  obstacles.visit(v);
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const RandomGeneratorOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(RandomGeneratorOptions::kFamily, context);
  const auto options = checks.scaled(given);
  checks.expect_valid(options.obstacles);
  checks.expect_start_goal_fit(options.start_goal, options.width, options.height);
  return std::make_unique<RandomGenerator>(options);
}

}  // namespace slalom
