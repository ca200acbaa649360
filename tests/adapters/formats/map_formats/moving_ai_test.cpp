// SPDX-License-Identifier: BSD-3-Clause
#include "map_files.h"

#include <slalom/map_formats/map_import.h>
#include <slalom/map_formats/moving_ai.h>

#include <gtest/gtest.h>

#include <cmath>
#include <queue>
#include <sstream>

namespace slalom {
namespace {

using Map = mrpt::maps::COccupancyGridMap2D;

const std::string kRows[] = {"....@...", ".TT.@.@.", ".T....@G", "...@@O@."};

std::string map_text(const std::string& line_end) {
  std::string text =
      "type octile" + line_end + "height 4" + line_end + "width 8" + line_end + "map" + line_end;
  for (const std::string& row : kRows) text += row + line_end;
  return text;
}

/// Whether reading this map fails in `line` ("5") with a message that mentions `words`.
testing::AssertionResult rejects_map(const std::string& text, const std::string& line,
                                     std::initializer_list<std::string> words) {
  const MapFolder folder;
  const std::string path = folder.write("m.map", text);
  return throws_error(ErrorKind::File, path + ":" + line + ": ", words,
                      [&] { read_moving_ai_map(path, 1); });
}

bool is_free(const Map& map, int x, int y) {
  const int size_x = static_cast<int>(map.getSizeX()), size_y = static_cast<int>(map.getSizeY());
  return x >= 0 && y >= 0 && x < size_x && y < size_y && map.getCell(x, size_y - 1 - y) > 0.5F;
}

/// Length of the shortest 8-connected path between cells (y from above); diagonals require that
/// both adjacent cells are free.
double dijkstra(const Map& map, const MovingAiProblem& problem) {
  const int width = static_cast<int>(map.getSizeX()), height = static_cast<int>(map.getSizeY());
  std::vector<double> best(static_cast<std::size_t>(width * height), 1e300);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  open.push({0, problem.start_y * width + problem.start_x});
  while (!open.empty()) {
    const auto [length, cell] = open.top();
    open.pop();
    if (length >= best[static_cast<std::size_t>(cell)]) continue;
    best[static_cast<std::size_t>(cell)] = length;
    const int x = cell % width, y = cell / width;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (is_free(map, x + dx, y + dy) && is_free(map, x + dx, y) && is_free(map, x, y + dy))
          open.push({length + std::hypot(dx, dy), cell + dy * width + dx});
  }
  const int goal = problem.goal_y * width + problem.goal_x;
  return best[static_cast<std::size_t>(goal)];
}

TEST(MovingAiMap, ReadsTheTopRowFirstWithAnyLineEnds) {
  const MapFolder folder;
  for (const std::string line_end : {"\n", "\r\n"}) {
    const Map map = read_moving_ai_map(folder.write("m.map", map_text(line_end)), 0.5);
    EXPECT_EQ(map.getSizeX(), 8U);
    EXPECT_EQ(map.getSizeY(), 4U);
    EXPECT_FLOAT_EQ(map.getResolution(), 0.5F);
    EXPECT_EQ(map.getXMin(), 0);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 8; ++x) {
        const char c = kRows[y][static_cast<std::size_t>(x)];
        EXPECT_EQ(is_free(map, x, y), c == '.' || c == 'G') << x << " " << y;
      }
  }
}

TEST(MovingAiMap, IsReadByLoadMap) {
  const MapFolder folder;
  const std::string path = folder.write("m.map", map_text("\n"));
  MapImportOptions options;
  options.cell_size = 0.25;
  EXPECT_FLOAT_EQ(load_map(path, options).getXMax(), 2);
  EXPECT_TRUE(throws_error(ErrorKind::Usage, path + ": ", {"cell size", "--cell-size"},
                           [&] { load_map(path, {}); }));
}

TEST(MovingAiMap, RejectsSwampAndWater) {
  const std::string header = "type octile\nheight 1\nwidth 3\nmap\n";
  EXPECT_TRUE(rejects_map(header + "..S\n", "5", {"swamp", "column 3", "free and occupied"}));
  EXPECT_TRUE(rejects_map(header + "W..\n", "5", {"water", "column 1"}));
}

TEST(MovingAiMap, ReportsTheLineOfErrors) {
  const std::string header = "type octile\nheight 2\nwidth 3\nmap\n";
  EXPECT_TRUE(rejects_map(header + "...\n..\n..\n", "6", {"has 2 cells"}));
  EXPECT_TRUE(rejects_map(header + "...\n..x\n", "6", {"has an unknown cell in column 3"}));
  EXPECT_TRUE(rejects_map(header + "......\n", "5", {"has 6 cells"}));
  EXPECT_TRUE(rejects_map(header + "...\n...\n...\n", "7", {"after the last row"}));
  EXPECT_TRUE(rejects_map(header + "...\n", "4", {"declares 3 x 2 cells"}));
  EXPECT_TRUE(rejects_map("type tile\n", "1", {"unsupported type", "octile"}));
  EXPECT_TRUE(rejects_map("type octile\nheight 0\n", "2", {"invalid height"}));
  EXPECT_TRUE(rejects_map("type octile\nwidth 99999999999\n", "2", {"invalid width"}));
  EXPECT_TRUE(rejects_map("type octile\nheight 1\nmap\n.\n", "3", {"incomplete header"}));
  EXPECT_TRUE(rejects_map("\x01\x02\n", "1", {"unknown entry '"}));
  EXPECT_TRUE(rejects_map("", "0", {"no map"}));
  EXPECT_TRUE(rejects_map("type octile\nheight 65536\nwidth 65536\nmap\n..\n", "4",
                          {"declares 65536 x 65536 cells"}));
}

/// In the map above. Every diagonal of these paths has an adjacent occupied cell, so there are only
/// straight steps. To (3,0): 3. From (3,1): (3,2) (4,2) (5,2) (5,1). To (5,2): by (3,0), then
/// (3,1) (3,2) (4,2) (5,2). To (7,3): (1,3) (2,3), (2,2) to (5,2), (5,1) (5,0) (6,0), (7,0) to
/// (7,3): 2 + 4 + 3 + 4.
const char* const kProblems =
    "version 1\n"
    "0\tmaps/m.map\t8\t4\t0\t0\t3\t0\t3\n"
    "0\tmaps/m.map\t8\t4\t3\t1\t5\t1\t4\n"
    "1\tmaps/m.map\t8\t4\t0\t1\t0\t1\t0\n"
    "1\tmaps/m.map\t8\t4\t0\t0\t5\t2\t7\n"
    "3\tmaps/m.map\t8\t4\t0\t3\t7\t3\t13\n";

TEST(MovingAiProblems, ReadsColumnsOfTabsOrSpaces) {
  const MapFolder folder;
  std::string spaces = kProblems;
  for (char& c : spaces)
    if (c == '\t') c = ' ';
  spaces.replace(spaces.find("version 1"), 9, "version 1.0");
  for (const std::string& text : {std::string(kProblems), spaces}) {
    const auto problems = read_moving_ai_problems(folder.write("m.map.scen", text));
    ASSERT_EQ(problems.size(), 5U);
    EXPECT_EQ(problems[4].bucket, 3);
    EXPECT_EQ(problems[4].start_x, 0);
    EXPECT_EQ(problems[4].start_y, 3);
    EXPECT_EQ(problems[4].goal_x, 7);
    EXPECT_EQ(problems[4].goal_y, 3);
    EXPECT_EQ(problems[4].published_length, 13);
    EXPECT_EQ(problems[4].line, 6);
  }
}

TEST(MovingAiProblems, LengthsAreOfEightConnectedPathsWithoutCuttingCorners) {
  const MapFolder folder;
  const Map map = read_moving_ai_map(folder.write("m.map", map_text("\n")), 1);
  for (const auto& problem : read_moving_ai_problems(folder.write("m.scen", kProblems)))
    EXPECT_DOUBLE_EQ(dijkstra(map, problem), problem.published_length) << problem.line;
  // No obstacles: 2 diagonals and 1 straight step, as published with 6 digits.
  const Map open = read_moving_ai_map(
      folder.write("o.map", "type octile\nheight 3\nwidth 4\nmap\n....\n....\n....\n"), 1);
  const auto across = read_moving_ai_problems(
      folder.write("o.scen", "version 1\n0\to.map\t4\t3\t0\t0\t3\t2\t3.82843\n"));
  EXPECT_NEAR(dijkstra(open, across.at(0)), across.at(0).published_length, 5e-6);
}

TEST(MovingAiProblems, AreSelectedByDifficultyAndNumber) {
  const MapFolder folder;
  const auto problems = read_moving_ai_problems(folder.write("m.scen", kProblems));
  const auto lines = [&](const ProblemSelection& selection) {
    std::string text;
    for (const MovingAiProblem& p : select_problems(problems, selection))
      text += std::to_string(p.line) + " ";
    return text;
  };
  EXPECT_EQ(lines({}), "2 3 5 6 ");  // start and goal of line 4 are equal
  EXPECT_EQ(lines({1, 3, 0}), "5 6 ");
  EXPECT_EQ(lines({0, 0, 0}), "2 3 ");
  EXPECT_EQ(lines({0, 9, 2}), "2 5 ");
  EXPECT_EQ(lines({0, 9, 99}), "2 3 5 6 ");
  EXPECT_EQ(lines({7, 9, 0}), "");
}

TEST(MovingAiProblems, RejectsMalformedLines) {
  const MapFolder folder;
  const auto rejects = [&](const std::string& text, const std::string& line,
                           std::initializer_list<std::string> words) {
    const std::string path = folder.write("m.scen", text);
    return throws_error(ErrorKind::File, path + ":" + line + ": ", words,
                        [&] { read_moving_ai_problems(path); });
  };
  EXPECT_TRUE(rejects("", "0", {"missing version"}));
  EXPECT_TRUE(rejects("version 2\n", "1", {"missing version"}));
  EXPECT_TRUE(rejects("version 1\n0 m 8 4 0 0 3 0\n", "2", {"has 8 columns"}));
  EXPECT_TRUE(rejects("version 1\n0 m 8 4 8 0 3 0 3\n", "2",
                      {"start x '8' is outside the map", "expected 0 to 7"}));
  EXPECT_TRUE(rejects("version 1\n0 m 8 4 0 0 3 -1 3\n", "2", {"goal y '-1'"}));
  EXPECT_TRUE(rejects("version 1\n0 m 8 4 0 0 3 0 nan\n", "2", {"the length is 'nan'"}));
  EXPECT_TRUE(rejects("version 1\n-1 m 8 4 0 0 3 0 3\n", "2", {"the bucket is '-1'"}));
  EXPECT_TRUE(rejects("version 1\n0 m 99999999999 4 0 0 3 0 3\n", "2", {"the map's width is"}));
}

}  // namespace
}  // namespace slalom
