// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/start_goal.h>

#include <cstdint>
#include <string>
#include <vector>

namespace slalom {

/// The representation of a filled cell.
enum class FilledCell {
  Cylinder,  ///< of the cell's diameter
  GridCell
};
constexpr auto enum_names(FilledCell) {
  return std::array{"cylinders", "cells"};
}

/// Section [generator.cellular_automaton]: a field of random cells, smoothed, between start and
/// goal. The generator of the BARN data set (Perille et al., "Benchmarking Metric Ground
/// Navigation", SSRR 2020), whose cells, fills and smoothings are the defaults.
struct CellularAutomatonOptions {
  static constexpr char kFamily[] = "cellular_automaton";
  int columns = 30, rows = 30;             ///< cells along and across the direction of travel
  double cell = 0.15;                      ///< m
  double min_fill = 0.15, max_fill = 0.3;  ///< probability, drawn per scenario
  int min_smoothing = 2, max_smoothing = 4;
  int birth = 4;      ///< a cell with more filled neighbors than this becomes filled
  int survival = 2;   ///< a cell with fewer filled neighbors than this becomes empty
  double lead = 1.8;  ///< m, length of the free strips before and behind the field
  FilledCell obstacles = FilledCell::Cylinder;
  StartGoalOptions start_goal = {0.3, 5, 0.6};

  void visit(OptionVisitor& v);
};

/// Cells filled at random (first and last row completely), then smoothed. The start lies before the
/// field, the goal behind it.
std::unique_ptr<Generator> make_generator(const CellularAutomatonOptions& options,
                                          const GeneratorContext& context = {});

/// Cells of the automaton, row-major; 1: filled.
struct AutomatonCells {
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> filled;

  bool at(int column, int row) const {
    return filled[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)] != 0;
  }
};

/// Fills each cell with `probability`, and all cells of the first and the last row.
AutomatonCells fill_cells(RandomEngine& engine, int columns, int rows, double probability);

/// One step: cells with more than `birth` filled neighbors (of 8) become filled, cells with fewer
/// than `survival` become empty. Neighbors beyond the first and last row count as filled, those
/// beyond the columns as empty.
AutomatonCells smooth_cells(const AutomatonCells& cells, int birth, int survival);

}  // namespace slalom
