// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

namespace slalom {
namespace {

class ConvertPrograms : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("ring.scenario.yaml", R"(name: ring
representation: grid
bounds: [0, 0, 4, 3]
start: [0.25, 0.25, 0.5]
goal: [3.75, 2.75]
resolution: 0.5
cells:
  - "........"
  - "..####.."
  - "..#..#.."
  - "..#..#.."
  - "..####.."
  - "........"
)");
    ASSERT_EQ(run("slalom-scenarios import ring.scenario.yaml -o ring.scenarios").status, 0);
  }

  /// The hash that `show` prints for the scenario with this name.
  std::string hash(const std::string& list, const std::string& name = "ring") const {
    const std::string text = run("slalom-scenarios show " + list + " --id " + name).out;
    const std::string key = "hash            ";
    const std::size_t at = text.find(key);
    return at == std::string::npos ? "none: " + text : text.substr(at + key.size(), 32);
  }
};

TEST_F(ConvertPrograms, ConvertsAGridToPolygonsAndBackExactly) {
  ASSERT_EQ(run("slalom-scenarios convert ring.scenarios --to continuous -o p.scenarios").status,
            0);
  const std::string shown = run("slalom-scenarios show p.scenarios --id ring").out;
  EXPECT_NE(shown.find("continuous (0 discs, 2 polygons)"), std::string::npos) << shown;
  ASSERT_EQ(
      run("slalom-scenarios convert p.scenarios --to grid --resolution 0.5 -o g.scenarios").status,
      0);
  EXPECT_EQ(hash("g.scenarios"), hash("ring.scenarios"));
  const ProgramResult points =
      run("slalom-scenarios convert p.scenarios --to points -o q.scenarios");
  EXPECT_EQ(points.err, "q.scenarios: 1 scenario\n");
}

TEST_F(ConvertPrograms, RejectsOccupiedStartOrGoal) {
  write("near.scenario.yaml", R"(name: near
representation: points
bounds: [0, 0, 4, 3]
start: [1, 1, 0]
goal: [3, 2]
points:
  - [3.1, 2]
)");
  ASSERT_EQ(
      run("slalom-scenarios import near.scenario.yaml ring.scenario.yaml -o n.scenarios").status,
      0);
  const std::string command =
      "slalom-scenarios convert n.scenarios --to continuous --radius 0.2 -o c.scenarios";
  expect_failure(command, 1, {"near: ", "occupied goal", "continuous", "--skip-blocked"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "c.scenarios"));
  const std::string precious = read("ring.scenarios");
  write("c.scenarios", precious);
  EXPECT_EQ(run(command).status, 1);
  EXPECT_EQ(read("c.scenarios"), precious);
  const ProgramResult result = run(command + " --skip-blocked");
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find("near: occupied goal"), std::string::npos);
  EXPECT_NE(result.err.find("c.scenarios: 1 scenario\n"), std::string::npos);
}

TEST_F(ConvertPrograms, KeepsTagsAndDoesNotReplaceItsInput) {
  ASSERT_EQ(run("slalom-scenarios tag ring.scenarios --add round").status, 0);
  expect_failure("slalom-scenarios convert ring.scenarios --to points -o ring.scenarios", 2,
                 {"-o ring.scenarios", "is also an input"});
  const ProgramResult result =
      run("slalom-scenarios convert ring.scenarios --to points -o points.scenarios");
  ASSERT_EQ(result.status, 0) << result.err;
  const std::string shown = run("slalom-scenarios show points.scenarios --id ring").out;
  EXPECT_NE(shown.find("representation  points"), std::string::npos) << shown;
  EXPECT_EQ(run("slalom-scenarios select points.scenarios --where 'tag = round'").out,
            run("slalom-scenarios list points.scenarios").out);
}

TEST_F(ConvertPrograms, ImportsWhatItExported) {
  for (const std::string file : {"ros ring.yaml", "mrpt ring.gridmap.gz"}) {
    const std::string path = file.substr(file.find(' ') + 1);
    const std::string format = file.substr(0, file.find(' '));
    ASSERT_EQ(
        run("slalom-scenarios export ring.scenarios --id ring --format " + format + " -o " + path)
            .status,
        0);
    const ProgramResult result = run("slalom-scenarios import " + path + " -o again.scenarios");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(hash("again.scenarios"), hash("ring.scenarios")) << format;
  }
  expect_failure("slalom-scenarios export ring.scenarios --id ring --format ros -o ring.png", 2,
                 {"ring.png", "a name with .yaml"});
  ASSERT_EQ(
      run("slalom-scenarios export ring.scenarios --id ring --format mvsim -o r.world.xml").status,
      0);
  EXPECT_NE(read("r.world.xml").find("<file>r.gridmap</file>"), std::string::npos);
}

TEST_F(ConvertPrograms, ImportsAPointMap) {
  write("posts.xyz", "3 1 0.1\n3 2 0.1\n3 3 5\n");
  const std::string command =
      "slalom-scenarios import posts.xyz --start 2.6,0.6 --goal 2.6,1.5 --margin 0.9 --z-max 1 "
      "--robot-radius 0.2 -o p.scenarios";
  const ProgramResult result = run(command);
  ASSERT_EQ(result.status, 0) << result.err;
  const std::string shown = run("slalom-scenarios show p.scenarios --id posts").out;
  EXPECT_NE(shown.find("points (2 points)"), std::string::npos) << shown;
  write("posts.xyz", "3 1\n3 nan\n");
  expect_failure(command, 3, {"posts.xyz:2", "invalid number"});
}

}  // namespace
}  // namespace slalom
