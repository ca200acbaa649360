// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

namespace slalom {
namespace {

using ImportProgram = ProgramTest;

/// 8 x 4 cells with a wall in the middle and a gap at the bottom.
const char* const kMap =
    "type octile\nheight 4\nwidth 8\nmap\n....@...\n....@...\n....@...\n........\n";
const char* const kProblems =
    "version 1\n"
    "0\tm.map\t8\t4\t0\t0\t2\t0\t2\n"
    "2\tm.map\t8\t4\t0\t3\t7\t3\t7\n"
    "2\tm.map\t8\t4\t3\t0\t5\t0\t8\n";

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST_F(ImportProgram, MovingAiProblemsAreSelectedByDifficulty) {
  write("m.map", kMap);
  write("m.map.scen", kProblems);
  const ProgramResult all =
      run("slalom-scenarios import m.map --cell-size 1 --scen m.map.scen -o a.scenarios");
  ASSERT_EQ(all.status, 0) << all.err;
  EXPECT_EQ(lines_of(run("slalom-scenarios list a.scenarios").out), 3U);
  ASSERT_EQ(run("slalom-scenarios import m.map --cell-size 1 --scen m.map.scen --buckets 2-9 "
                "--pairs 1 -o b.scenarios")
                .status,
            0);
  // The upper left cell of the file is at x 0 to 1, y 3 to 4; row 3 is the lowest one.
  const std::string shown = run("slalom-scenarios show b.scenarios --id m_bucket2_line3").out;
  EXPECT_NE(shown.find("start           0.5 m, 0.5 m, 0 rad"), std::string::npos) << shown;
  EXPECT_NE(shown.find("goal            7.5 m, 0.5 m"), std::string::npos) << shown;
}

TEST_F(ImportProgram, MovingAiProblemsThatAreUnsolvableAreLeftOut) {
  write("m.map", kMap);
  write("m.map.scen", kProblems);
  // Cells of 2 m: all starts are in border cells, 1 m from the wall.
  const std::string import =
      "slalom-scenarios import m.map --cell-size 2 -o a.scenarios --scen m.map.scen";
  expect_failure(import + " --robot-radius 1.01", 1,
                 {"m.map.scen", "no problem is solvable for a robot of radius 1.01 m"});
  write("inner.scen", std::string(kProblems) + "0\tm.map\t8\t4\t1\t1\t2\t2\t1.41421\n");
  const ProgramResult result =
      run("slalom-scenarios import m.map --cell-size 2 -o a.scenarios --scen "
          "inner.scen --robot-radius 1.01");
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find("left out 3 problems"), std::string::npos) << result.err;
}

TEST_F(ImportProgram, InvalidMovingAiProblemsAreRejected) {
  write("m.map", kMap);
  write("m.map.scen", kProblems);
  write("blocked.scen", "version 1\n0\tm.map\t8\t4\t4\t0\t2\t0\t2\n");
  write("other.scen", "version 1\n0\tm.map\t9\t4\t0\t0\t2\t0\t2\n");
  const std::string import = "slalom-scenarios import m.map -o a.scenarios --cell-size 1 --scen ";
  expect_failure(import + "blocked.scen", 3, {"blocked.scen:2", "occupied cell"});
  expect_failure(import + "other.scen", 3, {"other.scen:2", "9 x 4 cells"});
  expect_failure(import + "m.map.scen --buckets 7-8", 2, {"no problems of that difficulty"});
  expect_failure(import + "m.map.scen --buckets 8-7", 2,
                 {"--buckets 8-7", "range of difficulties"});
  expect_failure("slalom-scenarios import m.map --pairs 1 -o a.scenarios", 2, {"--cell-size"});
}

TEST_F(ImportProgram, ImagesBecomeMapsWithPairsOfTheRequestedDifficulty) {
  // 12 x 10 m, cells of 0.5 m: a free area with a wall across it that has a gap at the bottom.
  std::string image = "P2 24 20 255\n";
  for (int row = 0; row < 20; ++row)
    for (int x = 0; x < 24; ++x) image += x == 12 && row < 16 ? "0 " : "255 ";
  write("area.pgm", image);
  const ProgramResult result =
      run("slalom-scenarios import area.pgm --image-resolution 0.5 --pairs 3 "
          "--min-distance 2 --max-distance 9 --min-detour 1.2 -o a.scenarios");
  ASSERT_EQ(result.status, 0) << result.err;
  const std::string values =
      run("slalom-scenarios describe a.scenarios --descriptors detour_ratio").out;
  std::istringstream in(values);
  int ratios = 0;
  for (std::string word; in >> word;) {
    if (word != "=") continue;
    double ratio = 0;
    in >> ratio;
    EXPECT_GE(ratio, 1.2) << values;
    ++ratios;
  }
  EXPECT_EQ(ratios, 3);
  expect_failure("slalom-scenarios import area.pgm --pairs 1 -o a.scenarios", 2,
                 {"area.pgm", "--image-resolution"});
  expect_failure(
      "slalom-scenarios import area.pgm --image-resolution 0.5 --pairs 1 "
      "--min-distance 3 --max-distance 2 -o a.scenarios",
      2, {"distance from 3 to 2"});
}

TEST_F(ImportProgram, PairsOfAFileAreNamedByItsLines) {
  write("area.pgm", "P2 8 4 255\n" + std::string("255 255 255 0 255 255 255 255 ") +
                        "255 255 255 0 255 255 255 255 255 255 255 0 255 255 255 255 "
                        "255 255 255 0 255 255 255 255\n");  // a wall from x 3 to 4
  write("pairs.csv", "x,y,phi,gx,gy\n1,1,0,2,3\n5,1,0,7,3\n");
  const std::string import =
      "slalom-scenarios import area.pgm --image-resolution 1 -o a.scenarios --pairs ";
  ASSERT_EQ(run(import + "pairs.csv").status, 0);
  const std::string shown = run("slalom-scenarios show a.scenarios --id area_line3").out;
  EXPECT_NE(shown.find("goal            7 m, 3 m"), std::string::npos) << shown;
  write("goals.csv", "2,3\n7,3\n");
  expect_failure(import + "goals.csv --start 1,1,0", 1, {"goals.csv:2: ", "unsolvable pair"});
  expect_failure(import + "goals.csv --start 1,1,0 --goal 2,2", 2, {"--goal: goals.csv has"});
  expect_failure(import + "0", 2, {"--pairs: 0 is out of range", "1 to 1000000"});
  expect_failure(import + "none.csv", 3, {"none.csv"});
  write("m.map", kMap);
  write("m.map.scen", kProblems);
  expect_failure(
      "slalom-scenarios import m.map --cell-size 1 --scen m.map.scen --pairs goals.csv "
      "-o b.scenarios",
      2, {"--pairs: m.map.scen has the pairs"});
}

TEST_F(ImportProgram, OptionsOutOfRangeAreRefusedWithTheirRange) {
  const std::string import = "slalom-scenarios import area.pgm -o a.scenarios ";
  expect_failure(import + "--margin -1", 2, {"--margin: '-1' is not valid", "a number > 0, in m"});
  expect_failure(import + "--image-threshold 256", 2, {"'256'", "an integer in [1, 255]"});
  expect_failure(import + "--task other", 2, {"--task", "other"});
}

TEST_F(ImportProgram, BarnWorldsKeepTheirPathAndItsMetrics) {
  // A generated world: 30 x 30 cells, free except rows 0 and 29, with a path along row 15.
  const auto npy = [](int rows, int columns, const std::vector<int>& numbers) {
    std::string head = "{'descr': '<i8', 'fortran_order': False, 'shape': (" +
                       std::to_string(rows) + ", " + std::to_string(columns) + "), }";
    head.resize(117, ' ');
    std::string bytes = std::string("\x93NUMPY\x01\0\x76\0", 10) + head + "\n";
    for (const int number : numbers) bytes += static_cast<char>(number) + std::string(7, '\0');
    return bytes;
  };
  std::vector<int> cells(900, 0), path = {15, 0};
  for (std::size_t column = 0; column < 30; ++column) cells[column] = cells[870 + column] = 1;
  for (int column = 0; column < 30; ++column) path.insert(path.end(), {15, column});
  std::filesystem::create_directories(folder_ / "set/grid_files");
  std::filesystem::create_directories(folder_ / "set/path_files");
  write("set/grid_files/grid_4.npy", npy(30, 30, cells));
  write("set/path_files/path_4.npy", npy(31, 2, path));
  const ProgramResult result =
      run("slalom-scenarios import set --worlds 0-299/even -o barn.scenarios");
  ASSERT_EQ(result.status, 0) << result.err;
  // Dilated, the walls fill rows 0 to 2 and 27 to 29: 12 cells to row 27, in all rows 3 to 26 are
  // free, 23 without row 15; the path is straight.
  const std::string text =
      run("slalom-scenarios describe barn.scenarios --descriptors "
          "barn_closest_distance,barn_tortuosity,barn_characteristic_dimension")
          .out;
  EXPECT_NE(text.find("barn_closest_distance = 12.0000 cells"), std::string::npos) << text;
  EXPECT_NE(text.find("barn_tortuosity = 1.0000\n"), std::string::npos) << text;
  // The export to YAML includes the path.
  ASSERT_EQ(run("slalom-scenarios export barn.scenarios --id barn_4 -o w.scenario.yaml").status, 0);
  ASSERT_EQ(run("slalom-scenarios import w.scenario.yaml -o again.scenarios").status, 0);
  EXPECT_EQ(run("slalom-scenarios describe again.scenarios --descriptors "
                "barn_closest_distance,barn_tortuosity,barn_characteristic_dimension")
                .out,
            text);
  expect_failure("slalom-scenarios import set --worlds 5 -o barn.scenarios", 2,
                 {"--worlds 5", "worlds from 4 to 4"});
}

}  // namespace
}  // namespace slalom
