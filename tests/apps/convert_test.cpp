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

  /// The hash that `show` prints for the scenario of that name.
  std::string hash(const std::string& list, const std::string& name = "ring") const {
    const std::string text = run("slalom-scenarios show " + list + " --id " + name).out;
    const std::string key = "hash            ";
    const std::size_t at = text.find(key);
    return at == std::string::npos ? "none: " + text : text.substr(at + key.size(), 32);
  }
};

TEST_F(ConvertPrograms, TurnsAGridIntoPolygonsAndBackWithoutLoss) {
  ASSERT_EQ(run("slalom-scenarios convert ring.scenarios --to continuous -o p.scenarios").status,
            0);
  const std::string shown = run("slalom-scenarios show p.scenarios --id ring").out;
  EXPECT_NE(shown.find("continuous (0 discs, 2 polygons)"), std::string::npos) << shown;
  ASSERT_EQ(
      run("slalom-scenarios convert p.scenarios --to grid --resolution 0.5 -o g.scenarios").status,
      0);
  EXPECT_EQ(hash("g.scenarios"), hash("ring.scenarios"));
  const Ended points = run("slalom-scenarios convert p.scenarios --to points -o q.scenarios");
  EXPECT_EQ(points.err, "q.scenarios: 1 scenarios\n");
}

TEST_F(ConvertPrograms, RefusesToCoverStartOrGoal) {
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
  expect_refusal(command, 1, {"near: its goal would be occupied as continuous", "--skip-blocked"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "c.scenarios"));
  write("c.scenarios", "precious");
  EXPECT_EQ(run(command).status, 1);
  EXPECT_EQ(read("c.scenarios"), "precious");
  const Ended ended = run(command + " --skip-blocked");
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.err.find("near: its goal would be occupied"), std::string::npos);
  EXPECT_NE(ended.err.find("c.scenarios: 1 scenarios"), std::string::npos);
}

TEST_F(ConvertPrograms, TakesThePlaceOfItsOwnListAndKeepsTags) {
  ASSERT_EQ(run("slalom-scenarios tag ring.scenarios --add round").status, 0);
  const Ended ended = run("slalom-scenarios convert ring.scenarios --to points -o ring.scenarios");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string shown = run("slalom-scenarios show ring.scenarios --id ring").out;
  EXPECT_NE(shown.find("representation  points"), std::string::npos) << shown;
  EXPECT_EQ(run("slalom-scenarios select ring.scenarios --where 'tag = round'").out,
            run("slalom-scenarios list ring.scenarios").out);
}

TEST_F(ConvertPrograms, ImportsWhatItExported) {
  for (const std::string file : {"ros ring.yaml", "mrpt ring.gridmap.gz"}) {
    const std::string path = file.substr(file.find(' ') + 1);
    const std::string format = file.substr(0, file.find(' '));
    ASSERT_EQ(
        run("slalom-scenarios export ring.scenarios --id ring --format " + format + " -o " + path)
            .status,
        0);
    const Ended ended = run("slalom-scenarios import " + path + " -o again.scenarios");
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(hash("again.scenarios"), hash("ring.scenarios")) << format;
  }
  expect_refusal("slalom-scenarios export ring.scenarios --id ring --format ros -o ring.png", 2,
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
  const Ended ended = run(command);
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string shown = run("slalom-scenarios show p.scenarios --id posts").out;
  EXPECT_NE(shown.find("points (2 points)"), std::string::npos) << shown;
  write("posts.xyz", "3 1\n3 nan\n");
  expect_refusal(command, 3, {"posts.xyz:2", "no finite number"});
}

}  // namespace
}  // namespace slalom
