// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/studio/descriptor_loader.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

using State = DescriptorModel::State;

KeyedValue value_of(const std::string& id, Value value) {
  return {{id, 1, "robot_radius=0.25"}, std::move(value)};
}

TEST(DescriptorModel, BeginsWithAllDescriptorsUnknown) {
  const DescriptorModel model;
  ASSERT_FALSE(model.rows().empty());
  EXPECT_EQ(model.rows()[0].info.id, "density");
  EXPECT_EQ(model.rows()[0].state, State::Unknown);
  EXPECT_EQ(DescriptorModel::value_text(model.rows()[0]), "-");
  EXPECT_EQ(model.status(), "");
}

TEST(DescriptorModel, ReportsProgress) {
  DescriptorModel model;
  model.show("a");
  model.set_computing(0, 0);
  EXPECT_EQ(model.status(), "computing...");
  model.set_values("a", {value_of("density", Value::of(0.25))});
  model.set_computing(3, 22);
  EXPECT_EQ(model.status(), "computing... 3 of 22");
  EXPECT_EQ(model.find("density")->state, State::Known);
  EXPECT_EQ(DescriptorModel::value_text(*model.find("density")), "0.2500");
  EXPECT_EQ(DescriptorModel::value_text(*model.find("clearness")), "...");
}

TEST(DescriptorModel, IgnoresValuesOfAnotherScenario) {
  DescriptorModel model;
  model.show("b");
  model.set_values("a", {value_of("density", Value::of(0.25))});
  model.fail("a", "no such file");
  EXPECT_EQ(model.find("density")->state, State::Unknown);
  EXPECT_FALSE(model.failed());
}

TEST(DescriptorModel, ClearsTheValuesOfThePreviousScenario) {
  DescriptorModel model;
  model.show("a");
  model.set_values("a", {value_of("density", Value::of(0.25))});
  ASSERT_TRUE(model.select_row(2));
  model.show("b");
  EXPECT_EQ(model.find("density")->state, State::Unknown);
  EXPECT_EQ(model.selected_row().info.id, "clearness");
}

TEST(DescriptorModel, KeepsTheValuesOfTheSameScenario) {
  DescriptorModel model;
  model.show("a");
  model.set_values("a", {value_of("density", Value::of(0.25))});
  model.show("a");
  EXPECT_EQ(model.find("density")->state, State::Known);
}

TEST(DescriptorModel, ReportsWhyThereIsNoNumber) {
  DescriptorModel model;
  model.show("a");
  model.set_computing(0, 22);
  model.set_values("a", {value_of("detour_ratio", Value::na("the goal cannot be reached"))});
  model.fail("a", "list.scenarios: no such file");
  const auto& na = *model.find("detour_ratio");
  EXPECT_EQ(DescriptorModel::value_text(na), "NA");
  EXPECT_EQ(model.reason(na), "the goal cannot be reached");
  const auto& failed = *model.find("density");
  EXPECT_EQ(failed.state, State::Failed);
  EXPECT_EQ(model.reason(failed), "list.scenarios: no such file");
  EXPECT_EQ(model.status(), "list.scenarios: no such file");
}

TEST(DescriptorModel, ShowsValuesWithUnitAndError) {
  DescriptorModel model;
  model.show("a");
  model.set_values("a", {value_of("bottleneck_width", Value::of(1.25)),
                         value_of("confinement", Value::of(0.5, 0.0125)),
                         value_of("obstacle_count", Value::of(12))});
  EXPECT_EQ(model.describe(*model.find("bottleneck_width")),
            "Bottleneck width [bottleneck_width]: 1.2500 m; robot_radius=0.25");
  EXPECT_EQ(DescriptorModel::value_text(*model.find("confinement")), "0.5000 ± 0.0125");
  EXPECT_EQ(DescriptorModel::value_text(*model.find("obstacle_count")), "12");
}

TEST(DescriptorModel, ShowsNumbersOfAnySize) {
  EXPECT_EQ(descriptor_number(0), "0");
  EXPECT_EQ(descriptor_number(-2.5), "-2.5000");
  EXPECT_EQ(descriptor_number(0.00002), "2e-05");
  EXPECT_EQ(descriptor_number(1e300), "1e+300");
}

TEST(DescriptorModel, SelectsOnlyItsRows) {
  DescriptorModel model;
  EXPECT_FALSE(model.select_row(0)) << "is selected initially";
  EXPECT_TRUE(model.select_row(2));
  EXPECT_EQ(model.selected(), 2);
  EXPECT_FALSE(model.select_row(model.rows().size()));
}

}  // namespace
}  // namespace slalom
