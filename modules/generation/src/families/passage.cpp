// SPDX-License-Identifier: BSD-3-Clause
#include "straight_path_family.h"
#include "walls.h"

#include <slalom/generation/passage.h>

#include <algorithm>

namespace slalom {
namespace {

class PassageGenerator : public Generator {
 public:
  explicit PassageGenerator(const PassageOptions& options) : options_(options) {}

  std::string name() const override { return PassageOptions::kFamily; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const PassageOptions& o = options_;
    const double width = uniform_real(engine, o.min_width, o.max_width);
    // The gap is anywhere relative to the cells of grids.
    const double axis = uniform_real(engine, o.height / 4, 3 * o.height / 4);
    const double distance = uniform_real(engine, o.min_start_distance, o.max_start_distance);
    const double side = sample_side(engine);
    const double offset = side * uniform_real(engine, o.min_offset, o.max_offset);
    const double angle = sample_angle(engine, o.angle);
    const double left = (o.length - o.wall) / 2, right = (o.length + o.wall) / 2;
    Primitives walls;
    walls.polygons = {rectangle(left, 0, right, axis - width / 2),
                      rectangle(left, axis + width / 2, right, o.height)};
    const mrpt::math::TPose2D start{left - distance, axis + offset, angle};
    const double goal = std::max(right + distance, start.x + o.start_goal.min_distance);
    return Scenario::continuous(scenario_name, {0, 0, o.length, o.height}, std::move(walls), start,
                                {goal, axis});
  }

 private:
  PassageOptions options_;
};

}  // namespace

void PassageOptions::visit(OptionVisitor& v) {
  v.option("length", length, "m", "length of the workspace, across the wall", Range::positive());
  v.option("height", height, "m", "height of the workspace, along the wall", Range::positive());
  v.option("min_width", min_width, "m", "minimum clear width of the gap", Range::positive());
  v.option("max_width", max_width, "m", "maximum clear width of the gap", Range::positive());
  v.option("wall", wall, "m", "thickness of the wall", Range::positive());
  v.option("min_start_distance", min_start_distance, "m",
           "minimum distance of the start from the wall", Range::positive());
  v.option("max_start_distance", max_start_distance, "m",
           "maximum distance of the start from the wall", Range::positive());
  v.option("min_offset", min_offset, "m", "minimum distance of the start from the gap's axis",
           Range::at_least(0));
  v.option("max_offset", max_offset, "m", "maximum distance of the start from the gap's axis",
           Range::at_least(0));
  angle.visit(v);
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const PassageOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(PassageOptions::kFamily, context);
  const auto o = checks.scaled(given);
  checks.expect_order("min_width", o.min_width, "max_width", o.max_width);
  checks.expect_order("min_start_distance", o.min_start_distance, "max_start_distance",
                      o.max_start_distance);
  checks.expect_order("min_offset", o.min_offset, "max_offset", o.max_offset);
  expect_valid(checks, o.angle);
  checks.expect(o.max_width < o.height / 2, "max_width", "leaves no wall beside the gap",
                "less than half of height");
  checks.expect_start_goal_fit(o.start_goal, o.length, o.height);
  const double room = o.length / 2 - o.start_goal.margin;  // m, on each side of the wall's center
  checks.expect(o.start_goal.min_distance <= room + o.wall / 2 + o.min_start_distance,
                "min_distance", "start and goal cannot be min_distance apart within the margins",
                "at most " + format_number(room + o.wall / 2 + o.min_start_distance));
  checks.expect(o.max_start_distance + o.wall / 2 <= room, "max_start_distance",
                "places the start outside the margins",
                "at most " + format_number(room - o.wall / 2));
  checks.expect(o.max_offset + o.start_goal.margin <= o.height / 4, "max_offset",
                "places the start outside the margins", "a quarter of height less margin");
  checks.expect(o.start_goal.clear_radius <= o.min_start_distance, "clear_radius",
                "reaches the wall", "at most min_start_distance");
  return std::make_unique<PassageGenerator>(o);
}

}  // namespace slalom
