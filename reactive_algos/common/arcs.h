// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/geometry.h"
#include "common/map_kernels.h"

#include <cstddef>
#include <vector>

namespace reactive {

/// Many poses, to be moved together; headings as their cosines and sines. Arrays have
/// padded(size) elements.
struct PoseBatch {
  std::vector<double> x, y, cosine, sine;

  /// `size` copies of `pose`.
  void assign(std::size_t size, const Pose& pose);
};

/// Moves the first `count` poses along arcs of these lengths (m) that turn the heading by `turns`
/// (rad, at most 1e5): integrate() of motion.h, up to rounding errors. Vectorized for the processor
/// at run time, with the same bits on every processor. Arrays have padded(count) elements.
void move_along_arcs(const double* lengths, const double* turns, std::size_t count,
                     PoseBatch& poses);

}  // namespace reactive
