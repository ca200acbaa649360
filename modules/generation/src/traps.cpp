#include "family.h"

#include <slalom/generation/traps.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kPi = 3.14159265358979323846;

class TrapLayout {
 public:
  TrapLayout(RandomEngine& engine, const TrapsOptions& options, const Ends& ends)
      : engine_(engine), options_(options), ends_(ends) {}

  std::vector<Trap> draw() {
    const int count = uniform_int(engine_, options_.min_traps, options_.max_traps);
    for (int i = 0; i < count; ++i) place(i == 0);
    return std::move(traps_);
  }

 private:
  void place(bool across) {
    constexpr int kTries = 60;
    for (int i = 0; i < kTries; ++i) {
      const Trap trap = draw_one(across);
      if (!fits(trap)) continue;
      traps_.push_back(trap);
      return;
    }
  }

  Trap draw_one(bool across) {
    Trap trap;
    const bool dead_end = uniform_real(engine_, 0, 1) < options_.dead_end_share;
    trap.depth = uniform_real(engine_, options_.min_depth, options_.max_depth) * (dead_end ? 2 : 1);
    const double opening = uniform_real(engine_, options_.min_opening, options_.max_opening);
    trap.opening = dead_end ? options_.dead_end_width : opening;
    const double along = uniform_real(engine_, 0, 1);
    const TPoint2D on_line(ends_.start.x + along * (ends_.goal.x - ends_.start.x),
                           ends_.start.y + along * (ends_.goal.y - ends_.start.y));
    const TPoint2D anywhere{uniform_real(engine_, 0, options_.width),
                            uniform_real(engine_, 0, options_.height)};  // braces: x is drawn first
    trap.center = across ? on_line : anywhere;
    const double turn = options_.max_turn_deg * kPi / 180;
    trap.direction = std::atan2(ends_.start.y - trap.center.y, ends_.start.x - trap.center.x) +
                     uniform_real(engine_, -turn, turn);
    return trap;
  }

  bool fits(const Trap& trap) const {
    const double radius = bounding_radius(trap, options_.wall);
    const auto apart = [&](const TPoint2D& p, double least) {
      return std::hypot(trap.center.x - p.x, trap.center.y - p.y) >= radius + least;
    };
    const double clear = options_.ends.clear_radius;
    return apart(ends_.start, clear) && apart(ends_.goal, clear) &&
           std::all_of(traps_.begin(), traps_.end(), [&](const Trap& other) {
             return apart(other.center, bounding_radius(other, options_.wall) + options_.gap);
           });
  }

  RandomEngine& engine_;
  const TrapsOptions& options_;
  const Ends& ends_;
  std::vector<Trap> traps_;
};

class TrapsGenerator : public Generator {
 public:
  explicit TrapsGenerator(const TrapsOptions& options) : options_(options) {}

  std::string name() const override { return "traps"; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const Bounds floor = {0, 0, options_.width, options_.height};
    const Ends ends = draw_ends(engine, floor, options_.ends);
    Primitives walls;
    for (const Trap& trap : draw_traps(engine, options_, ends))
      walls.polygons.push_back(outline(trap, options_.wall));
    const auto start = start_pose(engine, ends);
    return Scenario::continuous(scenario_name, floor, std::move(walls), start, ends.goal);
  }

 private:
  TrapsOptions options_;
};

}  // namespace

Polygon outline(const Trap& trap, double wall) {
  // In the frame of the trap: x towards the mouth, the middle of the walls' rectangle at 0.
  const double x = (trap.depth + wall) / 2, inner = trap.opening / 2, outer = inner + wall;
  const double corners[][2] = {{-x, -outer},       {x, -outer}, {x, -inner}, {-x + wall, -inner},
                               {-x + wall, inner}, {x, inner},  {x, outer},  {-x, outer}};
  const double c = std::cos(trap.direction), s = std::sin(trap.direction);
  Polygon polygon;
  for (const auto& corner : corners)
    polygon.vertices.emplace_back(trap.center.x + c * corner[0] - s * corner[1],
                                  trap.center.y + s * corner[0] + c * corner[1]);
  return polygon;
}

double bounding_radius(const Trap& trap, double wall) {
  return std::hypot((trap.depth + wall) / 2, trap.opening / 2 + wall);
}

std::vector<Trap> draw_traps(RandomEngine& engine, const TrapsOptions& options, const Ends& ends) {
  return TrapLayout(engine, options, ends).draw();
}

void TrapsOptions::visit(OptionVisitor& v) {
  v.option("width", width, "m", "width of the floor", Range::positive());
  v.option("height", height, "m", "height of the floor", Range::positive());
  v.option("min_traps", min_traps, "-", "fewest traps", Range::between(0, 1000));
  v.option("max_traps", max_traps, "-", "most traps", Range::between(0, 1000));
  v.option("min_depth", min_depth, "m", "least depth inside; dead ends twice", Range::positive());
  v.option("max_depth", max_depth, "m", "largest depth inside; dead ends twice", Range::positive());
  v.option("min_opening", min_opening, "m", "least inside width of a U", Range::positive());
  v.option("max_opening", max_opening, "m", "largest inside width of a U", Range::positive());
  v.option("dead_end_share", dead_end_share, "-", "share of traps that are dead ends",
           Range::between(0, 1));
  v.option("dead_end_width", dead_end_width, "m", "inside width of a dead end", Range::positive());
  v.option("wall", wall, "m", "thickness of walls", Range::positive());
  v.option("max_turn_deg", max_turn_deg, "deg", "by how much a mouth may look past the start",
           Range::between(0, 180));
  v.option("gap", gap, "m", "least gap between traps", Range::at_least(0));
  ends.visit(v);
}

std::unique_ptr<Generator> make_traps(const IniFile& ini, const GeneratorContext& context) {
  const FamilySection section(ini, "traps", context);
  const auto options = section.read<TrapsOptions>();
  section.expect_order("min_traps", options.min_traps, "max_traps", options.max_traps);
  section.expect_order("min_depth", options.min_depth, "max_depth", options.max_depth);
  section.expect_order("min_opening", options.min_opening, "max_opening", options.max_opening);
  section.expect_room(options.ends, options.width, options.height);
  return std::make_unique<TrapsGenerator>(options);
}

}  // namespace slalom
