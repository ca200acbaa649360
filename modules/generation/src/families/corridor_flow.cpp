// SPDX-License-Identifier: BSD-3-Clause
#include "family.h"

#include <slalom/generation/corridor_flow.h>

#include <algorithm>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

class CorridorFlowGenerator : public Generator {
 public:
  CorridorFlowGenerator(std::string family, const CorridorFlowOptions& options, bool is_oncoming)
      : family_(std::move(family)), options_(options), is_oncoming_(is_oncoming) {}

  std::string name() const override { return family_; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const double width = uniform_real(engine, options_.min_width, options_.max_width);
    const Bounds corridor = {0, 0, options_.length, width};
    // Each in its outer part, as far apart as min_distance requires.
    const double part = (options_.length - options_.start_goal.min_distance) / 2;
    const StartGoal ends =
        sample_start_goal(engine, {0, 0, part, width},
                          {options_.length - part, 0, options_.length, width}, options_.start_goal);
    const auto start = start_pose(engine, ends);
    Movers movers = sample_movers(
        engine, options_.movers, MoverEnd::Vanish, ends.start, options_.start_goal.clear_radius,
        [&](double radius, double speed) { return walk(engine, ends, width, radius, speed); },
        options_.people);
    return with_moving(Scenario::continuous(scenario_name, corridor, {}, start, ends.goal),
                       std::move(movers), options_.people);
  }

 private:
  /// From anywhere ahead of the robot to one end of the corridor, not quite along it.
  std::vector<Waypoint> walk(RandomEngine& engine, const StartGoal& ends, double width,
                             double radius, double speed) const {
    const double m = radius + kWallMargin, far = options_.length - m;
    const double nearest = ends.start.x + options_.start_goal.clear_radius + radius;
    const double farthest = is_oncoming_ ? far : std::min(far, ends.goal.x);
    if (nearest > farthest) return {};
    const double x = uniform_real(engine, nearest, farthest);
    const double y = uniform_real(engine, m, width - m);
    const TPoint2D end{is_oncoming_ ? m : far, uniform_real(engine, m, width - m)};
    return walk_along({{x, y}, end}, speed);
  }

  std::string family_;
  CorridorFlowOptions options_;
  bool is_oncoming_;
};

template <typename Options>
std::unique_ptr<Generator> make_flow(const Options& given, const GeneratorContext& context,
                                     bool is_oncoming) {
  const FamilyChecks checks(Options::kFamily, context);
  const Options options = checks.scaled(given);
  checks.expect_order("min_width", options.min_width, "max_width", options.max_width);
  checks.expect_valid(options.movers);
  checks.expect_movers_fit(options.movers, options.min_width);
  const auto& s = options.start_goal;
  checks.expect(s.min_distance + 4 * s.margin <= options.length && 2 * s.margin < options.min_width,
                "min_distance", "start and goal cannot be min_distance apart within the margins",
                "a longer corridor or smaller min_distance and margin");
  return std::make_unique<CorridorFlowGenerator>(Options::kFamily, options, is_oncoming);
}

}  // namespace

void CorridorFlowOptions::visit(OptionVisitor& v) {
  v.option("length", length, "m", "length of the corridor", Range::positive());
  v.option("min_width", min_width, "m", "minimum width of the corridor", Range::positive());
  v.option("max_width", max_width, "m", "maximum width of the corridor", Range::positive());
  movers.visit(v);
  v.option("people", people, "moving obstacles are people, who react");
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const OncomingOptions& options,
                                          const GeneratorContext& context) {
  return make_flow(options, context, true);
}

std::unique_ptr<Generator> make_generator(const OvertakingOptions& options,
                                          const GeneratorContext& context) {
  return make_flow(options, context, false);
}

}  // namespace slalom
