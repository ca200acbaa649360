// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_sketch.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr int kBlocks = ScenarioSketch::kBlocks;

int ones(std::uint64_t word) {
  return __builtin_popcountll(word);
}

/// Number of differing bits divided by the smaller of the bits set in either and clear in either.
double lattice_difference(const ScenarioSketch& a, const ScenarioSketch& b) {
  int different = 0, set = 0, clear = 0;
  const auto count = [&](std::uint64_t x, std::uint64_t y) {
    different += ones(x ^ y);
    set += ones(x | y);
    clear += ones(~x | ~y);
  };
  for (std::size_t row = 0; row < a.any.size(); ++row) {
    count(a.any[row], b.any[row]);
    count(a.half[row], b.half[row]);
  }
  return different == 0 ? 0 : static_cast<double>(different) / std::min(set, clear);
}

double task_difference(const ScenarioSketch& a, const ScenarioSketch& b) {
  const double start = math::hypot(a.task[0] - b.task[0], a.task[1] - b.task[1]);
  const double goal = math::hypot(a.task[2] - b.task[2], a.task[3] - b.task[3]);
  return (start + goal) / 2 / std::sqrt(2.0);
}

double relative_difference(double a, double b) {
  return std::abs(a - b) / std::max(a, b);
}

}  // namespace

ScenarioSketch sketch(const World& world) {
  const Occupancy& cells = world.occupancy();
  const Bounds& bounds = world.scenario().bounds();
  ScenarioSketch result;
  constexpr std::size_t kAllBlocks = std::size_t{kBlocks} * kBlocks;
  std::array<int, kAllBlocks> occupied = {}, all = {};
  std::vector<std::size_t> column(static_cast<std::size_t>(cells.size_x()));
  for (std::size_t cx = 0; cx < column.size(); ++cx) column[cx] = cx * kBlocks / column.size();
  for (int cy = 0; cy < cells.size_y(); ++cy) {
    const std::uint8_t* row = cells.cells().data() + cells.index(0, cy);
    const std::size_t block_row =
        static_cast<std::size_t>(cy) * kBlocks / static_cast<std::size_t>(cells.size_y()) * kBlocks;
    for (std::size_t cx = 0; cx < column.size(); ++cx) {
      const std::size_t block = block_row + column[cx];
      occupied[block] += row[cx];
      ++all[block];
    }
  }
  for (std::size_t i = 0; i < occupied.size(); ++i) {
    const std::uint64_t bit = std::uint64_t{1} << (i % kBlocks);
    if (occupied[i] > 0) result.any[i / kBlocks] |= bit;
    if (all[i] > 0 && 2 * occupied[i] >= all[i]) result.half[i / kBlocks] |= bit;
  }
  result.width = bounds.width();
  result.height = bounds.height();
  const auto& start = world.scenario().start();
  const auto& goal = world.scenario().goal();
  result.task = {
      (start.x - bounds.x_min) / bounds.width(), (start.y - bounds.y_min) / bounds.height(),
      (goal.x - bounds.x_min) / bounds.width(), (goal.y - bounds.y_min) / bounds.height()};
  return result;
}

double difference(const ScenarioSketch& a, const ScenarioSketch& b) {
  const double size =
      std::max(relative_difference(a.width, b.width), relative_difference(a.height, b.height));
  return std::max({size, task_difference(a, b), lattice_difference(a, b)});
}

}  // namespace slalom
