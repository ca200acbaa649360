// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/campaign/shards.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace slalom {
namespace {

/// Empty fields that differ in their goal.
std::vector<Scenario> fields(int count) {
  std::vector<Scenario> scenarios;
  for (int i = 0; i < count; ++i)
    scenarios.push_back(Scenario::continuous("s" + std::to_string(i), {0, 0, 10, 10}, {}, {1, 1, 0},
                                             {5, 2 + 0.01 * i}));
  return scenarios;
}

std::vector<std::string> hashes(const std::vector<Scenario>& scenarios) {
  std::vector<std::string> hashes;
  for (const Scenario& scenario : scenarios) hashes.push_back(scenario.hash());
  return hashes;
}

TEST(Shards, AreReadAsIndexAndCount) {
  EXPECT_EQ(to_string(parse_shard("3/16", "--shard")), "3/16");
  EXPECT_EQ(to_string(parse_shard("1/1", "--shard")), "1/1");
  for (const char* text : {"", "3", "0/16", "17/16", "-1/4", "1/0", "a/4", "1/4/5", "1.5/4",
                           "1/1000001", "99999999999999999999/4"}) {
    EXPECT_TRUE(throws_error(ErrorKind::Usage, "--shard: invalid shard '" + std::string(text) + "'",
                             {"expected I/N"}, [&] { parse_shard(text, "--shard"); }));
  }
}

TEST(Shards, TogetherContainEachScenarioOnceAndAreBalanced) {
  const std::vector<Scenario> all = fields(10);
  for (const std::size_t count : {1U, 2U, 3U, 10U, 13U}) {
    std::vector<std::string> found;
    for (std::size_t i = 1; i <= count; ++i) {
      const std::vector<Scenario> part = scenarios_of_shard(all, {i, count});
      EXPECT_GE(part.size(), 10 / count);
      EXPECT_LE(part.size(), 10 / count + 1);
      EXPECT_EQ(part.size() * 6, (RunPlan{{}, 10, 6}.runs_of({i, count})));
      for (const std::string& hash : hashes(part)) found.push_back(hash);
    }
    std::vector<std::string> expected = hashes(all);
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(found, expected) << count << " shards";
  }
}

TEST(Shards, DoNotDependOnTheOrderOfTheListButKeepIt) {
  const std::vector<Scenario> all = fields(9);
  const std::vector<Scenario> reversed(all.rbegin(), all.rend());
  std::vector<std::string> part = hashes(scenarios_of_shard(all, {2, 4}));
  std::vector<std::string> other = hashes(scenarios_of_shard(reversed, {2, 4}));
  std::reverse(other.begin(), other.end());
  EXPECT_EQ(part, other);
  const std::vector<std::string> order = hashes(all);
  EXPECT_LT(std::find(order.begin(), order.end(), part[0]),
            std::find(order.begin(), order.end(), part[1]));
}

TEST(Shards, ThePlanIsReadFromTheManifest) {
  Manifest manifest = {{"campaign.ini", "[campaign]\nmethods = nd, gap\nrepetitions = 5\n"},
                       {"scenarios.count", "40"},
                       {"shard", "3/16"}};
  const RunPlan plan = plan_of(manifest, "a.results");
  EXPECT_EQ(to_string(plan.shard), "3/16");
  EXPECT_EQ(plan.runs(), 400U);
  EXPECT_EQ(plan.runs_of(plan.shard), 30U);  // ranks 2, 18, 34
  EXPECT_EQ(plan.runs_of({16, 16}), 20U);    // ranks 15, 31
  manifest.erase("shard");
  EXPECT_EQ(to_string(plan_of(manifest, "a.results").shard), "1/1");
  manifest["shard"] = "17/16";
  EXPECT_TRUE(throws_error(ErrorKind::File, "a.results: manifest", {"17/16"},
                           [&] { plan_of(manifest, "a.results"); }));
  manifest.erase("shard");
  manifest["until"] = "interval(success) < 0.1";
  EXPECT_TRUE(throws_error(ErrorKind::File, "a.results", {"stopping rule"},
                           [&] { plan_of(manifest, "a.results"); }));
}

TEST(Shards, NumbersArePrintedAsRanges) {
  EXPECT_EQ(number_ranges({}), "");
  EXPECT_EQ(number_ranges({3, 7, 12, 13, 14, 15}), "3,7,12-15");
  EXPECT_EQ(number_ranges({1, 2}), "1-2");
}

}  // namespace
}  // namespace slalom
