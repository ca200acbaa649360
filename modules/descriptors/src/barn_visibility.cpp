#include "barn_field.h"

#include <cmath>

namespace slalom {
namespace {

/// Free cells on a ray, the first one included, and whether an obstacle ends it (or the map does).
struct Ray {
  int cells = 0;
  bool ends_at_obstacle = false;
};

Ray cast(const BarnField& field, int row, int column, int dr, int dc) {
  Ray ray;
  while (field.inside(row, column)) {
    if (field.blocked(row, column)) {
      ray.ends_at_obstacle = true;
      break;
    }
    ++ray.cells;
    row += dr;
    column += dc;
  }
  return ray;
}

/// BARN's average visibility: the mean over the rays in 8 directions that end at an obstacle. In
/// 2021 cells counted 1 or sqrt 2 by their direction; in 2020 each counted 1, and the mean was
/// rounded down.
std::optional<double> visibility(const BarnField& field, int row, int column, int year) {
  double length = 0;
  int cells = 0, rays = 0;
  for (int dr = -1; dr <= 1; ++dr)
    for (int dc = -1; dc <= 1; ++dc) {
      if (dr == 0 && dc == 0) continue;
      const Ray ray = cast(field, row, column, dr, dc);
      if (!ray.ends_at_obstacle) continue;
      ++rays;
      cells += ray.cells;
      length += ray.cells * std::hypot(dr, dc);
    }
  if (rays == 0) return std::nullopt;
  return year == 2020 ? cells / rays : length / rays;
}

class BarnVisibility : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"barn_visibility", 1, "BARN: average visibility", "cells", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters(
        {barn_parameters(context), "barn_visibility=" + std::to_string(context.barn_visibility)});
  }

  Value compute(const DescriptorContext& context) const override {
    const BarnField field(context);
    return field.mean(
        [&](int r, int c) { return visibility(field, r, c, context.barn_visibility); },
        "no ray from the path ends at an obstacle");
  }
};

}  // namespace

DescriptorPtr make_barn_visibility() {
  return std::make_shared<BarnVisibility>();
}

}  // namespace slalom
