// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/geometry.h>
#include <slalom/trajectory/path.h>

#include <vector>

namespace slalom {

/// Exact distances from many points to one path, equal to distance_to_path. Segments of the path
/// are grouped in blocks with bounding boxes, and only blocks that may contain a closer segment are
/// searched: a reference path has hundreds of segments, and each run needs thousands of distances.
class PathDistance {
 public:
  explicit PathDistance(const Path& path);  ///< must not be empty, and must outlive this object

  /// Distance (m) from p to the nearest point of the path. Fastest for consecutive nearby points.
  double operator()(const mrpt::math::TPoint2D& p);

  /// The segment of the path (from vertex k to k + 1) that was nearest in the last call.
  std::size_t nearest_piece() const { return nearest_piece_; }
  double distance_to_piece(const mrpt::math::TPoint2D& p, std::size_t piece) const;

 private:
  struct Block {
    std::size_t first, last;  ///< vertices
    Bounds box;
  };

  /// Distance to the block, and its nearest segment.
  double distance_to_block(const mrpt::math::TPoint2D& p, const Block& block,
                           std::size_t& piece) const;

  const Path& path_;
  std::vector<Block> blocks_;
  std::size_t nearest_ = 0;  ///< block nearest to the previous point
  std::size_t nearest_piece_ = 0;
};

}  // namespace slalom
