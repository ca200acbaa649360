// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/io/reference_text.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace slalom {
namespace {

/// A shortest path of 5 m, no safest one.
References shortest_only() {
  References references;
  references.shortest = {{{0, 0}, {3, 4}}, 5, {4.9, 5}, "exact", "", 5, std::nullopt};
  references.safest_reason = "no collision-free configuration";
  references.timing = {0.5, 0.25, 0};
  return references;
}

TEST(ReferenceText, JsonHasPathsAndReasons) {
  const auto json = nlohmann::json::parse(render_json(shortest_only(), "a1", "room"));
  EXPECT_EQ(json["id"], "a1");
  EXPECT_EQ(json["shortest_length"], 5);
  EXPECT_EQ(json["lower_bound"], 4.9);
  EXPECT_EQ(json["shortest_path"], (nlohmann::json{{0, 0}, {3, 4}}));
  EXPECT_FALSE(json.contains("planner_length"));
  EXPECT_TRUE(json["safest_length"].is_null());
  EXPECT_EQ(json["safest_reason"], "no collision-free configuration");
  EXPECT_EQ(json["time_seconds"], 0.75);
}

TEST(ReferenceText, HasTheEarliestArrivalOfScenariosWithMovers) {
  References references = shortest_only();
  EXPECT_EQ(render_json(references, "a1", "room").find("arrival"), std::string::npos);
  references.arrival = EarliestArrival{{8, 10}, {{0, {0, 0}}, {10, {3, 4}}}};
  references.timing.arrival = 0.5;
  auto json = nlohmann::json::parse(render_json(references, "a1", "room"));
  EXPECT_EQ(json["earliest_arrival_lower_bound"], 8);
  EXPECT_EQ(json["earliest_arrival_upper_bound"], 10);
  EXPECT_EQ(json["earliest_arrival_gap"], 0.25);
  EXPECT_EQ(json["earliest_arrival_plan"], (nlohmann::json{{0, 0, 0}, {10, 3, 4}}));
  EXPECT_EQ(json["time_seconds"], 1.25);
  references.arrival.reset();
  references.arrival_reason = "there is none";
  json = nlohmann::json::parse(render_json(references, "a1", "room"));
  EXPECT_TRUE(json["earliest_arrival_lower_bound"].is_null());
  EXPECT_EQ(json["earliest_arrival_reason"], "there is none");
}

TEST(ReferenceText, TextHasTheSameKeysWithoutPoints) {
  const std::string text = render_text(shortest_only(), "a1", "room");
  EXPECT_EQ(text.find("  id = a1\n  name = room\n  shortest_length = 5.0\n"), 0U) << text;
  EXPECT_NE(text.find("  safest_length = null\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("shortest_path"), std::string::npos) << text;
}

}  // namespace
}  // namespace slalom
