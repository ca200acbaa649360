#pragma once

#include <slalom/scenario/world.h>

#include <array>
#include <cstdint>

namespace slalom {

/// A scenario in few bytes, to tell how much two of them differ: its floor on a lattice of 64 x 64
/// blocks (two bits each: any cell of the block occupied, at least half of them), the sides of the
/// floor and the task.
struct ScenarioSketch {
  static constexpr int kBlocks = 64;
  std::array<std::uint64_t, kBlocks> any = {}, half = {};  ///< one word per row of blocks
  double width = 0, height = 0;                            ///< m
  std::array<double, 4> task = {};  ///< start x, y, goal x, y as shares of the sides
};

ScenarioSketch sketch(const World& world);

/// How much two scenarios differ, in [0, 1]: the largest of
/// - the share of their lattices that differs, relative to what is occupied in either or free in
///   either, whichever is less (so a few posts on a large floor and a narrow way through rock both
///   count);
/// - the mean displacement of start and goal, as a share of the diagonal;
/// - the relative difference of width or height.
double difference(const ScenarioSketch& a, const ScenarioSketch& b);

}  // namespace slalom
