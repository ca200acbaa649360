#include "result_fixture.h"

#include <slalom/analysis/campaign_settings.h>
#include <slalom/analysis/completion.h>
#include <slalom/analysis/csv_columns.h>
#include <slalom/analysis/descriptor_map.h>
#include <slalom/analysis/failure_taxonomy.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/method_ranks.h>
#include <slalom/analysis/performance_profile.h>
#include <slalom/analysis/robustness.h>
#include <slalom/analysis/validity.h>
#include <slalom/core/error.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace slalom {
namespace {

/// Six scenarios of density 0.1 .. 0.6; a fails in the densest two, b in none. Optimality falls
/// with density.
ResultFixture six() {
  ResultFixture fixture;
  for (int i = 1; i <= 6; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1 * i));
    fixture.add_run(hash, "a", i <= 4 ? 1 - 0.1 * i : -1);
    fixture.add_run(hash, "b", 1 - 0.05 * i);
  }
  return fixture;
}

Question question(const std::string& rows, const std::vector<std::string>& metrics) {
  Question asked;
  asked.rows = parse_bin_specs(rows);
  asked.metrics = metrics;
  return asked;
}

const Interpreter& named(const std::vector<std::unique_ptr<Interpreter>>& all,
                         const std::string& id) {
  for (const auto& interpreter : all)
    if (interpreter->id() == id) return *interpreter;
  throw std::runtime_error("no " + id);
}

TEST(Interpreter, EachHasANameOfItsOwnAndSaysTheSameInEveryForm) {
  const auto all = all_interpreters();
  std::set<std::string> ids;
  for (const auto& interpreter : all) {
    EXPECT_TRUE(ids.insert(interpreter->id()).second);
    EXPECT_FALSE(interpreter->help().empty());
    if (interpreter->fewest_results() > 1) continue;
    const std::string rows = interpreter->id() == "map" ? "density:2;density:3" : "density:2";
    const std::vector<RunColumns> results = {to_columns(six().table)};
    const auto found = interpreter->interpret(results, question(rows, {"optimality"}));
    ASSERT_FALSE(found.tables.empty()) << interpreter->id();
    const auto json = nlohmann::json::parse(render_json(found));
    EXPECT_EQ(json["tables"].size(), found.tables.size());
    EXPECT_EQ(json["tables"][0]["rows"].size(), found.tables[0].rows);
    const std::string csv = render_csv(found.tables[0]);
    EXPECT_EQ(csv.substr(0, csv.find(',')), found.tables[0].columns[0]);
    EXPECT_FALSE(render_text(found).empty());
    const auto again = interpreter->interpret(results, question(rows, {"optimality"}));
    EXPECT_EQ(render_json(found), render_json(again));
  }
}

TEST(Interpreter, MapPutsEachRunIntoItsField) {
  const RunColumns table = to_columns(six().table);
  const DescriptorMap map =
      build_descriptor_map(table, "a", parse_bin_spec("density:0,0.35,1"),
                           parse_bin_spec("clearness:0,0.5,1"), "success", {});
  EXPECT_EQ(map.fields[0][1].cell.n, 3u);  // 0.1, 0.2, 0.3; clearness is 0.5 throughout
  EXPECT_EQ(map.fields[1][1].cell.n, 3u);
  EXPECT_EQ(map.fields[1][1].cell.failures, 2u);
  EXPECT_NEAR(*map.fields[1][1].cell.estimate, 1 / 3.0, 1e-12);
  EXPECT_EQ(map.fields[0][0].cell.n, 0u);
  EXPECT_EQ(map.left_out, 0u);
  EXPECT_THROW(build_descriptor_map(table, "a", BinSpec{}, BinSpec{}, "success", {}), Error);
}

TEST(Interpreter, EmptyCellsSayWhy) {
  const auto all = all_interpreters();
  const auto found =
      named(all, "map")
          .interpret({to_columns(six().table)},
                     question("density:0,0.45,0.65;clearness:0,0.4,1", {"optimality"}));
  const std::string csv = render_csv(found);
  EXPECT_NE(csv.find("no runs"), std::string::npos) << csv;
  EXPECT_NE(csv.find("no values: 2 collision"), std::string::npos) << csv;
}

TEST(Interpreter, FailuresAddUpToTheRuns) {
  const RunColumns table = to_columns(six().table);
  const FailureTaxonomy taxonomy =
      build_failure_taxonomy(table, parse_bin_spec("density:0,0.45,1"), {});
  EXPECT_EQ(taxonomy.outcomes, (std::vector<std::string>{"success", "collision"}));
  ASSERT_EQ(taxonomy.groups.size(), 4u);
  const OutcomeGroup& dense_a = taxonomy.groups[1];
  EXPECT_EQ(dense_a.n, 2u);
  EXPECT_EQ(dense_a.outcomes[1].share, 1);
  EXPECT_EQ(table.outcomes[table.outcome[dense_a.outcomes[1].runs[0]]], "collision");
  for (const OutcomeGroup& group : taxonomy.groups)
    EXPECT_EQ(group.outcomes[0].runs.size() + group.outcomes[1].runs.size(), group.n);
}

TEST(Interpreter, ValidityFindsWhatFallsWithDensity) {
  const ValidityTable validity = build_validity(to_columns(six().table), {"optimality"}, {});
  for (const DescriptorValidity& entry : validity.validity) {
    const bool constant = entry.descriptor == "clearness";
    EXPECT_EQ(entry.correlation.rho.has_value(), !constant);
    if (constant) continue;
    EXPECT_NEAR(*entry.correlation.rho, -1, 1e-12);
  }
  EXPECT_EQ(validity.redundancy.size(), 3u);  // two descriptors: each with itself, and the pair
}

TEST(Interpreter, RanksAreOfScenariosThatAllHaveValuesIn) {
  const MethodRanks ranks = build_method_ranks(to_columns(six().table), "optimality", {});
  EXPECT_EQ(ranks.test.scenarios, 4u);
  EXPECT_EQ(ranks.left_out, 2u);
  EXPECT_EQ(ranks.test.mean_ranks, (std::vector<double>{2, 1}));
}

TEST(Interpreter, ProfilesAreRatiosToTheBest) {
  const ProfileTable table = build_profiles(to_columns(six().table), "optimality");
  EXPECT_EQ(table.scenarios, 6u);
  const PerformanceProfile &a = table.profiles[0], &b = table.profiles[1];
  EXPECT_EQ(b.steps.size(), 1u);
  EXPECT_EQ(b.steps[0].share, 1);  // the best everywhere
  EXPECT_EQ(a.without_value, 2u);
  ASSERT_EQ(a.steps.size(), 5u);
  EXPECT_EQ(a.steps[0].share, 0);
  EXPECT_NEAR(a.steps[1].ratio, 0.95 / 0.9, 1e-12);
  EXPECT_NEAR(a.steps[4].ratio, 0.8 / 0.6, 1e-12);
  EXPECT_NEAR(a.steps[4].share, 4 / 6.0, 1e-12);
  EXPECT_THROW(build_profiles(to_columns(six().table), "success"), Error);  // a rate has zeros
}

TEST(Interpreter, CompletionEndsAtTheSuccessRate) {
  ResultFixture fixture = six();
  for (std::size_t i = 0; i < fixture.table.runs.size(); ++i) {
    RunRecord& run = fixture.table.runs[i];
    const bool arrived = run.outcome == "success";
    run.metrics["time_to_goal"] = {
        1, arrived ? Value::of(10 + static_cast<double>(i)) : Value::na("outcome: collision")};
    run.metrics["mean_speed"] = {1, Value::of(2)};  // with a path length of 10: all end after 5 s
  }
  const auto curves = build_completion(to_columns(fixture.table), "time_to_goal");
  EXPECT_EQ(curves[0].n, 6u);
  EXPECT_NEAR(curves[0].incidence.back().value, 4 / 6.0, 1e-12);
  EXPECT_NEAR(curves[0].kaplan_meier.back().value, 1, 1e-12);  // the rest left at 5 s
  EXPECT_NEAR(curves[1].incidence.back().value, 1, 1e-12);
}

Manifest campaign(const std::string& sigma) {
  return {{"campaign.ini", "[campaign]\nname = x" + sigma + "\n[sensor]\nnoise_sigma = " + sigma +
                               "\nrays = 181\n"},
          {"scenarios.hash", "abc"}};
}

std::vector<RunColumns> sweep() {
  std::vector<RunColumns> results;
  for (const char* sigma : {"0.2", "0", "0.1"}) {
    ResultFixture fixture;
    double number = 0;
    number = std::stod(sigma);
    for (int i = 0; i < 10; ++i) {
      const std::string hash = fixture.add_scenario(Value::of(0.1));
      fixture.add_run(hash, "a", 0.9 - number - 0.001 * i);
    }
    fixture.table.manifest = campaign(sigma);
    results.push_back(to_columns(fixture.table));
    results.back().source = std::string("at ") + sigma;
  }
  return results;
}

TEST(Interpreter, RobustnessFollowsTheParameter) {
  const RobustnessTable table = build_robustness(sweep(), "sensor.noise_sigma", {"optimality"}, {});
  ASSERT_EQ(table.curves.size(), 1u);
  const auto& points = table.curves[0].points;
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0].parameter, 0);
  EXPECT_EQ(points[2].parameter, 0.2);
  EXPECT_FALSE(points[0].change);
  EXPECT_NEAR(*points[2].change->difference, -0.2, 1e-9);
  EXPECT_EQ(points[2].change->verdict, Verdict::Worse);
}

TEST(Interpreter, RobustnessTellsCampaignsApart) {
  auto results = sweep();
  EXPECT_THROW(build_robustness(results, "sensor.dropout_ratio", {"success"}, {}), Error);
  results[1].manifest["campaign.ini"] += "max_range = 4\n";
  try {
    build_robustness(results, "sensor.noise_sigma", {"success"}, {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("sensor.max_range: (default), 4"), std::string::npos)
        << error.what();
  }
  RobustnessOptions options;
  options.allow_differences = true;
  EXPECT_EQ(build_robustness(results, "sensor.noise_sigma", {"success"}, options).curves.size(),
            1u);
  options.values = {1, 2, 2};
  EXPECT_THROW(build_robustness(results, "anything", {"success"}, options), Error);
}

TEST(CsvColumns, AnyTwoColumnsOfNumbersCanBeCrossed) {
  const RunColumns table =
      columns_from_csv("width, cost,note\n1,10,x\n2,,y\r\n3,30,\"z,\n z\"\n4,40,w\n", "t.csv");
  EXPECT_EQ(table.size(), 4u);
  EXPECT_EQ(table.metrics.size(), 2u);  // notes are no numbers
  const auto cross = build_cross_tables(table, parse_bin_specs("width:1,3,4"), {"cost"}, {})[0];
  EXPECT_EQ(cross.title, "all by width");
  EXPECT_EQ(*cross.rows[0].cells[0].estimate, 10);
  EXPECT_EQ(cross.rows[0].cells[0].na.at("empty"), 1u);
  EXPECT_EQ(*cross.rows[1].cells[0].estimate, 35);
}

TEST(CsvColumns, KeysSayWhatRowsBelongTo) {
  CsvColumnOptions options;
  options.down = {"time"};
  const RunColumns table = columns_from_csv(
      "scenario,method,repetition,time,ok\ns1,b,nan,5,1\ns1,a,-1,6,0\ns2,b,1,7,1\n", "t.csv",
      options);
  EXPECT_EQ(table.methods, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(table.scenario_hashes.size(), 2u);
  EXPECT_EQ(table.repetition, (std::vector<std::uint32_t>{0, 0, 1}));
  EXPECT_EQ(find_metric(table, "time")->info().direction, Direction::Down);
  EXPECT_TRUE(find_metric(table, "ok")->rate);
  EXPECT_FALSE(find_metric(table, "time")->rate);
}

TEST(CsvColumns, RefuseBrokenTables) {
  for (const char* text : {"", "a,b\n", "a,b\n1,2,3\n", "a,b\nx,y\n"})
    EXPECT_THROW(columns_from_csv(text, "t.csv"), Error) << text;
  try {
    columns_from_csv("a,b\n1,2\n1\n", "t.csv");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_status(), 3);
    EXPECT_NE(std::string(error.what()).find("t.csv:3"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace slalom
