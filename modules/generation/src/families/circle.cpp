// SPDX-License-Identifier: BSD-3-Clause
#include "family.h"

#include <slalom/core/math.h>
#include <slalom/generation/circle.h>

#include <mrpt/core/bits_math.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

class CircleGenerator : public Generator {
 public:
  explicit CircleGenerator(const CircleOptions& options) : options_(options) {}

  std::string name() const override { return CircleOptions::kFamily; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const double radius = uniform_real(engine, options_.min_circle, options_.max_circle);
    const double side = 2 * (options_.max_circle + options_.start_goal.margin);
    const TPoint2D center{side / 2, side / 2};
    const auto at = [&](double angle) {
      return center + TPoint2D{math::cos(angle), math::sin(angle)} * radius;
    };
    const double angle = uniform_real(engine, -M_PI, M_PI);
    const StartGoal ends = {at(angle), at(angle + M_PI)};
    const auto start = start_pose(engine, ends);
    Movers movers = sample_movers(engine, options_.movers, MoverEnd::Stop, ends.start,
                                  options_.start_goal.clear_radius, [&](double, double speed) {
                                    return walk_along({ends.goal, ends.start}, speed);
                                  });
    spread(engine, angle, at, movers);
    return Scenario::continuous(scenario_name, {0, 0, side, side}, {}, start, ends.goal)
        .with_movers(std::move(movers));
  }

 private:
  /// All paths are equally long, so only their ends differ, which depend on the number of movers.
  template <typename PositionAt>
  void spread(RandomEngine& engine, double robot, const PositionAt& at, Movers& movers) const {
    const double step = 2 * M_PI / static_cast<double>(movers.size() + 1);
    const double shift = std::min(mrpt::DEG2RAD(options_.max_shift_deg), step / 4);
    for (std::size_t i = 0; i < movers.size(); ++i) {
      const double angle =
          robot + step * static_cast<double>(i + 1) + uniform_real(engine, -shift, shift);
      movers[i].waypoints.front().position = at(angle);
      movers[i].waypoints.back().position = at(angle + M_PI);
    }
  }

  CircleOptions options_;
};

}  // namespace

void CircleOptions::visit(OptionVisitor& v) {
  v.option("min_circle", min_circle, "m", "minimum radius of the circle", Range::positive());
  v.option("max_circle", max_circle, "m", "maximum radius of the circle", Range::positive());
  v.option("max_shift_deg", max_shift_deg, "deg",
           "maximum shift of a moving obstacle along the circle", Range::between(0, 180));
  movers.visit(v);
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const CircleOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(CircleOptions::kFamily, context);
  const auto options = checks.scaled(given);
  checks.expect_order("min_circle", options.min_circle, "max_circle", options.max_circle);
  checks.expect_valid(options.movers);
  checks.expect(2 * options.min_circle >= options.start_goal.min_distance, "min_distance",
                "start and goal cannot be min_distance apart on the circle",
                "at most twice min_circle");
  checks.expect(options.movers.max_radius + kWallMargin <= options.start_goal.margin, "max_radius",
                "moving obstacles would touch the border", "at least 0.05 m less than margin");
  // The nearest mover of the largest number, shifted by a quarter of its step.
  const double nearest =
      2 * options.min_circle * math::sin(0.375 * 2 * M_PI / (options.movers.max_movers + 1));
  checks.expect(nearest >= options.movers.max_radius + options.start_goal.clear_radius,
                "max_movers", "moving obstacles would be within clear_radius of the start",
                "fewer moving obstacles or a larger circle");
  return std::make_unique<CircleGenerator>(options);
}

}  // namespace slalom
