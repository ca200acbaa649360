// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

#include <slalom/core/hash.h>

#include <nlohmann/json.hpp>

#include <array>
#include <functional>
#include <map>
#include <vector>

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
  /// Writes the certificate of limit(), whose runs are executed for the first test that needs it,
  /// and returns what the command printed.
  std::string write_limit(const std::string& name) const {
    static std::string printed, answered;
    if (answered.empty()) {
      const ProgramResult result = run(limit("-o " + name));
      EXPECT_EQ(result.status, 0) << result.err;
      printed = result.out;
      answered = read(name);
    }
    write(name, answered);
    return printed;
  }
};

TEST_F(Certify, LimitIsTheSameForAnyNumberOfWorkersAndItsCertificateIsVerified) {
  const ProgramResult one = run(limit("-o a.json"));
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(one.err, "");
  const ProgramResult three = run(limit("-j 3 --require 1.05 -o b.json"));
  EXPECT_EQ(three.status, 0) << three.err;
  EXPECT_EQ(three.out, one.out);
  EXPECT_EQ(read("a.json"), read("b.json"));
  const Json answer = certificate("a.json").at("answer").at("claims").at(0);
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
  write_limit("a.json");
  Json changed = certificate("a.json");
  changed["answer"]["claims"][0]["limit"] = 0.65;
  write("better.json", changed.dump());
  expect_failure("slalom-certify verify better.json --quiet", 1,
                 {"better.json: differs: claims[0].limit: ", " instead of 0.65"});
  changed = certificate("a.json");
  changed["answer"]["outcomes"] = "0123";
  write("other.json", changed.dump());
  expect_failure("slalom-certify verify other.json --quiet", 1, {"differs: outcomes: "});
  changed = certificate("a.json");
  changed["answer"]["front"] = {1};
  write("more.json", changed.dump());
  expect_failure("slalom-certify verify more.json --quiet", 1,
                 {"differs: front: nothing instead of [1]"});
}

TEST_F(Certify, VerifyRefusesWhatItCannotRead) {
  expect_failure("slalom-certify verify my.ini", 3, {"my.ini: ", "expected a certificate"});
  write("short.json", R"({"format": 3, "kind": "limit", "question": {}})");
  expect_failure("slalom-certify verify short.json", 3, {"short.json: ", "expected a certificate"});
  write("newer.json", R"({"format": 4, "kind": "limit"})");
  expect_failure("slalom-certify verify newer.json", 3, {"format 4 is unknown"});
  const std::string nested = std::string(300000, '[') + std::string(300000, ']');
  write("nested.json", R"({"format": 3, "kind": "risk", "campaign.ini": "", "question": {}, )"
                       R"("answer": {"claim": )" +
                           nested + "}}");
  expect_failure("slalom-certify show nested.json", 3, {"nested.json: has more than 100 levels"});
  write_limit("a.json");
  Json foreign = certificate("a.json");
  foreign["campaign.ini"] =
      "[campaign]\nmethods = gap\n[scenarios]\ngenerator = passage\n[method.gap]\n"
      "adapter = library\nplugin = foreign.so\n";
  write("foreign.json", foreign.dump());
  write("foreign.so", "");
  expect_failure("slalom-certify verify foreign.json", 2, {"foreign.so", "--trust"});
  // A search would build the method with each value, whatever the user has overridden.
  foreign["campaign.ini"] =
      std::string(kIni) + "[tune]\nplugin = libslalom_follow_the_gap.so | foreign.so\n";
  write("foreign.json", foreign.dump());
  expect_failure("slalom-certify verify foreign.json", 2,
                 {"method.gap: plugin = foreign.so", "--trust"});
}

TEST_F(Certify, NothingClaimedIsAnAnswerUnlessALimitIsRequired) {
  const std::string go =
      "slalom-certify limit my.ini --quiet --method go --of random.obstacles --from 20 --to 40 "
      "--step 10 --reliability 0.99 -o go.json ";
  const ProgramResult nothing = run(go);
  EXPECT_EQ(nothing.status, 0) << nothing.err;
  EXPECT_NE(nothing.out.find("nothing can be claimed at 0.99: best seen "), std::string::npos);
  EXPECT_TRUE(certificate("go.json").at("answer").at("claims").at(0).at("limit").is_null());
  expect_failure(go + "--require 20", 1, {"--require 20: nothing can be claimed"});
  expect_failure(limit("--require 0.7"), 1, {"--require 0.7 m: the limit is "});
}

TEST_F(Certify, KeysOfRobotAndSensorAreParametersInTheScenariosOfTheGenerators) {
  const ProgramResult result =
      run("slalom-certify limit my.ini --quiet --method gap --of robot.radius --from 0.1 --to 0.7 "
          "--step 0.2 --reliability 0.5 -o radius.json");
  ASSERT_EQ(result.status, 0) << result.err;
  // No robot of more than 0.6 m passes a gap of at most 1.2 m, and few of less.
  const Json answer = certificate("radius.json").at("answer").at("claims").at(0);
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
      {width + "--from 1.2 --to 1.2 --step 0.1", {"--to 1.2 m: is the value of --from"}},
      {width + "--from 1.2 --to 0.6 --step -0.1", {"--step -0.1", "positive"}},
      {width + "--from 6 --to 1 --step 1", {"--of generator.passage.max_width", "no wall"}},
      {width + "--from 0.4 --to 1.6 --step 0.4", {"--from 0.4 --to 1.6", "the easy end first"}},
      {"--of random.obstacles --from 8 --to 12 --step 0.5", {"integers"}},
      {"--of passage.widht " + range, {"no numeric option 'widht'; expected 'width'"}},
      {"--of passage " + range, {"no numeric option ''"}},
      {"--of pasage.width " + range, {"unknown family, robot or sensor 'pasage'", "'passage'"}},
      {width + range + "--reliability 0.9 1.5", {"--reliability 1.5"}},
      {width + "--from 1.2", {"--to", "both ends"}},
      {"--of robot.max_v", {"--from", "no range of its own"}},
      {"--of robot.radius --from 0.1 --to 0.5 --step 0.1 --set scenarios.list=a.scenarios",
       {"scenarios.list", "generator and maps only"}}};
  for (const auto& [options, words] : kRefused) expect_failure(base + options, 2, words);
  expect_failure("slalom-certify limit my.ini --method gaap " + width + range, 2,
                 {"--method gaap", "'gap'"});
}

TEST_F(Certify, EachOfSeveralReliabilitiesHasTheClaimThatItHasAlone) {
  ASSERT_EQ(run(limit("0.5 -o both.json")).status, 0);
  write_limit("high.json");
  const Json both = certificate("both.json").at("answer").at("claims");
  const Json high = certificate("high.json").at("answer").at("claims");
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both.at(0), high.at(0));
  // Easier to show, so that it reaches at least as far.
  EXPECT_LE(both.at(1).at("limit").get<double>(), both.at(0).at("limit").get<double>());
}

TEST_F(Certify, TheRangeOfAnOptionIsTheDefaultWithTheEasyEndFirst) {
  const ProgramResult result =
      run("slalom-certify limit my.ini --quiet --method gap --of passage.width --reliability 0.5 "
          "--set generator.passage.min_width=0.8 --set generator.passage.max_width=1.2 -o a.json");
  ASSERT_EQ(result.status, 0) << result.err;
  const Json question = certificate("a.json").at("question");
  EXPECT_EQ(question.at("from"), 1.2);
  EXPECT_EQ(question.at("to"), 0.8);
  EXPECT_EQ(question.at("step"), 0.1);  // two cells, which is more than a tenth of the range
}

TEST_F(Certify, ALimitOfTheDelayIsComparedWithTheTimeOfACycle) {
  write("slow.py",
        "import math, time\n"
        "class Slow:\n"
        "    options = {}\n"
        "    def __init__(self, robot, options): pass\n"
        "    def reset(self, task): pass\n"
        "    def step(self, o):\n"
        "        time.sleep(0.001)\n"
        "        return 1, max(-1, min(1, math.atan2(o.goal_y, o.goal_x)))\n");
  const ProgramResult result = run(
      "slalom-certify limit my.ini --quiet --method slow --of robot.delay --from 0 --to 0.4 "
      "--step 0.4 --reliability 0.1 --set method.slow.adapter=python --set "
      "method.slow.module=slow.py --set method.slow.class=Slow --set scenarios.generator=random "
      "--set generator.random.min_obstacles=0 --set generator.random.max_obstacles=0");
  ASSERT_EQ(result.status, 0) << result.err;
  const std::string words = "not part of the claim: a control cycle took at most ";
  const std::size_t at = result.out.find(words);
  ASSERT_NE(at, std::string::npos) << result.out;
  // At least the time that the method sleeps, so that 0.4 s are at most 400 times that.
  EXPECT_GE(std::stod(result.out.substr(at + words.size())), 1);
  const std::string slower = "a computer ";
  EXPECT_LE(std::stod(result.out.substr(result.out.find(slower) + slower.size())), 400);
}

TEST_F(Certify, AMethodThatEndsAllItsRunsByErrorsIsNotTested) {
  write("bad.py",
        "class Bad:\n    options = {}\n    def __init__(self, robot, options): pass\n"
        "    def reset(self, task): pass\n    def step(self, o): raise ValueError('no')\n");
  expect_failure(
      "slalom-certify risk my.ini --quiet --method bad --set method.bad.adapter=python --set "
      "method.bad.module=bad.py --set method.bad.class=Bad --budget 5",
      2, {"every run ended with method_error", "ValueError"});
}

TEST_F(Certify, ARiskIsBoundedByWhatItsRunsShow) {
  const ProgramResult stuck = run(
      "slalom-certify risk my.ini --quiet --method go --outcome failure --budget 200 -o go.json");
  ASSERT_EQ(stuck.status, 0) << stuck.err;
  const Json answer = certificate("go.json").at("answer");
  const double rate = answer.at("hits").get<double>() / 200;
  EXPECT_GT(answer.at("bound").get<double>(), rate);
  EXPECT_EQ(answer.at("runs"), 200);
  std::size_t failures = 0;
  for (const auto& [outcome, count] : answer.at("outcome_counts").items())
    failures += outcome == "success" ? 0 : count.get<std::size_t>();
  EXPECT_EQ(answer.at("hits"), failures);
  EXPECT_EQ(answer.at("failures").size(), std::min<std::size_t>(failures, 100));

  const std::string risk = "slalom-certify risk my.ini --quiet --method gap --at-most 0.05 ";
  const ProgramResult shown = run(risk + "--require -o gap.json");
  ASSERT_EQ(shown.status, 0) << shown.err;
  EXPECT_NE(shown.out.find("claim: probability of collision <= 0.05"), std::string::npos);
  EXPECT_EQ(run(risk + "-j 3 -o three.json").status, 0);
  EXPECT_EQ(read("gap.json"), read("three.json"));
  expect_failure(
      "slalom-certify risk my.ini --quiet --method go --outcome failure --at-most 0.05 "
      "--require",
      1, {"--require: ", "<= 0.05 is not shown"});
  expect_failure(risk + "--budget 66", 2, {"runs without that outcome"});
  expect_failure(risk + "--outcome colision", 2, {"'collision'"});
  // 1 minus this is 1 in double precision.
  expect_failure("slalom-certify risk my.ini --method gap --at-most 1e-17", 2,
                 {"--at-most 1e-17", "at least 1e-09"});
}

TEST_F(Certify, ASampleOfTheBatchesOfARiskIsVerified) {
  ASSERT_EQ(run("slalom-certify risk my.ini --quiet --method gap --budget 60 -o a.json").status, 0);
  const ProgramResult sampled = run("slalom-certify verify a.json --quiet --sample 1 --seed 7");
  EXPECT_EQ(sampled.out, "a.json: 1 of 1 batches (0) identical, sample 7\n") << sampled.err;
  // Whatever follows from the batches is recomputed before any run.
  const auto forged = [&](const std::function<void(Json&)>& change) {
    Json other = certificate("a.json");
    change(other["answer"]);
    write("b.json", other.dump());
    return "slalom-certify verify b.json --quiet --sample 1";
  };
  expect_failure(forged([](Json& answer) { answer["batches"][0]["hash"] = "0"; }), 1,
                 {"outcomes: differs"});
  expect_failure(forged([](Json& answer) {
                   answer["batches"][0]["hash"] = "0";
                   answer["outcomes"] = Hasher().add("risk/0").add("0").hex();
                 }),
                 1, {"batch 0: differs"});
  for (const char* key : {"resolution", "seed"})
    expect_failure(forged([&](Json& answer) { answer[key] = 99; }), 1,
                   {std::string(key) + ": differs: ", " instead of 99"});
  expect_failure(forged([](Json& answer) { answer["bound"] = 1e-4; }), 1, {"bound: differs"});
  expect_failure(
      forged([](Json& answer) { answer["claim"] = "probability of collision <= 0.0001"; }), 1,
      {"claim: differs"});
  expect_failure(forged([](Json& answer) { answer["runs"] = 2000000; }), 1,
                 {"runs: differs: 60 instead of 2000000"});
  expect_failure(forged([](Json& answer) {
                   answer["runs"] = 2000000;
                   answer["batches"][0]["runs"] = 2000000;
                 }),
                 1, {"batch 0: differs", "batches of 10000 runs"});
  expect_failure(forged([](Json& answer) {
                   answer["batches"][0]["runs"] = 10000;
                   answer["batches"].push_back(answer["batches"][0]);
                 }),
                 1, {"batch 1: differs: it has the runs of batch 0"});
  expect_failure(forged([](Json& answer) {
                   answer["outcome_counts"] = {{"success", 59}};
                 }),
                 1, {"outcome_counts: differs"});
  expect_failure(forged([](Json& answer) {
                   Json& counts = answer["outcome_counts"];
                   counts["stuck"] = counts.value("stuck", 0) + counts["success"].get<int>();
                   counts.erase("success");
                 }),
                 1, {"outcome_counts: differs: ", " success in 1 batches, 0 in all"});
  expect_failure(forged([](Json& answer) { answer["failures"].push_back(1); }), 1,
                 {"failures: differs: "});
  write_limit("limit.json");
  expect_failure("slalom-certify verify limit.json --quiet --sample 1", 2, {"no parts"});
}

TEST_F(Certify, TheFailuresOfASampledBatchAreCompared) {
  ASSERT_EQ(run("slalom-certify risk my.ini --quiet --method gap --budget 20 --outcome success "
                "-o a.json")
                .status,
            0);
  Json changed = certificate("a.json");
  Json& failures = changed["answer"]["failures"];
  ASSERT_GE(failures.size(), 2U);
  failures[1]["yaml"] = failures[0]["yaml"];
  write("b.json", changed.dump());
  expect_failure("slalom-certify verify b.json --quiet --sample 1", 1, {"failures[1]: differs: "});
}

TEST_F(Certify, AnInterruptedQuestionContinuesWithItsRuns) {
  const std::string risk = "slalom-certify risk my.ini --quiet --method gap --budget 400 -o a.json";
  // Interrupted once it has some runs; should it be faster, it has ended with a certificate.
  const ProgramResult first =
      run("sh -c '" + risk +
          " & pid=$!; while kill -0 $pid 2>.null && [ ! -e a.json ]; do "
          "[ -e a.json.runs ] && [ \"$(wc -l <a.json.runs)\" -gt 30 ] && break; done; "
          "kill -INT $pid; wait $pid'");
  if (first.status == 130) {
    // A run that the journal has is not executed again: one that is another there stays so.
    const std::string journal = read("a.json.runs");
    const std::size_t at = journal.find("\nsuccess ");
    write("a.json.runs", journal.substr(0, at) + "\ncollision " + journal.substr(at + 9) + "succ");
    ASSERT_EQ(run(risk).status, 0);
    EXPECT_EQ(certificate("a.json").at("answer").at("hits"), 1);
    write("a.json.runs", journal);
  }
  ASSERT_EQ(run(risk).status, 0);
  const std::string continued = read("a.json");
  EXPECT_EQ(run("test -e a.json.runs").status, 1);
  ASSERT_EQ(run(risk).status, 0);
  EXPECT_EQ(read("a.json"), continued);
  write("a.json.runs", "slalom-certify journal of something else\n");
  expect_failure(risk, 2, {"a.json.runs: is of another question"});
  EXPECT_EQ(read("a.json.runs"), "slalom-certify journal of something else\n");
}

/// A method in Python. The first run of all waits until it is killed, while the others go on, so
/// that each interruption kills a run that others have overtaken. Once 12 others have begun, so
/// that the other workers have finished some, it writes to the pipe "told", on which the test
/// waits.
constexpr char kWaitingMethod[] =
    "import math, os, time\n"
    "class Waits:\n"
    "    options = {}\n"
    "    def __init__(self, robot, options): pass\n"
    "    def reset(self, task):\n"
    "        with open('begun', 'a') as file: file.write('.')\n"
    "        if os.path.getsize('begun') > 12:\n"
    "            with open('told', 'r+b', 0) as pipe: pipe.write(b'\\n')\n"
    "        try: os.mkdir('first')\n"
    "        except FileExistsError: return\n"
    "        while True: time.sleep(1)\n"
    "    def step(self, o):\n"
    "        return 0.5, max(-1, min(1, math.atan2(o.goal_y, o.goal_x)))\n";

TEST_F(Certify, AnInterruptedQuestionIsAnsweredAsAnUndisturbedOne) {
  write("waits.py", kWaitingMethod);
  const std::string method =
      " --quiet --method waits --set method.waits.adapter=python --set "
      "method.waits.module=waits.py --set method.waits.class=Waits ";
  const std::string risk = "slalom-certify risk my.ini --budget 40" + method;
  const std::string limit =
      "slalom-certify limit my.ini --of passage.width --from 1.45 --to 0.65 --step 0.4 "
      "--reliability 0.5 --blocks 0" +
      method;
  const std::vector<std::array<std::string, 3>> cases = {
      {risk, "INT", "2"}, {risk, "KILL", "3"}, {limit, "HUP", "2"}, {limit, "TERM", "3"}};
  ASSERT_EQ(run("mkfifo told").status, 0);
  std::map<std::string, std::string> undisturbed;
  for (const auto& [question, signal, workers] : cases) {
    SCOPED_TRACE(question + signal);
    run("rm -rf a.json* b.json* begun first");
    const std::string command = question + "-o a.json -j " + workers;
    // The end of the program is told, too.
    run("sh -c 'exec 3<>told; { sh -c \"echo \\$\\$ >pid; exec " + command +
        "\"; echo >&3; } & read line <&3; kill -" + signal + " $(cat pid); wait $!'");
    EXPECT_EQ(run("test -e a.json").status, 1) << "the first run waits";
    const ProgramResult continued = run(command);
    ASSERT_EQ(continued.status, 0) << continued.err;
    if (undisturbed.count(question) == 0) {
      ASSERT_EQ(run(question + "-o b.json -j 1").status, 0);
      undisturbed[question] = read("b.json");
    }
    EXPECT_EQ(read("a.json"), undisturbed.at(question));
  }
}

TEST_F(Certify, AContinuedQuestionWhoseOtherRunsFailKeepsThoseOfTheJournal) {
  const std::string flag = (folder_ / "fail").string();
  write("half.py",
        "import math, os\n"
        "class Half:\n"
        "    options = {}\n"
        "    def __init__(self, robot, options): pass\n"
        "    def reset(self, task): pass\n"
        "    def step(self, o):\n"
        "        if os.path.exists('" +
            flag +
            "'): raise ValueError('no')\n"
            "        return 0.5, max(-1, min(1, math.atan2(o.goal_y, o.goal_x)))\n");
  const std::string risk =
      "slalom-certify risk my.ini --quiet --method half --budget 40 -o a.json --set "
      "method.half.adapter=python --set method.half.module=half.py --set method.half.class=Half";
  // Interrupted once it has some runs, or it has ended.
  const ProgramResult first =
      run("sh -c '" + risk +
          " & pid=$!; while kill -0 $pid 2>.null && [ ! -e a.json ]; do "
          "[ -e a.json.runs ] && [ \"$(wc -l <a.json.runs)\" -gt 10 ] && break; done; "
          "kill -INT $pid; wait $pid'");
  if (first.status != 130) return;
  write("fail", "");
  const ProgramResult second = run(risk);
  ASSERT_EQ(second.status, 0) << second.err;
  EXPECT_NE(second.out.find("runs ended by errors of the method, such as method_error: "),
            std::string::npos)
      << second.out;
  EXPECT_EQ(certificate("a.json").at("answer").at("runs"), 40);
}

TEST_F(Certify, PeopleWhoDecideBetweenControlCyclesAreRefusedBeforeAnyRun) {
  expect_failure(
      "slalom-certify risk my.ini --quiet --method gap --budget 20 --set "
      "scenarios.people=2 --set simulation.control_period=0.15",
      2, {"people", "period", "multiple of"});
}

TEST_F(Certify, AnEnvelopeHasRowsThatEndAtTheirFirstCellWithoutAClaim) {
  const std::string envelope =
      "slalom-certify envelope my.ini --quiet --method gap --of passage.width --from 1.4 --to 0.4 "
      "--step 0.5 --rows robot.radius --rows-from 0.15 --rows-to 0.35 --rows-step 0.1 "
      "--reliability 0.5 ";
  const ProgramResult result = run(envelope + "-o a.json");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(run(envelope + "-j 3 -o b.json").status, 0);
  EXPECT_EQ(read("a.json"), read("b.json"));
  const Json answer = certificate("a.json").at("answer");
  ASSERT_EQ(answer.at("rows").size(), 2U);
  std::size_t claimed = 0;
  for (const Json& row : answer.at("rows")) {
    bool before = true;
    for (const Json& cell : row.at("cells")) {
      EXPECT_TRUE(before);
      before = cell.at("claimed").get<bool>();
      claimed += before ? 1 : 0;
    }
  }
  EXPECT_EQ(answer.at("claimed"), claimed);
  // Each row at half of 1 - confidence: one run more than the 5 at 0.95.
  EXPECT_EQ(answer.at("rows").at(0).at("cells").at(0).at("runs"), 6);
  EXPECT_EQ(run("slalom-certify verify a.json --quiet").status, 0);
  expect_failure(envelope + "--require 1", 1, {"--require 1: success >= 0.5 in "});
  expect_failure(envelope + "--budget 3", 2, {"2 rows need at least"});
  expect_failure(
      "slalom-certify envelope my.ini --method gap --of passage.width --rows random.obstacles", 2,
      {"--rows random.obstacles", "another family"});
  expect_failure(
      "slalom-certify envelope my.ini --method gap --of passage.width --rows passage.width", 2,
      {"--rows passage.width", "another one"});
}

TEST_F(Certify, ShowsCertificatesAsPagesTablesFiguresAndLists) {
  const std::string printed = write_limit("a.json");
  EXPECT_EQ(run("slalom-certify show a.json").out, printed);
  for (const std::string name : {"a.html", "a.tex", "a.svg", "a.scenarios"})
    ASSERT_EQ(run("slalom-certify show a.json -o " + name).status, 0) << name;
  const Json answer = certificate("a.json").at("answer");
  const std::string page = read("a.html");
  EXPECT_LT(page.find("class=\"answer\">claim: "), page.find("<svg")) << "the answer first";
  EXPECT_LT(page.find("<svg"), page.find("<table>"));
  // The figure, and a picture of each failure.
  std::size_t pictures = 0;
  for (std::size_t at = 0; (at = page.find("<svg", at)) != std::string::npos; ++at) ++pictures;
  EXPECT_EQ(pictures, 1 + answer.at("failures").size());
  EXPECT_NE(read("a.tex").find("\\begin{tabular}"), std::string::npos);
  EXPECT_EQ(read("a.svg").substr(0, 4), "<svg");
  ASSERT_EQ(run("slalom-simulate run my.ini --quiet --set scenarios.list=a.scenarios "
                "--set scenarios.generator= -o a.results")
                .status,
            0);
  const ProgramResult again = run("slalom-analyze dump a.results");
  ASSERT_EQ(again.status, 0) << again.err;
  // Each listed failure is the failure of this campaign, too.
  for (const Json& failure : answer.at("failures"))
    EXPECT_NE(again.out.find(failure.at("scenario").get<std::string>()), std::string::npos);
  EXPECT_EQ(again.out.find(R"("outcome":"success")"), std::string::npos) << again.out;
  expect_failure("slalom-certify show a.json -o a.pdf", 2, {"a.pdf", ".html, .tex, .svg"});
}

TEST_F(Certify, StandardTestsHaveVerdictsWithTheirConfidence) {
  const std::string standard =
      "slalom-certify standard my.ini --quiet --method go --families passage avoid --speeds 0.5 1 ";
  ASSERT_EQ(run(standard + "--trials 20 -o a.json").status, 0);
  EXPECT_EQ(run(standard + "--trials 20 -j 3 -o b.json").status, 0);
  EXPECT_EQ(read("a.json"), read("b.json"));
  const Json tests = certificate("a.json").at("answer").at("tests");
  ASSERT_EQ(tests.size(), 4U);
  EXPECT_EQ(tests.at(0).at("max_v"), 0.5);
  EXPECT_EQ(tests.at(1).at("max_v"), 1.0);
  for (const Json& test : tests) {
    // 0 or 1 failures of 20 show 0.8 with 0.988 and 0.931, 2 with 0.794.
    EXPECT_EQ(test.at("passed").get<bool>(), test.at("failures").get<int>() <= 1) << test;
    // Driving straight at an obstacle is no way around it.
    EXPECT_TRUE(test.at("test") != "avoid" || test.at("collisions") == 20) << test;
  }
  EXPECT_EQ(run("slalom-certify verify a.json --quiet").status, 0);
  expect_failure(standard + "--require", 1, {"--require: ", "of 4 tests passed"});
  expect_failure(standard + "--trials 8", 2, {"--trials 8", "at least 9"});
  expect_failure(standard + "--reliability 0.999999999999", 2, {"--trials 30", "at most 1000000"});
  expect_failure(standard + "--speeds 1.5", 2, {"--speeds: 1.5", "at most 1"});
  expect_failure(standard + "--families pasage", 2, {"'pasage'", "'passage'"});
}

TEST_F(Certify, MapsAreSourcesOfScenarios) {
  // A free room of 8 m x 8 m with walls, as a map of ROS.
  std::string image = "P2\n80 80\n255\n";
  for (int row = 0; row < 80; ++row)
    for (int column = 0; column < 80; ++column)
      image += row % 79 == 0 || column % 79 == 0 ? "0 " : "254 ";
  write("room.pgm", image);
  write("room.yaml",
        "image: room.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.2\n");
  const ProgramResult result =
      run("slalom-certify envelope my.ini --quiet --method go --maps room.yaml --of robot.radius "
          "--from 0.1 --to 0.3 --step 0.1 --rows robot.max_v --rows-from 0.5 --rows-to 1 "
          "--rows-step 0.5 --reliability 0.5 -o a.json");
  ASSERT_EQ(result.status, 0) << result.err;
  // Nothing is in the way in a free room.
  EXPECT_EQ(certificate("a.json").at("answer").at("claimed"), 2);
  EXPECT_EQ(run("slalom-certify verify a.json --quiet").status, 0);
  expect_failure(
      "slalom-certify envelope my.ini --method go --maps room.yaml --of passage.width "
      "--rows robot.max_v",
      2, {"--of passage.width", "with --maps"});
}

TEST_F(Certify, ShowRefusesHostileCertificates) {
  write_limit("a.json");
  for (const char* key : {"claims", "unit", "resolution"}) {
    for (const Json& hostile : {Json(), Json::array(), Json("x"), Json::object()}) {
      Json changed = certificate("a.json");
      changed["answer"][key] = hostile;
      write("b.json", changed.dump());
      const ProgramResult result = run("slalom-certify show b.json");
      EXPECT_TRUE(result.status == 3 || (result.status == 0 && hostile.is_string())) << result.err;
    }
  }
  Json changed = certificate("a.json");
  changed["question"]["more"] = 1;
  write("b.json", changed.dump());
  expect_failure("slalom-certify show b.json", 3, {"b.json: does not match its checksum"});
  expect_failure("slalom-certify verify b.json", 3, {"unknown key 'more'"});
}

TEST_F(Certify, ChangedCertificatesAreNotShownAndAreDifferent) {
  ASSERT_EQ(run("slalom-certify risk my.ini --quiet --method gap --budget 60 -o a.json").status, 0);
  const Json stored = certificate("a.json");
  // Another program may write members and spaces otherwise, and whole numbers without a fraction.
  write("same.json", stored.dump(4));
  EXPECT_EQ(run("slalom-certify show same.json").out, run("slalom-certify show a.json").out);
  EXPECT_EQ(run("slalom-certify verify same.json --quiet --sample 1").status, 0);
  // A text that nothing else depends on.
  Json changed = stored;
  changed["environment"]["compiler"] = "cc";
  write("b.json", changed.dump());
  expect_failure("slalom-certify show b.json", 3, {"does not match its checksum"});
  expect_failure("slalom-certify verify b.json --quiet --sample 1", 1, {"differs: checksum"});
  changed = stored;
  changed.erase("checksum");
  write("b.json", changed.dump());
  expect_failure("slalom-certify show b.json", 3, {"does not match its checksum"});
}

constexpr char kNarrow[] =
    "[campaign]\nmethods = go\n[generator.passage]\nmin_width = 0.3\nmax_width = 0.3\n"
    "[method.go]\nadapter = library\nplugin = libslalom_go_to_goal.so\n";

TEST_F(Certify, ASlowRobotHasTheTimeThatItsScenariosTake) {
  // 7.5 m and more, at 0.1 m/s.
  const std::string standard =
      "slalom-certify standard slow.ini --quiet --method gap --families sudden_obstacle "
      "--speeds 0.5 --trials 8 --reliability 0.75 ";
  write("slow.ini", std::string(kIni) + "[robot]\nmax_v = 0.2\n");
  const ProgramResult result = run(standard + "-o a.json");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(certificate("a.json").at("answer").at("tests").at(0).at("passed")) << result.out;
  expect_failure(standard + "--set simulation.max_time=60", 2,
                 {"[simulation] max_time: scenario sudden_obstacle_0000: nobody can arrive within "
                  "60 s: the shortest path takes at least ",
                  " s at 0.1 m/s", "or auto"});
}

TEST_F(Certify, DrawsThatTheRobotCannotSolveAreNoRuns) {
  write("none.ini", std::string(kNarrow) + "[scenarios]\ngenerator = passage\n");
  expect_failure("slalom-certify risk none.ini --method go --at-most 0.005 --require --quiet", 1,
                 {"no solvable scenario in 100 draws"});
  write("mixed.ini",
        std::string(kNarrow) + "[scenarios]\ngenerator = passage, random\nweights = 3, 1\n");
  const ProgramResult mixed =
      run("slalom-certify risk mixed.ini --method go --outcome failure --budget 20 --quiet -j 2 "
          "-o mixed.json");
  ASSERT_EQ(mixed.status, 0) << mixed.err;
  const Json answer = certificate("mixed.json").at("answer");
  EXPECT_EQ(answer.at("runs"), 20);
  EXPECT_FALSE(answer.at("outcome_counts").contains("unsolvable_scenario"));
  // Three of four draws: 60 are expected, with a deviation of 15.
  const auto redrawn = answer.at("redrawn").get<int>();
  EXPECT_NEAR(redrawn, 60, 50);
  EXPECT_NE(mixed.out.find(std::to_string(redrawn) + " draws without a solvable scenario"),
            std::string::npos)
      << mixed.out;
  for (const Json& failure : answer.at("failures")) EXPECT_FALSE(failure.at("yaml").is_null());
  const ProgramResult verified = run("slalom-certify verify mixed.json --quiet");
  EXPECT_EQ(verified.status, 0) << verified.err;
}

}  // namespace
}  // namespace slalom
