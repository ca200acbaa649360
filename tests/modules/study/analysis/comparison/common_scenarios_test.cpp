// SPDX-License-Identifier: BSD-3-Clause
#include "result_fixture.h"

#include <slalom/analysis/common_scenarios.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// Method a solves all ten scenarios, with values from 0.1 to 1; b the first `solved` ones, with
/// 0.5.
ResultTable survivors(int solved) {
  ResultFixture fixture;
  for (int i = 0; i < 10; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    fixture.add_run(hash, "a", 0.1 * (i + 1));
    fixture.add_run(hash, "b", i < solved ? 0.5 : -1);
  }
  return fixture.table;
}

TEST(CommonScenarios, AreThoseThatAllMethodsSolved) {
  const auto found = build_common_scenarios(survivors(4), {"optimality", "path_length"}, {});
  ASSERT_EQ(found.size(), 1u) << "each path has a length";
  EXPECT_EQ(found[0].scenarios, 4u);
  EXPECT_EQ(found[0].left_out, 6u);
  EXPECT_NEAR(*found[0].cells[0].estimate, 0.25, 1e-12);  // 0.1 to 0.4; 0.55 over all
  EXPECT_EQ(found[0].runs[0], (std::vector<std::size_t>{0, 2, 4, 6}));
  EXPECT_EQ(title_of(found[0]), "optimality on the 4 scenarios that all 2 methods solved");
}

TEST(CommonScenarios, AreNotNeededWhereATenthOrLessIsMissing) {
  EXPECT_TRUE(build_common_scenarios(survivors(9), {"optimality"}, {}).empty());
  EXPECT_FALSE(build_common_scenarios(survivors(8), {"optimality"}, {}).empty());
}

TEST(CommonScenarios, NeedARunOfEveryMethodAndEveryRepetition) {
  ResultFixture fixture;
  fixture.table = survivors(4);
  const std::string first = fixture.table.scenario_hashes[0];
  fixture.add_run(first, "b", -1, 1);                               // fails the second time
  fixture.add_run(fixture.add_scenario(Value::of(0.1)), "a", 0.9);  // without b
  const auto found = build_common_scenarios(fixture.table, {"optimality"}, {});
  EXPECT_EQ(found[0].scenarios, 3u);
  EXPECT_EQ(found[0].left_out, 8u);
}

}  // namespace
}  // namespace slalom
