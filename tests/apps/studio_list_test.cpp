// SPDX-License-Identifier: BSD-3-Clause
#include "studio_fixture.h"

#include <mrpt/img/CImage.h>

#include <algorithm>
#include <sstream>

namespace slalom {
namespace {

class StudioList : public StudioTest {
 protected:
  /// The numbers of the scenario names in the output of `print`: "random_0003" is 3.
  static std::vector<int> rows_in(const std::string& shown) {
    std::vector<int> rows;
    const std::string prefix = "random_";
    for (std::size_t at = shown.find(prefix); at != std::string::npos;
         at = shown.find(prefix, at + 1))
      rows.push_back(std::stoi(shown.substr(at + prefix.size(), 4)));
    return rows;
  }
  void make_described_list(int count) const {
    make_list(count);
    ASSERT_EQ(run("slalom-scenarios describe a.scenarios --descriptors density").status, 0);
  }
  /// The brightest red of the text in the filter of a window of 1280 x 800.
  int brightest_of_filter(const std::string& file) const {
    mrpt::img::CImage picture;
    if (!picture.loadFromFile(folder_ / file)) ADD_FAILURE() << file << " cannot be read";
    int brightest = 0;
    for (unsigned y = 72; y < 92; ++y)
      for (unsigned x = 12; x < 200; ++x)
        brightest = std::max<int>(brightest, picture.at<std::uint8_t>(x, y, 2));
    return brightest;
  }
  std::string names(const std::string& list) const {
    return run("slalom-scenarios list " + list).out;
  }
};

TEST_F(StudioList, SortsByADescriptorInBothDirections) {
  make_described_list(8);
  const std::string shown = expect_played(
      "size 1280 1000\n"  // so that all rows are seen
      "wait idle\n"
      "click list sort\n"
      "key Down\n"
      "key Down\n"
      "key Enter\n"
      "wait idle\n"
      "expect list contains \"sort: density, ascending\"\n"
      "print rows\n"
      "click list direction\n"
      "wait idle\n"
      "expect list contains \"sort: density, descending\"\n"
      "print rows\n",
      "a.scenarios");
  std::vector<int> up = rows_in(shown), down;
  ASSERT_EQ(up.size(), 16U) << shown;
  down.assign(up.begin() + 8, up.end());
  up.resize(8);
  EXPECT_NE(up, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7})) << "scenarios differ in density";
  EXPECT_EQ(down, std::vector<int>(up.rbegin(), up.rend()));
  // The same order as on the command line.
  ASSERT_EQ(
      run("slalom-scenarios select a.scenarios --where \"density >= 0\" --order-by density -o "
          "sorted.scenarios")
          .status,
      0);
  EXPECT_EQ(rows_in(names("sorted.scenarios")), up);
}

TEST_F(StudioList, FiltersAndReportsInvalidFilters) {
  make_list(12);
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "click filter\n"
      "type \"name glob '*1?'\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect list contains \"2 of 12 scenarios\"\n"
      "expect rows contains \"row 0: random_0010\"\n"
      "click filter\n"
      "key Ctrl+A\n"
      "type \"densitty > 1\"\n"
      "key Enter\n"
      "expect list contains \"expected 'density'\"\n"
      "expect list contains \"2 of 12 scenarios\"\n"
      "screenshot error.png\n"
      "click filter\n"
      "key Ctrl+A\n"
      "key Backspace\n"
      "key Enter\n"
      "wait idle\n"
      "expect list contains \"0 selected, 12 scenarios\"\n"
      "expect list lacks expected\n",
      "a.scenarios");
}

TEST_F(StudioList, TypesLettersIntoTheFilterThatAreKeysElsewhereAndClearsItByItsCross) {
  make_list(5);
  expect_played(
      "wait idle\n"
      "click filter\n"
      "type \"density > 0.2 and tag = hard\"\n"  // as the empty filter says
      "expect list contains \"sort: list order, ascending\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect filter is \"density > 0.2 and tag = hard\"\n"
      "expect list contains \"0 of 5 scenarios\"\n"
      "click list clear\n"
      "wait idle\n"
      "expect filter is \"\"\n"
      "expect list contains \"0 selected, 5 scenarios\"\n"
      "type \"name glob '*2'\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect list contains \"1 of 5 scenarios\"\n",
      "a.scenarios");
}

TEST_F(StudioList, GivesTheFilterNeitherTheKeyThatGoesThereNorItsOwnKeysToTheList) {
  make_list(5);
  expect_played(
      "wait idle\n"
      "click list \"row 1\"\n"
      "key Delete\n"
      "wait idle\n"
      "expect list contains \"0 selected, 4 scenarios\"\n"
      "key Ctrl+A\n"
      "key F\n"
      "type \"name = FGSD \"\n"
      "key Delete\n"
      "key Ctrl+Z\n"
      "key Home\n"
      "key Delete\n"
      "expect list contains \"4 selected, 4 scenarios\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect filter is \"ame = FGSD \"\n"
      "expect list contains \"4 selected, 4 scenarios\"\n"
      "click list \"row 1\"\n"
      "key S\n"  // the list has its keys again
      "expect choices contains density\n",
      "a.scenarios");
}

TEST_F(StudioList, KeepsTheFocusInTheFilterAfterEnterWithItsTextSelected) {
  make_list(5);
  expect_played(
      "wait idle\n"
      "click list \"row 1\"\n"
      "click filter\n"
      "type \"name glob '*1'\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect list contains \"1 of 5 scenarios\"\n"
      "key Delete\n"
      "expect filter is \"name glob '*1'\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect filter is \"\"\n"
      "expect list contains \"1 selected, 5 scenarios\"\n"
      "type \"densitty > 1\"\n"
      "key Enter\n"
      "expect list contains \"expected 'density'\"\n"
      "key Ctrl+A\n"
      "key Delete\n"
      "key Enter\n"
      "expect list lacks expected\n"
      "type \"name glob '*2'\"\n"
      "key Enter\n"
      "type \"name glob '*3'\"\n"  // replaces it
      "key Enter\n"
      "wait idle\n"
      "expect rows contains \"row 0: random_0003\"\n"
      "expect filter is \"name glob '*3'\"\n",
      "a.scenarios");
  EXPECT_EQ(rows_in(names("a.scenarios")), (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST_F(StudioList, LeavesTheFilterUnchangedByEscape) {
  make_list(5);
  make_list(2, "b.scenarios", 8);
  expect_played(
      "wait idle\n"
      "click list \"tab 0\"\n"
      "click filter\n"
      "type \"name glob '*1'\"\n"
      "key Enter\n"
      "type nonsense\n"
      "key Escape\n"
      "wait idle\n"
      "expect filter is \"name glob '*1'\"\n"
      "expect list contains \"1 of 5 scenarios\"\n"
      "key S\n"  // a key of the list
      "expect choices contains density\n"
      "key Escape\n"
      "click filter\n"
      "key Ctrl+PageDown\n"  // another list
      "expect filter is \"\"\n"
      "key Enter\n"
      "expect list contains \"0 selected, 2 scenarios\"\n",
      "a.scenarios b.scenarios");
}

TEST_F(StudioList, DrawsAnAppliedFilterBrighterThanItsPlaceholder) {
  make_list(2);
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "screenshot placeholder.png\n"
      "click filter\n"
      "type \"density > 0.2 and tag = hard\"\n"
      "key Enter\n"
      "key Escape\n"
      "move status at 0.5 0.5\n"
      "wait idle\n"
      "screenshot applied.png\n",
      "a.scenarios");
  const int placeholder = brightest_of_filter("placeholder.png");
  EXPECT_GT(brightest_of_filter("applied.png"), placeholder + 32);
}

TEST_F(StudioList, DeletesOneScenarioWithAnOfferToUndoIt) {
  make_list(5);
  expect_played(
      "wait idle\n"
      "click list \"row 1\"\n"
      "key Delete\n"
      "wait idle\n"
      "expect status is \"Deleted 1 scenario - Undo\"\n"
      "expect list contains \"0 selected, 4 scenarios\"\n"
      "key Delete\n"  // the next row is current, but not selected
      "expect list contains \"0 selected, 4 scenarios\"\n"
      "expect status is \"Delete: nothing is selected\"\n"
      "click list \"row 2\"\n"
      "key Delete\n"
      "wait idle\n"
      "click status undo\n"
      "wait idle\n"
      "expect status is \"Undone: Delete 1 scenario\"\n"
      "expect list contains \"4 scenarios\"\n"
      "key Ctrl+Z\n"
      "wait idle\n"
      "key Ctrl+Z\n"
      "expect status is \"Undo: there is nothing to undo\"\n"
      "key Ctrl+T\n"
      "expect status is \"Tags...: nothing is selected\"\n"
      "click list \"row 0\"\n"
      "key F2\n"  // no dialog has the keys
      "expect status is \"\"\n"
      "type corridor\n"
      "key Enter\n"
      "wait idle\n"
      "expect rows contains \"row 0: corridor\"\n"
      "expect status contains Rename\n",
      "a.scenarios");
  EXPECT_EQ(rows_in(names("a.scenarios")), (std::vector<int>{1, 2, 3, 4}));
}

TEST_F(StudioList, AsksBeforeItDeletesSeveralScenarios) {
  make_list(6);
  expect_played(
      "wait idle\n"
      "click list \"row 1\"\n"
      "click list \"row 3\" shift\n"
      "key Delete\n"
      "expect dialog contains \"Delete 3 scenarios of a.scenarios?\"\n"
      "key Enter\n"  // Cancel has the focus
      "expect list contains \"3 selected, 6 scenarios\"\n"
      "key Delete\n"
      "key Escape\n"
      "expect list contains \"3 selected, 6 scenarios\"\n"
      "key Delete\n"
      "key Right\n"
      "key Enter\n"
      "wait idle\n"
      "expect status is \"Deleted 3 scenarios - Undo\"\n"
      "expect list contains \"0 selected, 3 scenarios\"\n"
      "click list \"row 0\"\n"
      "key Ctrl+A\n"
      "key Delete\n"
      "click dialog cancel\n"
      "expect list contains \"3 selected, 3 scenarios\"\n",
      "a.scenarios");
  EXPECT_EQ(rows_in(names("a.scenarios")), (std::vector<int>{0, 4, 5}));
}

TEST_F(StudioList, NeverDeletesAScenarioThatIsNotVisible) {
  make_described_list(40);
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "click list \"row 0\"\n"
      "wheel -100 rows\n"
      "expect rows lacks selected\n"
      "key Delete\n"
      "expect status contains \"out of view\"\n"
      "expect rows contains \"row 0: random_0000\"\n"
      "expect list contains \"1 selected, 40 scenarios\"\n"
      "click filter\n"
      "type \"not name = random_0000\"\n"
      "key Enter\n"
      "key Escape\n"
      "wait idle\n"
      "key Delete\n"
      "expect status is \"Delete: nothing is selected\"\n"
      "expect list contains \"0 selected, 39 of 40 scenarios\"\n"
      "click list clear\n"
      "wait idle\n"
      "key Escape\n"
      "key Ctrl+I\n"
      "click dialog \"field edges\"\n"
      "type \"0, 0.5, 1\"\n"
      "key Enter\n"
      "wait idle\n"
      "click list \"row 0\"\n"
      "click list \"group 0\"\n"
      "key Delete\n"
      "expect status is \"Delete: nothing is selected\"\n"
      "wheel 100 rows\n"
      "click list \"group 0\"\n"
      "click list \"row 0\"\n"
      "key Delete\n"
      "wait idle\n"
      "expect status is \"Deleted 1 scenario - Undo\"\n",
      "a.scenarios");
}

TEST_F(StudioList, ShowsTheStatusOfTheLastActionOnly) {
  make_list(3);
  make_list(2, "b.scenarios", 8);
  expect_played(
      "wait idle\n"
      "click list \"tab 0\"\n"
      "wait idle\n"
      "click list \"row 1\"\n"
      "wait idle\n"
      "click view \"tool start\"\n"
      "drag view start to view goal\n"
      "wait idle\n"
      "expect status is \"Move start\"\n"
      "click list \"row 0\"\n"
      "expect status is \"\"\n"
      "click list \"row 2\"\n"
      "key Delete\n"
      "wait idle\n"
      "click list \"row 0\"\n"
      "expect status is \"Deleted 1 scenario - Undo\"\n"
      "click list \"tab 1\"\n"
      "expect status is \"b.scenarios: 2 scenarios\"\n"
      "key Ctrl+W\n"
      "expect status is \"b.scenarios was closed\"\n",
      "a.scenarios b.scenarios");
}

TEST_F(StudioList, PutsAnEditedScenarioWhereItBelongs) {
  make_described_list(30);
  const std::string shown = expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "click list sort\n"
      "click choices \"choice density\"\n"
      "wait idle\n"
      "click list \"row 0\"\n"
      "wait idle\n"
      "click view \"tool disc\"\n"
      "drag view \"at 4 1.5\" to view \"at 4 2.5\"\n"
      "expect status is \"Add disc\"\n"
      "wait idle\n"
      "print rows\n"
      "key Ctrl+Z\n"
      "wait idle\n"
      "expect rows contains \"row 0: \"\n",
      "a.scenarios");
  std::vector<double> densities;
  for (std::size_t at = shown.find(", density "); at != std::string::npos;
       at = shown.find(", density ", at + 1))
    densities.push_back(std::stod(shown.substr(at + 10)));
  EXPECT_GE(densities.size(), 4U) << shown;
  EXPECT_TRUE(std::is_sorted(densities.begin(), densities.end())) << shown;
  EXPECT_NE(shown.find("current, selected"), std::string::npos) << shown;
  EXPECT_EQ(shown.find("row 0: "), std::string::npos) << "it was the first: " << shown;
}

TEST_F(StudioList, EditsTheSameScenarioAgainUnderAFilterOfItsValues) {
  make_described_list(30);
  const std::string before = names("a.scenarios");
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "click filter\n"
      "type \"density > 0\"\n"
      "key Enter\n"
      "key Escape\n"
      "wait idle\n"
      "click list \"row 0\"\n"
      "wait idle\n"
      "click view \"tool disc\"\n"
      "drag view \"at 4 1.5\" to view \"at 4 2.5\"\n"
      "drag view \"at 4 1.5\" to view \"at 4 2\"\n"
      "wait idle\n",
      "a.scenarios");
  std::istringstream old_lines(before), new_lines(names("a.scenarios"));
  int changed = 0;
  for (std::string a, b; std::getline(old_lines, a) && std::getline(new_lines, b);)
    changed += a != b ? 1 : 0;
  EXPECT_EQ(changed, 1);
}

TEST_F(StudioList, EscapeRestoresTheFilterOfTheViewAfterAnInvalidOne) {
  make_described_list(3);
  expect_played(
      "wait idle\n"
      "click filter\n"
      "type \"density > 0\"\n"
      "key Enter\n"
      "type \"foo > 1\"\n"
      "key Enter\n"
      "expect list contains \"'foo'\"\n"
      "key Escape\n"
      "expect filter is \"density > 0\"\n",
      "a.scenarios");
}

TEST_F(StudioList, HasKeysForDirectionGroupsAndTabs) {
  make_list(2);
  make_list(3, "b.scenarios", 8);
  expect_played(
      "wait idle\n"
      "click list \"row 1\"\n"
      "key D\n"
      "expect list contains \"list order, descending\"\n"
      "key Ctrl+PageUp\n"
      "expect list contains \"a.scenarios, active\"\n"
      "key Ctrl+PageDown\n"
      "expect list contains \"b.scenarios, active\"\n"
      "key G\n"
      "expect choices contains \"no groups\"\n",
      "a.scenarios b.scenarios");
}

TEST_F(StudioList, StaysAtTheEditedScenarioWhenTheEditIsUndone) {
  make_list(5);
  // Nothing is computed yet; the scenario that is looked at is computed first, and its row goes up.
  expect_played(
      "wait idle\n"
      "click list sort\n"
      "click choices \"choice density\"\n"
      "wait idle\n"
      "click list \"row 2\"\n"
      "wait idle\n"
      "expect view contains \"scenario random_0002\"\n"
      "click view \"tool start\"\n"
      "drag view start to view goal\n"
      "wait idle\n"
      "expect status is \"Move start\"\n"
      "key Ctrl+Z\n"
      "wait idle\n"
      "expect status is \"Undone: Edit random_0002\"\n"
      "expect view contains \"scenario random_0002\"\n"
      "expect rows contains \"row 0: random_0002\"\n"
      "key Ctrl+Y\n"
      "wait idle\n"
      "expect status is \"Redone: Edit random_0002\"\n"
      "expect view contains \"scenario random_0002\"\n",
      "a.scenarios");
}

TEST_F(StudioList, SelectsWithTheMouseAndTagsRenamesAndRemoves) {
  make_list(9);
  expect_played(
      "wait idle\n"
      "click list \"row 2\"\n"
      "click list \"row 4\" shift\n"
      "click list \"row 7\" ctrl\n"
      "expect list contains \"4 selected\"\n"
      "expect rows contains \"random_0007\"\n"
      "key Ctrl+T\n"
      "type narrow\n"
      "key Enter\n"
      "wait idle\n"
      "click filter\n"
      "type \"tag = narrow\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect list contains \"4 of 9 scenarios\"\n"
      "expect rows contains \"tags narrow\"\n"
      "click list \"row 0\"\n"
      "key F2\n"
      "type corridor\n"
      "key Enter\n"
      "wait idle\n"
      "expect rows contains \"row 0: corridor\"\n"
      "click list \"row 1\"\n"
      "key Ctrl+A\n"
      "key Space\n"
      "key Delete\n"
      "click dialog ok\n"
      "wait idle\n"
      "expect list contains \"1 of 6 scenarios\"\n",
      "a.scenarios");
  const std::string remaining = names("a.scenarios");
  EXPECT_EQ(rows_in(remaining), (std::vector<int>{0, 1, 3, 5, 6, 8})) << remaining;
  EXPECT_EQ(remaining.find("corridor"), std::string::npos) << remaining;
}

TEST_F(StudioList, MovesThroughRowsByKeys) {
  make_list(40);
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "click list \"row 0\"\n"
      "key Down\n"
      "key Down\n"
      "expect rows contains \"random_0002\"\n"
      "key Shift+Down\n"
      "key Shift+Down\n"
      "expect list contains \"3 selected\"\n"
      "key End\n"
      "expect list contains \"1 selected\"\n"
      "expect rows contains \"row 39: random_0039\"\n"
      "expect rows lacks \"row 2:\"\n"
      "key Home\n"
      "expect rows contains \"row 0: random_0000\"\n"
      "key PageDown\n"
      "key Shift+End\n"
      "wheel 100 rows\n"
      "expect rows contains \"row 0: random_0000\"\n"
      "wheel -100 rows\n"
      "expect rows contains \"row 39:\"\n"
      "click list \"row 20\"\n"
      "expect rows contains \"row 20: random_0020\"\n"
      "key Escape\n"
      "expect list contains \"0 selected\"\n",
      "a.scenarios");
}

TEST_F(StudioList, ShowsAGridOfPicturesAndKeepsItForTheNextTime) {
  make_list(60);
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "do view.grid\n"
      "wait idle\n"
      "expect rows lacks \"row 30:\"\n"
      "click list \"row 1\"\n"
      "expect rows contains \"row 1: random_0001\"\n"
      "expect list contains \"1 selected\"\n"
      "key Right\n"
      "key Shift+Right\n"
      "expect list contains \"2 selected\"\n"
      "click list \"row 50\" ctrl\n"
      "expect list contains \"3 selected\"\n"
      "key End\n"
      "expect rows contains \"row 59: random_0059\"\n"
      "expect rows lacks \"row 2:\"\n"
      "click list \"row 2\" right\n"
      "expect popup contains Rename\n"
      "key Escape\n"
      "wait idle\n"
      "screenshot grid.png\n"
      "key Home\n"
      "key Shift+Down\n"
      "expect list contains \"4 selected\"\n"
      "drag splitter_list to menu at 0.5 0.5\n"
      "key Home\n"
      "key Shift+Down\n"
      "expect list contains \"5 selected\"\n"
      "wait idle\n"
      "screenshot wide.png\n",
      "a.scenarios --settings studio.ini");
  EXPECT_NE(read("studio.ini").find("grid = true"), std::string::npos);
  expect_played("expect rows contains \"row 11:\"\ndo view.grid\nwait idle\n",
                "a.scenarios --settings studio.ini");
  EXPECT_NE(read("studio.ini").find("grid = false"), std::string::npos);
}

TEST_F(StudioList, GroupsByAnIndexThatIsCreatedAndDropped) {
  make_described_list(6);
  expect_played(
      "size 1280 1000\n"
      "wait idle\n"
      "key Ctrl+I\n"
      "click dialog \"field edges\"\n"
      "type \"0, 0.5, 1\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect list contains \"groups: by_density\"\n"
      "expect rows contains \"group 0: density 0 to 0.5, 6\"\n"
      "expect rows contains \"group 1: density 0.5 to 1, 0\"\n"
      "screenshot groups.png\n"
      "click list \"group 0\"\n"
      "expect rows contains \"group 0: density 0 to 0.5, 6, closed\"\n"
      "expect rows lacks random_\n"
      "key Right\n"
      "expect rows contains random_0005\n"
      "click list group_by\n"
      "click choices \"choice no groups\"\n"
      "wait idle\n"
      "expect rows lacks group\n"
      "do list.drop_index\n"
      "key Enter\n"
      "wait idle\n"
      "key Ctrl+Z\n"
      "wait idle\n",
      "a.scenarios");
  EXPECT_NE(run("slalom-scenarios index list a.scenarios").out.find("by_density"),
            std::string::npos);
}

TEST_F(StudioList, CopiesAndMovesBetweenListsAndSavesThem) {
  make_list(4);
  make_list(2, "b.scenarios", 8);
  expect_played(
      "wait idle\n"
      "click list \"tab 0\"\n"
      "wait idle\n"
      "click list \"row 0\"\n"
      "key Ctrl+Shift+C\n"
      "key Enter\n"
      "wait idle\n"
      "click list \"row 1\"\n"
      "click list \"row 2\" ctrl\n"
      "key Ctrl+Shift+X\n"
      "key Enter\n"
      "wait idle\n"
      "expect list contains \"2 scenarios\"\n"
      "click list \"tab 1\"\n"
      "wait idle\n"
      "expect list contains \"tab 1: b.scenarios, active\"\n"
      "expect list contains \"5 scenarios\"\n"
      "key Ctrl+Shift+S\n"
      "type c.scenarios\n"
      "key Enter\n"
      "wait idle\n"
      "expect list contains \"tab 2: c.scenarios, active\"\n"
      "click list \"close 0\"\n"
      "expect list lacks a.scenarios\n",
      "a.scenarios b.scenarios");
  EXPECT_EQ(rows_in(names("a.scenarios")), (std::vector<int>{0, 3}));
  EXPECT_EQ(rows_in(names("c.scenarios")), (std::vector<int>{0, 1, 0, 1, 2}));
}

TEST_F(StudioList, ScrollsALongListByItsScrollBar) {
  make_list(1200);
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "drag list bar to list at 0.5 1\n"
      "expect rows contains \"row 1199:\"\n"
      "wait idle\n"
      "screenshot bottom.png\n",
      "a.scenarios");
}

}  // namespace
}  // namespace slalom
