#pragma once

#include <slalom/scenario/geometry.h>
#include <slalom/trajectory/path.h>

#include <vector>

namespace slalom {

/// Exact distances from many points to one path, as distance_to_path gives them. Pieces of the path
/// are kept in blocks with their bounding boxes, and only blocks that may hold a nearer piece are
/// looked at: a reference path has hundreds of pieces, and each run asks for thousands of
/// distances.
class PathDistance {
 public:
  explicit PathDistance(const Path& path);  ///< the path is not empty and outlives this

  /// Distance (m) from p to the nearest point of the path. Quickest for points that follow each
  /// other.
  double operator()(const mrpt::math::TPoint2D& p);

  /// The piece of the path (from vertex k to k + 1) that was nearest in the last call.
  std::size_t nearest_piece() const { return nearest_piece_; }
  double distance_to_piece(const mrpt::math::TPoint2D& p, std::size_t piece) const;

 private:
  struct Block {
    std::size_t first, last;  ///< vertices
    Bounds box;
  };

  /// And the piece of the block that is the nearest.
  double distance_to_block(const mrpt::math::TPoint2D& p, const Block& block,
                           std::size_t& piece) const;

  const Path& path_;
  std::vector<Block> blocks_;
  std::size_t nearest_ = 0;  ///< block that was nearest to the point before
  std::size_t nearest_piece_ = 0;
};

}  // namespace slalom
