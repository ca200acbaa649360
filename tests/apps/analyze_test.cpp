#include "program_run.h"

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

/// One campaign for all tests of this file, since they only read it.
class Analyze : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (results().empty()) {
      write("small.ini", kSmallCampaign);
      ASSERT_EQ(run("slalom-evaluate small.ini -o out --quiet").status, 0);
      results() = read("out/runs.results");
    }
    write("runs.results", results());
  }
  static std::string& results() {
    static std::string bytes;
    return bytes;
  }
};

TEST_F(Analyze, TableCrossesDescriptorBinsWithMetrics) {
  const Ended ended =
      run("slalom-analyze table runs.results --rows density:0,0.1,1 --columns success,safety");
  ASSERT_EQ(ended.status, 0) << ended.err;
  for (const char* word : {"nd by density", "gap by density", "success", "safety", "[0, 0.1)"})
    EXPECT_NE(ended.out.find(word), std::string::npos) << word << "\n" << ended.out;
}

TEST_F(Analyze, TableAsCsvAndJsonHaveTheSameCells) {
  const std::string common = "slalom-analyze table runs.results --rows density:0,0.1,1 ";
  const std::string csv = run(common + "--csv").out;
  const auto json = nlohmann::json::parse(run(common + "--json").out);
  EXPECT_FALSE(json.empty());
  EXPECT_GT(std::count(csv.begin(), csv.end(), '\n'), 4);
}

TEST_F(Analyze, ShowPrintsTheRunThatDumpLists) {
  std::istringstream dump(run("slalom-analyze dump runs.results").out);
  std::string line;
  ASSERT_TRUE(std::getline(dump, line));
  const auto run_line = nlohmann::json::parse(line);
  const std::string id = run_line["scenario"]["hash"].get<std::string>().substr(0, 8) + "/" +
                         run_line["method"].get<std::string>() + "/0";
  EXPECT_EQ(run("slalom-analyze show runs.results --json --run " + id).out, line + "\n");
  EXPECT_NE(run("slalom-analyze show runs.results --run " + id).out.find("outcome"),
            std::string::npos);
  expect_refusal("slalom-analyze show runs.results --run 00000000/nd/0", 2, {"00000000"});
}

TEST_F(Analyze, ReportIsAFolderThatOpensOffline) {
  ASSERT_EQ(run("slalom-analyze report runs.results -o report").status, 0);
  EXPECT_NE(read("report/index.html").find("<svg"), std::string::npos);
}

TEST_F(Analyze, RefusesWhatIsNoResultFile) {
  write("text.results", "no results");
  expect_refusal("slalom-analyze table text.results", 3, {"text.results"});
  expect_refusal("slalom-analyze table none.results", 3, {"none.results"});
  write("half.results", results().substr(0, results().size() / 2));
  expect_refusal("slalom-analyze dump half.results", 3, {"half.results"});
  expect_refusal("slalom-analyze table runs.results --columns sucess", 2, {"sucess", "success"});
}

}  // namespace
}  // namespace slalom
