#include "configuration_cells.h"

#include <cmath>

namespace slalom {
namespace {

CellGrid empty_grid(int size_x, int size_y) {
  return {size_x, size_y,
          std::vector<std::uint8_t>(static_cast<std::size_t>(size_x) *
                                    static_cast<std::size_t>(size_y))};
}

/// Distance to the occupied squares at the centre of a subcell, exact where it matters: near the
/// radius.
class SubcellDistance {
 public:
  SubcellDistance(const World& world, int subdivision, double near, double margin)
      : cells_(world.occupancy()),
        field_(world.distance_field()),
        subdivision_(subdivision),
        near_(near),
        // d changes by at most the distance between two points; a subcell's centre lies this near
        // its cell's.
        certain_(margin + cells_.resolution() * std::sqrt(0.5)) {}

  double operator()(int sx, int sy) const {
    const int cx = sx / subdivision_, cy = sy / subdivision_;
    const double at_center = field_.at_center(cx, cy);
    if (subdivision_ == 1 || std::abs(at_center - near_) > 2 * certain_) return at_center;
    return field_.clearance(cells_.to_world((sx + 0.5) / subdivision_, (sy + 0.5) / subdivision_));
  }

 private:
  const Occupancy& cells_;
  const DistanceField& field_;
  int subdivision_;
  double near_, certain_;
};

}  // namespace

ConfigurationCells make_configuration_cells(const World& world, double robot_radius,
                                            int subdivision) {
  const Occupancy& cells = world.occupancy();
  ConfigurationCells result;
  result.cell_size = cells.resolution() / subdivision;
  result.outer = empty_grid(cells.size_x() * subdivision, cells.size_y() * subdivision);
  result.inner = result.outer;
  // No point of a subcell is farther from its centre than this, so d differs by no more. The rest
  // absorbs the rounding of distances kept as floats.
  const double margin = result.cell_size * std::sqrt(0.5) + 1e-5 * cells.resolution();
  const SubcellDistance distance(world, subdivision, robot_radius, margin);
  std::size_t i = 0;
  for (int sy = 0; sy < result.outer.size_y; ++sy)
    for (int sx = 0; sx < result.outer.size_x; ++sx, ++i) {
      const double d = distance(sx, sy);
      result.outer.blocked[i] = d + margin < robot_radius ? 1 : 0;
      result.inner.blocked[i] = d - margin < robot_radius ? 1 : 0;
    }
  return result;
}

}  // namespace slalom
