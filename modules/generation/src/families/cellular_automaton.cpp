// SPDX-License-Identifier: BSD-3-Clause
#include "family.h"
#include "grid_scenario.h"

#include <slalom/generation/cellular_automaton.h>

#include <cmath>

namespace slalom {
namespace {

int filled_neighbors(const AutomatonCells& cells, int column, int row) {
  int count = 0;
  for (int y = row - 1; y <= row + 1; ++y)
    for (int x = column - 1; x <= column + 1; ++x) {
      if (x == column && y == row) continue;
      const bool beyond_rows = y < 0 || y >= cells.rows;
      const bool beyond_columns = x < 0 || x >= cells.columns;
      if (beyond_rows || (!beyond_columns && cells.at(x, y))) ++count;
    }
  return count;
}

class CellularAutomaton : public Generator {
 public:
  explicit CellularAutomaton(const CellularAutomatonOptions& options)
      : options_(options), lead_cells_(static_cast<int>(std::ceil(options.lead / options.cell))) {}

  std::string name() const override { return "cellular_automaton"; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const double fill = uniform_real(engine, options_.min_fill, options_.max_fill);
    AutomatonCells cells = fill_cells(engine, options_.columns, options_.rows, fill);
    const int smoothing = uniform_int(engine, options_.min_smoothing, options_.max_smoothing);
    for (int i = 0; i < smoothing; ++i)
      cells = smooth_cells(cells, options_.birth, options_.survival);
    return options_.obstacles == FilledCell::GridCell ? grid_of(scenario_name, cells, engine)
                                                      : cylinders_of(scenario_name, cells, engine);
  }

 private:
  Scenario cylinders_of(const std::string& name, const AutomatonCells& cells,
                        RandomEngine& engine) const {
    const double cell = options_.cell;
    const Bounds workspace = {0, 0, (cells.columns + 2 * lead_cells_) * cell, cells.rows * cell};
    Primitives cylinders;
    for (int y = 0; y < cells.rows; ++y)
      for (int x = 0; x < cells.columns; ++x)
        if (cells.at(x, y))
          cylinders.discs.push_back({{(lead_cells_ + x + 0.5) * cell, (y + 0.5) * cell}, cell / 2});
    const StartGoal start_goal = sample_outside_field(
        engine, workspace, clearance_filter(cylinders, options_.start_goal.clear_radius));
    const auto start = start_pose(engine, start_goal);
    return Scenario::continuous(name, workspace, std::move(cylinders), start, start_goal.goal);
  }

  Scenario grid_of(const std::string& name, const AutomatonCells& cells,
                   RandomEngine& engine) const {
    Occupancy occupancy(cells.columns + 2 * lead_cells_, cells.rows, options_.cell, {0, 0});
    for (int y = 0; y < cells.rows; ++y)
      for (int x = 0; x < cells.columns; ++x)
        if (cells.at(x, y)) occupancy.set_occupied(lead_cells_ + x, y, true);
    const DistanceField field(occupancy);
    const StartGoal start_goal = sample_outside_field(
        engine, occupancy.bounds(), clearance_filter(field, options_.start_goal.clear_radius));
    return grid_scenario(name, occupancy, start_pose(engine, start_goal), start_goal.goal);
  }

  /// Samples the start in the free strip before the field and the goal in the one behind it.
  StartGoal sample_outside_field(RandomEngine& engine, const Bounds& workspace,
                                 const PositionFilter& is_valid) const {
    Bounds before = workspace, behind = workspace;
    before.x_max = workspace.x_min + lead_cells_ * options_.cell;
    behind.x_min = workspace.x_max - lead_cells_ * options_.cell;
    return sample_start_goal(engine, before, behind, options_.start_goal, is_valid);
  }

  CellularAutomatonOptions options_;
  int lead_cells_;
};

}  // namespace

AutomatonCells fill_cells(RandomEngine& engine, int columns, int rows, double probability) {
  AutomatonCells cells{columns, rows, {}};
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      cells.filled.push_back(y == 0 || y == rows - 1 || uniform_real(engine, 0, 1) < probability);
  return cells;
}

AutomatonCells smooth_cells(const AutomatonCells& cells, int birth, int survival) {
  AutomatonCells next = cells;
  for (int y = 0; y < cells.rows; ++y)
    for (int x = 0; x < cells.columns; ++x) {
      const int neighbors = filled_neighbors(cells, x, y);
      auto& cell =
          next.filled[static_cast<std::size_t>(y) * static_cast<std::size_t>(cells.columns) +
                      static_cast<std::size_t>(x)];
      if (neighbors > birth) cell = 1;
      if (neighbors < survival) cell = 0;
    }
  return next;
}

void CellularAutomatonOptions::visit(OptionVisitor& v) {
  v.option("columns", columns, "-", "cells along the direction of travel", Range::between(1, 4000));
  v.option("rows", rows, "-", "cells across the direction of travel", Range::between(3, 4000));
  v.option("cell", cell, "m", "side of a cell, diameter of a cylinder", Range::positive());
  v.option("min_fill", min_fill, "-", "minimum probability that a cell is filled",
           Range::between(0, 1));
  v.option("max_fill", max_fill, "-", "maximum probability that a cell is filled",
           Range::between(0, 1));
  v.option("min_smoothing", min_smoothing, "-", "minimum number of smoothing steps",
           Range::between(0, 100));
  v.option("max_smoothing", max_smoothing, "-", "maximum number of smoothing steps",
           Range::between(0, 100));
  v.option("birth", birth, "-", "a cell with more filled neighbors becomes filled",
           Range::between(0, 8));
  v.option("survival", survival, "-", "a cell with fewer filled neighbors becomes empty",
           Range::between(0, 8));
  v.option("lead", lead, "m", "length of the free strips before and behind the field",
           Range::positive());
  v.option("obstacles", obstacles, "representation of a filled cell");
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const CellularAutomatonOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(CellularAutomatonOptions::kFamily, context);
  const auto options = checks.scaled(given);
  checks.expect_order("min_fill", options.min_fill, "max_fill", options.max_fill);
  checks.expect_order("min_smoothing", options.min_smoothing, "max_smoothing",
                      options.max_smoothing);
  checks.expect(options.lead > 2 * options.start_goal.margin, "lead",
                "leaves no space for start and goal", "more than twice margin");
  checks.expect(options.lead / options.cell <= 4000, "lead", "is too long for such cells",
                "at most 4000 cells");
  checks.expect_start_goal_fit(options.start_goal,
                               options.columns * options.cell + 2 * options.lead,
                               options.rows * options.cell);
  return std::make_unique<CellularAutomaton>(options);
}

}  // namespace slalom
