#include "barn_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

/// Free cells from the neighbour of a cell on.
int free_cells(const BarnField& field, int row, int column, int dr, int dc) {
  int cells = 0;
  for (int r = row + dr, c = column + dc; field.inside(r, c) && !field.blocked(r, c);
       r += dr, c += dc)
    ++cells;
  return cells;
}

/// BARN's characteristic dimension: the free length on both sides along 4 axes (the cell itself not
/// counted; a diagonal cell is sqrt 2 long), the least of them. 0 in an obstacle.
double characteristic_dimension(const BarnField& field, int row, int column) {
  if (field.blocked(row, column)) return 0;
  constexpr int kAxes[][2] = {{0, 1}, {1, 1}, {1, 0}, {1, -1}};
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [dr, dc] : kAxes) {
    const int cells =
        free_cells(field, row, column, dr, dc) + free_cells(field, row, column, -dr, -dc);
    least = std::min(least, cells * std::hypot(dr, dc));
  }
  return least;
}

class BarnCharacteristicDimension : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"barn_characteristic_dimension", 1, "BARN: characteristic dimension", "cells",
            Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return barn_parameters(context);
  }

  Value compute(const DescriptorContext& context) const override {
    const BarnField field(context);
    return field.mean([&](int r, int c) { return characteristic_dimension(field, r, c); },
                      "no points");
  }
};

}  // namespace

DescriptorPtr make_barn_characteristic_dimension() {
  return std::make_shared<BarnCharacteristicDimension>();
}

}  // namespace slalom
