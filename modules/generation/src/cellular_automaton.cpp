#include "family.h"
#include "grid_scenario.h"

#include <slalom/generation/cellular_automaton.h>

#include <cmath>

namespace slalom {
namespace {

int filled_neighbours(const AutomatonCells& cells, int column, int row) {
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
    return options_.obstacles == "cells" ? of_cells(scenario_name, cells, engine)
                                         : of_cylinders(scenario_name, cells, engine);
  }

 private:
  Scenario of_cylinders(const std::string& name, const AutomatonCells& cells,
                        RandomEngine& engine) const {
    const double cell = options_.cell;
    const Bounds floor = {0, 0, (cells.columns + 2 * lead_cells_) * cell, cells.rows * cell};
    Primitives cylinders;
    for (int y = 0; y < cells.rows; ++y)
      for (int x = 0; x < cells.columns; ++x)
        if (cells.at(x, y))
          cylinders.discs.push_back({{(lead_cells_ + x + 0.5) * cell, (y + 0.5) * cell}, cell / 2});
    const Ends ends =
        ends_beyond_field(engine, floor, clear_of(cylinders, options_.ends.clear_radius));
    const auto start = start_pose(engine, ends);
    return Scenario::continuous(name, floor, std::move(cylinders), start, ends.goal);
  }

  Scenario of_cells(const std::string& name, const AutomatonCells& cells,
                    RandomEngine& engine) const {
    Occupancy occupancy(cells.columns + 2 * lead_cells_, cells.rows, options_.cell, {0, 0});
    for (int y = 0; y < cells.rows; ++y)
      for (int x = 0; x < cells.columns; ++x)
        if (cells.at(x, y)) occupancy.set_occupied(lead_cells_ + x, y, true);
    const DistanceField field(occupancy);
    const Ends ends =
        ends_beyond_field(engine, occupancy.bounds(), clear_of(field, options_.ends.clear_radius));
    return grid_scenario(name, occupancy, start_pose(engine, ends), ends.goal);
  }

  /// Start in the free strip before the field, goal in the one behind it.
  Ends ends_beyond_field(RandomEngine& engine, const Bounds& floor, const PlaceTest& clear) const {
    Bounds before = floor, behind = floor;
    before.x_max = floor.x_min + lead_cells_ * options_.cell;
    behind.x_min = floor.x_max - lead_cells_ * options_.cell;
    return draw_ends(engine, before, behind, options_.ends, clear);
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
      const int neighbours = filled_neighbours(cells, x, y);
      auto& cell =
          next.filled[static_cast<std::size_t>(y) * static_cast<std::size_t>(cells.columns) +
                      static_cast<std::size_t>(x)];
      if (neighbours > birth) cell = 1;
      if (neighbours < survival) cell = 0;
    }
  return next;
}

void CellularAutomatonOptions::visit(OptionVisitor& v) {
  v.option("columns", columns, "-", "cells of the field along the way", Range::between(1, 4000));
  v.option("rows", rows, "-", "cells of the field across the way", Range::between(3, 4000));
  v.option("cell", cell, "m", "side of a cell, diameter of a cylinder", Range::positive());
  v.option("min_fill", min_fill, "-", "least probability that a cell is filled",
           Range::between(0, 1));
  v.option("max_fill", max_fill, "-", "largest probability that a cell is filled",
           Range::between(0, 1));
  v.option("min_smoothing", min_smoothing, "-", "fewest smoothing steps", Range::between(0, 100));
  v.option("max_smoothing", max_smoothing, "-", "most smoothing steps", Range::between(0, 100));
  v.option("birth", birth, "-", "a cell with more filled neighbours is filled",
           Range::between(0, 8));
  v.option("survival", survival, "-", "a cell with fewer filled neighbours is emptied",
           Range::between(0, 8));
  v.option("lead", lead, "m", "free before and behind the field, for start and goal",
           Range::positive());
  v.option("obstacles", obstacles, "what a filled cell becomes", {"cylinders", "cells"});
  ends.visit(v);
}

std::unique_ptr<Generator> make_cellular_automaton(const IniFile& ini,
                                                   const GeneratorContext& context) {
  const FamilySection section(ini, "cellular_automaton", context);
  const auto options = section.read<CellularAutomatonOptions>();
  section.expect_order("min_fill", options.min_fill, "max_fill", options.max_fill);
  section.expect_order("min_smoothing", options.min_smoothing, "max_smoothing",
                       options.max_smoothing);
  section.expect(options.lead > 2 * options.ends.margin, "lead",
                 "leaves no room for start and goal", "more than twice margin");
  section.expect(options.lead / options.cell <= 4000, "lead", "is too long for such cells",
                 "at most 4000 cells");
  section.expect_room(options.ends, options.columns * options.cell + 2 * options.lead,
                      options.rows * options.cell);
  return std::make_unique<CellularAutomaton>(options);
}

}  // namespace slalom
