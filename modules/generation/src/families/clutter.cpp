// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scenario.h"
#include "load_windows.h"

#include <slalom/generation/clutter.h>

namespace slalom {
namespace {

void occupy(const Primitives& obstacles, Occupancy& cells) {
  const Bounds bounds = cells.bounds();
  const mrpt::math::TPoint2D corner(bounds.x_min, bounds.y_min);
  const Scenario scenario =
      Scenario::continuous("obstacles", bounds, obstacles, {corner.x, corner.y, 0}, corner);
  const Occupancy touched = make_occupancy(scenario, cells.resolution());
  for (int y = 0; y < cells.size_y(); ++y)
    for (int x = 0; x < cells.size_x(); ++x)
      if (touched.occupied(x, y)) cells.set_occupied(x, y, true);
}

class Clutter : public Generator {
 public:
  Clutter(const ClutterOptions& options, MapWindows windows)
      : options_(options), windows_(std::move(windows)) {}

  std::string name() const override { return "clutter"; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    Occupancy window = windows_.draw(engine);
    const DistanceField field(window);
    const Bounds bounds = window.bounds();
    const double clear_radius = options_.start_goal.clear_radius;
    const StartGoal start_goal = sample_start_goal(engine, bounds, options_.start_goal,
                                                   clearance_filter(field, clear_radius));
    // A cell is occupied if an obstacle touches it, so obstacles grow by up to a cell's diagonal.
    const double cell_diagonal = window.resolution() * 1.5;
    occupy(scatter_obstacles(engine, options_.obstacles, bounds, start_goal,
                             clear_radius + cell_diagonal,
                             [&](const auto& p) { return field.clearance(p) > 0; }),
           window);
    return grid_scenario(scenario_name, window, start_pose(engine, start_goal), start_goal.goal);
  }

 private:
  ClutterOptions options_;
  MapWindows windows_;
};

}  // namespace

void ClutterOptions::visit(OptionVisitor& v) {
  window.visit(v);
  obstacles.visit(v);
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const ClutterOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(ClutterOptions::kFamily, context);
  const auto options = checks.scaled(given);
  checks.expect_valid(options.obstacles);
  return std::make_unique<Clutter>(options,
                                   load_windows(checks, options.window, options.start_goal));
}

}  // namespace slalom
