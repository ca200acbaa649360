#include "descriptors.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace slalom {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kQuadrats = 8;  ///< along each side of W

std::size_t count_occupied(const std::uint8_t* first, std::ptrdiff_t count) {
  std::size_t occupied = 0;
  for (const std::uint8_t* cell = first; cell != first + count; ++cell) occupied += *cell;
  return occupied;
}

/// Occupied area (cells) of the quadrats, as if all were of their mean size.
std::vector<double> areas_of_quadrats(const Occupancy& cells) {
  const int columns = std::min(kQuadrats, cells.size_x());
  const int rows = std::min(kQuadrats, cells.size_y());
  const auto border = [](std::int64_t i, int size, int parts) {
    return static_cast<int>(i * size / parts);
  };
  const double mean_size = static_cast<double>(cells.cells().size()) / (columns * rows);
  std::vector<double> areas;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int x0 = border(column, cells.size_x(), columns);
      const int width = border(column + 1, cells.size_x(), columns) - x0;
      const int y0 = border(row, cells.size_y(), rows), y1 = border(row + 1, cells.size_y(), rows);
      std::size_t occupied = 0;
      for (int y = y0; y < y1; ++y)
        occupied += count_occupied(cells.cells().data() + cells.index(x0, y), width);
      areas.push_back(static_cast<double>(occupied) * mean_size /
                      (static_cast<double>(width) * (y1 - y0)));
    }
  return areas;
}

/// How often two runs of cells differ.
std::size_t count_changes(const std::uint8_t* a, const std::uint8_t* b, std::ptrdiff_t count) {
  std::size_t changes = 0;
  for (std::ptrdiff_t i = 0; i < count; ++i) changes += a[i] ^ b[i];
  return changes;
}

/// Length (cells) of the staircase around what is occupied, along the border of W too.
std::size_t outline_of(const Occupancy& cells) {
  const int size_x = cells.size_x(), size_y = cells.size_y();
  const auto row = [&](int y) { return cells.cells().data() + cells.index(0, y); };
  std::size_t sides = count_occupied(row(0), size_x) + count_occupied(row(size_y - 1), size_x);
  for (int y = 0; y < size_y; ++y) {
    sides += row(y)[0] + std::size_t{row(y)[size_x - 1]};
    sides += count_changes(row(y), row(y) + 1, size_x - 1);
    if (y > 0) sides += count_changes(row(y - 1), row(y), size_x);
  }
  return sides;
}

/// Area (cells) of a disc with the same ratio of area to outline. A staircase is 4 / pi times as
/// long as the outline that it follows, of what looks the same in all directions.
double area_of_grain(const Occupancy& cells) {
  const double outline = 0.25 * kPi * static_cast<double>(outline_of(cells));
  const double radius = 2 * static_cast<double>(cells.count_occupied()) / outline;
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
