// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/geometry.h>

#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// A path that was published together with an environment, and the square cells on which its source
/// measured the environment along it. Metadata of a scenario: not part of its content and its hash.
struct PublishedPath {
  std::vector<mrpt::math::TPoint2D> points;  ///< m, as published, including repeated points
  Bounds field;                              ///< m, the extent of the source's cells
  double cell_size = 0;                      ///< m

  int size_x() const;  ///< cells of the field
  int size_y() const;
  std::string hash() const;  ///< 32 hexadecimal digits

  bool operator==(const PublishedPath& other) const;
  bool operator!=(const PublishedPath& other) const { return !(*this == other); }
};

using PublishedPathPtr = std::shared_ptr<const PublishedPath>;

/// Throws Error (File) naming `name` when there are no points or one is not finite, the cell size
/// is not positive, the cells do not fill the field (to 1 % of a cell), or there are more than 4
/// million.
void check_published_path(const std::string& name, const PublishedPath& path);

}  // namespace slalom
