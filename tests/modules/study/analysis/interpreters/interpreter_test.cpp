// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "result_fixture.h"
#include "robustness.h"

#include <slalom/analysis/campaign_settings.h>
#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/completion.h>
#include <slalom/analysis/csv_columns.h>
#include <slalom/analysis/descriptor_map.h>
#include <slalom/analysis/failure_taxonomy.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/method_ranks.h>
#include <slalom/analysis/performance_profile.h>
#include <slalom/analysis/table_export.h>
#include <slalom/analysis/table_latex.h>
#include <slalom/analysis/table_text.h>
#include <slalom/analysis/validity.h>
#include <slalom/core/error.h>
#include <slalom/results/privileged.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <sstream>

namespace slalom {
namespace {

/// Six scenarios of density 0.1 .. 0.6; a fails in the densest two, b in none. Optimality
/// decreases with density.
ResultFixture six() {
  ResultFixture fixture;
  for (int i = 1; i <= 6; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1 * i));
    fixture.add_run(hash, "a", i <= 4 ? 1 - 0.1 * i : -1);
    fixture.add_run(hash, "b", 1 - 0.05 * i);
  }
  return fixture;
}

AnalysisQuery query(const std::string& rows, const std::vector<std::string>& metrics) {
  AnalysisQuery result;
  result.rows = parse_bin_specs(rows);
  result.metrics = metrics;
  return result;
}

const Interpreter& named(const std::string& id) {
  for (const Interpreter& interpreter : all_interpreters())
    if (interpreter.id == id) return interpreter;
  throw std::runtime_error("no " + id);
}

/// Whether the analysis is possible with six() alone. A scale of difficulty needs methods that fail
/// where another one succeeds, both ways: difficulty_test.cpp.
bool accepts_six(const Interpreter& interpreter) {
  return interpreter.min_results == 1 && interpreter.id != "difficulty";
}

TEST(Interpreter, IdsAreUniqueAndAllFormatsAgree) {
  std::set<std::string> ids;
  for (const Interpreter& interpreter : all_interpreters()) {
    EXPECT_TRUE(ids.insert(interpreter.id).second);
    EXPECT_FALSE(interpreter.help.empty());
    if (!accepts_six(interpreter) || interpreter.id == "table") continue;
    const std::string rows = interpreter.id == "map" ? "density:2;density:3" : "density:2";
    const std::vector<ResultTable> results = {six().table};
    const auto found = interpreter.interpret(results, query(rows, {"optimality"}));
    ASSERT_FALSE(found.tables.empty()) << interpreter.id;
    const auto json = nlohmann::json::parse(render_json(found));
    EXPECT_EQ(json["tables"].size(), found.tables.size());
    EXPECT_EQ(json["tables"][0]["rows"].size(), found.tables[0].rows);
    const std::string csv = render_csv(found.tables[0]);
    EXPECT_EQ(csv.substr(0, csv.find(',')), found.tables[0].columns[0]);
    EXPECT_FALSE(render_text(found).empty());
    const auto again = interpreter.interpret(results, query(rows, {"optimality"}));
    EXPECT_EQ(render_json(found), render_json(again));
  }
}

TEST(Interpreter, CrossTablesKeepTheirOwnFormats) {
  const std::vector<ResultTable> results = {six().table};
  AnalysisQuery asked = query("density:2;all", {"optimality"});
  const auto tables =
      build_cross_tables(results[0], asked.rows, asked.metrics, asked.comparison.analysis);
  const Interpretation found = named("table").interpret(results, asked);
  EXPECT_EQ(render_csv(found), render_csv(tables));
  EXPECT_EQ(render_json(found), render_json(tables));
  EXPECT_EQ(render_text(found), render_tables_text(results[0], asked.rows, asked.metrics, 0.95));
  asked.method = "b";  // no summary, which would be of all methods
  EXPECT_EQ(render_text(named("table").interpret(results, asked)),
            render_cross_table_text(tables[1]) + "\n\n" + render_cross_table_text(tables[3]));
}

TEST(Interpreter, MethodsInColumnsHaveTheCellsOfTheirTables) {
  const std::vector<ResultTable> results = {six().table};
  const AnalysisQuery asked = query("density:2;density:0,0.2,1;all", {"success", "optimality"});
  const auto tables =
      build_cross_tables(results[0], asked.rows, asked.metrics, asked.comparison.analysis);
  Interpretation found = named("table").interpret(results, asked);
  put_methods_in_columns(found);
  ASSERT_EQ(found.tables.size(), 3U * 2) << "bins by metrics";
  for (std::size_t i = 0; i < found.tables.size(); ++i) {
    const DataTable &exact = found.tables[i], &shown = found.views[i];
    ASSERT_EQ(exact.columns.size(), 2U + 2 * 3) << "two methods with their intervals";
    for (std::size_t method = 0; method < 2; ++method) {
      const CrossTable& table = tables[i / 2 * 2 + method];
      EXPECT_EQ(shown.columns[2 + method], table.method);
      ASSERT_EQ(exact.rows, table.rows.size());
      for (std::size_t row = 0; row < exact.rows; ++row) {
        const Cell& cell = table.rows[row].cells[i % 2];
        EXPECT_EQ(exact.at(row, 0), Field{table.rows[row].bin.label()});
        EXPECT_EQ(exact.at(row, 2 + 3 * method), cell.estimate ? Field{*cell.estimate} : Field{});
        EXPECT_EQ(exact.at(row, 3 + 3 * method),
                  cell.interval ? Field{cell.interval->low} : Field{});
        const std::string text = std::get<std::string>(shown.at(row, 2 + method));
        EXPECT_EQ(text.find(estimate_text(cell, 2).substr(0, 3)), 0U) << text;
        EXPECT_EQ(text.find("n = ") != std::string::npos, cell.available < cell.n) << text;
      }
    }
  }
  const std::string markdown = render_markdown(found);
  EXPECT_NE(markdown.find("**success by all, 95 % intervals**\n\n| all | runs | a | b |\n"
                          "| --- | --- | --- | --- |\n| all | 6 | "),
            std::string::npos)
      << markdown;
  EXPECT_NE(render_latex(found).find("\\label{tab:success-by-all}"), std::string::npos);
}

TEST(Interpreter, MethodsInColumnsSayThatTheirNumbersOfRunsDiffer) {
  ResultFixture fixture;
  const std::string hash = fixture.add_scenario(Value::of(0.05));
  fixture.add_run(hash, "a", 0.5);
  fixture.add_run(hash, "a", 0.5, 1);
  fixture.add_run(hash, "b", 0.5);
  Interpretation found = named("table").interpret({fixture.table}, query("all", {"success"}));
  put_methods_in_columns(found);
  EXPECT_EQ(found.tables.at(0).at(0, 1), Field{std::string("1 to 2")});
}

TEST(Interpreter, MarksPrivilegedMethodsInAllFormats) {
  const std::string footnote = "* privileged: b is given the tracks of movers";
  for (const Interpreter& interpreter : all_interpreters()) {
    if (!accepts_six(interpreter)) continue;
    std::vector<ResultTable> results = {six().table};
    const std::string rows = interpreter.id == "map" ? "density:2;density:3" : "density:2";
    const AnalysisQuery asked = query(rows, {"optimality"});
    const Interpretation plain = interpreter.interpret(results, asked);
    const Interpretation same = interpret(interpreter, results, asked);
    EXPECT_EQ(render_text(same), render_text(plain)) << "without privileged methods";
    EXPECT_EQ(render_csv(same), render_csv(plain));
    results[0].manifest[kPrivilegedKey] = "b";
    const Interpretation marked = interpret(interpreter, results, asked);
    for (const std::string& text : {render_text(marked), render_csv(marked)}) {
      EXPECT_NE(text.find("b*"), std::string::npos) << interpreter.id << "\n" << text;
      EXPECT_NE(text.find(footnote), std::string::npos) << interpreter.id << "\n" << text;
      EXPECT_EQ(text.find("a*"), std::string::npos) << interpreter.id;
    }
    Interpretation documents = marked;
    put_methods_in_columns(documents);
    for (const std::string& text : {render_latex(documents), render_html(documents, "t"),
                                    render_markdown(documents), render_json(documents)}) {
      EXPECT_NE(text.find("b*"), std::string::npos) << interpreter.id << "\n" << text;
      EXPECT_NE(text.find(footnote), std::string::npos) << interpreter.id << "\n" << text;
    }
  }
}

TEST(Interpreter, MarksPrivilegedMethodsInLatexOfSummaryAndCrossTables) {
  std::vector<ResultTable> results = {six().table};
  results[0].manifest[kPrivilegedKey] = "b";
  const Interpretation found =
      interpret(named("table"), results, query("density:2", {"optimality"}));
  const std::string summary = render_latex(*found.summary);
  EXPECT_NE(summary.find("b* & "), std::string::npos) << summary;
  EXPECT_NE(summary.find(". * privileged: b is given"), std::string::npos) << summary;
  ASSERT_EQ(found.cross_tables->size(), 2U);
  EXPECT_EQ(render_latex(found.cross_tables->at(0)).find("privileged"), std::string::npos);
  EXPECT_NE(render_latex(found.cross_tables->at(1)).find("b* by density"), std::string::npos);
}

TEST(Interpreter, MarksNamesOfPrivilegedMethodsButNoOtherWords) {
  for (const Interpreter& interpreter : all_interpreters()) {
    if (!accepts_six(interpreter)) continue;
    const std::string rows = interpreter.id == "map" ? "density:2;density:3" : "density:2";
    const auto marks = [&](const std::string& name) {
      std::vector<ResultTable> results = {six().table};
      results[0].methods[1] = name;
      results[0].manifest[kPrivilegedKey] = name;
      std::string text = render_text(interpret(interpreter, results, query(rows, {"optimality"})));
      return std::count(text.begin(), text.end(), '*');
    };
    for (const char* word : {"runs", "of", "success", "optimality", "density", "is", "succeeds"})
      EXPECT_EQ(marks(word), marks("zzz")) << interpreter.id << ": " << word;
  }
}

TEST(Interpreter, TakesNamesOfForeignMethodsThatEndLikeTheMarkAsTheyAre) {
  std::vector<ResultTable> results = {six().table};
  results[0].methods = {"RRT", "RRT*"};
  EXPECT_EQ(index_of_method(results[0], "RRT"), 0U);
  EXPECT_EQ(index_of_method(results[0], "RRT*"), 1U);
  EXPECT_EQ(marked_name(results[0], "RRT"), "RRT");
  const std::string compared =
      render_text(interpret(named("compare"), results, query("all", {"optimality"})));
  EXPECT_EQ(compared.find("identical"), std::string::npos) << compared;
  const std::size_t last = results[0].size() - 1;
  EXPECT_NE(run_id(results[0], last).find("/" + results[0].methods[results[0].method[last]] + "/"),
            std::string::npos);
}

TEST(Interpreter, TakesNamesOfPrivilegedMethodsWithoutTheirMark) {
  std::vector<ResultTable> results = {six().table};
  results[0].manifest[kPrivilegedKey] = "b";
  AnalysisQuery asked = query("all", {"optimality"});
  asked.baseline = "b";
  const std::string text = render_text(interpret(named("compare"), results, asked));
  EXPECT_NE(text.find("b*"), std::string::npos) << text;
  asked = query("all", {"optimality"});
  asked.method = "b";
  const std::string summary = render_text(interpret(named("summary"), results, asked));
  EXPECT_NE(summary.find("b* succeeds"), std::string::npos) << summary;
}

/// Three methods over `six`; c is as good as a, and reaches nothing beyond scenario 2.
ResultFixture three_methods() {
  ResultFixture fixture = six();
  int i = 0;
  for (const std::string& hash : fixture.table.scenario_hashes)
    fixture.add_run(hash, "c", ++i <= 2 ? 1 - 0.1 * i : -1);
  return fixture;
}

std::string csv_of(const std::string& id, const std::string& method, const std::string& metric) {
  AnalysisQuery asked = query("density:2", {metric});
  asked.method = method;
  return render_csv(named(id).interpret({three_methods().table}, asked));
}

TEST(Interpreter, AMethodIsShownAsItIsAmongAll) {
  // Its rows are those of the answer about all methods, which ranks and profiles compare.
  for (const char* id : {"ranks", "profile", "completion", "failures", "summary", "validity"}) {
    const std::string metric = std::string(id) == "completion" ? "path_length" : "optimality";
    const std::string all = csv_of(id, "", metric), one = csv_of(id, "b", metric);
    EXPECT_EQ(one.find("\na,"), std::string::npos) << id << "\n" << one;
    EXPECT_NE(one.find("\nb,"), std::string::npos) << id << "\n" << one;
    std::istringstream lines(one);
    for (std::string line; std::getline(lines, line);)
      EXPECT_NE(all.find(line), std::string::npos) << id << ": " << line;
  }
}

/// Two methods in 20 scenarios, the second always better: p of the signed ranks is 2 / 2^20, that
/// of Friedman's test, chi squared 20 with one degree of freedom, 8e-6.
ResultTable clearly_different() {
  ResultFixture fixture;
  for (int i = 1; i <= 20; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.01 * i));
    fixture.add_run(hash, "a", 0.5 + 0.01 * i);
    fixture.add_run(hash, "b", 0.6 + 0.015 * i);
  }
  return fixture.table;
}

TEST(Interpreter, WritesSmallPValuesAsBoundsForPeopleAndExactlyInCsv) {
  const ResultTable table = clearly_different();
  for (const char* id : {"compare", "ranks"}) {
    const auto found = named(id).interpret({table}, query("all", {"optimality"}));
    const std::string text = render_text(found);
    EXPECT_EQ(text.find("0.0000 "), std::string::npos) << text;
    EXPECT_NE(text.find("  < 0.0001"), std::string::npos) << text;
    EXPECT_NE(text.find("p < 0.0001"), std::string::npos) << text;
    EXPECT_NE(render_html(found, "title").find("<td>&lt; 0.0001</td>"), std::string::npos);
    EXPECT_EQ(render_csv(found).find("< 0.0001,"), std::string::npos) << render_csv(found);
  }
  const auto comparison = named("compare").interpret({table}, query("all", {"optimality"}));
  EXPECT_NE(render_csv(comparison).find(",1.9073486328125e-06,"), std::string::npos)
      << render_csv(comparison);
}

TEST(Interpreter, CompareTakesTheOthersAgainstAMethod) {
  const std::string csv = csv_of("compare", "b", "optimality");
  EXPECT_NE(csv.find("optimality,a,b,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("optimality,b,c,"), std::string::npos) << csv;
  EXPECT_EQ(csv.find("optimality,a,c,"), std::string::npos) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
}

TEST(Interpreter, AMethodThatIsNotThereIsRefusedByAll) {
  for (const Interpreter& interpreter : all_interpreters()) {
    const bool sweeps = interpreter.min_results > 1;
    AnalysisQuery asked =
        query(interpreter.id == "map" ? "density:2;clearness:2" : "density:2", {"optimality"});
    asked.method = "nothing_like_it";
    asked.parameter = "sensor.noise_sigma";
    std::vector<ResultTable> results = {six().table};
    if (sweeps) results.push_back(results.front());
    try {
      interpreter.interpret(results, asked);
      FAIL() << interpreter.id;
    } catch (const Error& error) {
      EXPECT_EQ(error.exit_status(), 2) << interpreter.id;
      EXPECT_NE(std::string(error.what()).find("one of a, b"), std::string::npos) << error.what();
    }
  }
}

TEST(Interpreter, ScenariosOfRanksAddUpToAllThatThereAre) {
  ResultFixture fixture = six();
  for (int i = 0; i < 3; ++i) {  // scenarios in which nobody arrives
    const std::string hash = fixture.add_scenario(Value::of(0.9));
    fixture.add_run(hash, "a", -1);
    fixture.add_run(hash, "b", -1);
  }
  const ResultTable table = fixture.table;
  const auto ranks = named("ranks").interpret({table}, query("all", {"optimality"}));
  // a and b have values in 4 of 9 scenarios, b alone in 2, none in 3.
  const std::string text = render_text(ranks);
  EXPECT_NE(text.find("4 of 9 scenarios; left out: 2 in which not every method has a value, 3 in "
                      "which none has"),
            std::string::npos)
      << text;
  EXPECT_NE(render_csv(ranks).find("scenarios,left_out,without_value,"), std::string::npos);
  EXPECT_NE(render_csv(ranks).find("\n4,2,3,"), std::string::npos) << render_csv(ranks);
  EXPECT_NE(render_csv(ranks).find(",0.05,"), std::string::npos) << render_csv(ranks);
  const auto profile = named("profile").interpret({table}, query("all", {"optimality"}));
  EXPECT_NE(
      render_text(profile).find("6 of 9 scenarios; left out: 3 in which no method has a value"),
      std::string::npos)
      << render_text(profile);
}

TEST(Interpreter, MapAssignsEachRunToItsField) {
  const ResultTable table = six().table;
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

TEST(Interpreter, EmptyCellsHaveAReason) {
  const auto found = named("map").interpret(
      {six().table}, query("density:0,0.45,0.65;clearness:0,0.4,1", {"optimality"}));
  const std::string csv = render_csv(found);
  EXPECT_NE(csv.find("no runs"), std::string::npos) << csv;
  EXPECT_NE(csv.find("no values: 2 collision"), std::string::npos) << csv;
}

TEST(Interpreter, FailuresAddUpToTheRuns) {
  const ResultTable table = six().table;
  const FailureTaxonomy taxonomy =
      build_failure_taxonomy(table, parse_bin_spec("density:0,0.45,1"), {});
  EXPECT_EQ(taxonomy.outcomes, (std::vector<std::string>{"success", "collision"}));
  ASSERT_EQ(taxonomy.groups.size(), 4u);
  const OutcomeGroup& dense_a = taxonomy.groups[1];
  EXPECT_EQ(dense_a.n, 2u);
  EXPECT_EQ(dense_a.outcomes[1].fraction, 1);
  EXPECT_EQ(table.outcomes[table.outcome[dense_a.outcomes[1].runs[0]]], "collision");
  for (const OutcomeGroup& group : taxonomy.groups)
    EXPECT_EQ(group.outcomes[0].runs.size() + group.outcomes[1].runs.size(), group.n);
}

TEST(Interpreter, ValidityFindsTheCorrelationWithDensity) {
  const ValidityTable validity = build_validity(six().table, {"optimality"}, {});
  for (const DescriptorValidity& entry : validity.validity) {
    const bool constant = entry.descriptor == "clearness";
    EXPECT_EQ(entry.correlation.rho.has_value(), !constant);
    if (constant) continue;
    EXPECT_NEAR(*entry.correlation.rho, -1, 1e-12);
  }
  EXPECT_EQ(validity.redundancy.size(), 3u);  // two descriptors: each with itself, and the pair
}

TEST(Interpreter, RanksUseScenariosWithValuesOfAllMethods) {
  const MethodRanks ranks = build_method_ranks(six().table, "optimality", {});
  EXPECT_EQ(ranks.test.scenarios, 4u);
  EXPECT_EQ(ranks.left_out, 2u);
  EXPECT_EQ(ranks.test.mean_ranks, (std::vector<double>{2, 1}));
}

TEST(Interpreter, ProfilesAreRatiosToTheBest) {
  const ProfileTable table = build_profiles(six().table, "optimality");
  EXPECT_EQ(table.scenarios, 6u);
  const PerformanceProfile &a = table.profiles[0], &b = table.profiles[1];
  EXPECT_EQ(b.steps.size(), 1u);
  EXPECT_EQ(b.steps[0].fraction, 1);  // the best everywhere
  EXPECT_EQ(a.without_value, 2u);
  ASSERT_EQ(a.steps.size(), 5u);
  EXPECT_EQ(a.steps[0].fraction, 0);
  EXPECT_NEAR(a.steps[1].ratio, 0.95 / 0.9, 1e-12);
  EXPECT_NEAR(a.steps[4].ratio, 0.8 / 0.6, 1e-12);
  EXPECT_NEAR(a.steps[4].fraction, 4 / 6.0, 1e-12);
  EXPECT_THROW(build_profiles(six().table, "success"), Error);  // a rate has zeros
}

TEST(Interpreter, CompletionEndsAtTheSuccessRate) {
  ResultFixture fixture = six();
  ResultTable& table = fixture.table;
  ValueColumn time({"time_to_goal", 1, "", "s", Direction::Down});
  ValueColumn speed({"mean_speed", 1, "", "m/s", Direction::Up});
  for (std::size_t run = 0; run < table.size(); ++run) {
    const bool reached = table.outcomes[table.outcome[run]] == "success";
    time.add(reached ? Value::of(10 + static_cast<double>(run)) : Value::na("outcome: collision"));
    speed.add_number(2);  // with a path length of 10: all end after 5 s
  }
  table.metrics.push_back(time);
  table.metrics.push_back(speed);
  const auto curves = build_completion(table, "time_to_goal");
  EXPECT_EQ(curves[0].n, 6u);
  EXPECT_NEAR(curves[0].incidence.back().value, 4 / 6.0, 1e-12);
  EXPECT_NEAR(curves[0].kaplan_meier.back().value, 1, 1e-12);  // the others are censored at 5 s
  EXPECT_NEAR(curves[1].incidence.back().value, 1, 1e-12);
}

TEST(Interpreter, CompletionOfATableCountsArrivalsOnly) {
  // Collisions at 3 s and 4 s are competing ends, the time limit at 100 s comes after the arrival.
  const std::string rows[] = {"outcome,time\nsuccess,10\ncollision,4\ntimeout,100\ncollision,3\n",
                              "success,time\n1,10\n0,4\n0,100\n0,3\n"};
  for (const std::string& text : rows) {
    const ResultTable table = columns_from_csv(text, "t.csv");
    const CompletionCurve curve = build_completion(table, "time").at(0);
    EXPECT_EQ(curve.n, 4u);
    EXPECT_EQ(curve.successes, 1u);
    EXPECT_EQ(curve.unknown_end, 0u);
    for (const CurvePoint& point : curve.incidence)
      EXPECT_EQ(point.value, point.time < 10 ? 0 : 0.25) << point.time;
    // One of the two runs that are not yet censored at 10 s arrives.
    EXPECT_EQ(curve.kaplan_meier.back().value, 0.5);
  }
  const ResultTable gap = columns_from_csv("success,time\n1,10\n1,NA\n,7\n", "t.csv");
  EXPECT_EQ(build_completion(gap, "time")[0].untimed, 1u);
  EXPECT_EQ(build_completion(gap, "time")[0].n, 1u) << "the end of the last is not known";
}

TEST(Interpreter, CompletionNeedsEndsAndTimes) {
  for (const char* text : {"method,time\na,10\n", "collided,time\n0,10\n1,4\n"})
    EXPECT_TRUE(throws_error(ErrorKind::Usage, "completion",
                             {"t.csv has neither outcomes nor success", "--outcome-column"},
                             [&] { build_completion(columns_from_csv(text, "t.csv"), "time"); }))
        << text;
  EXPECT_TRUE(throws_error(
      ErrorKind::Usage, "completion", {"'success' is a rate", "--metric COLUMN of times"},
      [] { build_completion(columns_from_csv("success\n1\n0\n", "t.csv"), "success"); }));
}

Manifest campaign(const std::string& sigma) {
  return {{"campaign.ini", "[campaign]\nname = x" + sigma + "\n[sensor]\nnoise_sigma = " + sigma +
                               "\nrays = 181\n"},
          {"scenarios.hash", "abc"}};
}

std::vector<ResultTable> sweep(const std::vector<std::string>& methods = {"a"}) {
  std::vector<ResultTable> results;
  for (const char* sigma : {"0.2", "0", "0.1"}) {
    ResultFixture fixture;
    double number = 0;
    number = std::stod(sigma);
    for (int i = 0; i < 10; ++i) {
      const std::string hash = fixture.add_scenario(Value::of(0.1));
      for (const std::string& method : methods)
        fixture.add_run(hash, method, 0.9 - number - 0.001 * i);
    }
    fixture.table.manifest = campaign(sigma);
    results.push_back(fixture.table);
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
  EXPECT_TRUE(table.orders.empty()) << "a single method";
}

TEST(Interpreter, RobustnessSaysWhetherTheOrderOfTheMethodsIsKept) {
  std::vector<ResultTable> results = sweep({"a", "b"});
  // b, equal to a so far, is worse than a everywhere, and better at 0.2, the first file.
  for (std::size_t i = 0; i < results.size(); ++i)
    for (std::size_t run = 0; run < results[i].size(); ++run)
      if (results[i].method[run] == 1) {
        ValueColumn& values = results[i].metrics[0];
        ValueColumn changed(values.info());
        for (std::size_t other = 0; other < values.size(); ++other)
          changed.add_number(values.number(other) + (other == run ? (i == 0 ? 0.05 : -0.05) : 0));
        values = changed;
      }
  AnalysisQuery asked = query("all", {"optimality"});
  asked.parameter = "sensor.noise_sigma";
  const std::string text = render_text(named("robustness").interpret(results, asked));
  EXPECT_NE(text.find("the order of the methods in optimality at sensor.noise_sigma = 0.1 is that "
                      "at the first value: Kendall's tau 1.00 [1.00, 1.00] over 10 scenarios"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("at sensor.noise_sigma = 0.2 is not shown to resemble that at the first "
                      "value: Kendall's tau -1.00 [-1.00, -1.00] over 10 scenarios; if the true "
                      "means were those seen, in the same order, it would be 1.00 [1.00, 1.00]"),
            std::string::npos)
      << text;
}

TEST(Interpreter, RobustnessOfAMethodHasTheSameCorrectionAsOfAll) {
  // All ten differences of a change have the same sign: p = 2 / 2^10. A method has two changes.
  const auto adjusted = [](const std::string& method) {
    const RobustnessTable table =
        build_robustness(sweep({"a", "b"}), "sensor.noise_sigma", {"optimality"}, {}, method);
    EXPECT_EQ(table.curves.back().method, "b");
    return table.curves.back().points.back().change->adjusted_p;
  };
  EXPECT_NEAR(adjusted(""), 4 * 2 / 1024.0, 1e-12);
  EXPECT_NEAR(adjusted("b"), 4 * 2 / 1024.0, 1e-12);
}

TEST(Interpreter, CampaignsWithOtherSettingsHaveNoVerdictUnlessItIsAskedFor) {
  const std::vector<ResultTable> all = sweep();
  const std::vector<ResultTable> two = {all[1], all[0]};  // noise 0, then 0.2
  const std::string difference = "the campaigns differ: sensor.noise_sigma: 0, 0.2";
  AnalysisQuery query;
  query.metrics = {"optimality"};
  for (const char* id : {"compare", "history"}) {
    query.comparison.despite_settings = false;
    const auto without = named(id).interpret(two, query).remarks;
    EXPECT_EQ(without.front(), difference);
    EXPECT_NE(join(without, "\n").find("no verdict on a (at 0.2) against a (at 0) in optimality"),
              std::string::npos);
    EXPECT_EQ(join(without, "\n").find("is worse"), std::string::npos);
    query.comparison.despite_settings = true;
    const auto with = named(id).interpret(two, query).remarks;
    EXPECT_EQ(with.front(), difference);
    EXPECT_NE(join(with, "\n").find("a (at 0.2) is worse than a (at 0)"), std::string::npos);
  }
  // The options of methods and the scenarios are what campaigns are compared for.
  ResultTable other = all[1];
  other.manifest["campaign.ini"] += "[method.a]\nalpha = 2\n[generator.random]\nx = 1\n";
  query.comparison.despite_settings = false;
  EXPECT_FALSE(
      compare_results(all[1], other, {"optimality"}, query.comparison).front().other_settings);
  const std::string section = "[method.only_here]\nalpha = 2\n";
  const Manifest one = {{"campaign.ini", "[campaign]\nmethods = a\n" + section}};
  const Manifest both = {{"campaign.ini", "[campaign]\nmethods = a, only_here\n" + section},
                         {"method.only_here.plugin_hash", "abc"}};
  EXPECT_EQ(campaign_differences(one, both, {}), std::vector<std::string>{});
  // A gate is a verdict.
  query.gates = {parse_gate("optimality >= -1")};
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--gate", {difference, "--despite-settings"},
                           [&] { named("compare").interpret(two, query); }));
}

TEST(Interpreter, AGateSaysWhatItLeavesOut) {
  ResultFixture before, after;
  for (int i = 0; i < 4; ++i) {
    const std::string name = before.add_scenario(Value::of(0.1 * i));
    ASSERT_EQ(after.add_scenario(Value::of(0.1 * i)), name);
    before.add_run(name, "a", 0.5);
    before.add_run(name, "b", 0.5);
    after.add_run(name, "a", i == 0 ? 0.5 : -1);  // the others fail
  }
  before.table.source = "before.results";
  after.table.source = "after.results";
  AnalysisQuery query;
  query.metrics = {"optimality"};
  query.gates = {parse_gate("optimality >= -0.1")};
  const std::string text =
      join(named("compare").interpret({before.table, after.table}, query).remarks, "\n");
  EXPECT_NE(text.find("passed: difference 0.0000"), std::string::npos) << text;
  EXPECT_NE(text.find(", no value in 3 pairs of runs"), std::string::npos) << text;
  EXPECT_NE(text.find("b: not compared, as after.results has no runs of it"), std::string::npos)
      << text;
}

TEST(Interpreter, RobustnessRejectsCampaignsWithOtherDifferences) {
  auto results = sweep();
  EXPECT_THROW(build_robustness(results, "sensor.dropout_ratio", {"success"}, {}), Error);
  results[1].manifest["campaign.ini"] += "max_range = 4\n";
  EXPECT_TRUE(throws_error(
      ErrorKind::Usage, "at 0", {"sensor.max_range: (default), 4", "--despite-settings"},
      [&] { build_robustness(results, "sensor.noise_sigma", {"success"}, {}); }));
  RobustnessOptions options;
  options.allow_differences = true;
  EXPECT_EQ(build_robustness(results, "sensor.noise_sigma", {"success"}, options).curves.size(),
            1u);
  options.values = {1, 2, 2};
  EXPECT_THROW(build_robustness(results, "anything", {"success"}, options), Error);
}

}  // namespace
}  // namespace slalom
