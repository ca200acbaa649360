#pragma once

#include <slalom/generation/ends.h>
#include <slalom/generation/generator.h>

#include <cstdint>
#include <string>
#include <vector>

namespace slalom {

/// Section [generator.cellular_automaton]: a field of random cells, smoothed, which the robot
/// crosses. The family of the BARN data set (Perille et al., "Benchmarking Metric Ground
/// Navigation", SSRR 2020), whose cells, fills and smoothings are the defaults.
struct CellularAutomatonOptions {
  int columns = 30, rows = 30;             ///< cells along and across the way
  double cell = 0.15;                      ///< m
  double min_fill = 0.15, max_fill = 0.3;  ///< probability, drawn anew for each scenario
  int min_smoothing = 2, max_smoothing = 4;
  int birth = 4;      ///< a cell with more filled neighbours than this is filled
  int survival = 2;   ///< a cell with fewer filled neighbours than this is emptied
  double lead = 1.8;  ///< m, free before and behind the field, where start and goal lie
  std::string obstacles = "cylinders";  ///< cylinders as wide as a cell, or cells: a grid of them
  EndsOptions ends = {0.3, 5, 0.6};

  void visit(OptionVisitor& v);
};

/// Cells filled at random, the outermost rows wholly, then smoothed. Start before the field and
/// goal behind it.
std::unique_ptr<Generator> make_cellular_automaton(const IniFile& ini,
                                                   const GeneratorContext& context = {});

/// Cells of the automaton, row by row, 1 filled.
struct AutomatonCells {
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> filled;

  bool at(int column, int row) const {
    return filled[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)] != 0;
  }
};

/// Each cell filled with a probability, all of the first and the last row.
AutomatonCells fill_cells(RandomEngine& engine, int columns, int rows, double probability);

/// One step: cells with more than `birth` filled neighbours (of 8) are filled, with fewer than
/// `survival` emptied. What lies beyond the first and last row counts as filled, what lies beyond
/// the columns as empty.
AutomatonCells smooth_cells(const AutomatonCells& cells, int birth, int survival);

}  // namespace slalom
