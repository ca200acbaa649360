// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/straight_path.h>

namespace slalom {

/// Section [generator.follow_path]: a winding corridor of constant width.
struct FollowPathOptions {
  static constexpr char kFamily[] = "follow_path";
  int min_segments = 2, max_segments = 5;                 ///< number, drawn per scenario
  double min_segment_length = 2, max_segment_length = 4;  ///< m, of the center line
  double min_turn_deg = 20, max_turn_deg = 60;            ///< from segment to segment
  double min_width = 1, max_width = 1.6;                  ///< m, clear width of the corridor
  double wall = 0.15;                                     ///< m, thickness
  StartAngleOptions angle;                                ///< to the first segment
  StartGoalOptions start_goal = {0.5, 2, 0.5};

  void visit(OptionVisitor& v);
};

/// Turns are to either side, unless the heading of a segment would exceed 80 degrees. Start and
/// goal are on the center line, at its ends less the margin; the last segment is longer if
/// min_distance requires it.
std::unique_ptr<Generator> make_generator(const FollowPathOptions& options,
                                          const GeneratorContext& context = {});

}  // namespace slalom
