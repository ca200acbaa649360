// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

#include <SQLiteCpp/SQLiteCpp.h>

namespace slalom {
namespace {

class Interrupt : public ProgramTest {
 protected:
  /// campaign.sh runs a campaign of 80000 runs and interrupts it as soon as the first of them is
  /// stored.
  void SetUp() override {
    ProgramTest::SetUp();
    write("long.ini", kSmallCampaign);
    write("campaign.sh",
          "slalom-evaluate long.ini -o out -j 2 --set campaign.repetitions=20000 "
          "--set campaign.methods=gap &\n"
          "until slalom-analyze dump out/runs.results 2>.none | grep -q . || ! kill -0 $!\n"
          "do sleep 0.05; done\n"
          "kill -INT $!; wait $!\n");
  }
};

TEST_F(Interrupt, ExitsWith130AndKeepsFinishedRuns) {
  const ProgramResult result = run("sh campaign.sh");
  EXPECT_EQ(result.status, 130) << result.err;
  EXPECT_NE(last_line(result.err).find("interrupted"), std::string::npos) << result.err;
  const std::string dump = run("slalom-analyze dump out/runs.results").out;
  EXPECT_GT(std::count(dump.begin(), dump.end(), '\n'), 0);
}

TEST_F(Interrupt, ARunIsContinuedByTheSameCommand) {
  write("small.ini", kSmallCampaign);
  const std::string command = "slalom-evaluate small.ini --set campaign.repetitions=3 ";
  ASSERT_EQ(run(command + "--quiet -o undisturbed").status, 0);
  ASSERT_EQ(run(command + "--quiet -o out").status, 0);
  SQLite::Database((folder_ / "out/runs.results").string(), SQLite::OPEN_READWRITE)
      .exec(
          "DELETE FROM runs WHERE run % 4 > 0; DELETE FROM trajectories WHERE run % 4 > 0; "
          "DELETE FROM run_timings WHERE run % 4 > 0");
  ProgramResult result = run(command + "-o out --resume");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err.find("continues: 6 of 24 runs are there\n"), 0U) << result.err;
  EXPECT_EQ(result.out.substr(0, result.out.find("Report: ")),
            run(command + "-o undisturbed --quiet").out.substr(0, result.out.find("Report: ")));
  EXPECT_EQ(run("slalom-analyze dump out/runs.results").out,
            run("slalom-analyze dump undisturbed/runs.results").out);
  result = run(command + "-o out");
  EXPECT_EQ(result.err.find("all 24 runs are there\n"), 0U) << result.err;
  expect_failure(command + "-o out --set robot.max_v=0.6", 3,
                 {"out/runs.results", "robot.max_v is 0.6 here and 1 in", "--overwrite"});
  expect_failure(command + "-o new --resume", 3, {"new/runs.results", "does not exist"});
}

TEST_F(Interrupt, ShowsHowFarTheRunsWere) {
  if (std::system("command -v script >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "needs the package bsdutils";
  // script(1) is the terminal on which a bar is drawn.
  run("script -qec 'sh campaign.sh' terminal.txt");
  const std::string shown = read("terminal.txt");
  const std::size_t last = shown.rfind("Running methods");
  ASSERT_NE(last, std::string::npos) << shown;
  // 4 scenarios in 20000 repetitions. The program counts the runs that the file holds.
  const std::size_t total = shown.find("/80000 ", last), count = shown.rfind(' ', total);
  ASSERT_NE(total, std::string::npos) << shown.substr(last);
  const std::string dump = run("slalom-analyze dump out/runs.results").out;
  std::size_t runs = 0;
  for (std::size_t at = 0; (at = dump.find("\"outcome\"", at + 1)) != std::string::npos;) ++runs;
  EXPECT_EQ(shown.substr(count + 1, total - count - 1), std::to_string(runs)) << shown.substr(last);
  EXPECT_NE(shown.find("\r\nslalom-evaluate: interrupted", last), std::string::npos) << shown;
}

TEST_F(Interrupt, UnwritableStandardOutputIsAnError) {
  write("small.ini", kSmallCampaign);
  ASSERT_EQ(run("slalom-evaluate small.ini -o out --quiet").status, 0);
  const ProgramResult result = run("sh -c 'slalom-analyze dump out/runs.results >/dev/full'");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("standard output"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace slalom
