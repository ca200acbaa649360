#include "configuration_space.h"
#include "descriptors.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace slalom {
namespace {

/// Where steepest descent of the distance to the goal leads from each cell.
class Descent {
 public:
  /// `free` has an entry above 0 for each cell in F_C; the goal's cell counts as one.
  Descent(const Occupancy& cells, std::vector<std::uint8_t> free, int goal_x, int goal_y)
      : cells_(cells), free_(std::move(free)), goal_x_(goal_x), goal_y_(goal_y) {
    fate_.resize(free_.size(), Fate::Unknown);
    free_[cells.index(goal_x, goal_y)] = 1;
    fate_[cells.index(goal_x, goal_y)] = Fate::Arrives;
  }

  /// Share of F_C from which descent stops before the goal.
  double trapped() {
    std::size_t all = 0, stopped = 0;
    for (int y = 0; y < cells_.size_y(); ++y)
      for (int x = 0; x < cells_.size_x(); ++x) {
        if (!free(x, y)) continue;
        ++all;
        stopped += follow(x, y) == Fate::Stops ? 1 : 0;
      }
    return static_cast<double>(stopped) / static_cast<double>(all);
  }

 private:
  enum class Fate : std::uint8_t { Unknown, Arrives, Stops };

  bool free(int x, int y) const { return free_[cells_.index(x, y)] != 0; }

  /// Goes down until the fate is known, which then is that of all cells on the way.
  Fate follow(int x, int y) {
    way_.clear();
    std::size_t here = cells_.index(x, y);
    while (fate_[here] == Fate::Unknown) {
      way_.push_back(here);
      if (!step_down(x, y)) {
        fate_[here] = Fate::Stops;
        break;
      }
      here = cells_.index(x, y);
    }
    for (const std::size_t passed : way_) fate_[passed] = fate_[here];
    return fate_[here];
  }

  /// To the lowest free neighbour that is lower. Diagonal steps need both side cells free: so one
  /// that comes nearer in one coordinate only is never lower than the step in that coordinate.
  bool step_down(int& x, int& y) const {
    const int right = goal_x_ - x, up = goal_y_ - y;
    const int dx = right > 0 ? 1 : right < 0 ? -1 : 0, dy = up > 0 ? 1 : up < 0 ? -1 : 0;
    const bool across = dx != 0 && free(x + dx, y), along = dy != 0 && free(x, y + dy);
    const bool diagonal = across && along && free(x + dx, y + dy);
    const bool x_first = across && (!along || std::abs(right) >= std::abs(up));
    if (diagonal || x_first) x += dx;
    if (diagonal || (along && !x_first)) y += dy;
    return across || along;
  }

  const Occupancy& cells_;
  std::vector<std::uint8_t> free_;
  std::vector<Fate> fate_;
  std::vector<std::size_t> way_;
  int goal_x_, goal_y_;
};

/// Share of F_C from which steepest 8-connected descent of |q - g| stops before g.
class TrapFraction : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"trap_fraction", 1, "Local-minimum traps", "-", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters({robot_parameter(context), resolution_parameter(context.world)});
  }

  Value compute(const DescriptorContext& context) const override {
    const mrpt::math::TPoint2D goal = context.world.scenario().goal();
    if (context.world.distance_field().clearance(goal) < context.robot_radius() - 1e-9)
      return Value::na("goal is closer to an obstacle than the robot's radius");
    const Occupancy& cells = context.world.occupancy();
    const mrpt::math::TPoint2D at = cells.to_cells(goal);
    Descent descent(cells, free_headings(context).free,
                    std::min(static_cast<int>(at.x), cells.size_x() - 1),
                    std::min(static_cast<int>(at.y), cells.size_y() - 1));
    return Value::of(descent.trapped());
  }
};

}  // namespace

DescriptorPtr make_trap_fraction() {
  return std::make_shared<TrapFraction>();
}

}  // namespace slalom
