#include "descriptors.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace slalom {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kQuadrats = 8;  ///< along each side of W

/// Occupied area (cells) of the quadrats, as if all were of their mean size.
std::vector<double> areas_of_quadrats(const Occupancy& cells) {
  const int columns = std::min(kQuadrats, cells.size_x()),
            rows = std::min(kQuadrats, cells.size_y());
  std::vector<double> occupied(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)),
      all = occupied;
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx) {
      const auto column = static_cast<std::size_t>(std::int64_t{cx} * columns / cells.size_x());
      const auto row = static_cast<std::size_t>(std::int64_t{cy} * rows / cells.size_y());
      const std::size_t quadrat = row * static_cast<std::size_t>(columns) + column;
      occupied[quadrat] += cells.occupied(cx, cy) ? 1 : 0;
      all[quadrat] += 1;
    }
  const double mean_size =
      static_cast<double>(cells.cells().size()) / static_cast<double>(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) occupied[i] *= mean_size / all[i];
  return occupied;
}

/// Area (cells) of a disc with the same ratio of area to outline. The outline of cells is a
/// staircase, 4 / pi times as long as the outline of what looks the same in all directions.
double area_of_grain(const Occupancy& cells) {
  double area = 0, sides = 0;
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx) {
      if (!cells.occupied(cx, cy)) continue;
      area += 1;
      for (const auto& [dx, dy] :
           {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)})
        sides += cells.inside(cx + dx, cy + dy) && cells.occupied(cx + dx, cy + dy) ? 0 : 1;
    }
  const double radius = 2 * area / (0.25 * kPi * sides);
  return kPi * radius * radius;
}

/// Variance / mean of the occupied area over k x k quadrats, area counted in grains: discs with the
/// same ratio of area to outline as the obstacles. So it does not depend on the cell size, and is 1
/// for equal discs that lie independently of each other and are small beside a quadrat.
class Clustering : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"clustering", 1, "Clustering index", "-", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters({"quadrats=8", resolution_parameter(context.world)});
  }

  Value compute(const DescriptorContext& context) const override {
    const Occupancy& cells = context.world.occupancy();
    const std::vector<double> areas = areas_of_quadrats(cells);
    if (areas.size() < 2) return Value::na("fewer than two quadrats");
    double sum = 0, squares = 0;
    for (const double area : areas) sum += area;
    if (sum == 0) return Value::na("no obstacles");
    const double mean = sum / static_cast<double>(areas.size());
    for (const double area : areas) squares += (area - mean) * (area - mean);
    const double variance = squares / (static_cast<double>(areas.size()) - 1);
    return Value::of(variance / mean / area_of_grain(cells));
  }
};

}  // namespace

DescriptorPtr make_clustering() {
  return std::make_shared<Clustering>();
}

}  // namespace slalom
