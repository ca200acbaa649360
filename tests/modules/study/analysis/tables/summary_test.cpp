// SPDX-License-Identifier: BSD-3-Clause
#include "result_fixture.h"

#include <slalom/analysis/summary.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(Summary, CountsOutcomesPerMethodWithSuccessFirst) {
  ResultFixture fixture;
  const std::string hash = fixture.add_scenario(Value::of(0.1));
  fixture.add_run(hash, "nd", 0.9, 0);
  fixture.add_run(hash, "nd", -1, 1);
  fixture.add_run(hash, "vff", -1, 0);
  const SummaryTable summary = build_summary(fixture.table, {"success", "optimality"}, {});
  EXPECT_EQ(summary.outcomes, (std::vector<std::string>{"success", "collision"}));
  ASSERT_EQ(summary.methods.size(), 2u);
  EXPECT_EQ(summary.methods[0].n, 2u);
  EXPECT_EQ(summary.methods[0].outcomes.at("collision"), 1u);
  EXPECT_DOUBLE_EQ(*summary.methods[0].cells[1].estimate, 0.9);
  EXPECT_FALSE(summary.methods[1].cells[1].estimate.has_value());
}

}  // namespace
}  // namespace slalom
