// SPDX-License-Identifier: BSD-3-Clause
#include "disc_arcs.h"

namespace slalom::disc_path {

ArcRows::ArcRows(const OccupiedRows& occupied, double radius)
    : occupied_(occupied),
      radius_(radius),
      buckets_((occupied.size_x() >> kBucketBits) + 1),
      corners_(static_cast<std::size_t>(occupied.size_y()) + 1),
      rows_(static_cast<std::size_t>(occupied.size_y())) {}

int ArcRows::bucket_of(double x) const {
  return std::clamp(static_cast<int>(std::floor(x)), 0, occupied_.size_x() - 1) >> kBucketBits;
}

std::pair<const int*, const int*> ArcRows::near(int y, double low, double high) {
  Row& row = rows_[static_cast<std::size_t>(y)];
  if (row.begin.empty()) prepare(y);
  const auto first = static_cast<std::size_t>(bucket_of(low));
  const auto last = static_cast<std::size_t>(bucket_of(high));
  return {row.entries.data() + row.begin[first], row.entries.data() + row.begin[last + 1]};
}

void ArcRows::add_corner(int x, int line) {
  if (x < 1 || x >= occupied_.size_x()) return;
  const bool sw = occupied_.is_occupied(x - 1, line - 1), se = occupied_.is_occupied(x, line - 1);
  const bool nw = occupied_.is_occupied(x - 1, line), ne = occupied_.is_occupied(x, line);
  if (sw + se + nw + ne == 1) arcs_.push_back({x, line, sw || nw ? 1 : -1, sw || se ? 1 : -1});
}

/// Corners are ends of runs in the row below or above the line, and never in both.
const ArcRows::Corners& ArcRows::corners_on(int line) {
  Corners& corners = corners_[static_cast<std::size_t>(line)];
  if (corners.is_prepared) return corners;
  corners = {true, static_cast<int>(arcs_.size()), 0};
  if (line > 0 && line < occupied_.size_y())
    for (const int y : {line - 1, line})
      for (const Run& run : occupied_.runs(y)) {
        add_corner(run.first, line);
        add_corner(run.last, line);
      }
  corners.end = static_cast<int>(arcs_.size());
  return corners;
}

template <typename Visit>
void ArcRows::for_crossing(int y, Visit visit) {
  const auto width_at = [this](int dy) {
    const double square = radius_ * radius_ - static_cast<double>(dy) * dy;
    return square > 0 ? std::sqrt(square) : 0;
  };
  for (int dy = 0; dy < radius_; ++dy) {  // rows between the corner and this one
    const double outer = width_at(dy), inner = width_at(dy + 1);
    for (const int out_y : {-1, 1}) {
      const int line = out_y > 0 ? y - dy : y + 1 + dy;
      if (line < 0 || line > occupied_.size_y()) continue;
      const Corners corners = corners_on(line);
      for (int i = corners.begin; i < corners.end; ++i) {
        const Arc& arc = (*this)[i];
        if (arc.out_y != out_y) continue;
        const double near_x = arc.x + arc.out_x * inner, far_x = arc.x + arc.out_x * outer;
        visit(i, bucket_of(std::min(near_x, far_x)), bucket_of(std::max(near_x, far_x)));
      }
    }
  }
}

void ArcRows::prepare(int y) {
  Row& row = rows_[static_cast<std::size_t>(y)];
  row.begin.assign(static_cast<std::size_t>(buckets_) + 1, 0);
  for_crossing(y, [&row](int, int first, int last) {
    for (int b = first; b <= last; ++b) ++row.begin[static_cast<std::size_t>(b)];
  });
  int sum = 0;
  for (int& begin : row.begin) begin = sum += begin;
  row.entries.resize(static_cast<std::size_t>(sum));
  for_crossing(y, [&row](int arc, int first, int last) {
    for (int b = first; b <= last; ++b)
      row.entries[static_cast<std::size_t>(--row.begin[static_cast<std::size_t>(b)])] = arc;
  });
}

}  // namespace slalom::disc_path
