// SPDX-License-Identifier: BSD-3-Clause
#include "family.h"

#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/generation/poisson_forest.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kMaxPoints = 1e6;

/// Points in a grid of square cells with at most one point each.
class SpacedPoints {
 public:
  SpacedPoints(const Bounds& bounds, double spacing)
      : bounds_(bounds),
        spacing_(spacing),
        cell_(spacing / std::sqrt(2.0)),
        columns_(static_cast<int>(bounds.width() / cell_) + 1),
        rows_(static_cast<int>(bounds.height() / cell_) + 1),
        at_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1) {}

  bool fits(const TPoint2D& p) const {
    if (!bounds_.contains(p)) return false;
    constexpr int kReach = 2;  // cells, covers the spacing
    const int cx = column(p), cy = row(p);
    for (int y = std::max(0, cy - kReach); y <= std::min(rows_ - 1, cy + kReach); ++y)
      for (int x = std::max(0, cx - kReach); x <= std::min(columns_ - 1, cx + kReach); ++x) {
        const int other = at_[index(x, y)];
        if (other < 0) continue;
        const TPoint2D& q = points_[static_cast<std::size_t>(other)];
        if (distance_between(p, q) < spacing_) return false;
      }
    return true;
  }

  void add(const TPoint2D& p) {
    at_[index(column(p), row(p))] = static_cast<int>(points_.size());
    points_.push_back(p);
  }

  const std::vector<TPoint2D>& points() const { return points_; }

 private:
  int column(const TPoint2D& p) const { return static_cast<int>((p.x - bounds_.x_min) / cell_); }
  int row(const TPoint2D& p) const { return static_cast<int>((p.y - bounds_.y_min) / cell_); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x);
  }

  Bounds bounds_;
  double spacing_, cell_;
  int columns_, rows_;
  std::vector<int> at_;
  std::vector<TPoint2D> points_;
};

class PoissonForest : public Generator {
 public:
  explicit PoissonForest(const PoissonForestOptions& options) : options_(options) {}

  std::string name() const override { return "poisson_forest"; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const Bounds workspace = {0, 0, options_.width, options_.height};
    const StartGoal start_goal = sample_start_goal(engine, workspace, options_.start_goal);
    Primitives trunks;
    for (const TPoint2D& center : poisson_discs(engine, workspace, options_.spacing)) {
      const Disc trunk = {center, sample_obstacle_size(engine, options_.trunks)};
      if (distance(start_goal.start, trunk) >= options_.start_goal.clear_radius &&
          distance(start_goal.goal, trunk) >= options_.start_goal.clear_radius)
        trunks.discs.push_back(trunk);
    }
    const auto start = start_pose(engine, start_goal);
    return Scenario::continuous(scenario_name, workspace, std::move(trunks), start,
                                start_goal.goal);
  }

 private:
  PoissonForestOptions options_;
};

}  // namespace

std::vector<TPoint2D> poisson_discs(RandomEngine& engine, const Bounds& bounds, double spacing) {
  constexpr int kCandidates = 30;
  SpacedPoints spaced(bounds, spacing);
  const double x = uniform_real(engine, bounds.x_min, bounds.x_max);
  spaced.add({x, uniform_real(engine, bounds.y_min, bounds.y_max)});
  std::vector<TPoint2D> active = spaced.points();
  while (!active.empty()) {
    const auto chosen =
        static_cast<std::size_t>(uniform_int(engine, 0, static_cast<int>(active.size()) - 1));
    const TPoint2D from = active[chosen];
    bool found = false;
    for (int k = 0; k < kCandidates && !found; ++k) {
      // The square root makes points uniform over the area of the annulus.
      const double radius = spacing * std::sqrt(uniform_real(engine, 1, 4));
      const double angle = uniform_real(engine, 0, 2 * M_PI);
      const TPoint2D p(from.x + radius * math::cos(angle), from.y + radius * math::sin(angle));
      found = spaced.fits(p);
      if (!found) continue;
      spaced.add(p);
      active.push_back(p);
    }
    if (found) continue;
    active[chosen] = active.back();
    active.pop_back();
  }
  return spaced.points();
}

void PoissonForestOptions::visit(OptionVisitor& v) {
  v.option("width", width, "m", "width of the workspace", Range::positive());
  v.option("height", height, "m", "height of the workspace", Range::positive());
  v.option("spacing", spacing, "m", "minimum distance between centers of trunks",
           Range::positive());
  trunks.visit(v);
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const PoissonForestOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(PoissonForestOptions::kFamily, context);
  const auto options = checks.scaled(given);
  checks.expect_valid(options.trunks);
  checks.expect(options.spacing >= 2 * options.trunks.max_size, "spacing",
                "trunks of max_size would overlap", "at least twice max_size");
  const double squares =
      (options.width / options.spacing + 1) * (options.height / options.spacing + 1);
  checks.expect(squares <= kMaxPoints, "spacing", "is too small for the workspace",
                "at most 1000000 squares of that side in the workspace");
  checks.expect_start_goal_fit(options.start_goal, options.width, options.height);
  return std::make_unique<PoissonForest>(options);
}

}  // namespace slalom
