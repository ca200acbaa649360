// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

namespace slalom {
namespace {

class Until : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("small.ini", kSmallCampaign);
  }
  static std::size_t lines(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
};

TEST_F(Until, StopsWhenEveryCellHasTheRequiredPrecision) {
  // At the first look 10 scenarios at 97 %: the widest Wilson interval, of 5 in 10, is 0.566.
  const std::string command = "slalom-evaluate small.ini -o out --quiet --set scenarios.count=40 ";
  const ProgramResult result = run(command + "--until 'interval(success) < 0.6'");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("2 of 2 cells reached after 20 runs and 1 look: the rule is met"),
            std::string::npos)
      << result.out;
  EXPECT_EQ(lines(run("slalom-analyze dump out/runs.results").out), 20u);
}

TEST_F(Until, ReportsAnExhaustedPool) {
  const ProgramResult result =
      run("slalom-evaluate small.ini -o out --quiet --until 'interval(success) < 0.05'");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("0 of 2 cells reached after 8 runs"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("no scenarios left"), std::string::npos) << result.out;
  EXPECT_NE(read("out/until.txt").find("no scenarios left"), std::string::npos);
}

TEST_F(Until, IsTheSameWithManyWorkersAndAddsRunsOnlyToOpenBins) {
  const std::string command =
      "slalom-evaluate small.ini --quiet --set scenarios.count=60 --until "
      "'interval(success) < 0.55 in density:3' ";
  ASSERT_EQ(run(command + "-o one -j 1").status, 0);
  ASSERT_EQ(run(command + "-o three -j 3").status, 0);
  const std::string dump = run("slalom-analyze dump one/runs.results").out;
  EXPECT_EQ(dump, run("slalom-analyze dump three/runs.results").out);
  EXPECT_LT(lines(dump), 2u * 60u) << "every scenario was run";
  EXPECT_EQ(read("one/until.txt"), read("three/until.txt"));
}

TEST_F(Until, StopsAtTheMaximumNumberOfRuns) {
  const ProgramResult result =
      run("slalom-evaluate small.ini -o out --quiet --set scenarios.count=40 "
          "--until 'interval(success) < 0.01' --max-runs 20");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("after 20 runs and 1 look: maximum number of runs reached"),
            std::string::npos)
      << result.out;
}

TEST_F(Until, StopsWhenAComparisonIsDecidedOrThePoolIsExhausted) {
  const ProgramResult result =
      run("slalom-evaluate small.ini -o out --quiet --set scenarios.count=12 "
          "--until 'compare(success, gap, nd) no worse than 0.9'");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find(" in success: mean advantage "), std::string::npos) << result.out;
  EXPECT_EQ(result.out.substr(0, result.out.find("\n\n")),
            read("out/until.txt").substr(0, result.out.find("\n\n")));
  const std::string note = "the results decided when the campaign ended, by --until";
  for (const std::string file : {"out/tables.txt", "out/report/index.html"})
    EXPECT_NE(read(file).find(note), std::string::npos) << file;
  for (const std::string verb : {"summary", "compare", "compare --ranks", "table --failures"}) {
    const std::string json = run("slalom-analyze " + verb + " out/runs.results --json").out;
    EXPECT_NE(json.find(note), std::string::npos) << verb << json;
  }
}

TEST_F(Until, TheFirstScreenDoesNotCallALeadShownThatTheResultsEnded) {
  // The other method drives to the goal without a scan.
  write("blind.ini", std::string(kSmallCampaign) +
                         "[method.blind]\nadapter = library\nplugin = libslalom_go_to_goal.so\n");
  ASSERT_EQ(run("slalom-evaluate blind.ini -o out --quiet --set campaign.methods=gap,blind --set "
                "scenarios.count=60 --until 'compare(success, gap, blind) decided'")
                .status,
            0);
  const std::string page = read("out/report/index.html");
  EXPECT_NE(page.find("but --until chose it by the results"), std::string::npos);
  EXPECT_EQ(page.find("shown clearly"), std::string::npos);
}

TEST_F(Until, ComparesInEveryBoundedMetric) {
  const std::string command = "slalom-evaluate small.ini --quiet --set scenarios.count=12 ";
  for (const std::string metric : {"barn_score_v2", "risk_time_ratio"}) {
    const ProgramResult result = run(command + "-o " + metric + " --until 'compare(" + metric +
                                     ", gap, nd) no worse than 0.45'");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find(" in " + metric + ": mean advantage "), std::string::npos)
        << result.out;
  }
  expect_failure(command + "-o out --until 'compare(path_length, gap, nd) decided'", 2,
                 {"--until", "'path_length' is not bounded"});
  expect_failure(command + "-o out --until 'compare(sucess, gap, nd) decided'", 2,
                 {"sucess", "'success'"});
}

TEST_F(Until, ComparesCollisionsWithMoversWhereScenariosHaveThem) {
  const std::string rule = " --until 'compare(mover_collision, gap, nd) no worse than 0.9'";
  const std::string command = "slalom-evaluate small.ini --quiet --set metrics.enabled=all";
  const ProgramResult result = run(command + " -o moving --set scenarios.walkers=1" + rule);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find(" in mover_collision: mean advantage "), std::string::npos);
  expect_failure(command + " -o standing" + rule, 2, {"'mover_collision' is not computed"});
}

TEST_F(Until, RejectsInvalidRules) {
  const std::string command = "slalom-evaluate small.ini -o out --quiet ";
  expect_failure(command + "--until 'success < 0.1'", 2, {"--until", "interval(METRIC)"});
  expect_failure(command + "--until 'interval(sucess) < 0.1'", 2, {"sucess", "'success'"});
  expect_failure(command + "--until 'interval(success) < 0.1 in densty:3'", 2,
                 {"densty", "'density'"});
  expect_failure(command + "--until 'interval(success) < 0.1 in density:'", 2,
                 {"--until 'density:'", "density:q4"});
  expect_failure(command + "--until 'interval(success) < 0.1 in density:@by_density'", 2,
                 {"--until", "@by_density"});
  expect_failure(command + "--until 'compare(success, gap, dn) decided'", 2, {"--until", "'dn'"});
  expect_failure(command + "--until 'compare(success, gap) decided'", 2, {"--until", "compare("});
  expect_failure(command + "--max-runs 5", 2, {"--until"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << "checked before anything is made";
}

}  // namespace
}  // namespace slalom
