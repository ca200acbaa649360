// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/results/privileged.h>
#include <slalom/results/result_table.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace slalom {
namespace {

/// Runs with these methods and outcomes, each in a scenario of its own.
ResultTable table_of(const std::vector<std::pair<std::string, std::string>>& runs) {
  ResultTable table;
  NameIndex methods(table.methods), outcomes(table.outcomes);
  ValueColumn& position = table.metrics.emplace_back(QuantityInfo{"position", 1, "", "-", {}});
  ValueColumn& density = table.descriptors.emplace_back(QuantityInfo{"density", 1, "", "-", {}});
  for (const auto& [method, outcome] : runs) {
    const std::size_t run = table.size();
    table.scenario_hashes.push_back("0123456789abcdef" + std::to_string(run));
    table.scenario_names.push_back("s" + std::to_string(run));
    table.scenario.push_back(static_cast<std::uint32_t>(run));
    table.method.push_back(methods.index_of(method));
    table.outcome.push_back(outcomes.index_of(outcome));
    table.repetition.push_back(0);
    table.details.push_back({run, "", "", 0});
    position.add_number(static_cast<double>(run));
    density.add_number(0.1 * static_cast<double>(run));
  }
  return table;
}

TEST(ResultTable, HaveAReasonForEachMissingValue) {
  ValueColumn column({"spl", 1, "SPL", "-", Direction::Up});
  column.add(Value::of(0.5));
  column.add(Value::na("outcome: stuck"));
  column.add_number(std::numeric_limits<double>::quiet_NaN());
  column.add_na("outcome: stuck");
  ASSERT_EQ(column.size(), 4u);
  EXPECT_EQ(column.number(0), 0.5);
  EXPECT_FALSE(column.is_na(0));
  EXPECT_EQ(column.reason(1), "outcome: stuck");
  EXPECT_EQ(column.reason(2), "not a finite number");
  EXPECT_EQ(column.reason(3), "outcome: stuck");
}

TEST(ResultTable, HaveSortedMethodsAndOutcomesWithSuccessFirst) {
  ResultTable table = table_of({{"z", "timeout"}, {"a", "success"}, {"z", "collision"}});
  sort_names(table);
  EXPECT_EQ(table.methods, (std::vector<std::string>{"a", "z"}));
  EXPECT_EQ(table.method, (std::vector<std::uint32_t>{1, 0, 1}));
  EXPECT_EQ(table.outcomes, (std::vector<std::string>{"success", "collision", "timeout"}));
  EXPECT_EQ(table.outcome, (std::vector<std::uint32_t>{2, 0, 1}));
}

TEST(ResultTable, KeepRunsAndScenariosTogetherWhenSorted) {
  ResultTable table = table_of({{"a", "success"}, {"b", "stuck"}, {"a", "stuck"}});
  table.scenario_names = {"z", "y", "z"};
  std::swap(table.scenario_hashes[0], table.scenario_hashes[2]);
  sort_rows(table);
  EXPECT_EQ(table.scenario_names, (std::vector<std::string>{"y", "z", "z"}));
  EXPECT_TRUE(std::is_sorted(table.scenario_hashes.begin() + 1, table.scenario_hashes.end()));
  const std::vector<std::size_t> before = {1, 2, 0};
  for (std::size_t run = 0; run < table.size(); ++run) {
    const std::size_t was = before[run];
    EXPECT_EQ(table.scenario[run], run);
    EXPECT_EQ(table.metrics[0].number(run), static_cast<double>(was));
    EXPECT_EQ(table.details[run].seed, was);
    EXPECT_EQ(table.descriptors[0].number(run), 0.1 * static_cast<double>(was));
  }
  EXPECT_EQ(run_id(table, 0), "01234567/b/0");
}

TEST(ResultTable, ValuesOfFailedRunsStayWithTheirRuns) {
  ResultTable table = table_of({{"b", "success"}, {"a", "stuck"}});
  table.scenario = {0, 0};
  ValueColumn time({"time", 1, "time", "s", Direction::Down});
  time.add_number(5);
  time.add_number(7);
  table.unconditional = {time};
  time.set_na(1, "outcome: stuck");
  table.metrics.push_back(time);
  sort_rows(table);
  EXPECT_EQ(find_metric(table, "time")->reason(0), "outcome: stuck");
  EXPECT_EQ(find_unconditional(table, "time")->number(0), 7);
  EXPECT_EQ(find_unconditional(table, "time")->number(1), 5);
  EXPECT_EQ(find_unconditional(table, "none"), nullptr);
}

TEST(ResultTable, AreSortedByMethodAndRepetitionWithinAScenario) {
  ResultTable table =
      table_of({{"b", "success"}, {"a", "stuck"}, {"a", "success"}, {"b", "stuck"}});
  table.scenario = {0, 0, 0, 0};
  table.repetition = {9, 10, 9, 0};
  sort_rows(table);
  std::vector<std::string> ids;
  for (std::size_t run = 0; run < table.size(); ++run) ids.push_back(run_id(table, run).substr(8));
  EXPECT_EQ(ids, (std::vector<std::string>{"/a/9", "/a/10", "/b/0", "/b/9"}));
}

TEST(ResultTable, SuccessFollowsFromTheOutcome) {
  ResultTable columns = table_of(
      {{"m", "success"}, {"m", "collision"}, {"m", "unsolvable_scenario"}, {"m", kUnknownOutcome}});
  add_success(columns);
  const ValueColumn& success = *find_metric(columns, "success");
  EXPECT_TRUE(success.info().is_rate());
  EXPECT_EQ(success.number(0), 1);
  EXPECT_EQ(success.number(1), 0);
  EXPECT_EQ(success.reason(2), "unsolvable_scenario");
  EXPECT_EQ(success.reason(3), "not recorded");
  add_success(columns);
  EXPECT_EQ(columns.metrics.size(), 2u);  // it was there already
  EXPECT_TRUE(is_failure("stuck"));
  for (const char* outcome :
       {"success", "unsolvable_scenario", "infrastructure_error", kUnknownOutcome})
    EXPECT_FALSE(is_failure(outcome));
}

TEST(PrivilegedMarks, FollowTheNamesInATableAndAreNotInIdsOfRuns) {
  ResultTable table;
  table.methods = {"gap", "nd", "nd_tracks"};
  table.manifest[kPrivilegedKey] = "nd";
  table.scenario_hashes = {"0123abcd99"};
  table.scenario = {0};
  table.method = {1};
  table.repetition = {0};
  for (int i = 0; i < 2; ++i) {
    mark_privileged(table);
    EXPECT_EQ(table.methods, (std::vector<std::string>{"gap", "nd*", "nd_tracks"})) << "once";
  }
  EXPECT_EQ(run_id(table, 0), "0123abcd/nd/0");
  EXPECT_EQ(marked_name(table, "nd"), "nd*");
  EXPECT_EQ(marked_name(table, "gap"), "gap");
  EXPECT_EQ(marked_name(table, "none"), "none");
  EXPECT_NE(privileged_footnote(table), "");
  table.methods = {"gap", "nd"};
  EXPECT_EQ(privileged_footnote(table), "") << "without marks";
}

TEST(PrivilegedMarks, AreExplainedByAFootnoteFromTheManifest) {
  EXPECT_TRUE(privileged_methods({{"campaign", "a"}}).empty());
  EXPECT_EQ(privileged_footnote(PrivilegedMethods{}), "");
  const auto names = privileged_methods({{kPrivilegedKey, "a, b"}});
  EXPECT_EQ(names.names(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(
      privileged_footnote(names),
      "* privileged: a, b are given the tracks of movers (positions, velocities, radii); methods "
      "without the mark are not");
}

TEST(PrivilegedMarks, TellTracksFromTheMap) {
  PrivilegedMethods methods;
  methods.add("a", true, false);
  methods.add("b", true, true);
  methods.add("b", true, true);
  methods.add("c", false, true);
  methods.add("d", false, false);
  EXPECT_EQ(methods.names(), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(privileged_footnote(methods),
            "* privileged: a, b are given the tracks of movers (positions, velocities, radii); b, "
            "c are given the map of static obstacles; methods without the mark are not");
  EXPECT_EQ(privileged_footnote(PrivilegedMethods{{}, {"c"}}),
            "* privileged: c is given the map of static obstacles; methods without the mark are "
            "not");
  Manifest manifest;
  store_privileged(methods, manifest);
  EXPECT_EQ(privileged_footnote(privileged_methods(manifest)), privileged_footnote(methods));
  store_privileged({}, manifest = {});
  EXPECT_TRUE(manifest.empty());
}

}  // namespace
}  // namespace slalom
