// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "list_sample.h"

#include <slalom/commands/select_list.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

class SelectList : public testing::Test {
 protected:
  SelectList() : list_(ScenarioList::create(folder_ / "a.scenarios")) {
    for (int i = 0; i < 4; ++i) list_.add(sample_scenario(i, "room" + std::to_string(i)));
    options_.resolution = 0.5;
  }
  std::vector<std::string> names(const SelectionRequest& request) {
    const ListSelection selection = select_scenarios(list_, request, options_, *silent_);
    std::vector<std::string> names;
    for (const auto& entry : list_.select(selection)) names.push_back(entry.name);
    return names;
  }
  static SelectionRequest where(const std::string& text) {
    SelectionRequest request;
    request.where = text;
    return request;
  }
  const TemporaryFolder folder_;
  ScenarioList list_;
  DescribeOptions options_;
  const std::unique_ptr<Progress> silent_ = make_silent_progress();
};

TEST_F(SelectList, ComputesTheDescriptorsThatItNeeds) {
  SelectionRequest request = where("density >= 0");
  request.order_by = "clearness desc";
  EXPECT_EQ(names(request).size(), 4U);
  for (const auto& [id, keys] : descriptor_view({"density", "clearness"}, options_))
    EXPECT_TRUE(list_.missing_values(keys).empty()) << id;
  for (const auto& [id, keys] : descriptor_view({"confinement"}, options_))
    EXPECT_EQ(list_.missing_values(keys).size(), 4U) << id;
}

TEST_F(SelectList, CombinesConditionIdsOrderAndLimit) {
  SelectionRequest request = where("name like 'room%'");
  request.ids = "room3, room1,room0";
  request.order_by = "name desc";
  request.limit = 2;
  EXPECT_EQ(names(request), (std::vector<std::string>{"room3", "room1"}));
  EXPECT_EQ(condition_text(request), "name like 'room%', ids room3, room1,room0");
  EXPECT_EQ(origin_text(request),
            " where name like 'room%' ids room3, room1,room0 order by name desc limit 2");
  EXPECT_EQ(names({}).size(), 4U);
  EXPECT_EQ(origin_text({}), "");
}

TEST_F(SelectList, CompletesIndexesOnlyWithTheirOwnParameters) {
  const DescriptorView view = descriptor_view({"density"}, options_);
  list_.create_index({"by_density", "density", view.at("density"), {0, 1}});
  EXPECT_EQ(names(where("by_density[0]")).size(), 4U);
  list_.add(sample_scenario(9));
  options_.resolution = 0.25;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, list_.path(), {"1 scenario without", "'by_density'"},
                           [&] { names(where("by_density[0]")); }));
}

TEST_F(SelectList, MinimumDifferencesAreDescriptorsAndNumbers) {
  const auto differences = parse_min_differences("density:0.01, confinement:0.02", "--by");
  ASSERT_EQ(differences.size(), 2U);
  EXPECT_EQ(differences[1].first, "confinement");
  EXPECT_EQ(differences[1].second, 0.02);
  for (const char* text : {"density", "density:0", "density:x", "density:1:2"})
    EXPECT_TRUE(throws_error(ErrorKind::Usage, std::string("--by ") + text, {"DESCRIPTOR:NUMBER"},
                             [&] { parse_min_differences(text, "--by"); }));
}

}  // namespace
}  // namespace slalom
