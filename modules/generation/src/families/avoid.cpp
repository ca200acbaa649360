// SPDX-License-Identifier: BSD-3-Clause
#include "straight_path_family.h"

#include <slalom/core/math.h>
#include <slalom/generation/avoid.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// The square of this side, turned by `angle` about its center.
Polygon box(const TPoint2D& center, double side, double angle) {
  const auto [s, c] = math::sin_cos(angle);
  const TPoint2D along{c * side / 2, s * side / 2}, across{-along.y, along.x};
  return {{center - along - across, center + along - across, center + along + across,
           center - along + across}};
}

class AvoidGenerator : public Generator {
 public:
  explicit AvoidGenerator(const AvoidOptions& options) : options_(options) {}

  std::string name() const override { return AvoidOptions::kFamily; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const AvoidOptions& o = options_;
    const StraightPath path = sample_straight_path(engine, o);
    const double size = uniform_real(engine, o.min_size, o.max_size);
    const double side = sample_side(engine);
    const TPoint2D center{path.place.x,
                          path.place.y + side * uniform_real(engine, o.min_offset, o.max_offset)};
    Primitives obstacle;
    if (uniform_real(engine, 0, 1) < o.disc_fraction) {
      obstacle.discs = {{center, size / 2}};
    } else {
      obstacle.polygons = {box(center, size, uniform_real(engine, 0, M_PI / 2))};
    }
    return Scenario::continuous(scenario_name, {0, 0, o.length, o.height}, std::move(obstacle),
                                path.start, path.goal);
  }

 private:
  AvoidOptions options_;
};

}  // namespace

void AvoidOptions::visit(OptionVisitor& v) {
  StraightPathOptions::visit(v);
  v.option("min_size", min_size, "m", "minimum width of the obstacle: side of a box or diameter",
           Range::positive());
  v.option("max_size", max_size, "m", "maximum width of the obstacle: side of a box or diameter",
           Range::positive());
  v.option("min_offset", min_offset, "m",
           "minimum distance of the obstacle's center from the straight path", Range::at_least(0));
  v.option("max_offset", max_offset, "m",
           "maximum distance of the obstacle's center from the straight path", Range::at_least(0));
  v.option("disc_fraction", disc_fraction, "-", "fraction of obstacles that are discs, not boxes",
           Range::between(0, 1));
}

std::unique_ptr<Generator> make_generator(const AvoidOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(AvoidOptions::kFamily, context);
  const auto o = checks.scaled(given);
  expect_valid(checks, o);
  checks.expect_order("min_size", o.min_size, "max_size", o.max_size);
  checks.expect_order("min_offset", o.min_offset, "max_offset", o.max_offset);
  const double reach = o.max_size * M_SQRT1_2;  // m, of a box from its center
  checks.expect(
      reach + o.start_goal.clear_radius <= std::min(o.min_start_distance, o.goal_distance),
      "clear_radius", "reaches the obstacle",
      "at most min_start_distance and goal_distance, less 0.71 of max_size");
  checks.expect(o.max_offset + reach <= room_beside(o), "max_offset",
                "places the obstacle outside the workspace",
                "at most " + format_number(room_beside(o) - reach));
  return std::make_unique<AvoidGenerator>(o);
}

}  // namespace slalom
