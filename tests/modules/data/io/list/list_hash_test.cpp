// SPDX-License-Identifier: BSD-3-Clause
#include "list_sample.h"

#include <slalom/io/list_hash.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

class ListHash : public testing::Test {
 protected:
  ScenarioList list_of(const std::string& name, const std::vector<int>& contents) const {
    ScenarioList list = ScenarioList::create(folder_ / name);
    for (const int content : contents) list.add(sample_scenario(content));
    return list;
  }
  const TemporaryFolder folder_;
};

TEST_F(ListHash, DoesNotDependOnOrderNamesTagsAndNotes) {
  ScenarioList list = list_of("a.scenarios", {1, 2, 3});
  const std::string hash = content_hash(list);
  EXPECT_EQ(hash.size(), 32U);
  EXPECT_EQ(content_hash(list_of("b.scenarios", {3, 1, 2})), hash);
  list.rename(list.entries()[0].hash, "another");
  list.tag({}, {"odd"}, {});
  list.set_note("origin", "elsewhere");
  EXPECT_EQ(content_hash(list), hash);
}

TEST_F(ListHash, ChangesWithWhatIsInTheList) {
  const std::string hash = content_hash(list_of("a.scenarios", {1, 2, 3}));
  EXPECT_NE(content_hash(list_of("b.scenarios", {1, 2})), hash);
  EXPECT_NE(content_hash(list_of("c.scenarios", {1, 2, 4})), hash);
  EXPECT_NE(content_hash(list_of("d.scenarios", {})), hash);
}

}  // namespace
}  // namespace slalom
