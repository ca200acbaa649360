// SPDX-License-Identifier: BSD-3-Clause
#include "finish_jobs.h"
#include "list_files.h"

#include <slalom/studio/jobs.h>
#include <slalom/studio/list_document.h>

#include <algorithm>

namespace slalom {
namespace {

using FileState = ListDocument::FileState;

class ListDocuments : public OpenList {};

TEST_F(ListDocuments, StartAtTheFirstScenario) {
  EXPECT_EQ(document_.title(), "a.scenarios");
  EXPECT_EQ(shown(), (Numbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(document_.current(), hash_of(0));
  EXPECT_EQ(document_.selected_count(), 0U);
}

TEST_F(ListDocuments, SelectByClicksAndModifiers) {
  document_.select_only(4);
  EXPECT_EQ(selected(), Numbers{4});
  EXPECT_EQ(document_.current(), hash_of(4));
  document_.select_to(6);
  EXPECT_EQ(selected(), (Numbers{4, 5, 6}));
  document_.select_to(3);  // still from the last click
  EXPECT_EQ(selected(), (Numbers{3, 4}));
  document_.toggle(8);
  EXPECT_EQ(selected(), (Numbers{3, 4, 8}));
  document_.toggle(4);
  EXPECT_EQ(selected(), (Numbers{3, 8}));
  EXPECT_EQ(document_.current(), hash_of(4));
  document_.select_all();
  EXPECT_EQ(document_.selected_count(), 10U);
  document_.select_none();
  EXPECT_EQ(selected(), Numbers{});
  document_.select({hash_of(7), "no hash", hash_of(1)});
  EXPECT_EQ(selected(), (Numbers{1, 7}));
  document_.select_only(10);
  document_.toggle(10);
  document_.select_to(10);
  EXPECT_EQ(selected(), (Numbers{1, 7}));
}

TEST_F(ListDocuments, NotifyOfTheCurrentScenario) {
  std::vector<std::string> notified;
  document_.observe([&](Change change) {
    if (change == Change::Current) notified.push_back(document_.current());
  });
  document_.set_current(hash_of(3));
  document_.set_current(hash_of(3));
  document_.set_current("nobody");
  EXPECT_EQ(notified, std::vector<std::string>{hash_of(3)});
  document_.set_filter("density < 0.2");  // 0 and 1: the last of them is next to what was current
  EXPECT_EQ(document_.current(), hash_of(1));
  document_.set_filter("name = nobody");
  EXPECT_EQ(document_.current(), "");
  EXPECT_EQ(notified, (std::vector<std::string>{hash_of(3), hash_of(1), ""}));
}

TEST_F(ListDocuments, KeepSelectionAndCurrentByContentWhenTheOrderChanges) {
  select({2, 8});
  document_.set_current(hash_of(8));
  document_.set_sort("density", true);
  EXPECT_EQ(shown(), (Numbers{7, 6, 5, 4, 3, 2, 1, 0, 8, 9}));
  EXPECT_EQ(selected(), (Numbers{2, 8}));
  EXPECT_EQ(document_.current(), hash_of(8));
  document_.set_filter("density >= 0");
  EXPECT_EQ(selected(), Numbers{2});  // hidden scenarios are not selected
}

TEST_F(ListDocuments, LeaveTheViewUnchangedOnAnInvalidFilter) {
  document_.set_filter("density > 0.5");
  EXPECT_EQ(shown(), (Numbers{6, 7}));
  document_.set_filter("densitty > 0.6");
  EXPECT_NE(document_.filter_error().find("'density'"), std::string::npos)
      << document_.filter_error();
  EXPECT_EQ(document_.filter_text(), "densitty > 0.6");
  EXPECT_EQ(shown(), (Numbers{6, 7}));
  document_.restore_filter();
  EXPECT_EQ(document_.filter_text(), "density > 0.5");
  EXPECT_EQ(document_.filter_error(), "");
  EXPECT_EQ(shown(), (Numbers{6, 7}));
  document_.set_filter("");
  EXPECT_EQ(shown().size(), 10U);
}

TEST_F(ListDocuments, KeepAnEditedScenarioUnderAFilterUntilItsValuesAreComputed) {
  std::vector<Change> changes;
  document_.set_filter("density > 0.2");
  EXPECT_EQ(shown(), (Numbers{3, 4, 5, 6, 7}));
  document_.set_current(hash_of(4));
  document_.observe([&](Change change) { changes.push_back(change); });
  const auto lost = [&] { return std::count(changes.begin(), changes.end(), Change::CurrentLost); };
  const Scenario edited = make_scenario(104).renamed("world_4");
  document_.edit_current(edited);
  EXPECT_EQ(shown(), (Numbers{3, 4, 5, 6, 7})) << "its density is not known";
  EXPECT_EQ(document_.current(), edited.hash());
  const Scenario again = make_scenario(204).renamed("world_4");
  document_.edit_current(again);
  EXPECT_EQ(shown(), (Numbers{3, 4, 5, 6, 7}));
  EXPECT_EQ(document_.current(), again.hash());
  EXPECT_EQ(lost(), 0);

  const ValueKey key = descriptor_view({"density"}, {}).at("density").front();
  document_.store_values(again.hash(), {{key, Value::of(0.9)}});
  EXPECT_EQ(shown(), (Numbers{3, 4, 5, 6, 7})) << "the filter still holds";
  EXPECT_EQ(document_.current(), again.hash());
  EXPECT_EQ(lost(), 0);

  document_.edit_current(edited);
  document_.store_values(edited.hash(), {{key, Value::of(0.1)}});
  EXPECT_EQ(shown(), (Numbers{3, 5, 6, 7})) << "it does no longer";
  EXPECT_EQ(document_.current(), hash_of(5));
  EXPECT_EQ(lost(), 1) << "whoever acts on the current scenario is told";
}

TEST_F(ListDocuments, ReadRowsWithTheValueTheyAreSortedBy) {
  const ListRow* row = document_.row(hash_of(3));
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->entry.name, "world_3");
  EXPECT_EQ(row->entry.tags, std::vector<std::string>{"hard"});
  EXPECT_FALSE(row->value);
  document_.set_sort("density", false);
  EXPECT_EQ(document_.row(hash_of(3))->value, Value::of(0.3));
  EXPECT_EQ(document_.row(hash_of(8))->value, Value::na("no reason"));
  EXPECT_FALSE(document_.row(hash_of(9))->value);
  EXPECT_EQ(document_.row(hash_of(99)), nullptr);
  EXPECT_EQ(document_.sort_unit(), "-");
  document_.set_sort("bottleneck_width", false);
  EXPECT_EQ(document_.sort_unit(), "m");
}

TEST_F(ListDocuments, RemoveAndRestore) {
  select({4, 5});
  document_.set_current(hash_of(5));
  document_.remove_selected();
  EXPECT_EQ(shown(), (Numbers{0, 1, 2, 3, 6, 7, 8, 9}));
  EXPECT_EQ(document_.current(), hash_of(7)) << "the next one";
  EXPECT_EQ(document_.selected_count(), 0U);
  EXPECT_EQ(document_.history().undo_title(), "Delete 2 scenarios");
  document_.undo();
  EXPECT_EQ(shown(), (Numbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  document_.redo();
  EXPECT_EQ(shown().size(), 8U);
}

TEST_F(ListDocuments, KeepTheEditedScenarioCurrentWhereverItsRowGoes) {
  std::vector<std::string> notified;
  document_.set_sort("density", false);
  document_.set_current(hash_of(3));
  document_.edit_current(make_scenario(103).renamed("world_3"));  // its density was never computed
  EXPECT_EQ(shown(), (Numbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(document_.current(), hash_of(103));
  document_.edit_current(make_scenario(104).renamed("world_3"));
  document_.observe([&](Change change) {
    if (change == Change::Current) notified.push_back(document_.current());
  });
  document_.undo();
  EXPECT_EQ(document_.current(), hash_of(103));
  document_.undo();
  EXPECT_EQ(shown(), (Numbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(document_.current(), hash_of(3));
  document_.redo();
  EXPECT_EQ(document_.current(), hash_of(103));
  document_.redo();
  EXPECT_EQ(notified,
            (std::vector<std::string>{hash_of(103), hash_of(3), hash_of(103), hash_of(104)}))
      << "no other scenario is shown in between";
  document_.set_current(hash_of(5));
  document_.undo();
  EXPECT_EQ(document_.current(), hash_of(5)) << "the user has gone on to another";
}

TEST_F(ListDocuments, PutAnEditedScenarioWhereItBelongsWhenItsValueIsStored) {
  std::size_t moved = 0;
  document_.observe([&](Change change) { moved += change == Change::CurrentRow ? 1 : 0; });
  document_.set_sort("density", false);
  document_.select_only(3);
  document_.edit_current(make_scenario(103).renamed("world_3"));
  EXPECT_EQ(shown(), (Numbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9})) << "its density is not yet computed";
  EXPECT_EQ(moved, 1U);
  const ValueKey key = descriptor_view({"density"}, {}).at("density").front();
  document_.store_values(hash_of(5), {{key, Value::of(0)}});
  EXPECT_EQ(shown(), (Numbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9})) << "one that is only looked at stays";
  document_.store_values(hash_of(103), {{key, Value::of(0.65)}});
  EXPECT_EQ(shown(), (Numbers{0, 5, 1, 2, 4, 6, 3, 7, 8, 9}));
  EXPECT_EQ(document_.current(), hash_of(103));
  EXPECT_EQ(selected(), Numbers{3});
  EXPECT_EQ(moved, 2U);
  document_.undo();
  EXPECT_EQ(document_.current(), hash_of(3));
  EXPECT_EQ(selected(), Numbers{3});
}

TEST_F(ListDocuments, DeselectTheScenariosOfAClosedGroup) {
  const auto keys = descriptor_view({"density"}, {}).at("density");
  document_.run(make_create_index(document_.list(), {"by_density", "density", keys, {0, 0.5, 1}}));
  document_.set_group_by("by_density");
  document_.select_all();
  document_.toggle_group(0);
  EXPECT_EQ(selected(), (Numbers{5, 6, 7, 8, 9}));
  document_.select_all();
  EXPECT_EQ(selected(), (Numbers{5, 6, 7, 8, 9}));
  document_.select({hash_of(1), hash_of(6)});
  EXPECT_EQ(selected(), Numbers{6});
}

TEST_F(ListDocuments, KeepTheCurrentScenarioWhenAnotherActionIsUndoneAfterAnEdit) {
  document_.set_current(hash_of(3));
  document_.edit_current(make_scenario(103).renamed("world_3"));
  select({1});
  document_.tag({"easy"}, {});
  document_.undo();
  EXPECT_EQ(document_.current(), hash_of(103));
}

TEST_F(ListDocuments, RenameAndTag) {
  document_.rename(hash_of(2), "corridor");
  EXPECT_EQ(document_.row(hash_of(2))->entry.name, "corridor");
  select({1, 2});
  document_.tag({"easy"}, {});
  EXPECT_EQ(document_.row(hash_of(1))->entry.tags, std::vector<std::string>{"easy"});
  document_.undo();
  document_.undo();
  EXPECT_EQ(document_.row(hash_of(2))->entry.name, "world_2");
  EXPECT_TRUE(document_.row(hash_of(2))->entry.tags.empty());
  EXPECT_NE(error_text(ErrorKind::Usage, [&] { document_.tag({"no tag"}, {}); }), "(no error)");
  EXPECT_NE(error_text(ErrorKind::Usage, [&] { document_.rename(hash_of(2), ""); }), "(no error)");
  EXPECT_FALSE(document_.history().can_undo());
}

TEST_F(ListDocuments, CopyAndMoveToOneAnother) {
  auto other = std::make_unique<ListDocument>(make_list("b.scenarios", 2, 100));
  other->refresh();
  select({0, 1});
  document_.copy_to(*other);
  EXPECT_EQ(shown(*other), (Numbers{100, 101, 0, 1}));
  select({2});
  document_.move_to(*other);
  EXPECT_EQ(shown(*other), (Numbers{100, 101, 0, 1, 2}));
  EXPECT_EQ(shown(), (Numbers{0, 1, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(other->file_state(), FileState::Same) << "its own change is not reported";
  document_.undo();
  EXPECT_EQ(shown().size(), 10U);
  EXPECT_NE(other->update_from_file(), "");
  EXPECT_EQ(shown(*other), (Numbers{100, 101, 0, 1}));
  EXPECT_NE(error_text(ErrorKind::Usage, [&] { document_.copy_to(document_); }), "(no error)");
  other.reset();  // closed; its changes can still be undone
  document_.undo();
  EXPECT_EQ(ScenarioList::open(folder_ / "b.scenarios").size(), 2U);
}

TEST_F(ListDocuments, MakeShowAndDropIndexes) {
  document_.create_index("by_density", "density", {0, 0.5, 1});
  document_.set_group_by("by_density");
  ASSERT_EQ(document_.view().groups.size(), 4U);  // two ranges, NA, not computed
  EXPECT_EQ(document_.lines().size(), 14U);
  document_.toggle_group(0);
  EXPECT_EQ(document_.lines().size(), 9U);  // without 0 to 4
  document_.set_sort("density", true);
  EXPECT_TRUE(document_.lines().is_closed(0)) << "stays closed";
  document_.toggle_group(0);
  EXPECT_EQ(document_.lines().size(), 14U);
  EXPECT_NE(error_text(ErrorKind::Usage,
                       [&] {
                         document_.create_index("by_density", "density", {1, 2});
                       }),
            "(no error)");
  EXPECT_NE(error_text(ErrorKind::Usage,
                       [&] {
                         document_.create_index("b", "density", {2, 1});
                       }),
            "(no error)");
  document_.drop_index("by_density");
  EXPECT_TRUE(document_.view().groups.empty());
  EXPECT_EQ(document_.request().group_by, "");
  EXPECT_NE(document_.disabled_reason(ListAction::DropIndex), "");
  document_.undo();
  EXPECT_EQ(document_.indexes().size(), 1U);
}

TEST_F(ListDocuments, RemoveNearDuplicates) {
  document_.list().add(make_scenario(10));  // density like scenario 0
  const ValueKey key = descriptor_view({"density"}, {}).at("density").front();
  document_.list().store_value(hash_of(10), {key, Value::of(0.01)});
  document_.refresh();
  // Only 10 is within 0.05 of another one; 8 and 9 have no value, so that 9 equals 8.
  EXPECT_EQ(document_.deduplicate({{"density", 0.05}}), 2U);
  EXPECT_EQ(shown(), (Numbers{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "a.scenarios: ", {"duplicates"}, [&] {
    document_.deduplicate({{"density", 0.05}});
  }));
}

TEST_F(ListDocuments, SaveCopies) {
  const std::string copy = folder_ / "copy.scenarios";
  document_.save_as(copy);
  EXPECT_EQ(ScenarioList::open(copy).size(), 10U);
  EXPECT_NE(error_text(ErrorKind::Usage, [&] { document_.save_as(path_); }), "(no error)");
  EXPECT_NE(error_text(ErrorKind::Job, [&] { document_.save_as(folder_ / "no/folder.scenarios"); }),
            "(no error)");
}

TEST_F(ListDocuments, ReportWhyAnActionIsDisabled) {
  for (const ListAction action :
       {ListAction::CopyTo, ListAction::MoveTo, ListAction::Remove, ListAction::Tag})
    EXPECT_EQ(document_.disabled_reason(action), "nothing is selected");
  EXPECT_EQ(document_.disabled_reason(ListAction::Undo), "there is nothing to undo");
  EXPECT_EQ(document_.disabled_reason(ListAction::Redo), "there is nothing to redo");
  EXPECT_EQ(document_.disabled_reason(ListAction::DropIndex), "the list has no index");
  EXPECT_EQ(document_.disabled_reason(ListAction::Rename), "");
  EXPECT_EQ(document_.disabled_reason(ListAction::SaveAs), "");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "a.scenarios: ", {"nothing is selected"},
                           [&] { document_.remove_selected(); }));
  select({1});
  EXPECT_EQ(document_.disabled_reason(ListAction::Remove), "");
}

TEST_F(ListDocuments, SortManyScenariosInABackgroundThread) {
  constexpr int kMany = 20000;
  Jobs jobs;
  ListDocument document(make_list("many.scenarios", kMany), &jobs);
  document.refresh();
  EXPECT_TRUE(document.is_computing());
  EXPECT_TRUE(document.view().hashes.empty()) << "the window does not wait";
  finish_jobs(jobs);
  EXPECT_FALSE(document.is_computing());
  ASSERT_EQ(document.view().hashes.size(), static_cast<std::size_t>(kMany));
  EXPECT_EQ(document.lines().size(), static_cast<std::size_t>(kMany));
  document.set_sort("density", true);
  document.set_filter("density >= 0.7");  // replaces the job before
  finish_jobs(jobs);
  EXPECT_EQ(document.view().hashes.size(), static_cast<std::size_t>(kMany) / 10);
  EXPECT_EQ(document.row(document.view().hashes[1234])->value, Value::of(0.7));
  document.select_all();
  document.remove_selected();
  document.set_current(hash_of(5));  // still hidden by the filter
  finish_jobs(jobs);
  EXPECT_TRUE(document.view().hashes.empty());
  EXPECT_EQ(document.view().total, static_cast<std::size_t>(kMany) * 9 / 10);
  document.undo();
  document.set_filter("");
  document.set_current(hash_of(kMany - 3));  // in the view that is being computed
  finish_jobs(jobs);
  EXPECT_EQ(document.view().hashes.size(), static_cast<std::size_t>(kMany));
  EXPECT_EQ(document.current(), hash_of(kMany - 3));
}

}  // namespace
}  // namespace slalom
