// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "list_sample.h"

#include <slalom/commands/describe_list.h>
#include <slalom/commands/list_command.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace slalom {
namespace {

/// Two lists that share a scenario, and a history.
class ListCommands : public testing::Test {
 protected:
  void SetUp() override {
    a_path_ = folder_ / "a.scenarios";
    b_path_ = folder_ / "b.scenarios";
    a_ = std::make_unique<ScenarioList>(sample_list(a_path_, 40, 1, rows_));
    std::vector<SampleRow> others;
    b_ = std::make_unique<ScenarioList>(sample_list(b_path_, 10, 2, others));
    b_->copy_from(*a_, a_->entries()[0]);
  }
  std::string dump() const { return dump_list(a_path_) + dump_list(b_path_); }

  ListSelection where(const std::string& text) const {
    ListSelection selection;
    selection.view = sample_view();
    selection.where =
        parse_selection(text, a_->vocabulary({"density", "clearness", "confinement"}));
    return selection;
  }

  /// A command of each kind, by number; it may be disabled because of previous commands.
  ListCommandPtr command(int kind, RandomEngine& engine) {
    const auto entries = a_->entries();
    const std::string hash = entries[static_cast<std::size_t>(uniform_int(
                                         engine, 0, static_cast<int>(entries.size()) - 1))]
                                 .hash;
    const std::string number = std::to_string(++commands_);
    const ListSelection few = where("id = " + hash.substr(0, 1));
    switch (kind) {
      case 0:
        return make_add_scenarios(*a_, {sample_scenario(commands_ + 7000), sample_scenario(7001)});
      case 1:
        return make_delete_scenarios(*a_, few);
      case 2:
        return make_copy_scenarios(*a_, few, *b_);
      case 3:
        return make_move_scenarios(*a_, few, *b_);
      case 4:
        return make_move_scenarios(*b_, few, *a_);
      case 5:
        return make_merge_lists({b_.get()}, *a_);
      case 6:
        return make_rename_scenario(*a_, hash, "name " + number);
      case 7:
        return make_edit_scenario(*a_, hash, sample_scenario(commands_ + 9000, "edited"));
      case 8:
        return make_tag_scenarios(*a_, few, {"t" + number}, {"hard"});
      case 9:
        return make_create_index(*a_,
                                 {"i" + number, "density", sample_view().at("density"), {0, 1}});
      case 10:
        return make_deduplicate(*a_, sample_view(), {{"density", 0.01}, {"clearness", 0.01}});
      case 11:
        return make_describe_list(*a_, describe_density(), *silent_);
      case 12: {
        const auto deletions = a_->deletions();
        return make_restore_scenarios(*a_, deletions.empty()
                                               ? std::vector<std::string>{}
                                               : std::vector<std::string>{deletions[0][0].hash});
      }
      default:
        return make_drop_index(*a_, a_->indexes().empty() ? "none" : a_->indexes()[0].name);
    }
  }

  static DescribeOptions describe_density() {
    DescribeOptions options;
    options.ids = {"density"};
    options.resolution = 0.5;
    return options;
  }

  TemporaryFolder folder_;
  std::string a_path_, b_path_;
  std::vector<SampleRow> rows_;
  std::unique_ptr<ScenarioList> a_, b_;
  std::unique_ptr<Progress> silent_ = make_silent_progress();
  CommandHistory history_;
  std::uint64_t commands_ = 0;
};

TEST_F(ListCommands, AnySequenceIsUndoneAndRedone) {
  RandomEngine engine(3);
  std::vector<std::string> dumps = {dump()}, titles;
  for (int step = 0; step < 42; ++step) {
    ListCommandPtr next = command(step % 14, engine);
    if (!next->disabled_reason().empty()) continue;
    titles.push_back(next->title());
    history_.execute(std::move(next));
    dumps.push_back(dump());
  }
  ASSERT_GT(titles.size(), 30U) << "too many were disabled";
  for (std::size_t i = titles.size(); i-- > 0;) {
    EXPECT_EQ(history_.undo_title(), titles[i]);
    history_.undo();
    ASSERT_EQ(dump(), dumps[i]) << titles[i];
  }
  EXPECT_FALSE(history_.can_undo());
  EXPECT_EQ(history_.undo_title(), "");
  for (std::size_t i = 0; i < titles.size(); ++i) {
    EXPECT_EQ(history_.redo_title(), titles[i]);
    history_.redo();
    ASSERT_EQ(dump(), dumps[i + 1]) << titles[i];
  }
  EXPECT_FALSE(history_.can_redo());
}

TEST_F(ListCommands, TheHistoryDropsTheOldestAndTheUndoneCommands) {
  CommandHistory history(2);
  for (const char* name : {"x", "y", "z"})
    history.execute(make_rename_scenario(*a_, rows_[0].hash, name));
  history.undo();
  history.undo();
  EXPECT_FALSE(history.can_undo()) << "the history is limited to two commands";
  EXPECT_EQ(a_->entries()[0].name, "x");
  history.execute(make_rename_scenario(*a_, rows_[0].hash, "w"));
  EXPECT_FALSE(history.can_redo());
  EXPECT_THROW(history.redo(), std::logic_error);
}

TEST_F(ListCommands, FailedCommandsAreNotInTheHistory) {
  const std::string before = dump();
  EXPECT_THROW(history_.execute(make_rename_scenario(*a_, "no such hash", "x")), Error);
  EXPECT_FALSE(history_.can_undo());
  EXPECT_EQ(dump(), before);
}

TEST_F(ListCommands, HaveATitleAndAReasonWhenDisabled) {
  EXPECT_EQ(make_delete_scenarios(*a_, {})->title(), "Delete 40 scenarios");
  EXPECT_EQ(make_delete_scenarios(*a_, {})->disabled_reason(), "");
  EXPECT_EQ(make_delete_scenarios(*a_, where("density > 5"))->disabled_reason(),
            "no scenarios selected");
  EXPECT_EQ(make_copy_scenarios(*a_, where("name = room_3"), *b_)->title(),
            "Copy 1 scenario to b.scenarios");
  EXPECT_EQ(make_rename_scenario(*a_, rows_[0].hash, "")->disabled_reason(), "the name is empty");
  EXPECT_EQ(make_rename_scenario(*a_, "ab", "x")->disabled_reason(),
            "the scenario is not in the list");
  EXPECT_EQ(make_edit_scenario(*a_, rows_[0].hash, a_->read(rows_[1].hash))->disabled_reason(),
            "the list already contains this scenario");
  EXPECT_EQ(make_edit_scenario(*a_, rows_[0].hash, a_->read(rows_[0].hash))->disabled_reason(), "");
  EXPECT_EQ(make_tag_scenarios(*a_, {}, {}, {})->disabled_reason(),
            "no scenarios or no tags selected");
  EXPECT_EQ(make_drop_index(*a_, "x")->disabled_reason(), "no index of this name exists");
  EXPECT_EQ(make_add_scenarios(*a_, {})->disabled_reason(), "no scenarios to add");
  EXPECT_EQ(make_select_into(*a_, {}, b_path_)->disabled_reason(),
            "a file of this name already exists");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, a_path_, {"the same list"},
                           [&] { make_copy_scenarios(*a_, {}, *a_); }));
}

TEST_F(ListCommands, AddSkipsScenariosThatTheListContains) {
  const auto add = make_add_scenarios(*a_, {a_->read(rows_[5].hash), sample_scenario(777)},
                                      {{"maze", 1, {}}, {"forest", 2, {"new"}}});
  EXPECT_EQ(add->title(), "Add 2 scenarios");
  add->execute();
  EXPECT_EQ(a_->size(), 41U);
  EXPECT_EQ(a_->entries().back().generator, "forest");
  EXPECT_EQ(a_->entries().back().tags, std::vector<std::string>{"new"});
  add->undo();
  EXPECT_EQ(a_->size(), 40U) << "the previously contained scenario remains";
}

TEST_F(ListCommands, SelectIntoANewListCopiesIndexes) {
  a_->create_index({"x", "density", sample_view().at("density"), {0, 1}});
  const std::string path = folder_ / "c.scenarios";
  const auto select = make_select_into(*a_, where("density < 0.5"), path);
  select->execute();
  const auto chosen = a_->select(where("density < 0.5"));
  const auto copied = ScenarioList::open(path).entries();
  ASSERT_EQ(copied.size(), chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) EXPECT_EQ(copied[i].hash, chosen[i].hash);
  EXPECT_EQ(ScenarioList::open(path).indexes().size(), 1U);
  select->undo();
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(ListCommands, MergedListsContainNoDuplicates) {
  make_merge_lists({b_.get()}, *a_)->execute();
  EXPECT_EQ(a_->size(), 50U) << "40 and 11, one of them in both";
  EXPECT_EQ(a_->entries().back().hash, b_->entries()[9].hash);
}

TEST_F(ListCommands, DeduplicationKeepsTheFirstOfNearDuplicates) {
  const std::vector<std::pair<std::string, double>> differences = {{"density", 0.17},
                                                                   {"clearness", 0.3}};
  make_deduplicate(*a_, sample_view(), differences)->execute();
  // Brute force: compare every scenario with all that were kept before.
  std::vector<SampleRow> kept;
  for (const SampleRow& row : rows_) {
    const bool duplicate = std::any_of(kept.begin(), kept.end(), [&](const SampleRow& other) {
      return std::all_of(differences.begin(), differences.end(), [&](const auto& pair) {
        const auto &x = row.values.at(pair.first), &y = other.values.at(pair.first);
        if (!x || !y) return x.has_value() == y.has_value();
        return std::abs(*x / pair.second - *y / pair.second) < 1;
      });
    });
    if (!duplicate) kept.push_back(row);
  }
  const auto entries = a_->entries();
  ASSERT_EQ(entries.size(), kept.size());
  EXPECT_LT(kept.size(), 30U);
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(entries[i].hash, kept[i].hash);
  EXPECT_TRUE(
      throws_error(ErrorKind::Usage, "minimum difference of density: ", {"expected > 0"}, [&] {
        make_deduplicate(*a_, sample_view(), {{"density", 0}});
      }));
}

TEST_F(ListCommands, TheSplitDependsOnContentAndSeedOnly) {
  ScenarioList development = ScenarioList::create(folder_ / "d"),
               held = ScenarioList::create(folder_ / "h");
  make_split(*a_, {0.3, 5}, development, held)->execute();
  EXPECT_EQ(development.size() + held.size(), 40U);
  for (const auto& entry : development.entries()) EXPECT_FALSE(is_held_out(entry.hash, {0.3, 5}));
  for (const auto& entry : held.entries()) EXPECT_TRUE(is_held_out(entry.hash, {0.3, 5}));
  // The fraction holds on average: 3 sigma of 4000 draws at 0.3 are 0.022.
  int out = 0, differ = 0;
  for (int i = 0; i < 4000; ++i) {
    const bool first = is_held_out(std::to_string(i), {0.3, 5});
    out += first ? 1 : 0;
    differ += first != is_held_out(std::to_string(i), {0.3, 6}) ? 1 : 0;
  }
  EXPECT_NEAR(out / 4000.0, 0.3, 0.022);
  EXPECT_NEAR(differ / 4000.0, 2 * 0.3 * 0.7, 0.024) << "another seed, another split";
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(is_held_out(std::to_string(i), {0, 5}));
    EXPECT_TRUE(is_held_out(std::to_string(i), {1, 5}));
    EXPECT_TRUE(!is_held_out(std::to_string(i), {0.3, 5}) ||
                is_held_out(std::to_string(i), {0.6, 5}))
        << "a larger fraction holds out a superset";
  }
}

TEST(DescribeList, FindsStoredValuesOfEveryKindOfScenario) {
  const TemporaryFolder folder;
  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  const Scenario room = sample_scenario(1, "room");
  for (const Representation kind :
       {Representation::Continuous, Representation::Grid, Representation::Points})
    list.add(convert(room, kind, 0.25));
  const auto path = std::make_shared<const PublishedPath>(
      PublishedPath{{{1, 1}, {5, 5}, {9, 9}}, room.bounds(), 0.5});
  list.add(sample_scenario(2).with_published_path(path));
  DescribeOptions options;
  options.resolution = 0.25;
  options.ids = descriptor_ids();
  const auto silent = make_silent_progress();
  const auto describe = make_describe_list(list, options, *silent);
  EXPECT_EQ(describe->disabled_reason(), "");
  describe->execute();
  EXPECT_EQ(describe->disabled_reason(), "all values are already computed");
  for (const auto& [id, keys] : descriptor_view(options.ids, options)) {
    EXPECT_TRUE(list.missing_values(keys).empty()) << id;
    list.create_index({"by_" + id, id, keys, {0, 1}});
    EXPECT_EQ(list.index_counts("by_" + id).unknown, 0U) << id;
  }
  // Values for another robot have other keys.
  options.robot = Footprint::disc(0.4);
  EXPECT_EQ(
      list.missing_values(descriptor_view({"detour_ratio"}, options).at("detour_ratio")).size(),
      4U);
  EXPECT_EQ(list.missing_values(descriptor_view({"clearness"}, options).at("clearness")).size(),
            0U);
}

}  // namespace
}  // namespace slalom
