#include "studio_fixture.h"

#include <algorithm>

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
  std::string names(const std::string& list) const {
    return run("slalom-scenarios list " + list).out;
  }
};

TEST_F(StudioList, SortsByADescriptorInBothDirections) {
  make_described_list(8);
  const std::string up = expect_played(
      "size 1280 1000\n"  // so that all rows are seen
      "wait idle\n"
      "click list sort\n"
      "click choices \"choice density\"\n"
      "wait idle\n"
      "expect list contains \"sort: density, ascending\"\n"
      "print rows\n",
      "a.scenarios");
  const std::string down = expect_played(
      "size 1280 1000\n"  // so that all rows are seen
      "wait idle\n"
      "click list sort\n"
      "key Down\n"
      "key Down\n"
      "key Enter\n"
      "click list direction\n"
      "wait idle\n"
      "expect list contains \"sort: density, descending\"\n"
      "print rows\n",
      "a.scenarios");
  std::vector<int> rows = rows_in(up);
  ASSERT_EQ(rows.size(), 8U) << up;
  EXPECT_NE(rows, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7})) << "scenarios differ in density";
  std::reverse(rows.begin(), rows.end());
  EXPECT_EQ(rows_in(down), rows);
  // The same order as on the command line.
  ASSERT_EQ(
      run("slalom-scenarios select a.scenarios --where \"density >= 0\" --order-by density -o "
          "sorted.scenarios")
          .status,
      0);
  EXPECT_EQ(rows_in(names("sorted.scenarios")), rows_in(up));
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

TEST_F(StudioList, TypesLettersIntoTheFilterThatAreKeysElsewhere) {
  make_list(5);
  expect_played(
      "wait idle\n"
      "click filter\n"
      "type \"density > 0.2 and tag = hard\"\n"  // as the empty filter says
      "expect list contains \"sort: list order, ascending\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect filter is \"density > 0.2 and tag = hard\"\n"
      "expect list contains \"0 of 5 scenarios\"\n",
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
