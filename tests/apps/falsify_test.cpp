// SPDX-License-Identifier: BSD-3-Clause
#include "browser.h"
#include "places.h"
#include "planted_failure.h"
#include "program_run.h"

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

using Json = nlohmann::json;

class Falsify : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("planted.ini", kPlantedCampaign);
    write("passage.scenario.yaml", kPlantedPassage);
  }
  Json failures(const std::string& folder) const {
    return Json::parse(read(folder + "/failures.json"));
  }
  Json report(const std::string& folder) const {
    return Json::parse(read(folder + "/report.json"));
  }
};

constexpr char kShrink[] =
    "slalom-falsify shrink passage.scenario.yaml -c planted.ini --method squeeze -o out";

TEST_F(Falsify, ShrinkWritesTheSmallestScenarioItsProofAndACampaignThatRepeatsIt) {
  const ProgramResult result = run(kShrink);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("squeeze_collision_1: squeeze ends as collision"), std::string::npos);
  EXPECT_NE(result.out.find("base reaches the goal, repeated bit for bit"), std::string::npos);
  const Json failure = failures("out").at("failures").at(0);
  EXPECT_EQ(failure["shrinking"]["parts_before"], 6);
  EXPECT_LE(failure["shrinking"]["parts_after"], 3);
  EXPECT_EQ(failure["shrinking"]["minimal"], true);
  EXPECT_EQ(failure["shrinking"]["removals"].size(), failure["shrinking"]["parts_after"]);
  EXPECT_EQ(failure["fairness"]["fair"], true);
  EXPECT_EQ(failure["fairness"]["witness"], "base");
  EXPECT_TRUE(failure["descriptors"].contains("density"));
  EXPECT_NE(read("out/squeeze_collision_1.svg").find("<svg"), std::string::npos);
  EXPECT_NE(read("out/squeeze_collision_1.scenario.yaml").find("polygons"), std::string::npos);
  ASSERT_EQ(run("slalom-evaluate out/failures.ini -o check --quiet").status, 0);
  const std::string runs = run("slalom-analyze dump check/runs.results").out;
  EXPECT_NE(runs.find(R"("method":"base","metrics")"), std::string::npos);
  EXPECT_NE(runs.find(R"("outcome":"collision")"), std::string::npos);
  EXPECT_NE(runs.find(R"("outcome":"success")"), std::string::npos);
  EXPECT_NE(runs.find(failure["trajectory"].get<std::string>()), std::string::npos);
}

TEST_F(Falsify, ShrinkWritesAReportWithTheVariantsThatPassAsNeighbors) {
  const ProgramResult result = run(kShrink);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("1 failure: collision, "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("Report: out/index.html"), std::string::npos);
  const Json removals = failures("out")["failures"][0]["shrinking"]["removals"];
  const Json page = report("out");
  ASSERT_EQ(page["clusters"].size(), 1U);
  const Json& cluster = page["clusters"][0];
  ASSERT_EQ(cluster["members"].size(), 1U);
  const Json& member = cluster["members"][0];
  EXPECT_EQ(member["compared"], member["run"]);
  EXPECT_NE(member["command"].get<std::string>().find("slalom-replay play"), std::string::npos);
  // The proof of shrinking says of each removal how the run without the obstacle ends.
  std::size_t passed = 0;
  for (const Json& removal : removals) passed += removal["verdict"] == "squeeze: success" ? 1 : 0;
  EXPECT_GE(passed, 1U);
  EXPECT_EQ(member["neighbors"].size(), passed);
  EXPECT_TRUE(cluster["statements"].empty()) << "one failure shows no difference";
  if (!has_browser()) GTEST_SKIP() << "needs the package chromium";
  const auto open = [&](const std::string& name) {
    return open_in_browser((folder_ / "out" / name).string());
  };
  EXPECT_EQ(all_matches(open("index.html"), "href=\"(cluster\\.html#1)\"").size(), 1U);
  const auto frames = all_matches(open("cluster.html#1"), "<iframe[^>]* src=\"([^\"]*)\"");
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_NE(open(frames[0]).find("data-ready=\"squeeze/0\""), std::string::npos);
}

TEST_F(Falsify, AnalyzeReportsTheSameClustersOfAFolderOfFailures) {
  ASSERT_EQ(run(kShrink).status, 0);
  const Json written = report("out");
  ASSERT_EQ(written["clusters"].size(), 1U);
  for (const char* input : {"out", "out/examined.results"}) {
    const ProgramResult result =
        run(std::string("slalom-analyze report ") + input + " -o again --quiet");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(report("again")["clusters"], written["clusters"]);
    EXPECT_EQ(read("again/index.html"), read("out/index.html"));
  }
  write("out/examined.json", "{}");
  expect_failure("slalom-analyze report out -o again", 3, {"out/examined.json", "slalom-falsify"});
}

TEST_F(Falsify, ShrinkDoesNotReplaceItsInput) {
  ASSERT_EQ(run(kShrink).status, 0);
  const std::string hash = failures("out")["failures"][0]["scenario"];
  const std::string id = hash.substr(0, 8) + "/squeeze/0";
  expect_failure("slalom-falsify shrink out/examined.results --run " + id + " -o out --trust", 2,
                 {"would replace out/examined.results", "another folder"});
  EXPECT_EQ(
      run("slalom-falsify shrink out/examined.results --run " + id + " -o again --trust").status,
      0);
}

TEST_F(Falsify, ShrinksARunOfAResultFile) {
  ASSERT_EQ(run("slalom-scenarios import passage.scenario.yaml -o passage.scenarios").status, 0);
  ASSERT_EQ(run("slalom-simulate run -c planted.ini --scenarios passage.scenarios -o runs.results "
                "--quiet")
                .status,
            0);
  const std::string dump = run("slalom-analyze dump runs.results").out;
  const std::string hash = Json::parse(dump.substr(0, dump.find('\n')))["scenario"]["hash"];
  const std::string id = hash.substr(0, 8) + "/squeeze/0";
  const ProgramResult result =
      run("slalom-falsify shrink runs.results --trust --run " + id + " -o out");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("run " + id + " of runs.results"), std::string::npos);
  // The same scenario as from the file with the scenario.
  const std::string shrunk = failures("out")["failures"][0]["scenario"];
  ASSERT_EQ(run(kShrink).status, 0);
  EXPECT_EQ(failures("out")["failures"][0]["scenario"], shrunk);
  expect_failure(
      "slalom-falsify shrink runs.results --trust --run " + hash.substr(0, 8) + "/base/0 -o out", 1,
      {"base reaches the goal"});
  expect_failure("slalom-falsify shrink runs.results --run 01234567/base/0 -o out", 2,
                 {"no such run"});
  expect_failure("slalom-falsify shrink runs.results -o out", 2, {"no run is named", "--run ID"});
}

TEST_F(Falsify, ShrinksARecordedRun) {
  ASSERT_EQ(run("slalom-scenarios import passage.scenario.yaml -o passage.scenarios").status, 0);
  ASSERT_EQ(run("slalom-simulate run -c planted.ini --scenarios passage.scenarios -o runs.results "
                "--set record.rawlog=all --quiet")
                .status,
            0);
  std::string log;
  for (const auto& file : std::filesystem::directory_iterator(folder_ / "runs.rawlogs"))
    if (file.path().string().find("_squeeze_0") != std::string::npos)
      log = "runs.rawlogs/" + file.path().filename().string();
  std::filesystem::remove(folder_ / "planted.ini");  // all is in the recorded run
  const ProgramResult result = run("slalom-falsify shrink " + log + " -o out --trust");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("/squeeze/0 of " + log), std::string::npos) << result.out;
  // The same scenario as from the file with the scenario.
  const std::string shrunk = failures("out")["failures"][0]["scenario"];
  write("planted.ini", kPlantedCampaign);
  ASSERT_EQ(run(kShrink).status, 0);
  EXPECT_EQ(failures("out")["failures"][0]["scenario"], shrunk);
  expect_failure("slalom-falsify shrink " + log + " --run 01234567/squeeze/0 -o out", 2,
                 {"one run only", "no --run"});
  expect_failure("slalom-falsify shrink " + log + " --method base -o out", 2,
                 {"--method base", "squeeze"});
  // With another method under the name of the recorded one.
  expect_failure(
      "slalom-falsify shrink " + log + " --set method.squeeze.defect=crash --trust -o out", 1,
      {"ended as collision, now as method_crash"});
  write("no.rawlog", "no run");
  expect_failure("slalom-falsify shrink no.rawlog -o out", 3, {"no.rawlog"});
}

TEST_F(Falsify, SearchReportsTheSimplestFirstAndHowDiverseTheyAre) {
  const std::string search =
      "slalom-falsify search planted.ini --method squeeze --runs 200 --failures 4 --quiet -o out";
  const ProgramResult result = run(search);
  ASSERT_EQ(result.status, 0) << result.err;
  const Json found = failures("out");
  ASSERT_GE(found["failures"].size(), 2U);
  const double diversity = found["search"]["diversity"];
  EXPECT_GE(diversity, 0.5) << "each two of them differ so much";
  EXPECT_LE(diversity, 1);
  EXPECT_NE(result.out.find("kept      " + std::to_string(found["failures"].size()) +
                            " failures, diversity 0."),
            std::string::npos)
      << result.out;
  for (std::size_t i = 1; i < found["failures"].size(); ++i)
    EXPECT_LE(found["failures"][i - 1]["shrinking"]["parts_after"],
              found["failures"][i]["shrinking"]["parts_after"]);
}

TEST_F(Falsify, SearchRunsTheMethodWhereARelativeFails) {
  write("surrogate.ini", read("planted.ini") + "[method.twin]\nadapter = library\nplugin = " +
                             kPlantedMethod + "\ndefect = squeeze\n");
  const std::string search = "slalom-falsify search surrogate.ini --method squeeze --quiet -o out ";
  const ProgramResult result = run(search + "--runs 40 --failures 1 --surrogate twin");
  ASSERT_EQ(result.status, 0) << result.err;
  // The twin has the same defect: each adaptive run fails, some without a witness.
  const Json adaptive = failures("out")["search"]["adaptive"];
  EXPECT_EQ(adaptive["runs"], 20);
  EXPECT_EQ(adaptive["failures"].get<int>() + adaptive["without_witness"].get<int>(), 20);
  EXPECT_EQ(read("out/failures.ini").find("methods = squeeze, twin"), std::string::npos);
  expect_failure(search + "--runs 40", 2, {"other settings"});
  expect_failure(search + "--surrogate other", 2, {"no section [method.other]"});
  expect_failure(search + "--surrogate squeeze", 2, {"is the method that is tested"});
  expect_failure(search + "--surrogate base", 2, {"is the only witness", "--witness METHOD"});
  expect_failure(search + "--surrogate twin --against base", 2, {"--surrogate", "--against"});
}

TEST_F(Falsify, SearchFindsShrinksAndReportsFailuresTheSameForAnyNumberOfWorkers) {
  const std::string search =
      "slalom-falsify search planted.ini --method squeeze --runs 200 --failures 2 --quiet ";
  const ProgramResult one = run(search + "-o one -j 1");
  ASSERT_EQ(one.status, 0) << one.err;
  ASSERT_EQ(run(search + "-o two -j 2").status, 0);
  const Json found = failures("one");
  EXPECT_GE(found["failures"].size(), 1U);
  EXPECT_EQ(found["search"]["random"]["runs"], 100);
  EXPECT_EQ(found["search"]["adaptive"]["runs"], 100);
  for (const Json& failure : found["failures"]) {
    EXPECT_EQ(failure["fairness"]["fair"], true);
    EXPECT_LE(failure["shrinking"]["parts_after"], 4);
  }
  Json other = failures("two");
  for (std::size_t i = 0; i < found["failures"].size(); ++i)
    EXPECT_EQ(other["failures"][i]["scenario"], found["failures"][i]["scenario"]);
  EXPECT_EQ(other["search"], found["search"]);
  const Json page = report("one"), other_page = report("two");
  EXPECT_EQ(other_page["runs"], page["runs"]);
  std::size_t members = 0;
  for (std::size_t i = 0; i < page["clusters"].size(); ++i) {
    const Json &cluster = page["clusters"][i], &same = other_page["clusters"][i];
    EXPECT_EQ(same["name"], cluster["name"]);
    EXPECT_EQ(same["scenarios"], cluster["scenarios"]);
    for (const Json& member : cluster["members"]) {
      EXPECT_EQ(member["neighbors"].size(), 3U);
      EXPECT_NE(member["run"], member["compared"]) << "the original is compared";
    }
    members += cluster["members"].size();
  }
  EXPECT_EQ(members, found["failures"].size());
  expect_failure(search + "--seed 2 -o one", 2, {"other settings", "--overwrite"});
}

TEST_F(Falsify, TheSameCommandShrinksNothingAgain) {
  const std::string search =
      "slalom-falsify search planted.ini --method squeeze --runs 100 --failures 1 --quiet -o out ";
  const ProgramResult first = run(search);
  ASSERT_EQ(first.status, 0) << first.err;
  ASSERT_GE(failures("out")["failures"].size(), 1U);
  const std::string shrunk = read("out/search.shrunk");
  // Kept files are reported: here with a mark that no new result would have.
  std::string marked = shrunk;
  const std::size_t verdict = marked.find("squeeze: success");
  ASSERT_NE(verdict, std::string::npos);
  marked.replace(verdict, 7, "SQUEEZE");
  write("out/search.shrunk", marked);
  const ProgramResult second = run(search);
  ASSERT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(first.out.find("SQUEEZE: success"), std::string::npos);
  EXPECT_NE(second.out.find("SQUEEZE: success"), std::string::npos);
  write("out/search.shrunk", shrunk.substr(0, shrunk.size() / 2));
  expect_failure(search, 3, {"search.shrunk", "unexpected end of data"});
  // Other limits of shrinking: those results are not used.
  EXPECT_EQ(run(search + "--max-runs 20").status, 0);
  EXPECT_NE(read("out/search.shrunk"), shrunk);
  expect_failure(
      "slalom-falsify search planted.ini --method base --witness squeeze --runs 100 "
      "--failures 1 --quiet -o out",
      2, {"other settings", "--overwrite"});
}

TEST_F(Falsify, KeepsItsOwnCollisionsWithoutAnotherMethod) {
  const std::string search =
      "slalom-falsify search planted.ini --method squeeze --set campaign.methods=squeeze --runs 40 "
      "--failures 1 --quiet -o out ";
  const ProgramResult result = run(search);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find(", no other method was asked, repeated bit for bit"), std::string::npos)
      << result.out;
  const Json failure = failures("out")["failures"].at(0);
  EXPECT_TRUE(failure["fairness"]["witness"].is_null());
  EXPECT_LT(failure["shrinking"]["parts_after"], failure["shrinking"]["parts_before"]);
  for (const char* other : {"--all-outcomes", "--set scenarios.walkers=2"})
    expect_failure(search + other + " --overwrite", 2,
                   {"there is no other method", "--no-witness"});
}

TEST_F(Falsify, NothingFoundIsABoundAndNotAProofOfSafety) {
  // The method without defect against itself: no failure has a witness.
  write("same.ini", read("planted.ini") +
                        "[method.twin]\nadapter = library\nplugin = " + kPlantedMethod + "\n");
  const ProgramResult result =
      run("slalom-falsify search same.ini --method base --against twin --runs 60 -o out --quiet");
  ASSERT_EQ(result.status, 0) << result.err;
  for (const char* part :
       {"0 of 30 failed where a witness reaches the goal: with 95 % confidence",
        "at most 0.1 of such scenarios do", "a failure is collision, left_workspace, method_"})
    EXPECT_NE(result.out.find(part), std::string::npos) << result.out;
  EXPECT_TRUE(failures("out")["failures"].empty());
}

TEST_F(Falsify, TheBoundNamesTheRunsWithoutSuccessThatItIsNotAbout) {
  // In half of the time that its shortest path takes no method reaches the goal.
  const ProgramResult result =
      run("slalom-falsify search planted.ini --method base --no-witness --runs 20 -o out --quiet "
          "--set simulation.max_time=1");
  ASSERT_EQ(result.status, 0) << result.err;
  const std::size_t at = result.out.find("not counted: ");
  ASSERT_NE(at, std::string::npos) << result.out;
  EXPECT_NE(result.out.find(" timeout", at), std::string::npos) << result.out;
}

TEST_F(Falsify, ASearchThatFindsNothingLeavesNoReportOfAnotherOne) {
  ASSERT_EQ(run(kShrink).status, 0);
  const std::vector<std::string> files = {
      "index.html",         "cluster.html",    "report.json",        "run.html",
      "data/runs.js",       "data/summary.js", "data/pictures-1.js", "examined.results",
      "examined.scenarios", "examined.json"};
  for (const std::string& file : files)
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / file)) << file;
  const ProgramResult result =
      run("slalom-falsify search planted.ini --method base --witness squeeze --runs 4 --overwrite "
          "-o out --quiet");
  ASSERT_EQ(result.status, 0) << result.err;
  ASSERT_TRUE(failures("out")["failures"].empty());
  for (const std::string& file : files)
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / file)) << file;
}

TEST_F(Falsify, AnEarlierVersionOfTheLibraryIsAWitness) {
  const ProgramResult result = run("slalom-falsify search planted.ini --method base --against " +
                                   kPlantedMethod + " --runs 20 -o out --quiet");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(read("out/failures.ini").find("[method.reference]"), std::string::npos);
}

TEST_F(Falsify, ReportsWrongArguments) {
  expect_failure("slalom-falsify search planted.ini --method squeze --runs 10 -o out", 2,
                 {"--method squeze", "'squeeze'"});
  expect_failure("slalom-falsify search planted.ini --method squeeze --witness bas -o out", 2,
                 {"--witness bas", "'base'"});
  expect_failure("slalom-falsify search planted.ini --method squeeze --witness squeeze -o out", 2,
                 {"is the method that is tested"});
  expect_failure("slalom-falsify search missing.ini --method squeeze -o out", 3, {"missing.ini"});
  expect_failure("slalom-falsify search planted.ini --method squeeze -o out --resume", 2,
                 {"no search to continue"});
  expect_failure("slalom-falsify shrink passage.scenario.yaml --method squeeze -o out", 2,
                 {"no campaign is named", "-c campaign.ini"});
  expect_failure(
      "slalom-falsify shrink missing.scenario.yaml -c planted.ini --method squeeze -o out", 3,
      {"missing.scenario.yaml"});
  expect_failure("slalom-falsify shrink passage.scenario.yaml -c planted.ini --method base -o out",
                 1, {"base reaches the goal"});
}

}  // namespace
}  // namespace slalom
