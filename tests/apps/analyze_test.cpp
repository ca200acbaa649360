#include "program_run.h"

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

class Analyze : public ResultsTest {};

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

TEST_F(Analyze, ComparesMethodsInEveryForm) {
  const std::string compare = "slalom-analyze compare runs.results --metric success,spl ";
  const Ended text = run(compare);
  ASSERT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("not enough runs to compare nd with gap in success"), std::string::npos)
      << text.out;
  const auto json = nlohmann::json::parse(run(compare + "--json").out);
  EXPECT_EQ(json["tables"][0]["rows"].size(), 2u);
  EXPECT_EQ(run(compare + "--csv").out.rfind("metric,a,b,verdict", 0), 0u);
  expect_refusal("slalom-analyze compare runs.results --baseline none", 2, {"none", "gap"});
}

TEST_F(Analyze, GatesDecideTheExitStatus) {
  const std::string compare = "slalom-analyze compare runs.results runs.results ";
  EXPECT_EQ(run(compare + "--gate 'success >= -0.02'").status, 0);
  EXPECT_EQ(run(compare + "--gate 'success > 0'").status, 1);
  EXPECT_EQ(run(compare + "--gate 'success >= -0.02' --gate-on interval").status, 1);
  expect_refusal(compare + "--gate 'success'", 2, {"success", "METRIC >= NUMBER"});
}

TEST_F(Analyze, EveryVerbAnswersOrRefusesInOneLine) {
  for (const char* verb : {"summary", "failures", "completion", "profile", "ranks --metric spl",
                           "validity", "map --rows 'density:2;clearness:2'"}) {
    const std::string command = std::string("slalom-analyze ") + verb + " runs.results ";
    const Ended text = run(command);
    EXPECT_EQ(text.status, 0) << command << text.err;
    EXPECT_FALSE(text.out.empty());
    EXPECT_TRUE(nlohmann::json::accept(run(command + "--json").out)) << command;
    EXPECT_NE(run(command + "--csv").out.find(','), std::string::npos) << command;
  }
  expect_refusal("slalom-analyze summary runs.results runs.results", 2, {"one result file"});
  expect_refusal("slalom-analyze map runs.results --rows density:2", 2, {"two descriptors"});
  expect_refusal("slalom-analyze robustness runs.results runs.results --parameter sensor.rays", 2,
                 {"sensor.rays", "--values"});
  expect_refusal("slalom-analyze robustness runs.results runs.results --values 1,1", 2,
                 {"--parameter"});
}

TEST_F(Analyze, RobustnessTakesValuesFromTheCommandLine) {
  const Ended ended = run(
      "slalom-analyze robustness runs.results runs.results --parameter noise --values 0,1 --csv");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.out.rfind("noise,source,success,", 0), 0u) << ended.out;
  const std::string header = ended.out.substr(0, ended.out.find('\n'));
  EXPECT_EQ(header.find("runs"), header.rfind("runs")) << header;
}

TEST_F(Analyze, AnyTableOfNumbersWillDo) {
  write("trials.csv", "width,cost\n1,10\n2,20\n3,30\n4,40\n");
  const Ended text =
      run("slalom-analyze table --csv trials.csv --rows width:1,2.5,4 --columns cost");
  ASSERT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("all by width"), std::string::npos) << text.out;
  EXPECT_EQ(run("slalom-analyze table trials.csv --rows all --columns cost --csv")
                .out.rfind("method,row_descriptor", 0),
            0u);
  // Before a result file the option asks for CSV.
  EXPECT_EQ(run("slalom-analyze table --csv runs.results").out.rfind("method,row_descriptor", 0),
            0u);
}

TEST_F(Analyze, BinsMayComeFromAnIndexOfTheList) {
  write("small.ini", kSmallCampaign);
  ASSERT_EQ(run("slalom-evaluate small.ini -o out --quiet").status, 0);
  ASSERT_EQ(run("slalom-scenarios index create out/campaign.scenarios --name by_density "
                "--descriptor density --edges 0,0.05,1")
                .status,
            0);
  const std::string table =
      "slalom-analyze table out/runs.results --columns success --csv --rows density:";
  const Ended indexed = run(table + "@by_density --scenarios out/campaign.scenarios");
  EXPECT_EQ(indexed.status, 0) << indexed.err;
  EXPECT_EQ(indexed.out, run(table + "0,0.05,1").out);
  expect_refusal(table + "@by_density", 2, {"--scenarios"});
  expect_refusal(table + "@other --scenarios out/campaign.scenarios", 2, {"other"});
}

TEST_F(Analyze, RefusesWhatIsNoResultFile) {
  write("text.results", "no results");
  expect_refusal("slalom-analyze table text.results", 3, {"text.results"});
  expect_refusal("slalom-analyze table none.results", 3, {"none.results"});
  write("half.results", results().substr(0, results().size() / 2));
  expect_refusal("slalom-analyze dump half.results", 3, {"half.results"});
  expect_refusal("slalom-analyze summary half.results", 3, {"half.results"});
  expect_refusal("slalom-analyze table runs.results --columns sucess", 2, {"sucess", "success"});
}

}  // namespace
}  // namespace slalom
