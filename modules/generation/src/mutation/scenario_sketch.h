// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/world.h>

#include <array>
#include <cstdint>

namespace slalom {

/// A compact signature of a scenario, to measure the difference of two: its workspace on a lattice
/// of 64 x 64 blocks (two bits each: any cell of the block occupied, at least half of them
/// occupied), the sides of the workspace, start and goal.
struct ScenarioSketch {
  static constexpr int kBlocks = 64;
  std::array<std::uint64_t, kBlocks> any = {}, half = {};  ///< one word per row of blocks
  double width = 0, height = 0;                            ///< m
  std::array<double, 4> task = {};  ///< start x, y, goal x, y as fractions of the sides
};

ScenarioSketch sketch(const World& world);

/// Difference of two scenarios in [0, 1]: the maximum of
/// - the fraction of differing lattice bits, relative to the bits occupied in either or free in
///   either, whichever is less (so that both a few posts in a large workspace and a narrow passage
///   through a filled one count);
/// - the mean displacement of start and goal, as a fraction of the diagonal;
/// - the relative difference of width or height.
double difference(const ScenarioSketch& a, const ScenarioSketch& b);

}  // namespace slalom
