// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

#include <slalom/evaluate.h>
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

}  // namespace
}  // namespace slalom
