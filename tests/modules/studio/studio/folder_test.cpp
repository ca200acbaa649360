// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "temporary_folder.h"

#include <slalom/studio/folder.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace slalom {
namespace {

/// The entries' names, folders with a slash.
std::string names_of(const FolderContent& content) {
  std::string names;
  for (const FolderEntry& entry : content.entries)
    names += entry.name + (entry.is_folder ? "/ " : " ");
  return names;
}

class Folder : public testing::Test {
 protected:
  void SetUp() override {
    for (const std::string folder : {"maps", "barn", ".git"})
      std::filesystem::create_directory(folder_ / folder);
    for (const std::string file : {"b.scenarios", "a.scenarios", "a.results", ".b.scenarios"})
      std::ofstream(folder_ / file) << file;
    std::filesystem::create_directory_symlink("maps", folder_ / "linked");
    std::filesystem::create_symlink("nowhere", folder_ / "broken.scenarios");
  }

  TemporaryFolder folder_;
};

TEST_F(Folder, ListsItsParentThenFoldersThenFilesWithTheExtensions) {
  EXPECT_EQ(names_of(content_of_folder(folder_ / "", {".scenarios"})),
            "../ barn/ linked/ maps/ a.scenarios b.scenarios ");
  EXPECT_EQ(names_of(content_of_folder(folder_ / "", {".results", ".ini"})),
            "../ barn/ linked/ maps/ a.results ");
  EXPECT_EQ(names_of(content_of_folder(folder_ / "", {""})),
            "../ barn/ linked/ maps/ a.results a.scenarios b.scenarios ");
  EXPECT_EQ(names_of(content_of_folder(folder_ / "", {"/"})), "../ barn/ linked/ maps/ ")
      << "no name of a file ends so";
  EXPECT_EQ(content_of_folder(folder_ / "", {""}).error, "");
  EXPECT_EQ(content_of_folder("", {}).entries.front().name, "..");
  for (const FolderEntry& entry : content_of_folder("/", {}).entries) EXPECT_NE(entry.name, "..");
}

TEST_F(Folder, ThatCannotBeReadSaysWhyAndOffersItsParent) {
  const FolderContent missing = content_of_folder(folder_ / "none/", {""});
  EXPECT_EQ(names_of(missing), "../ ");
  EXPECT_TRUE(mentions(missing.error, {folder_ / "none/", "No such file", "expected"}));
  EXPECT_TRUE(mentions(content_of_folder(folder_ / "a.results/", {""}).error, {"Not a directory"}));
}

TEST_F(Folder, GivesThePathToAnEntry) {
  const FolderEntry parent{"..", true}, maps{"maps", true}, list{"b.scenarios", false};
  EXPECT_EQ(path_to_entry("", list), "b.scenarios");
  EXPECT_EQ(path_to_entry("x/old", list), "x/b.scenarios");
  EXPECT_EQ(path_to_entry("", maps), "maps/");
  EXPECT_EQ(path_to_entry("x/", maps), "x/maps/");
  EXPECT_EQ(path_to_entry("x/y/", parent), "x/");
  EXPECT_EQ(path_to_entry("x/", parent), "");
  EXPECT_EQ(path_to_entry("", parent), "../");
  EXPECT_EQ(path_to_entry("../", parent), "../../");
  EXPECT_EQ(path_to_entry("/x/", parent), "/");
}

TEST_F(Folder, IsThatOfTheLastOfSeveralPaths) {
  EXPECT_EQ(begin_of_last_path(""), 0U);
  EXPECT_EQ(begin_of_last_path("x/a.map"), 0U);
  EXPECT_EQ(begin_of_last_path(" a.map"), 1U);
  EXPECT_EQ(begin_of_last_path("a.map,y/b"), 6U);
  EXPECT_EQ(begin_of_last_path("a.map, "), 7U);
}

TEST_F(Folder, KeepsTheNameOfANewFileButNoBeginningOfAnEntryAndNoExistingFile) {
  const FolderEntry maps{"maps", true}, parent{"..", true};
  EXPECT_EQ(path_to_entry(folder_ / "new.scenarios", maps), folder_ / "maps/new.scenarios");
  EXPECT_EQ(path_to_entry(folder_ / "maps/new", parent), folder_ / "new");
  EXPECT_EQ(path_to_entry(folder_ / "ma", maps), folder_ / "maps/");
  EXPECT_EQ(path_to_entry(folder_ / "a.scenarios", maps), folder_ / "maps/");
}

}  // namespace
}  // namespace slalom
