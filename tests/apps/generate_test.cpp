// SPDX-License-Identifier: BSD-3-Clause
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

TEST_F(Generate, AFamilyNeedsNoIni) {
  write("maze.ini", "[scenarios]\ngenerator = maze\n[generator.maze]\nrows = 5\ncolumns = 5\n");
  const std::string generate = "slalom-scenarios generate -n 3 --quiet ";
  ASSERT_EQ(run(generate + "-c maze.ini -o a.scenarios").status, 0);
  const std::string options = "--set generator.maze.rows=5 --set generator.maze.columns=5 ";
  ASSERT_EQ(run(generate + "--family maze " + options + "-o b.scenarios").status, 0);
  EXPECT_TRUE(read("a.scenarios") == read("b.scenarios"));
  ASSERT_EQ(run(generate + "-c mix.ini --family random -o c.scenarios").status, 0);
  EXPECT_NE(run("slalom-scenarios list c.scenarios").out.find("random_0002"), std::string::npos);
  const ProgramResult none = run(generate + "-o d.scenarios");
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("expected --family NAME or --config FILE.ini"), std::string::npos)
      << none.err;
  EXPECT_EQ(run(generate + "--family labyrinth -o d.scenarios").status, 2);
}

TEST_F(Generate, TheSeedIsThatOfTheCampaignUnlessAnotherIsGiven) {
  write("seeded.ini", "[campaign]\nseed = 5\n" + read("mix.ini"));
  const auto list = [&](const std::string& arguments) {
    EXPECT_EQ(run("slalom-scenarios generate -n 3 --quiet -o x.scenarios --overwrite " + arguments)
                  .status,
              0);
    return run("slalom-scenarios list x.scenarios").out;
  };
  const std::string of_campaign = list("-c seeded.ini");
  EXPECT_EQ(of_campaign, list("-c mix.ini --seed 5"));
  EXPECT_NE(of_campaign, list("-c mix.ini"));
  EXPECT_EQ(list("-c seeded.ini --seed 1"), list("-c mix.ini"));
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

TEST_F(Generate, ADescriptionThatWasKilledContinuesToTheSameBytes) {
  ASSERT_EQ(run("slalom-scenarios generate -c mix.ini -n 300 -o a.scenarios --quiet").status, 0);
  ASSERT_EQ(run("cp a.scenarios whole.scenarios").status, 0);
  const std::string what = " --descriptors density,clearness";
  const ProgramResult whole = run("slalom-scenarios describe whole.scenarios" + what);
  ASSERT_EQ(whole.status, 0) << whole.err;
  // Its output does not fit into the pipe of 64 KiB that nobody reads: it cannot end before it is
  // killed, as soon as the list contains values.
  const ProgramResult killed = run(
      "sh -c 'mkfifo pipe; slalom-scenarios describe a.scenarios --json" + what +
      " > pipe & exec 3< pipe; until [ $(sqlite3 -readonly a.scenarios \"SELECT count(*) FROM "
      "descriptor_values\" 2>/dev/null || echo 0) -gt 0 ]; do sleep 0.02; kill -0 $! || exit 9; "
      "done; kill -9 $!; wait $!'");
  ASSERT_EQ(killed.status, 128 + 9) << killed.err;
  const std::string described = "sqlite3 a.scenarios 'SELECT count(*) FROM descriptor_values'";
  EXPECT_LT(std::stoi(run(described).out), 2 * 300) << "two values of each";
  const ProgramResult continued = run("slalom-scenarios describe a.scenarios" + what);
  ASSERT_EQ(continued.status, 0) << continued.err;
  EXPECT_EQ(std::stoi(run(described).out), 2 * 300);
  EXPECT_EQ(continued.out, whole.out);
  EXPECT_TRUE(read("a.scenarios") == read("whole.scenarios")) << "byte for byte";
}

TEST_F(Generate, AListIsReplacedOnlyOnRequest) {
  const std::string generate = "slalom-scenarios generate -c mix.ini -o a.scenarios ";
  expect_failure(generate + "--resume", 3, {"a.scenarios", "does not exist"});
  ASSERT_EQ(run(generate + "-n 2 --quiet").status, 0);
  const std::string list = read("a.scenarios");
  EXPECT_EQ(run(generate + "-n 2 --resume").err,
            "all 2 scenarios are there\na.scenarios: 2 scenarios\n");
  expect_failure(generate + "-n 3", 3,
                 {"another generation", "scenarios.count is 3 here and 2 in a.scenarios"});
  write("mix.ini", read("mix.ini") + "[robot]\nmax_v = 0.7\n");
  EXPECT_EQ(run(generate + "-n 2").status, 0) << "does not matter";
  EXPECT_EQ(read("a.scenarios"), list);
  EXPECT_EQ(run(generate + "-n 3 --overwrite").err, "a.scenarios: 3 scenarios\n");
  EXPECT_EQ(run(generate + "-n 1 --overwrite").err, "a.scenarios: 1 scenario\n");
  ASSERT_EQ(run("slalom-scenarios create made.scenarios").status, 0);
  expect_failure("slalom-scenarios generate -c mix.ini -o made.scenarios", 3,
                 {"was not written by slalom-scenarios generate", "--overwrite"});
  write("text.scenarios", "a stranger's text\n");
  expect_failure("slalom-scenarios generate -c mix.ini --overwrite -o text.scenarios", 3,
                 {"different kind"});
}

TEST_F(Generate, AnotherMapUnderTheSameNameIsAnotherGeneration) {
  ASSERT_EQ(run("slalom-scenarios generate -c mix.ini -n 2 --quiet -o a.scenarios").status, 0);
  write("copy.ini", "[scenarios]\nlist = a.scenarios\n");
  const std::string copy = "slalom-scenarios generate -c copy.ini -o b.scenarios --quiet";
  ASSERT_EQ(run(copy).status, 0);
  ASSERT_EQ(run("slalom-scenarios describe a.scenarios --descriptors density").status, 0);
  EXPECT_EQ(run(copy).status, 0) << "values do not matter";
  ASSERT_EQ(
      run("slalom-scenarios generate -c mix.ini -n 1 --quiet --overwrite -o a.scenarios").status,
      0);
  expect_failure(copy, 3, {"files.a.scenarios is "});
}

TEST_F(Generate, FailedGenerationKeepsTheOldList) {
  ASSERT_EQ(run("slalom-scenarios generate -c mix.ini -n 1 --quiet -o a.scenarios").status, 0);
  const std::string precious = read("a.scenarios");
  expect_failure(
      "slalom-scenarios generate -c mix.ini -n 3 --quiet -o a.scenarios --overwrite "
      "--set robot.radius=2",
      1, {"_0000", "no solvable scenario"});
  EXPECT_EQ(read("a.scenarios"), precious);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.scenarios.partial")) << "nothing was stored";
  expect_failure("slalom-scenarios generate -c mix.ini -n 3 -o b.scenarios --describe densty", 2,
                 {"densty", "density"});
  expect_failure(
      "slalom-scenarios generate -c mix.ini -n 3 -o b.scenarios "
      "--set generator.maze.passage=-1",
      2, {"generator.maze.passage", "> 0"});
}

}  // namespace
}  // namespace slalom
