// SPDX-License-Identifier: BSD-3-Clause
#include "list_files.h"

#include <chrono>
#include <filesystem>
#include <fstream>

namespace slalom {
namespace {

namespace fs = std::filesystem;
using FileState = ListDocument::FileState;

class ListsOnDisk : public OpenList {};

TEST_F(ListsOnDisk, FollowChangesOfAnotherProgram) {
  EXPECT_EQ(document_.update_from_file(), "");
  select({3, 4});
  const auto written = fs::last_write_time(path_);
  {
    ScenarioList other = ScenarioList::open(path_);
    other.remove(hash_of(4));
    other.add(make_scenario(50));
  }
  fs::last_write_time(path_, written + std::chrono::seconds(1));  // even on a fast machine
  EXPECT_EQ(document_.file_state(), FileState::Changed);
  EXPECT_NE(document_.update_from_file().find("changed"), std::string::npos);
  EXPECT_EQ(document_.notice(), "") << "it is up to date";
  EXPECT_EQ(shown(), (Numbers{0, 1, 2, 3, 5, 6, 7, 8, 9, 50}));
  EXPECT_EQ(selected(), Numbers{3});
  EXPECT_EQ(document_.update_from_file(), "");
  document_.remove_selected();  // is still possible
}

TEST_F(ListsOnDisk, RefuseToUndoAfterAChangeOfAnotherProgram) {
  document_.rename(hash_of(1), "mine");
  ScenarioList::open(path_).rename(hash_of(1), "theirs");
  EXPECT_TRUE(throws_error(ErrorKind::Job, "", {"changed"}, [&] { document_.undo(); }));
  EXPECT_EQ(ScenarioList::open(path_).find_entry(hash_of(1)).name, "theirs");
}

TEST_F(ListsOnDisk, ReloadAFileThatAnotherProgramReplaced) {
  document_.rename(hash_of(1), "mine");
  const std::string next = make_list("next.scenarios", 3, 7);
  fs::rename(next, path_);
  EXPECT_EQ(document_.file_state(), FileState::Replaced);
  select({1});
  EXPECT_NE(document_.disabled_reason(ListAction::Remove).find("replaced"), std::string::npos);
  EXPECT_NE(document_.disabled_reason(ListAction::Undo).find("replaced"), std::string::npos);
  EXPECT_NE(document_.update_from_file(), "");
  EXPECT_EQ(shown(), (Numbers{7, 8, 9}));
  EXPECT_NE(document_.notice().find("replaced"), std::string::npos);
  EXPECT_FALSE(document_.history().can_undo());
}

TEST_F(ListsOnDisk, KeepTheViewWhenTheFileIsReplacedByAnotherFormat) {
  std::ofstream(folder_ / "other.txt") << "no list";
  fs::rename(folder_ / "other.txt", path_);
  EXPECT_NE(document_.update_from_file(), "");
  EXPECT_NE(document_.notice().find("a.scenarios"), std::string::npos) << document_.notice();
  EXPECT_EQ(document_.update_from_file(), "") << "reported once";
  EXPECT_EQ(shown().size(), 10U);
  EXPECT_NE(document_.disabled_reason(ListAction::CreateIndex), "");
  fs::rename(make_list("good.scenarios", 2), path_);
  EXPECT_NE(document_.update_from_file(), "");
  EXPECT_EQ(shown(), (Numbers{0, 1}));
}

TEST_F(ListsOnDisk, SaveAListWhoseFileWasRemoved) {
  fs::remove(path_);
  EXPECT_NE(document_.update_from_file(), "");
  EXPECT_EQ(document_.update_from_file(), "");
  EXPECT_NE(document_.notice().find("removed"), std::string::npos);
  select({1});
  EXPECT_NE(document_.disabled_reason(ListAction::Remove).find("removed"), std::string::npos);
  EXPECT_EQ(document_.disabled_reason(ListAction::CopyTo), "");
  document_.set_sort("name", true);  // can still be viewed
  EXPECT_EQ(shown().front(), 9);
  const std::string copy = folder_ / "saved.scenarios";
  document_.save_as(copy);
  EXPECT_EQ(ScenarioList::open(copy).size(), 10U);
}

TEST_F(ListsOnDisk, RefuseFilesOfOtherFormats) {
  std::ofstream(folder_ / "text.scenarios") << "no list";
  EXPECT_NE(error_text(ErrorKind::File, [&] { ListDocument{folder_ / "text.scenarios"}; }),
            "(no error)");
  EXPECT_NE(error_text(ErrorKind::File, [&] { ListDocument{folder_ / "missing"}; }), "(no error)");
}

}  // namespace
}  // namespace slalom
