// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/io/index_text.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace slalom {
namespace {

const ListIndex kIndex = {"by_density", "density", {{"density", 1, "a=1"}}, {0, 0.25, 1}};
const ListIndexCounts kCounts = {{3, 4}, 0, 1, 2, 0};

TEST(IndexText, HasTheRangesAndWhatIsInNone) {
  EXPECT_EQ(render_text(kIndex, kCounts),
            "by_density: density\n"
            "  by_density[0]  [0, 0.25)  3\n"
            "  by_density[1]  [0.25, 1]  4\n"
            "  above  1\n"
            "  NA  2\n");
}

TEST(IndexText, JsonHasCountsIfTheyAreGiven) {
  const auto json = nlohmann::json::parse(render_json(kIndex, kCounts));
  EXPECT_EQ(json["edges"], (nlohmann::json{0.0, 0.25, 1.0}));
  EXPECT_EQ(json["parameters"], (nlohmann::json{"a=1"}));
  EXPECT_EQ(json["counts"], (nlohmann::json{3, 4}));
  EXPECT_EQ(json["na"], 2);
  EXPECT_FALSE(nlohmann::json::parse(render_json(kIndex)).contains("counts"));
}

}  // namespace
}  // namespace slalom
