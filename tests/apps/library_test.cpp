// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

#include <slalom/evaluate.h>
#include <slalom/inquiry/tune_search.h>
#include <slalom/io/read_results.h>
#include <slalom/library/library_method.h>
#include <slalom/mrpt_nav/holonomic_method.h>
#include <slalom/ompl/ompl_planner.h>

namespace slalom {
namespace {

class Library : public ProgramTest {};

/// "0.5", or the reason why there is no value.
std::string text_of(const ValueColumn& column, std::size_t row) {
  return column.is_na(row) ? column.reason(row) : std::to_string(column.number(row));
}

/// Whether all values of both tables are the same, except measured times.
void expect_same(const std::vector<ValueColumn>& columns, const ResultTable& other,
                 const ValueColumn* (*find)(const ResultTable&, const std::string&)) {
  for (const ValueColumn& column : columns) {
    const ValueColumn* same = find(other, column.info().id);
    ASSERT_NE(same, nullptr) << column.info().id;
    EXPECT_EQ(same->wall_clock, column.wall_clock);
    ASSERT_EQ(same->size(), column.size());
    for (std::size_t row = 0; !column.wall_clock && row < column.size(); ++row) {
      EXPECT_EQ(text_of(*same, row), text_of(column, row)) << column.info().id;
      EXPECT_EQ(same->is_na(row), column.is_na(row));
      EXPECT_TRUE(column.is_na(row) || same->number(row) == column.number(row));
    }
  }
}

TEST_F(Library, GivesTheValuesOfTheProgram) {
  write("small.ini", kSmallCampaign);
  const ProgramResult result =
      run("slalom-evaluate small.ini -o out --quiet --set campaign.repetitions=2");
  ASSERT_EQ(result.status, 0) << result.err;
  const ResultTable expected = read_results((folder_ / "out/runs.results").string());

  RandomGeneratorOptions family;
  family.width = family.height = 6;
  family.start_goal.min_distance = 3;
  family.obstacles.max_obstacles = 10;
  family.obstacles.size.max_size = 0.4;
  Methods methods;
  methods.add("nd", mrpt_holonomic("CHolonomicND"));
  methods.add("gap", plugin("libslalom_follow_the_gap.so"));
  Options options;
  options.seed = 5;
  options.repetitions = 2;
  options.workers = 2;
  options.planner = make_ompl_planner({});
  const ResultTable table = evaluate(methods, generate(family, 4, options.seed), options);

  EXPECT_EQ(table.scenario_hashes, expected.scenario_hashes);
  EXPECT_EQ(table.scenario_names, expected.scenario_names);
  EXPECT_EQ(table.methods, expected.methods);
  ASSERT_EQ(table.size(), 16U);
  ASSERT_EQ(expected.size(), 16U);
  for (std::size_t run = 0; run < table.size(); ++run) {
    EXPECT_EQ(run_id(table, run), run_id(expected, run));
    EXPECT_EQ(table.outcomes[table.outcome[run]], expected.outcomes[expected.outcome[run]]);
  }
  ASSERT_EQ(table.metrics.size(), expected.metrics.size());
  expect_same(table.metrics, expected, find_metric);
  ASSERT_EQ(table.descriptors.size(), expected.descriptors.size());
  expect_same(table.descriptors, expected, find_descriptor);
}

// The example of docs/develop/library.md, with fewer scenarios.
TEST_F(Library, TunesByTheFunctionsOfTheAnalysis) {
  PassageOptions family;
  family.min_width = 0.68;
  family.max_width = 0.75;
  Options options;
  options.robot.radius = 0.21;
  options.workers = 2;
  options.metrics = options.descriptors = {};
  TuneOptions search;
  search.budget = kMinTuneBudget;
  search.development = search.finals = 100;
  // Name, default, low, high, log, integer, choices, condition.
  const slalom::ParameterSpace space({{"margin", 0.1, 0, 0.3, false, false, {}, {}},
                                      {"look_ahead", 2.5, 0.5, 5, true, false, {}, {}}});
  const auto development = slalom::generate(family, 100, 1),
             finals = slalom::generate(family, 100, 2);
  const auto run = [&](const slalom::TuneRequest& request) {
    slalom::Methods methods;
    methods.add("gap", slalom::plugin("libslalom_follow_the_gap.so",
                                      {{"margin", space.text(0, request.configuration[0])},
                                       {"look_ahead", space.text(1, request.configuration[1])}}));
    const auto& all = request.phase == slalom::TunePhase::Finals ? finals : development;
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(request.first);
    const auto table = slalom::evaluate(
        methods, {first, first + static_cast<std::ptrdiff_t>(request.count)}, options);
    std::vector<slalom::TuneOutcome> outcomes;
    for (std::size_t i = 0; i < table.size(); ++i) {
      const std::string& outcome = table.outcomes[table.outcome[i]];
      outcomes.push_back({outcome == "success", outcome == "collision", {}});
    }
    for (std::size_t i = 0; i < table.size(); ++i)
      EXPECT_EQ(table.scenario_hashes[table.scenario[i]], (first + i)->hash());
    return outcomes;
  };
  const slalom::TuneResult result = slalom::tune_search(space, search, run);
  const slalom::Configuration& best = result.candidates[result.winner].configuration;
  EXPECT_TRUE(result.complete);
  EXPECT_LE(result.runs(TunePhase::Development) + result.runs(TunePhase::Finals), search.budget);
  // The default has a margin at which some doors are too narrow.
  EXPECT_LT(best[0], 0.1);
}

}  // namespace
}  // namespace slalom
