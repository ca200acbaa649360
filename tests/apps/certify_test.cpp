// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

using Json = nlohmann::json;

constexpr char kIni[] =
    "[campaign]\nmethods = gap\n[scenarios]\ngenerator = passage\n"
    "[method.gap]\nadapter = library\nplugin = libslalom_follow_the_gap.so\n"
    "[method.go]\nadapter = library\nplugin = libslalom_go_to_goal.so\n";

class Certify : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("my.ini", kIni);
  }
  Json certificate(const std::string& name) const { return Json::parse(read(name)); }

  /// From wide gaps, which a method passes, to those that a robot of 0.5 m hardly passes.
  static std::string limit(const std::string& more = "") {
    return "slalom-certify limit my.ini --quiet --method gap --of passage.width "
           "--from 1.45 --to 0.65 --step 0.4 --reliability 0.9 " +
           more;
  }
};

TEST_F(Certify, LimitIsTheSameForAnyNumberOfWorkersAndItsCertificateIsVerified) {
  const ProgramResult one = run(limit("-o a.json"));
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(one.err, "");
  EXPECT_EQ(run(limit("-j 3 -o b.json")).out, one.out);
  EXPECT_EQ(read("a.json"), read("b.json"));
  const Json answer = certificate("a.json").at("answer");
  EXPECT_NE(one.out.find(answer.at("claim").get<std::string>()), std::string::npos) << one.out;
  // The smallest number without a failure, see runs_without_failure().
  EXPECT_EQ(answer.at("steps").at(0),
            Json({{"from", 1.45}, {"to", 1.05}, {"runs", 33}, {"failures", 0}, {"claimed", true}}));
  EXPECT_FALSE(answer.at("steps").back().at("claimed").get<bool>());
  const ProgramResult verified = run("slalom-certify verify a.json --quiet");
  EXPECT_EQ(verified.status, 0) << verified.err;
  EXPECT_NE(verified.out.find("a.json: identical"), std::string::npos);
}

TEST_F(Certify, VerifyFindsAnswersThatAreNotThoseOfTheRuns) {
  ASSERT_EQ(run(limit("-o a.json")).status, 0);
  Json changed = certificate("a.json");
  changed["answer"]["limit"] = 0.65;
  write("better.json", changed.dump());
  expect_failure("slalom-certify verify better.json --quiet", 1,
                 {"better.json: differs: limit: ", " instead of 0.65"});
  changed = certificate("a.json");
  changed["answer"]["outcomes"] = "0123";
  write("other.json", changed.dump());
  expect_failure("slalom-certify verify other.json --quiet", 1, {"differs: outcomes: "});
}

TEST_F(Certify, VerifyRefusesWhatItCannotRead) {
  expect_failure("slalom-certify verify my.ini", 3, {"my.ini: ", "expected a certificate"});
  write("short.json", R"({"format": 1, "kind": "limit", "question": {}})");
  expect_failure("slalom-certify verify short.json", 3, {"short.json: ", "expected a certificate"});
  write("newer.json", R"({"format": 2, "kind": "limit"})");
  expect_failure("slalom-certify verify newer.json", 3, {"unknown format or kind"});
  ASSERT_EQ(run(limit("-o a.json")).status, 0);
  Json foreign = certificate("a.json");
  foreign["campaign.ini"] =
      "[campaign]\nmethods = gap\n[scenarios]\ngenerator = passage\n[method.gap]\n"
      "adapter = library\nplugin = foreign.so\n";
  write("foreign.json", foreign.dump());
  write("foreign.so", "");
  expect_failure("slalom-certify verify foreign.json", 2, {"foreign.so", "--trust"});
}

TEST_F(Certify, NothingClaimedIsAnAnswerUnlessALimitIsRequired) {
  const std::string go =
      "slalom-certify limit my.ini --quiet --method go --of random.obstacles --from 20 --to 40 "
      "--step 10 --reliability 0.99 -o go.json ";
  const ProgramResult nothing = run(go);
  EXPECT_EQ(nothing.status, 0) << nothing.err;
  EXPECT_NE(nothing.out.find("nothing can be claimed at 0.99: best seen "), std::string::npos);
  EXPECT_TRUE(certificate("go.json").at("answer").at("limit").is_null());
  expect_failure(go + "--require 20", 1, {"--require 20: nothing can be claimed"});
  EXPECT_EQ(run(limit("--require 1.05")).status, 0);
  expect_failure(limit("--require 0.7"), 1, {"--require 0.7 m: the limit is "});
}

TEST_F(Certify, KeysOfRobotAndSensorAreParametersInTheScenariosOfTheGenerators) {
  const ProgramResult result =
      run("slalom-certify limit my.ini --quiet --method gap --of robot.radius --from 0.1 --to 0.7 "
          "--step 0.2 --reliability 0.5 -o radius.json");
  ASSERT_EQ(result.status, 0) << result.err;
  // No robot of more than 0.6 m passes a gap of at most 1.2 m, and few of less.
  const Json answer = certificate("radius.json").at("answer");
  EXPECT_EQ(answer.at("steps").at(0).at("claimed"), true);
  EXPECT_LT(answer.at("limit").get<double>(), 0.7);
}

TEST_F(Certify, RefusesQuestionsThatCannotBeAnswered) {
  const std::string base = "slalom-certify limit my.ini --method gap ";
  const std::string range = "--from 1.2 --to 0.6 --step 0.1 ", width = "--of passage.width ";
  const std::pair<std::string, std::vector<std::string>> kRefused[] = {
      {width + range + "--reliability 1", {"--reliability 1", "between 0 and 1"}},
      {width + range + "--confidence 0", {"--confidence 0", "between 0 and 1"}},
      {width + range + "--budget 66", {"--budget 66", "needs at least 67 runs without a failure"}},
      {width + range + "--max-per-step 66", {"--max-per-step 66", "at least 67"}},
      {width + range + "--require 2", {"--require 2", "--from and --to"}},
      {width + "--from 1.2 --to 0.6 --step 0.02", {"two cells", "simulation.resolution=0.01"}},
      {width + "--from 1.2 --to 0.6 --step 0.25", {"does not divide"}},
      {width + "--from 1.2 --to 1.2 --step 0.1", {"does not divide"}},
      {width + "--from 1.2 --to 0.6 --step -0.1", {"--step -0.1", "positive"}},
      {width + "--from 6 --to 1 --step 1", {"--of generator.passage.max_width", "no wall"}},
      {width + "--from 0.4 --to 1.6 --step 0.4", {"--from 0.4 --to 1.6", "the easy end first"}},
      {"--of random.obstacles --from 8 --to 12 --step 0.5", {"integers"}},
      {"--of passage.widht " + range, {"no numeric option 'widht'; expected 'width'"}},
      {"--of passage " + range, {"no numeric option ''"}},
      {"--of pasage.width " + range, {"'pasage' is no family", "'passage'"}},
      {"--of robot.radius --from 0.1 --to 0.5 --step 0.1 --set scenarios.maps=a.pgm",
       {"scenarios.maps", "generator only"}}};
  for (const auto& [options, words] : kRefused) expect_failure(base + options, 2, words);
  expect_failure("slalom-certify limit my.ini --method gaap " + width + range, 2,
                 {"--method gaap", "'gap'"});
}

}  // namespace
}  // namespace slalom
