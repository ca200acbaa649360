// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "result_fixture.h"

#include <slalom/analysis/analysis_request.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// One run of a and b with densities, success and optimality.
ResultTable one_scenario(const std::string& analysis_section = "") {
  ResultFixture fixture;
  const std::string hash = fixture.add_scenario(Value::of(0.1));
  fixture.add_run(hash, "a", 0.9);
  fixture.add_run(hash, "b", 0.8);
  if (!analysis_section.empty())
    fixture.table.manifest["campaign.ini"] = "[analysis]\n" + analysis_section;
  return fixture.table;
}

const Interpreter& interpreter_named(const std::string& id) {
  for (const Interpreter& candidate : all_interpreters())
    if (candidate.id == id) return candidate;
  throw std::runtime_error("no " + id);
}

using Ids = std::vector<std::string>;

TEST(AnalysisRequest, DefaultsAreThoseOfTheInterpreterThatTheResultsContain) {
  const AnalysisQuery query = make_query({}, interpreter_named("table"), one_scenario());
  EXPECT_EQ(query.metrics, (Ids{"success", "optimality"}));  // there is no safety
  ASSERT_EQ(query.rows.size(), 1U);
  EXPECT_EQ(query.rows[0].descriptor, "density");
  EXPECT_EQ(query.rows[0].count, 4);
  EXPECT_EQ(query.comparison.analysis.confidence, 0.95);
  EXPECT_FALSE(query.comparison.relevant);
}

TEST(AnalysisRequest, TheCampaignPrecedesTheDefaultsAndTheRequestPrecedesTheCampaign) {
  const ResultTable results =
      one_scenario("rows = clearness:0,1\ncolumns = path_length, success\nconfidence = 0.9\n");
  AnalysisRequest request;
  AnalysisQuery query = make_query(request, interpreter_named("summary"), results);
  EXPECT_EQ(query.metrics, (Ids{"path_length", "success"}));
  EXPECT_EQ(query.rows[0].descriptor, "clearness");
  EXPECT_EQ(query.comparison.analysis.confidence, 0.9);
  // Its columns are those of tables.
  EXPECT_EQ(make_query(request, interpreter_named("ranks"), results).metrics, (Ids{"success"}));
  request.rows = "density:2;all";
  request.metrics = "optimality,";
  request.confidence = 0.99;
  query = make_query(request, interpreter_named("summary"), results);
  EXPECT_EQ(query.metrics, (Ids{"optimality"}));
  EXPECT_EQ(query.rows.size(), 2U);
  EXPECT_EQ(query.comparison.analysis.confidence, 0.99);
}

TEST(AnalysisRequest, AMetricThatIsNamedTwiceIsOne) {
  AnalysisRequest request;
  request.metrics = "success,optimality,success";
  const Ids once = {"success", "optimality"};
  EXPECT_EQ(make_query(request, interpreter_named("compare"), one_scenario()).metrics, once);
  const ResultTable results = one_scenario("columns = success, optimality, success\n");
  EXPECT_EQ(make_query({}, interpreter_named("table"), results).metrics, once);
}

TEST(AnalysisRequest, GatesReplaceTheDefaultMetrics) {
  AnalysisRequest request;
  request.gates = {"success >= -0.02"};
  const AnalysisQuery query = make_query(request, interpreter_named("compare"), one_scenario());
  EXPECT_TRUE(query.metrics.empty());
  ASSERT_EQ(query.gates.size(), 1U);
  EXPECT_EQ(query.gates[0].metric, "success");
}

TEST(AnalysisRequest, OnlyColumnsThatAreKnownInAdvanceAreRequested) {
  AnalysisRequest request;
  request.metrics = "time_to_goal";
  EXPECT_FALSE(requested_columns(request, interpreter_named("completion")));  // rows by default
  request.rows = "density:2;all";
  EXPECT_EQ(requested_columns(request, interpreter_named("completion")),
            (Ids{"time_to_goal", "path_length", "mean_speed", "density"}));
  EXPECT_FALSE(requested_columns(request, interpreter_named("validity")));  // all descriptors
  request.metrics.clear();
  EXPECT_FALSE(requested_columns(request, interpreter_named("compare")));
  request.gates = {"safety > 0"};
  EXPECT_EQ(requested_columns(request, interpreter_named("compare")), (Ids{"safety", "density"}));
}

TEST(AnalysisRequest, MalformedValuesAndNumbersOfFilesAreRejected) {
  AnalysisRequest request;
  request.values = "0, 0.1, x";
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--values", {"'x'"}, [&] {
    make_query(request, interpreter_named("robustness"), one_scenario());
  }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "compare", {"3 files", "1 or 2 result files"},
                           [] { require_number_of_results(interpreter_named("compare"), 3); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "table", {"0 files", "one result file"},
                           [] { require_number_of_results(interpreter_named("table"), 0); }));
  EXPECT_NO_THROW(require_number_of_results(interpreter_named("robustness"), 7));
}

}  // namespace
}  // namespace slalom
