// SPDX-License-Identifier: BSD-3-Clause
#include "finish_jobs.h"
#include "io_sample.h"

#include <slalom/commands/describe_list.h>
#include <slalom/core/error.h>
#include <slalom/studio/descriptor_loader.h>

#include <gtest/gtest.h>

#include <map>

namespace slalom {
namespace {

/// A list of two scenarios, and what a loader returns of it.
class DescriptorLoaders : public testing::Test {
 protected:
  static Scenario scenario(double radius) {
    return Scenario::continuous("scenario", {0, 0, 10, 8}, {{{{5, 4}, radius}}, {}}, {1, 1, 0},
                                {9, 1});
  }
  static DescribeOptions options() {
    DescribeOptions options;
    options.ids = {"density", "clearness", "detour_ratio"};
    options.resolution = 0.1;
    return options;
  }

  void SetUp() override {
    path_ = folder_ / "a.scenarios";
    ScenarioList::write(path_, [](ScenarioList& list) {
      list.add(scenario(1));
      list.add(scenario(2));
    });
    events_.observe({Change::Descriptors}, [this] {
      const DescriptorModel& model = loader_.model();
      for (const DescriptorModel::Row& row : model.rows())
        if (row.state == DescriptorModel::State::Known)
          loaded_[model.hash()][row.info.id] = row.described.value;
      if (model.failed()) failed_[model.hash()] = model.status();
    });
    events_.observe({Change::ListValues}, [this] { failed_["list"] = loader_.list_message(); });
  }
  void wait() { finish_jobs(jobs_); }

  TemporaryFolder folder_;
  std::string path_;
  const std::string hash_ = scenario(1).hash();
  Jobs jobs_;
  StudioEvents events_;
  DescriptorLoader loader_{jobs_, events_, options(),
                           [this](const std::string& hash, const std::vector<KeyedValue>& values) {
                             ScenarioList list = ScenarioList::open(path_);
                             for (const KeyedValue& value : values) {
                               list.store_value(hash, value);
                               computed_.push_back(value.key.id);
                             }
                           }};
  std::map<std::string, std::map<std::string, Value>> loaded_;
  std::map<std::string, std::string> failed_;
  std::vector<std::string> computed_;
};

TEST_F(DescriptorLoaders, ComputeWhatTheListDoesNotContain) {
  loader_.show(path_, hash_);
  wait();
  ASSERT_EQ(loaded_[hash_].size(), 3);
  EXPECT_EQ(computed_, options().ids);
  MemoryDescriptorStore store;
  for (const KeyedValue& value : describe_scenario(scenario(1), options(), store))
    EXPECT_EQ(loaded_[hash_][value.key.id], value.value) << value.key.id;
}

TEST_F(DescriptorLoaders, ReadCachedValues) {
  const ValueKey key = descriptor_view({"clearness"}, options()).at("clearness").front();
  ScenarioList::open(path_).store_value(hash_, {key, Value::na("test")});
  loader_.show(path_, hash_);
  wait();
  EXPECT_EQ(loaded_[hash_]["clearness"], Value::na("test"));
  EXPECT_EQ(computed_, (std::vector<std::string>{"density", "detour_ratio"}));
  computed_.clear();
  loader_.show(path_, hash_);
  wait();
  EXPECT_TRUE(computed_.empty());
}

TEST_F(DescriptorLoaders, ReturnNothingOfAPreviousScenario) {
  loader_.show(path_, hash_);
  loader_.show(path_, scenario(2).hash());
  wait();
  EXPECT_EQ(loaded_.count(hash_), 0);
  EXPECT_EQ(loaded_[scenario(2).hash()].size(), 3);
  loader_.show(path_, hash_);
  loader_.show("", "");
  wait();
  EXPECT_EQ(loaded_.count(hash_), 0);
}

TEST_F(DescriptorLoaders, ReportReadErrors) {
  const std::string deleted = folder_ / "gone.scenarios";
  loader_.show(deleted, hash_);
  loader_.read_list(deleted, {hash_}, {"density"});
  wait();
  EXPECT_NE(failed_[hash_].find("gone.scenarios"), std::string::npos) << failed_[hash_];
  EXPECT_NE(failed_["list"].find("gone.scenarios"), std::string::npos) << failed_["list"];
}

TEST_F(DescriptorLoaders, ReadTheCachedValuesOfAList) {
  loader_.show(path_, hash_);
  wait();
  loader_.read_list(path_, {scenario(2).hash(), hash_}, {"density", "clearness"});
  wait();
  const auto& list = loader_.list_values();
  ASSERT_TRUE(list);
  EXPECT_EQ(list->size(), 2);
  EXPECT_EQ(list->hash(1), hash_);
  EXPECT_EQ(list->column("density")->not_computed_count(), 1);
  EXPECT_DOUBLE_EQ(*list->number("density", hash_), loaded_[hash_]["density"].number());
  EXPECT_FALSE(list->number("density", scenario(2).hash()));
  EXPECT_EQ(list->column("detour_ratio"), nullptr);
}

TEST(ListValues, NeedAValueOfEachScenario) {
  ListValues values({"a", "b"});
  ListColumn column({"density", 1, "Density", "-", Direction::None});
  column.add(Value::of(1));
  EXPECT_THROW(values.set(column), std::logic_error);
  column.add(std::nullopt);
  values.set(column);
  EXPECT_EQ(values.number("density", "a"), 1);
  EXPECT_FALSE(values.number("density", "b"));
  EXPECT_FALSE(values.number("density", "c"));
}

}  // namespace
}  // namespace slalom
