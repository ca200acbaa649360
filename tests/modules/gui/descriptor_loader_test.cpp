#include "io_sample.h"

#include <slalom/commands/describe_list.h>
#include <slalom/core/error.h>
#include <slalom/gui/descriptor_loader.h>

#include <gtest/gtest.h>

#include <map>
#include <thread>

namespace slalom {
namespace {

/// A list of two places, and what a loader brings of it.
class DescriptorLoaders : public testing::Test {
 protected:
  static Scenario place(double radius) {
    return Scenario::continuous("place", {0, 0, 10, 8}, {{{{5, 4}, radius}}, {}}, {1, 1, 0},
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
      list.add(place(1));
      list.add(place(2));
    });
    loader_.on_values = [this](const std::string& hash, const std::vector<DescribedValue>& values) {
      for (const DescribedValue& value : values) brought_[hash][value.info.id] = value.value;
    };
    loader_.on_computed = [this](const std::string& hash,
                                 const std::vector<GeneratedValue>& values) {
      ScenarioList list = ScenarioList::open(path_);
      for (const GeneratedValue& value : values) {
        list.keep(hash, value.id, value.version, value.parameters, value.value);
        computed_.push_back(value.id);
      }
    };
    loader_.on_failed = [this](const std::string& hash, const std::string& message) {
      failed_[hash] = message;
    };
    loader_.on_list_values = [this](std::shared_ptr<const ListValues> values) { list_ = values; };
    loader_.on_list_failed = [this](const std::string& message) { failed_["list"] = message; };
  }
  void wait() {
    while (!jobs_.idle()) {
      jobs_.poll();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  TemporaryFolder folder_;
  std::string path_;
  const std::string hash_ = place(1).hash();
  Jobs jobs_;
  DescriptorLoader loader_{jobs_, options()};
  std::map<std::string, std::map<std::string, Value>> brought_;
  std::map<std::string, std::string> failed_;
  std::vector<std::string> computed_;
  std::shared_ptr<const ListValues> list_;
};

TEST_F(DescriptorLoaders, ComputeWhatTheListDoesNotKeep) {
  loader_.show(path_, hash_);
  wait();
  ASSERT_EQ(brought_[hash_].size(), 3);
  EXPECT_EQ(computed_, options().ids);
  MemoryDescriptorStore store;
  for (const DescribedValue& value : describe_scenario(place(1), options(), store))
    EXPECT_EQ(brought_[hash_][value.info.id], value.value) << value.info.id;
}

TEST_F(DescriptorLoaders, LookUpWhatTheListKeeps) {
  const DescriptorKey key = descriptor_view({"clearness"}, options()).at("clearness").front();
  ScenarioList::open(path_).keep(hash_, key.id, key.version, key.parameters, Value::na("made up"));
  loader_.show(path_, hash_);
  wait();
  EXPECT_EQ(brought_[hash_]["clearness"], Value::na("made up"));
  EXPECT_EQ(computed_, (std::vector<std::string>{"density", "detour_ratio"}));
  computed_.clear();
  loader_.show(path_, hash_);
  wait();
  EXPECT_TRUE(computed_.empty());
}

TEST_F(DescriptorLoaders, BringNothingOfAScenarioThatIsNoLongerShown) {
  loader_.show(path_, hash_);
  loader_.show(path_, place(2).hash());
  wait();
  EXPECT_EQ(brought_.count(hash_), 0);
  EXPECT_EQ(brought_[place(2).hash()].size(), 3);
  loader_.show(path_, hash_);
  loader_.show("", "");
  wait();
  EXPECT_EQ(brought_.count(hash_), 0);
}

TEST_F(DescriptorLoaders, SayWhyNothingCanBeRead) {
  const std::string gone = folder_ / "gone.scenarios";
  loader_.show(gone, hash_);
  loader_.read_list(gone, {hash_}, {"density"});
  wait();
  EXPECT_NE(failed_[hash_].find("gone.scenarios"), std::string::npos) << failed_[hash_];
  EXPECT_NE(failed_["list"].find("gone.scenarios"), std::string::npos) << failed_["list"];
}

TEST_F(DescriptorLoaders, ReadWhatAListKeeps) {
  loader_.show(path_, hash_);
  wait();
  loader_.read_list(path_, {place(2).hash(), hash_}, {"density", "clearness"});
  wait();
  ASSERT_TRUE(list_);
  EXPECT_EQ(list_->size(), 2);
  EXPECT_EQ(list_->hash(1), hash_);
  EXPECT_EQ(list_->column("density")->not_computed_count(), 1);
  EXPECT_DOUBLE_EQ(*list_->number("density", hash_), brought_[hash_]["density"].number());
  EXPECT_FALSE(list_->number("density", place(2).hash()));
  EXPECT_EQ(list_->column("detour_ratio"), nullptr);
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
