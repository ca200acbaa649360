#include "program_run.h"

namespace slalom {
namespace {

class Interrupt : public ProgramTest {};

TEST_F(Interrupt, EndsWith130AndKeepsTheRunsSoFar) {
  write("long.ini", std::string(kSmallCampaign));
  // Enough runs for the signal to come amid them; timeout(1) passes the program's own status on.
  const Ended ended =
      run("timeout --preserve-status -s INT 4 slalom-evaluate long.ini -o out -j 2 "
          "--set campaign.repetitions=20000 --set campaign.methods=gap");
  EXPECT_EQ(ended.status, 130) << ended.err;
  EXPECT_NE(last_line(ended.err).find("interrupted"), std::string::npos) << ended.err;
  const std::string dump = run("slalom-analyze dump out/runs.results").out;
  EXPECT_GT(std::count(dump.begin(), dump.end(), '\n'), 0);
}

TEST_F(Interrupt, OutputThatNobodyReadsEndsQuietly) {
  write("small.ini", kSmallCampaign);
  ASSERT_EQ(run("slalom-evaluate small.ini -o out --quiet").status, 0);
  const Ended ended = run("sh -c 'slalom-analyze dump out/runs.results >/dev/full'");
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("standard output"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace slalom
