// SPDX-License-Identifier: BSD-3-Clause
#include "path_distance.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr std::size_t kPiecesPerBlock = 16;

/// Rounding tolerance of squared distances.
constexpr double kRounding = 1e-12;

double squared_distance_to_box(const TPoint2D& p, const Bounds& box) {
  const double dx = std::max({0.0, box.x_min - p.x, p.x - box.x_max});
  const double dy = std::max({0.0, box.y_min - p.y, p.y - box.y_max});
  return dx * dx + dy * dy;
}

Bounds box_of(const Path& path, std::size_t first, std::size_t last) {
  Bounds box{path[first].x, path[first].y, path[first].x, path[first].y};
  for (std::size_t i = first + 1; i <= last; ++i) {
    box.x_min = std::min(box.x_min, path[i].x);
    box.y_min = std::min(box.y_min, path[i].y);
    box.x_max = std::max(box.x_max, path[i].x);
    box.y_max = std::max(box.y_max, path[i].y);
  }
  return box;
}

}  // namespace

PathDistance::PathDistance(const Path& path) : path_(path) {
  if (path.empty()) throw std::invalid_argument("PathDistance: the path is empty");
  std::size_t first = 0;
  do {
    const std::size_t last = std::min(first + kPiecesPerBlock, path.size() - 1);
    blocks_.push_back({first, last, box_of(path, first, last)});
    first = last;
  } while (first + 1 < path.size());
}

double PathDistance::operator()(const TPoint2D& p) {
  const std::size_t start = nearest_;
  double best = distance_to_block(p, blocks_[start], nearest_piece_);
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (i == start) continue;
    if (squared_distance_to_box(p, blocks_[i].box) * (1 - kRounding) >= best * best) continue;
    std::size_t piece = 0;
    const double distance = distance_to_block(p, blocks_[i], piece);
    if (distance >= best) continue;
    best = distance;
    nearest_ = i;
    nearest_piece_ = piece;
  }
  return best;
}

double PathDistance::distance_to_piece(const TPoint2D& p, std::size_t piece) const {
  return distance_to_segment(p, path_[piece], path_[std::min(piece + 1, path_.size() - 1)]);
}

double PathDistance::distance_to_block(const TPoint2D& p, const Block& block,
                                       std::size_t& piece) const {
  piece = block.first;
  double best = distance_to_piece(p, piece);
  for (std::size_t i = block.first + 1; i < block.last; ++i) {
    const TPoint2D offset = offset_from_segment(p, path_[i], path_[i + 1]);
    const double square = offset.x * offset.x + offset.y * offset.y;
    if (square * (1 - kRounding) >= best * best) continue;  // most pieces: saves their roots
    const double distance = math::hypot(offset.x, offset.y);
    if (distance >= best) continue;
    best = distance;
    piece = i;
  }
  return best;
}

}  // namespace slalom
