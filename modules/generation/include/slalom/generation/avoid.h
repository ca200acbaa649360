// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/straight_path.h>

namespace slalom {

/// Section [generator.avoid]: one obstacle on the straight path, in an open workspace.
struct AvoidOptions : StraightPathOptions {
  static constexpr char kFamily[] = "avoid";
  double min_size = 0.3, max_size = 1;       ///< m, side of a box or diameter of a disc
  double min_offset = 0, max_offset = 0.15;  ///< m, of its center from the straight path
  double disc_fraction = 0.5;                ///< fraction of discs, the rest are boxes

  void visit(OptionVisitor& v);
};

/// The center of the obstacle is start_distance ahead of the start, beside the path by the offset
/// to either side. A box is turned by any angle.
std::unique_ptr<Generator> make_generator(const AvoidOptions& options,
                                          const GeneratorContext& context = {});

}  // namespace slalom
