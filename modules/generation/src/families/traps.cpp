// SPDX-License-Identifier: BSD-3-Clause
#include "family.h"

#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/generation/traps.h>

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

class TrapLayout {
 public:
  TrapLayout(RandomEngine& engine, const TrapsOptions& options, const StartGoal& start_goal)
      : engine_(engine), options_(options), start_goal_(start_goal) {}

  std::vector<Trap> draw() {
    const int count = uniform_int(engine_, options_.min_traps, options_.max_traps);
    for (int i = 0; i < count; ++i) add_trap(i == 0);
    return std::move(traps_);
  }

 private:
  void add_trap(bool on_line) {
    constexpr int kTries = 60;
    for (int i = 0; i < kTries; ++i) {
      const Trap trap = draw_one(on_line);
      if (!fits(trap)) continue;
      traps_.push_back(trap);
      return;
    }
  }

  Trap draw_one(bool on_line) {
    Trap trap;
    const bool dead_end = uniform_real(engine_, 0, 1) < options_.dead_end_fraction;
    trap.depth = uniform_real(engine_, options_.min_depth, options_.max_depth) * (dead_end ? 2 : 1);
    const double opening = uniform_real(engine_, options_.min_opening, options_.max_opening);
    trap.opening = dead_end ? options_.dead_end_width : opening;
    const double along = uniform_real(engine_, 0, 1);
    const TPoint2D line_point(
        start_goal_.start.x + along * (start_goal_.goal.x - start_goal_.start.x),
        start_goal_.start.y + along * (start_goal_.goal.y - start_goal_.start.y));
    const TPoint2D anywhere{uniform_real(engine_, 0, options_.width),
                            uniform_real(engine_, 0, options_.height)};  // braces: x is drawn first
    trap.center = on_line ? line_point : anywhere;
    const double turn = mrpt::DEG2RAD(options_.max_turn_deg);
    trap.direction =
        math::atan2(start_goal_.start.y - trap.center.y, start_goal_.start.x - trap.center.x) +
        uniform_real(engine_, -turn, turn);
    return trap;
  }

  bool fits(const Trap& trap) const {
    const double radius = bounding_radius(trap, options_.wall);
    const auto apart = [&](const TPoint2D& p, double min_gap) {
      return distance_between(trap.center, p) >= radius + min_gap;
    };
    const double clear = options_.start_goal.clear_radius;
    return apart(start_goal_.start, clear) && apart(start_goal_.goal, clear) &&
           std::all_of(traps_.begin(), traps_.end(), [&](const Trap& other) {
             return apart(other.center, bounding_radius(other, options_.wall) + options_.gap);
           });
  }

  RandomEngine& engine_;
  const TrapsOptions& options_;
  const StartGoal& start_goal_;
  std::vector<Trap> traps_;
};

class TrapsGenerator : public Generator {
 public:
  explicit TrapsGenerator(const TrapsOptions& options) : options_(options) {}

  std::string name() const override { return "traps"; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const Bounds workspace = {0, 0, options_.width, options_.height};
    const StartGoal start_goal = sample_start_goal(engine, workspace, options_.start_goal);
    Primitives walls;
    for (const Trap& trap : sample_traps(engine, options_, start_goal))
      walls.polygons.push_back(outline(trap, options_.wall));
    const auto start = start_pose(engine, start_goal);
    return Scenario::continuous(scenario_name, workspace, std::move(walls), start, start_goal.goal);
  }

 private:
  TrapsOptions options_;
};

}  // namespace

Polygon outline(const Trap& trap, double wall) {
  // In the frame of the trap: x toward the opening, origin at the center of the bounding rectangle.
  const double x = (trap.depth + wall) / 2, inner = trap.opening / 2, outer = inner + wall;
  const double corners[][2] = {{-x, -outer},       {x, -outer}, {x, -inner}, {-x + wall, -inner},
                               {-x + wall, inner}, {x, inner},  {x, outer},  {-x, outer}};
  const double c = math::cos(trap.direction), s = math::sin(trap.direction);
  Polygon polygon;
  for (const auto& corner : corners)
    polygon.vertices.emplace_back(trap.center.x + c * corner[0] - s * corner[1],
                                  trap.center.y + s * corner[0] + c * corner[1]);
  return polygon;
}

double bounding_radius(const Trap& trap, double wall) {
  return math::hypot((trap.depth + wall) / 2, trap.opening / 2 + wall);
}

std::vector<Trap> sample_traps(RandomEngine& engine, const TrapsOptions& options,
                               const StartGoal& start_goal) {
  return TrapLayout(engine, options, start_goal).draw();
}

void TrapsOptions::visit(OptionVisitor& v) {
  v.option("width", width, "m", "width of the workspace", Range::positive());
  v.option("height", height, "m", "height of the workspace", Range::positive());
  v.option("min_traps", min_traps, "-", "minimum number of traps", Range::between(0, 1000));
  v.option("max_traps", max_traps, "-", "maximum number of traps", Range::between(0, 1000));
  v.option("min_depth", min_depth, "m", "minimum inside depth; twice for dead ends",
           Range::positive());
  v.option("max_depth", max_depth, "m", "maximum inside depth; twice for dead ends",
           Range::positive());
  v.option("min_opening", min_opening, "m", "minimum inside width of a U", Range::positive());
  v.option("max_opening", max_opening, "m", "maximum inside width of a U", Range::positive());
  v.option("dead_end_fraction", dead_end_fraction, "-", "fraction of traps that are dead ends",
           Range::between(0, 1));
  v.option("dead_end_width", dead_end_width, "m", "inside width of a dead end", Range::positive());
  v.option("wall", wall, "m", "thickness of walls", Range::positive());
  v.option("max_turn_deg", max_turn_deg, "deg",
           "maximum angle between a trap's opening and the start", Range::between(0, 180));
  v.option("gap", gap, "m", "minimum gap between traps", Range::at_least(0));
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const TrapsOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(TrapsOptions::kFamily, context);
  const auto options = checks.scaled(given);
  checks.expect_order("min_traps", options.min_traps, "max_traps", options.max_traps);
  checks.expect_order("min_depth", options.min_depth, "max_depth", options.max_depth);
  checks.expect_order("min_opening", options.min_opening, "max_opening", options.max_opening);
  checks.expect_start_goal_fit(options.start_goal, options.width, options.height);
  return std::make_unique<TrapsGenerator>(options);
}

}  // namespace slalom
