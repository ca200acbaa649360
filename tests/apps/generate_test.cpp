#include "program_run.h"

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

class Generate : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("mix.ini",
          "[scenarios]\ngenerator = random, maze\n[generator.random]\nwidth = 6\nheight = 6\n"
          "min_distance = 3\nmax_obstacles = 8\n[generator.maze]\ncolumns = 5\nrows = 5\n"
          "min_distance = 3\n");
  }
};

TEST_F(Generate, TheListIsByteIdenticalForAnyNumberOfThreads) {
  const std::string generate =
      "slalom-scenarios generate -c mix.ini -n 140 --quiet --describe density,confinement ";
  ASSERT_EQ(run(generate + "-o a.scenarios").status, 0);
  ASSERT_EQ(run(generate + "-j 3 -o b.scenarios").status, 0);
  const std::string a = read("a.scenarios");
  EXPECT_GT(a.size(), 10000U);
  EXPECT_TRUE(a == read("b.scenarios"));
}

TEST_F(Generate, ValuesAgreeWithThoseOfDescribe) {
  const std::string generate = "slalom-scenarios generate -c mix.ini -n 4 --quiet ";
  ASSERT_EQ(run(generate + "--describe density,clearness -o a.scenarios").status, 0);
  ASSERT_EQ(run(generate + "-o b.scenarios").status, 0);
  const auto values = [&](const std::string& list) {
    std::istringstream lines(
        run("slalom-scenarios describe " + list + " --descriptors density,clearness --json").out);
    std::vector<double> numbers;
    for (std::string line; std::getline(lines, line);) {
      const auto json = nlohmann::json::parse(line);
      numbers.push_back(json["density"].is_object() ? json["density"]["value"].get<double>()
                                                    : json["density"].get<double>());
    }
    return numbers;
  };
  EXPECT_EQ(values("a.scenarios").size(), 4U);
  EXPECT_EQ(values("a.scenarios"), values("b.scenarios"));
}

TEST_F(Generate, WarnsAboutAnApertureInRadians) {
  const std::string command =
      "slalom-scenarios generate -c mix.ini -n 1 -o a.scenarios --set sensor.aperture_deg=3.14";
  const ProgramResult result = run(command);
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find("warning: --set sensor.aperture_deg: 3.14 degrees looks like radians"),
            std::string::npos)
      << result.err;
  EXPECT_EQ(run(command + " --quiet").err, "");
}

TEST_F(Generate, FailedGenerationKeepsTheOldList) {
  ASSERT_EQ(run("slalom-scenarios generate -c mix.ini -n 1 --quiet -o a.scenarios").status, 0);
  const std::string precious = read("a.scenarios");
  expect_failure(
      "slalom-scenarios generate -c mix.ini -n 3 --quiet -o a.scenarios "
      "--set robot.radius=2",
      1, {"_0000", "no solvable scenario"});
  EXPECT_EQ(read("a.scenarios"), precious);
  expect_failure("slalom-scenarios generate -c mix.ini -n 3 -o b.scenarios --describe densty", 2,
                 {"densty", "density"});
  expect_failure(
      "slalom-scenarios generate -c mix.ini -n 3 -o b.scenarios "
      "--set generator.maze.passage=-1",
      2, {"generator.maze.passage", "> 0"});
}

}  // namespace
}  // namespace slalom
