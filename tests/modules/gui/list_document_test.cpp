#include "list_files.h"

#include <slalom/gui/jobs.h>
#include <slalom/gui/list_document.h>

#include <chrono>
#include <thread>

namespace slalom {
namespace {

using State = ListDocument::FileState;

class ListDocuments : public OpenList {};

TEST_F(ListDocuments, ShowTheFirstScenarioFirst) {
  EXPECT_EQ(document_.title(), "a.scenarios");
  EXPECT_EQ(shown(), (Numbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(document_.current(), hash_of(0));
  EXPECT_EQ(document_.selected_count(), 0U);
}

TEST_F(ListDocuments, SelectAsUsersOfListsExpect) {
  int told = 0;
  document_.on_selection = [&] { ++told; };
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
  EXPECT_EQ(told, 8);
  document_.select_only(10);
  document_.toggle(10);
  document_.select_to(10);
  EXPECT_EQ(selected(), (Numbers{1, 7}));
}

TEST_F(ListDocuments, TellWhichScenarioIsTheCurrentOne) {
  std::vector<std::string> told;
  document_.on_current = [&](const std::string& hash) { told.push_back(hash); };
  document_.set_current(hash_of(3));
  document_.set_current(hash_of(3));
  document_.set_current("nobody");
  EXPECT_EQ(told, std::vector<std::string>{hash_of(3)});
  document_.set_filter("density < 0.2");  // 0 and 1: the last of them is next to what was current
  EXPECT_EQ(document_.current(), hash_of(1));
  document_.set_filter("name = nobody");
  EXPECT_EQ(document_.current(), "");
  EXPECT_EQ(told, (std::vector<std::string>{hash_of(3), hash_of(1), ""}));
}

TEST_F(ListDocuments, KeepSelectionAndCurrentByContentWhenTheOrderChanges) {
  select({2, 8});
  document_.set_current(hash_of(8));
  document_.set_sort("density", true);
  EXPECT_EQ(shown(), (Numbers{7, 6, 5, 4, 3, 2, 1, 0, 8, 9}));
  EXPECT_EQ(selected(), (Numbers{2, 8}));
  EXPECT_EQ(document_.current(), hash_of(8));
  document_.set_filter("density >= 0");
  EXPECT_EQ(selected(), Numbers{2});  // what is not seen is not acted on
}

TEST_F(ListDocuments, LeaveTheViewAsItIsWhenAFilterMakesNoSense) {
  document_.set_filter("density > 0.5");
  EXPECT_EQ(shown(), (Numbers{6, 7}));
  document_.set_filter("densitty > 0.6");
  EXPECT_NE(document_.filter_error().find("'density'"), std::string::npos)
      << document_.filter_error();
  EXPECT_EQ(document_.filter_text(), "densitty > 0.6");
  EXPECT_EQ(shown(), (Numbers{6, 7}));
  document_.set_filter("density > 0.5");
  EXPECT_EQ(document_.filter_error(), "");
  document_.set_filter("");
  EXPECT_EQ(shown().size(), 10U);
}

TEST_F(ListDocuments, ReadRowsWithTheValueTheyAreSortedBy) {
  const ListRow* row = document_.row(hash_of(3));
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->entry.name, "place_3");
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

TEST_F(ListDocuments, RemoveAndBringBack) {
  select({4, 5});
  document_.set_current(hash_of(5));
  document_.remove_selected();
  EXPECT_EQ(shown(), (Numbers{0, 1, 2, 3, 6, 7, 8, 9}));
  EXPECT_EQ(document_.current(), hash_of(7)) << "what moved to its place";
  EXPECT_EQ(document_.selected_count(), 0U);
  EXPECT_EQ(document_.history().undo_title(), "Delete 2 scenarios");
  document_.undo();
  EXPECT_EQ(shown(), (Numbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  document_.redo();
  EXPECT_EQ(shown().size(), 8U);
}

TEST_F(ListDocuments, RenameAndTag) {
  document_.rename(hash_of(2), "corridor");
  EXPECT_EQ(document_.row(hash_of(2))->entry.name, "corridor");
  select({1, 2});
  document_.tag({"easy"}, {});
  EXPECT_EQ(document_.row(hash_of(1))->entry.tags, std::vector<std::string>{"easy"});
  document_.undo();
  document_.undo();
  EXPECT_EQ(document_.row(hash_of(2))->entry.name, "place_2");
  EXPECT_TRUE(document_.row(hash_of(2))->entry.tags.empty());
  EXPECT_NE(error_text(Culprit::Usage, [&] { document_.tag({"no tag"}, {}); }), "(no error)");
  EXPECT_NE(error_text(Culprit::Usage, [&] { document_.rename(hash_of(2), ""); }), "(no error)");
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
  EXPECT_EQ(other->file_state(), State::Same) << "its own change is no news";
  document_.undo();
  EXPECT_EQ(shown().size(), 10U);
  EXPECT_TRUE(other->follow_file());
  EXPECT_EQ(shown(*other), (Numbers{100, 101, 0, 1}));
  EXPECT_NE(error_text(Culprit::Usage, [&] { document_.copy_to(document_); }), "(no error)");
  other.reset();  // closed; what was done to it can still be taken back
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
  EXPECT_NE(error_text(Culprit::Usage,
                       [&] {
                         document_.create_index("by_density", "density", {1, 2});
                       }),
            "(no error)");
  EXPECT_NE(error_text(Culprit::Usage,
                       [&] {
                         document_.create_index("b", "density", {2, 1});
                       }),
            "(no error)");
  document_.drop_index("by_density");
  EXPECT_TRUE(document_.view().groups.empty());
  EXPECT_EQ(document_.request().group_by, "");
  EXPECT_NE(document_.obstacle(ListAction::DropIndex), "");
  document_.undo();
  EXPECT_EQ(document_.indexes().size(), 1U);
}

TEST_F(ListDocuments, LeaveOutWhatIsAlike) {
  document_.list().add(place(10));  // 0.0 like place 0
  const DescriptorKey key = descriptor_view({"density"}, {}).at("density").front();
  document_.list().keep(hash_of(10), key.id, key.version, key.parameters, Value::of(0.01));
  document_.refresh();
  // Only 10 lies within 0.05 of another; both 8 and 9 have no value, so that 9 is like 8.
  EXPECT_EQ(document_.deduplicate({{"density", 0.05}}), 2U);
  EXPECT_EQ(shown(), (Numbers{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_NE(error_text(Culprit::Usage,
                       [&] {
                         document_.deduplicate({{"density", 0.05}});
                       })
                .find("alike"),
            std::string::npos);
}

TEST_F(ListDocuments, SaveCopies) {
  const std::string copy = folder_ / "copy.scenarios";
  document_.save_as(copy);
  EXPECT_EQ(ScenarioList::open(copy).size(), 10U);
  EXPECT_NE(error_text(Culprit::Usage, [&] { document_.save_as(path_); }), "(no error)");
  EXPECT_NE(error_text(Culprit::Job, [&] { document_.save_as(folder_ / "no/folder.scenarios"); }),
            "(no error)");
}

TEST_F(ListDocuments, SayWhyAnActionCannotBeDone) {
  for (const ListAction action :
       {ListAction::CopyTo, ListAction::MoveTo, ListAction::Remove, ListAction::Tag})
    EXPECT_EQ(document_.obstacle(action), "nothing is selected");
  EXPECT_EQ(document_.obstacle(ListAction::Undo), "nothing was done yet");
  EXPECT_EQ(document_.obstacle(ListAction::Redo), "nothing was taken back");
  EXPECT_EQ(document_.obstacle(ListAction::DropIndex), "the list has no index");
  EXPECT_EQ(document_.obstacle(ListAction::Rename), "");
  EXPECT_EQ(document_.obstacle(ListAction::SaveAs), "");
  EXPECT_EQ(error_text(Culprit::Usage, [&] { document_.remove_selected(); }),
            "a.scenarios: nothing is selected");
  select({1});
  EXPECT_EQ(document_.obstacle(ListAction::Remove), "");
}

TEST_F(ListDocuments, OfManyScenariosAreSortedBesideTheWindow) {
  constexpr int kMany = 20000;
  Jobs jobs;
  ListDocument document(make_list("many.scenarios", kMany), &jobs);
  const auto finish = [&] {
    while (!jobs.idle()) {
      jobs.poll();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  };
  document.refresh();
  EXPECT_TRUE(document.is_computing());
  EXPECT_TRUE(document.view().hashes.empty()) << "the window does not wait";
  finish();
  EXPECT_FALSE(document.is_computing());
  ASSERT_EQ(document.view().hashes.size(), static_cast<std::size_t>(kMany));
  EXPECT_EQ(document.lines().size(), static_cast<std::size_t>(kMany));
  document.set_sort("density", true);
  document.set_filter("density >= 0.7");  // takes the place of the one before
  finish();
  EXPECT_EQ(document.view().hashes.size(), static_cast<std::size_t>(kMany) / 10);
  EXPECT_EQ(document.row(document.view().hashes[1234])->value, Value::of(0.7));
  document.select_all();
  document.remove_selected();
  document.set_current(hash_of(5));  // hidden by the filter still
  finish();
  EXPECT_TRUE(document.view().hashes.empty());
  EXPECT_EQ(document.view().total, static_cast<std::size_t>(kMany) * 9 / 10);
  document.undo();
  document.set_filter("");
  document.set_current(hash_of(kMany - 3));  // of the view that is on its way
  finish();
  EXPECT_EQ(document.view().hashes.size(), static_cast<std::size_t>(kMany));
  EXPECT_EQ(document.current(), hash_of(kMany - 3));
}

}  // namespace
}  // namespace slalom
