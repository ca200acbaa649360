#include "descriptors.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kBlock = 1;            ///< m
constexpr int kLargestBlock = 1 << 29;  ///< cells; two of them are still an int

/// Entropy (bit) times the number of cells of the block x0 <= x < x1, y0 <= y < y1.
double entropy_of_block(const Occupancy& cells, int x0, int y0, int x1, int y1) {
  std::size_t occupied = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) occupied += cells.occupied(x, y) ? 1 : 0;
  const double all = static_cast<double>(x1 - x0) * (y1 - y0);
  const double share = static_cast<double>(occupied) / all;
  if (occupied == 0 || share == 1) return 0;
  return -all * (share * std::log2(share) + (1 - share) * std::log2(1 - share));
}

/// Mean over square blocks of the binary entropy (bit) of their occupied share, those cut off by
/// the border weighted by their area.
class OccupancyEntropy : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"occupancy_entropy", 1, "Occupancy entropy", "bit", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters({"block=1", resolution_parameter(context.world)});
  }

  Value compute(const DescriptorContext& context) const override {
    const Occupancy& cells = context.world.occupancy();
    // Blocks of one cell would have no entropy.
    const int side = static_cast<int>(std::clamp(std::round(kBlock / cells.resolution()), 2.0,
                                                 static_cast<double>(kLargestBlock)));
    double sum = 0;
    for (int y = 0; y < cells.size_y(); y += side)
      for (int x = 0; x < cells.size_x(); x += side)
        sum += entropy_of_block(cells, x, y, std::min(x + side, cells.size_x()),
                                std::min(y + side, cells.size_y()));
    return Value::of(sum / static_cast<double>(cells.cells().size()));
  }
};

}  // namespace

DescriptorPtr make_occupancy_entropy() {
  return std::make_shared<OccupancyEntropy>();
}

}  // namespace slalom
