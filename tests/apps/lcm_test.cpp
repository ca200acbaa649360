// SPDX-License-Identifier: BSD-3-Clause
#include "private_network.h"
#include "program_run.h"

#include <nlohmann/json.hpp>

#include <map>

namespace slalom {
namespace {

using Json = nlohmann::json;

/// Limits that a slow machine does not reach.
constexpr char kLongDeadlines[] = "deadline = 100\nstartup_time = 100\n";

/// Campaigns with methods in other processes, in a private network namespace if permitted.
class LcmProgramTest : public ProgramTest {
 protected:
  static void SetUpTestSuite() {
    enter_private_network();
    usable_ = has_multicast();
  }
  void SetUp() override {
    if (!usable_) GTEST_SKIP() << "neither a private network nor one with multicast";
    ProgramTest::SetUp();
  }
  void TearDown() override {
    if (usable_) ProgramTest::TearDown();
  }

  /// The small campaign with follow_the_gap in the worker and in a separate process.
  void write_campaign() const {
    std::string text = kSmallCampaign;
    text.replace(text.find("nd, gap"), 7, "gap, far");
    write("small.ini", text +
                           "[method.far]\nadapter = lcm\nlaunch = exec slalom-lcm-method --plugin "
                           "libslalom_follow_the_gap.so\n" +
                           kLongDeadlines);
  }

  std::string dump(const std::string& jobs) const {
    const std::string results = "runs" + jobs + ".results";
    const ProgramResult result =
        run("slalom-evaluate small.ini --quiet -o out" + jobs + " -j " + jobs);
    EXPECT_EQ(result.status, 0) << result.err;
    return run("slalom-analyze dump out" + jobs + "/runs.results").out;
  }

 private:
  inline static bool usable_ = false;
};

TEST_F(LcmProgramTest, WhatALaunchedProcessPrintsIsShownWithItsRun) {
  write_campaign();
  ASSERT_EQ(run("slalom-evaluate small.ini --quiet -o out --set "
                "'method.far.launch=echo hello; exec slalom-lcm-method --plugin "
                "libslalom_follow_the_gap.so'")
                .status,
            0);
  EXPECT_NE(run("slalom-analyze show out/runs.results --run random_0000/far/0")
                .out.find("printed by the method (not reproducible)\n  hello\n"),
            std::string::npos);
}

TEST_F(LcmProgramTest, AMethodOverLcmHasTheSameResultsAsInProcessForAnyNumberOfWorkers) {
  write_campaign();
  const std::string one = dump("1");
  EXPECT_EQ(dump("2"), one);
  std::istringstream lines(one);
  std::map<std::string, std::map<std::string, Json>> runs;  // by scenario and method
  for (std::string line; std::getline(lines, line);) {
    Json record = Json::parse(line);
    const std::string method = record.at("method");
    record.erase("method");
    runs[record.at("scenario").dump()][method] = record;
  }
  EXPECT_EQ(runs.size(), 4U);
  for (const auto& [scenario, by_method] : runs)
    EXPECT_EQ(by_method.at("gap"), by_method.at("far")) << scenario;
}

TEST_F(LcmProgramTest, ALaunchedProgramThatChangedIsNoticed) {
  write("method.sh", "#!/bin/sh\nexec slalom-lcm-method --plugin libslalom_follow_the_gap.so\n");
  std::filesystem::permissions(folder_ / "method.sh", std::filesystem::perms::owner_all);
  write("lcm.ini", std::string(kSmallCampaign) +
                       "[method.mine]\nadapter = lcm\nlaunch = exec ./method.sh\n" +
                       kLongDeadlines);
  const std::string command =
      "slalom-simulate run -c lcm.ini --set campaign.methods=mine --set scenarios.count=1 "
      "-o runs.results";
  const ProgramResult first = run(command);
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(run(command).status, 0);
  write("method.sh", "#!/bin/sh\nexec slalom-lcm-method --plugin  libslalom_follow_the_gap.so\n");
  expect_failure(command, 3, {"launch/method.sh of method.mine is not the one of runs.results"});
}

TEST_F(LcmProgramTest, TheHostRejectsAMissingLibrary) {
  expect_failure("slalom-lcm-method --plugin libnone.so", 2, {"library 'libnone.so' not found"});
  expect_failure("slalom-lcm-method --plugin libslalom_follow_the_gap.so --replay none.log", 3,
                 {"none.log", "cannot be read", "a log of lcm-logger"});
}

TEST_F(LcmProgramTest, TheHostPrintsHelpAndVersion) {
  const ProgramResult help = run("slalom-lcm-method --help");
  EXPECT_EQ(help.status, 0);
  for (const std::string option : {"--plugin", "--set", "--url", "--channel", "--replay"})
    EXPECT_NE(help.out.find(option), std::string::npos) << option;
  EXPECT_EQ(run("slalom-lcm-method --version").out.rfind("slalom-lcm-method ", 0), 0U);
}

}  // namespace
}  // namespace slalom
