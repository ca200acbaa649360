// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "list_sample.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

ListSelection where(const ScenarioList& list, const std::string& text) {
  ListSelection selection;
  selection.view = sample_view();
  selection.where = parse_selection(text, list.vocabulary({"density", "clearness", "confinement"}));
  return selection;
}

const ListIndex kByDensity = {"by_density", "density", sample_view().at("density"), {0, 0.25, 1}};

TEST(ListIndex, IsUsedForSelectionsAndPersists) {
  const TemporaryFolder folder;
  std::vector<SampleRow> rows;
  const std::string text = "density >= 0.1 and density < 0.2 and not (confinement > 0.8)";
  {
    ScenarioList list = sample_list(folder / "a.scenarios", 100, 1, rows);
    EXPECT_NE(list.query_plan(where(list, text)).find("SCAN s"), std::string::npos);
    list.create_index(kByDensity);
  }
  const ScenarioList list = ScenarioList::open(folder / "a.scenarios");
  for (const std::string& use :
       {text, std::string("by_density[1]"), std::string("density in (0.1, 0.2)"),
        std::string("0.1 <= density < 0.2 and name like 'room%'")}) {
    const std::string plan = list.query_plan(where(list, use));
    EXPECT_NE(plan.find("USING COVERING INDEX index_by_density (value"), std::string::npos)
        << use << "\n"
        << plan;
    EXPECT_EQ(plan.find("SCAN"), std::string::npos) << plan;
  }
}

TEST(ListIndex, DividesValuesIntoRanges) {
  const TemporaryFolder folder;
  std::vector<SampleRow> rows;
  ScenarioList list = sample_list(folder / "a.scenarios", 200, 2, rows);
  list.create_index({"x", "density", sample_view().at("density"), {0.1, 0.25, 0.5, 0.9}});
  const ListIndexCounts counts = list.index_counts("x");
  std::size_t below = 0, above = 0, missing = 0;
  std::vector<std::size_t> expected(3);
  for (const SampleRow& row : rows) {
    const auto& value = row.values.at("density");
    if (!value)
      ++missing;
    else if (*value < 0.1)
      ++below;
    else if (*value > 0.9)
      ++above;
    else
      ++expected[*value < 0.25 ? 0 : *value < 0.5 ? 1 : 2];  // the last range is closed
  }
  EXPECT_EQ(counts.ranges, expected);
  EXPECT_EQ(counts.below, below);
  EXPECT_EQ(counts.above, above);
  EXPECT_EQ(counts.na + counts.unknown, missing);
  EXPECT_GT(counts.na, 0U);
  EXPECT_GT(counts.unknown, 0U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(list.count(where(list, "x[" + std::to_string(i) + "]")), expected[i]);
}

TEST(ListIndex, IsCreatedAndDroppedByName) {
  const TemporaryFolder folder;
  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  list.create_index(kByDensity);
  ASSERT_EQ(list.indexes().size(), 1U);
  EXPECT_EQ(list.index("by_density").edges, (std::vector<double>{0, 0.25, 1}));
  EXPECT_EQ(list.index("by_density").keys[1].parameters, "resolution=0.05");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, list.path(), {"'by_densty'", "expected 'by_density'"},
                           [&] { list.drop_index("by_densty"); }));
  list.drop_index("by_density");
  EXPECT_TRUE(list.indexes().empty());
  EXPECT_EQ(dump_list(folder / "a.scenarios").find("index_by_density"), std::string::npos);
}

TEST(ListIndex, RejectsInvalidNamesAndEdges) {
  const TemporaryFolder folder;
  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  list.create_index(kByDensity);
  const auto refused = [&](const std::string& name, std::vector<double> edges,
                           const std::string& where, const std::string& reason) {
    return throws_error(ErrorKind::Usage, where, {reason}, [&] {
      list.create_index({name, "density", sample_view().at("density"), std::move(edges)});
    });
  };
  EXPECT_TRUE(refused("By_Density", {0, 1}, list.path(), "already exists"));
  for (const std::string name : {"", "a b", "1a", "x\"; DROP TABLE scenarios; --", "\xc3\xa4"})
    EXPECT_TRUE(refused(name, {0, 1}, "index '" + name + "'", "invalid index name"));
  const std::vector<std::vector<double>> invalid = {{0}, {0, 0}, {0, 1, 0.5}};
  for (const std::vector<double>& edges : invalid)
    EXPECT_TRUE(refused("x", edges, "index 'x'", "increasing edges"));
  EXPECT_EQ(list.indexes().size(), 1U);
}

}  // namespace
}  // namespace slalom
