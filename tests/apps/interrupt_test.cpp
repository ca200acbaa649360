#include "program_run.h"

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

TEST_F(Interrupt, ShowsHowFarTheRunsWere) {
  if (std::system("command -v script >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "needs the package bsdutils";
  // script(1) is the terminal on which a bar is drawn.
  run("script -qec 'sh campaign.sh' terminal.txt");
  const std::string shown = read("terminal.txt");
  const std::size_t last = shown.rfind("Running methods");
  ASSERT_NE(last, std::string::npos) << shown;
  // 4 scenarios in 20000 repetitions. What it counts is what the file holds.
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
