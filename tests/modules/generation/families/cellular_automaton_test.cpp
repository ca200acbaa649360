// SPDX-License-Identifier: BSD-3-Clause
#include "family_samples.h"

#include <slalom/generation/cellular_automaton.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

AutomatonCells cells_of(const std::vector<std::string>& rows) {
  AutomatonCells cells{static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), {}};
  for (const std::string& row : rows)
    for (const char c : row) cells.filled.push_back(c == '#');
  return cells;
}

std::vector<std::string> rows_of(const AutomatonCells& cells) {
  std::vector<std::string> rows;
  for (int y = 0; y < cells.rows; ++y) {
    rows.emplace_back();
    for (int x = 0; x < cells.columns; ++x) rows.back() += cells.at(x, y) ? '#' : '.';
  }
  return rows;
}

TEST(CellularAutomaton, FillsCellsWithTheGivenProbability) {
  RandomEngine engine(6);
  const int columns = 200, rows = 102;
  for (const double p : {0.15, 0.5}) {
    const AutomatonCells cells = fill_cells(engine, columns, rows, p);
    const double all = std::accumulate(cells.filled.begin(), cells.filled.end(), 0.0);
    // The outer rows are filled; the others are n = 20,000 draws, the fraction of filled ones has
    // the standard deviation sqrt(p (1 - p) / n).
    const double n = 200 * 100, fraction = (all - 2 * 200) / n;
    EXPECT_NEAR(fraction, p, 5 * std::sqrt(p * (1 - p) / n));
    for (int x = 0; x < columns; ++x) EXPECT_TRUE(cells.at(x, 0) && cells.at(x, rows - 1));
  }
}

TEST(CellularAutomaton, OneStepAppliesBirthAndSurvival) {
  // Cells beyond the first and last row count as filled, so cells of those rows have at least three
  // filled neighbors (two at the corners).
  const auto next = smooth_cells(cells_of({".....",    //
                                           "..#..",    //
                                           ".#.#.",    //
                                           "..##.",    //
                                           ".....",    //
                                           "....#",    //
                                           "....."}),  //
                                 4, 2);
  // The center of the ring has 5 neighbors and becomes filled; the isolated cell has none and
  // becomes empty. Cells of the outer rows have at most 3 + 1 neighbors and remain empty.
  EXPECT_EQ(rows_of(next), (std::vector<std::string>{".....",  //
                                                     "..#..",  //
                                                     ".###.",  //
                                                     "..##.",  //
                                                     ".....",  //
                                                     ".....",  //
                                                     "....."}));
}

TEST(CellularAutomaton, RepresentsFilledCellsAsCylindersOrGridCells) {
  const std::string fixed = "min_fill = 0.2\nmax_fill = 0.2\n";
  RandomEngine one(5), other(5);
  const Scenario cylinders = family("cellular_automaton", fixed)->generate("x", one);
  const Scenario cells =
      family("cellular_automaton", fixed + "obstacles = cells\n")->generate("x", other);
  std::size_t occupied = 0;
  const auto& map = *cells.grid_map();
  for (unsigned y = 0; y < map.getSizeY(); ++y)
    for (unsigned x = 0; x < map.getSizeX(); ++x)
      occupied += map.getCell(int(x), int(y)) < 0.5F ? 1 : 0;
  EXPECT_EQ(cylinders.primitives().discs.size(), occupied);
  for (const Disc& disc : cylinders.primitives().discs) EXPECT_EQ(disc.radius, 0.15 / 2);
  EXPECT_NEAR(map.getResolution(), 0.15, 1e-6);
  EXPECT_EQ(map.getSizeX(), 30U + 2 * 12U);  // a lead of 1.8 m on either side
  EXPECT_EQ(map.getSizeY(), 30U);
}

TEST(CellularAutomaton, StartAndGoalLieOnOppositeSidesOfTheField) {
  const auto generator = family("cellular_automaton", "min_distance = 1\n");
  RandomEngine engine(5);
  for (int i = 0; i < 20; ++i) {
    const Scenario s = generator->generate("x", engine);
    EXPECT_LT(s.start().x, 1.8);
    EXPECT_GT(s.goal().x, s.bounds().x_max - 1.8);
  }
}

TEST(CellularAutomaton, RejectsInvalidOptions) {
  EXPECT_NE(refusal("cellular_automaton", "lead = 1\n").find("[generator.cellular_automaton] lead"),
            std::string::npos);
  EXPECT_NE(refusal("cellular_automaton", "min_fill = 0.5\n").find("max_fill: is less"),
            std::string::npos);
  EXPECT_NE(refusal("cellular_automaton", "min_smoothing = 9\n").find("max_smoothing: is less"),
            std::string::npos);
  EXPECT_NE(refusal("cellular_automaton", "obstacles = cubes\n").find("obstacles"),
            std::string::npos);
  EXPECT_NE(refusal("cellular_automaton", "cell = 1e-9\n"), "no error");
}

}  // namespace
}  // namespace slalom
