// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "io_sample.h"

#include <slalom/commands/convert_list.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

class ConvertList : public testing::Test {
 protected:
  /// A free room with a tag, and one in which a point is 0.1 m from the goal.
  ConvertList() : list_(ScenarioList::create(folder_ / "a.scenarios")) {
    const Bounds bounds{0, 0, 4, 3};
    mrpt::maps::CSimplePointsMap none, near;
    near.insertPoint(3.1F, 2.0F);
    list_.add(Scenario::points("free", bounds, none, {1, 1, 0}, {3, 2}), {"", std::nullopt, {"x"}});
    list_.add(Scenario::points("near", bounds, near, {1, 1, 0}, {3, 2}));
    conversion_.options.point_radius = 0.2;
  }
  const TemporaryFolder folder_;
  ScenarioList list_;
  ListConversion conversion_;
};

TEST_F(ConvertList, KeepsNamesTagsAndTheOrigin) {
  conversion_.to = Representation::Grid;
  list_.set_note("origin", "by hand");
  ScenarioList output = ScenarioList::create(folder_ / "b.scenarios");
  EXPECT_TRUE(convert_list(list_, conversion_, output).empty());
  const auto entries = output.entries();
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].name, "free");
  EXPECT_EQ(entries[0].tags, (std::vector<std::string>{"x"}));
  EXPECT_EQ(entries[1].representation, Representation::Grid);
  EXPECT_EQ(output.note("origin"), "converted to grid from " + list_.path() +
                                       ": resolution 0.05 m, tolerance 0 m\nby hand");
}

TEST_F(ConvertList, LeavesOutScenariosWhoseGoalBecomesOccupiedIfAllowed) {
  ScenarioList output = ScenarioList::create(folder_ / "b.scenarios");
  EXPECT_TRUE(throws_error(ErrorKind::Job, "near", {"occupied goal", "continuous"},
                           [&] { convert_list(list_, conversion_, output); }));
  conversion_.skip_blocked = true;
  const auto messages = convert_list(list_, conversion_, output);
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_TRUE(mentions(messages[0], {"near", "left out"}));
  EXPECT_EQ(output.size(), 1U);
}

}  // namespace
}  // namespace slalom
