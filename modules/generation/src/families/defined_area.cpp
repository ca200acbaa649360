// SPDX-License-Identifier: BSD-3-Clause
#include "straight_path_family.h"
#include "walls.h"

#include <slalom/generation/defined_area.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// One area. The first aisle begins at the left; the others follow above it, or below.
class Area {
 public:
  Area(RandomEngine& engine, const DefinedAreaOptions& options)
      : engine_(engine),
        options_(options),
        width_(uniform_real(engine, options.min_width, options.max_width)),
        aisles_(uniform_int(engine, options.min_aisles, options.max_aisles)) {
    // The walls are anywhere relative to the cells of grids.
    const double x = uniform_real(engine, options.wall, 2 * options.wall);
    origin_ = {x, uniform_real(engine, options.wall, 2 * options.wall)};
    is_upward_ = uniform_int(engine, 0, 1) == 0;
    add_walls();
  }

  Scenario scenario(const std::string& name) {
    const DefinedAreaOptions& o = options_;
    const TPoint2D start{origin_.x + width_ / 2, low(0) + width_ / 2};
    const TPoint2D goal = goal_for(start);
    const int count = uniform_int(engine_, o.min_impairments, o.max_impairments);
    for (int i = 0; i < count; ++i) add_impairment(start, goal);
    const double angle = sample_angle(engine_, o.angle);
    return Scenario::continuous(name, bounds(), std::move(walls_), {start.x, start.y, angle}, goal);
  }

 private:
  double height() const { return aisles_ * width_ + (aisles_ - 1) * options_.wall; }
  double right() const { return origin_.x + options_.length; }
  Bounds bounds() const {
    return {0, 0, options_.length + 3 * options_.wall, height() + 3 * options_.wall};
  }

  /// The lower side (m) of an aisle; aisles are counted from the start.
  double low(int aisle) const {
    const int row = is_upward_ ? aisle : aisles_ - 1 - aisle;
    return origin_.y + row * (width_ + options_.wall);
  }

  void add_walls() {
    const Bounds all = bounds();
    const double top = origin_.y + height();
    walls_.polygons = {
        rectangle(0, 0, all.x_max, origin_.y), rectangle(0, top, all.x_max, all.y_max),
        rectangle(0, origin_.y, origin_.x, top), rectangle(right(), origin_.y, all.x_max, top)};
    for (int i = 0; i + 1 < aisles_; ++i) {
      const double y = std::min(low(i), low(i + 1)) + width_;
      const double open_left = i % 2 == 1 ? width_ : 0, open_right = i % 2 == 0 ? width_ : 0;
      walls_.polygons.push_back(
          rectangle(origin_.x + open_left, y, right() - open_right, y + options_.wall));
    }
  }

  TPoint2D goal_for(const TPoint2D& start) const {
    const double y = low(aisles_ - 1) + width_ / 2;
    if (aisles_ % 2 == 1) return {right() - width_ / 2, y};
    const double distance = options_.start_goal.min_distance + kRounding;
    const double beyond = distance * distance - (y - start.y) * (y - start.y);
    return {start.x + std::sqrt(std::max(0.0, beyond)), y};
  }

  /// A box at one wall of an aisle, not in a turn, and as far from the others in its aisle as the
  /// aisle is wide. It is left out if 60 draws do not suffice.
  void add_impairment(const TPoint2D& start, const TPoint2D& goal) {
    constexpr int kTries = 60;
    const DefinedAreaOptions& o = options_;
    const double depth = (1 - uniform_real(engine_, o.min_free, o.max_free)) * width_;
    for (int i = 0; i < kTries; ++i) {
      const int aisle = uniform_int(engine_, 0, aisles_ - 1);
      const double x = uniform_real(engine_, origin_.x + width_, right() - width_ - o.impairment);
      const bool is_below = uniform_int(engine_, 0, 1) == 0;
      const double y = is_below ? low(aisle) : low(aisle) + width_ - depth;
      const Polygon box = rectangle(x, y, x + o.impairment, y + depth);
      const bool is_clear =
          std::min(distance(start, box), distance(goal, box)) >= o.start_goal.clear_radius;
      const bool is_apart =
          std::all_of(boxes_.begin(), boxes_.end(), [&](const std::pair<int, double>& other) {
            return other.first != aisle || std::abs(other.second - x) >= o.impairment + width_;
          });
      if (!is_clear || !is_apart) continue;
      boxes_.emplace_back(aisle, x);
      walls_.polygons.push_back(box);
      return;
    }
  }

  RandomEngine& engine_;
  const DefinedAreaOptions& options_;
  double width_;
  int aisles_;
  TPoint2D origin_;
  bool is_upward_ = true;
  Primitives walls_;
  std::vector<std::pair<int, double>> boxes_;  ///< aisle and x
};

class DefinedAreaGenerator : public Generator {
 public:
  explicit DefinedAreaGenerator(const DefinedAreaOptions& options) : options_(options) {}

  std::string name() const override { return DefinedAreaOptions::kFamily; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    return Area(engine, options_).scenario(scenario_name);
  }

 private:
  DefinedAreaOptions options_;
};

}  // namespace

void DefinedAreaOptions::visit(OptionVisitor& v) {
  v.option("length", length, "m", "length of each aisle, with its turns", Range::positive());
  v.option("min_width", min_width, "m", "minimum clear width of aisles and turns",
           Range::positive());
  v.option("max_width", max_width, "m", "maximum clear width of aisles and turns",
           Range::positive());
  v.option("min_aisles", min_aisles, "-", "minimum number of aisles", Range::between(2, 100));
  v.option("max_aisles", max_aisles, "-", "maximum number of aisles", Range::between(2, 100));
  v.option("wall", wall, "m", "thickness of the walls between aisles", Range::positive());
  v.option("min_impairments", min_impairments, "-", "minimum number of boxes at the walls",
           Range::between(0, 1000));
  v.option("max_impairments", max_impairments, "-", "maximum number of boxes at the walls",
           Range::between(0, 1000));
  v.option("min_free", min_free, "-", "minimum fraction of the width beside a box",
           Range::between(0.01, 0.99));
  v.option("max_free", max_free, "-", "maximum fraction of the width beside a box",
           Range::between(0.01, 0.99));
  v.option("impairment", impairment, "m", "length of a box along the aisle", Range::positive());
  angle.visit(v);
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const DefinedAreaOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(DefinedAreaOptions::kFamily, context);
  const auto o = checks.scaled(given);
  checks.expect_order("min_width", o.min_width, "max_width", o.max_width);
  checks.expect_order("min_aisles", o.min_aisles, "max_aisles", o.max_aisles);
  checks.expect_order("min_impairments", o.min_impairments, "max_impairments", o.max_impairments);
  checks.expect_order("min_free", o.min_free, "max_free", o.max_free);
  expect_valid(checks, o.angle);
  checks.expect(2 * o.max_width < o.length, "max_width", "leaves no wall between the turns",
                "less than half of length");
  checks.expect(o.max_impairments == 0 || o.impairment <= o.length - 2 * o.max_width, "impairment",
                "does not fit between the turns",
                "at most " + format_number(o.length - 2 * o.max_width));
  checks.expect(o.start_goal.min_distance < o.length - o.max_width, "min_distance",
                "start and goal cannot be min_distance apart in each number of aisles",
                "less than " + format_number(o.length - o.max_width));
  checks.expect(2 * o.start_goal.margin <= o.min_width, "margin",
                "places the start outside the aisle", "at most half of min_width");
  checks.expect(2 * o.start_goal.clear_radius <= o.min_width, "clear_radius", "reaches the walls",
                "at most half of min_width");
  return std::make_unique<DefinedAreaGenerator>(o);
}

}  // namespace slalom
