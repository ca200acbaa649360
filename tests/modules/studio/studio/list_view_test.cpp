// SPDX-License-Identifier: BSD-3-Clause
#include "list_files.h"

#include <slalom/io/result_file.h>
#include <slalom/studio/list_view.h>

namespace slalom {
namespace {

using Numbers = std::vector<int>;

class ListViews : public ListFiles {
 protected:
  Numbers shown(const ListViewRequest& request) const {
    const ScenarioList list = ScenarioList::open(path_);
    return numbers(list, make_list_view(path_, request));
  }
  static ListViewRequest request(const std::string& filter, const std::string& sort = "",
                                 bool descending = false) {
    ListViewRequest request;
    request.filter = filter;
    request.sort = sort;
    request.descending = descending;
    return request;
  }
  void create_index(const std::vector<double>& edges) const {
    ScenarioList::open(path_).create_index(
        {"by_density", "density", descriptor_view({"density"}, {}).at("density"), edges});
  }

  std::string path_ = make_list("a.scenarios", 12);
};

TEST_F(ListViews, ShowAListInItsOrderOrReversed) {
  EXPECT_EQ(shown({}), (Numbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
  EXPECT_EQ(shown(request("  ", "", true)), (Numbers{11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0}));
}

TEST_F(ListViews, SortByADescriptorWithMissingValuesLast) {
  EXPECT_EQ(shown(request("", "density")), (Numbers{0, 10, 1, 11, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(shown(request("", "density", true)), (Numbers{7, 6, 5, 4, 3, 2, 1, 11, 0, 10, 8, 9}));
}

TEST_F(ListViews, SortByName) {
  EXPECT_EQ(shown(request("", "name")), (Numbers{0, 1, 10, 11, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST_F(ListViews, FilterBySelectionExpressions) {
  EXPECT_EQ(shown(request("density > 0.3 and not tag = hard")), (Numbers{4, 5, 7}));
  EXPECT_EQ(shown(request("density is na")), (Numbers{8, 9}));
  EXPECT_EQ(shown(request("name = nobody")), (Numbers{}));
  const ListView view = make_list_view(path_, request("density > 0.3"));
  EXPECT_EQ(view.total, 12U);
  EXPECT_EQ(view.index_of(hash_of(4)), 0U);
  EXPECT_EQ(view.index_of(hash_of(1)), std::nullopt);
  EXPECT_EQ(view.index_of(""), std::nullopt);
}

TEST_F(ListViews, RefuseInvalidFilters) {
  for (const std::string text :
       {"density >", "nothing = 3", "density > 0.1; DROP TABLE scenarios", "'", "(((((((((", ")",
        "density ~ 3", "by_density[1]", "name = 'a' -- or"})
    EXPECT_NE(error_text(ErrorKind::Usage, [&] { shown(request(text)); }).find("selection"),
              std::string::npos)
        << text;
  const std::string null("name = 'a\0b'", 12);
  for (const std::string& text :
       {std::string("name = 'x'' OR 1=1 --'"), std::string("name like '%''; DROP TABLE tags;%'"),
        null, "name = \"" + std::string(100000, 'x') + "\"", std::string("name = '\xff\xfe'")}) {
    try {
      EXPECT_EQ(shown(request(text)), Numbers{}) << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::Usage) << text;
    }
  }
  const std::string deep = std::string(200000, '(') + "density > 1" + std::string(200000, ')');
  EXPECT_NE(error_text(ErrorKind::Usage, [&] { shown(request(deep)); }), "(no error)");
  EXPECT_EQ(shown({}).size(), 12U);
}

TEST_F(ListViews, FilterAndSortByResults) {
  const std::string results = folder_ / "a.results";
  ResultFile file = ResultFile::create(results, {}, {}, {});
  for (const int number : {1, 4, 7}) {
    const Scenario scenario = make_scenario(number);
    file.add_scenario({scenario.hash(), scenario.name(), {}}, scenario, {});
    RunRecord run;
    run.scenario_hash = scenario.hash();
    run.scenario_name = scenario.name();
    run.method = "nd";
    run.outcome = number == 4 ? "collision" : "success";
    file.add_run(run, {}, {});
  }
  file.commit();
  const auto fields = std::make_shared<const ResultFields>(results);
  const auto with_results = [&](ListViewRequest request) {
    request.results = fields;
    return request;
  };
  EXPECT_EQ(shown(with_results(request("outcome.nd = collision"))), (Numbers{4}));
  EXPECT_EQ(shown(with_results(request("Success.nd = 1 and Density > 0.2"))), (Numbers{7}));
  EXPECT_EQ(shown(with_results(request("success.nd is not na", "success.nd"))), (Numbers{4, 1, 7}));
  EXPECT_NE(error_text(ErrorKind::Usage, [&] { shown(request("success.nd < 1")); }), "(no error)");
  ListDocument document(path_);
  document.set_filter("outcome.nd = success");
  EXPECT_NE(document.filter_error(), "");
  document.set_results(fields);
  EXPECT_EQ(document.filter_error(), "") << "the filter is tried again";
  EXPECT_EQ(document.view().hashes, (std::vector<std::string>{hash_of(1), hash_of(7)}));
  document.set_sort("success.nd", true);
  EXPECT_EQ(document.row(hash_of(7))->value, Value::of(1));
  document.set_sort("outcome.nd", false);
  EXPECT_EQ(document.row(hash_of(7))->outcomes, "success");
  document.set_results(nullptr);
  EXPECT_EQ(document.request().sort, "");
  EXPECT_NE(document.filter_error(), "") << "there are no results any more";
}

TEST_F(ListViews, RefuseAnUnknownSortField) {
  EXPECT_NE(error_text(ErrorKind::Usage, [&] { shown(request("", "content")); }), "(no error)");
}

TEST_F(ListViews, GroupByTheRangesOfAnIndex) {
  create_index({0.1, 0.3, 0.5, 0.55});
  ListViewRequest grouped = request("", "density", true);
  grouped.group_by = "by_density";
  // Densities 0.1 and 0.2 of 1, 11 and 2 lie in the first range, 0.3 and 0.4 in the second, 0.5 in
  // the third, which is closed; 0 of 0 and 10 lie below, 0.6 and 0.7 above.
  EXPECT_EQ(shown(grouped), (Numbers{0, 10, 2, 1, 11, 4, 3, 5, 7, 6, 8, 9}));
  const ListView view = make_list_view(path_, grouped);
  std::vector<std::string> groups;
  for (const ListGroup& group : view.groups)
    groups.push_back(group.title + ": " + std::to_string(group.count) + " from " +
                     std::to_string(group.first));
  EXPECT_EQ(groups, (std::vector<std::string>{
                        "density below 0.1: 2 from 0", "density 0.1 to 0.3: 3 from 2",
                        "density 0.3 to 0.5: 2 from 5", "density 0.5 to 0.55: 1 from 7",
                        "density above 0.55: 2 from 8", "density NA: 1 from 10",
                        "density not computed: 1 from 11"}));
  for (int number = 0; number < 12; ++number)
    EXPECT_EQ(view.hashes[view.index_of(hash_of(number)).value()], hash_of(number));
}

TEST_F(ListViews, GroupOnlyFilteredScenariosAndShowEmptyRanges) {
  create_index({0.2, 0.35, 0.37});
  ListViewRequest grouped = request("tag = hard");  // 0, 3, 6, 9
  grouped.group_by = "by_density";
  const ListView view = make_list_view(path_, grouped);
  ASSERT_EQ(view.groups.size(), 5U);  // below, two ranges, above, not computed
  const std::size_t counts[] = {1, 1, 0, 1, 1};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(view.groups[i].count, counts[i]) << i;
  EXPECT_EQ(shown(grouped), (Numbers{0, 3, 6, 9}));
}

TEST(ListLines, IncludeGroupHeaders) {
  const std::vector<ListGroup> groups = {{"a", 0, 2}, {"b", 2, 0}, {"c", 2, 3}, {"d", 5, 1}};
  const ListLines lines(6, groups, {"c"});
  ASSERT_EQ(lines.size(), 7U);  // four headers, two of a, one of d
  const int headers[] = {0, -1, -1, 1, 2, 3, -1};
  for (std::size_t i = 0; i < 7; ++i) {
    const auto group = lines.at(i).group;
    EXPECT_EQ(group ? static_cast<int>(*group) : -1, headers[i]) << i;
  }
  EXPECT_EQ(lines.at(2).index, 1U);
  EXPECT_EQ(lines.at(6).index, 5U);
  EXPECT_EQ(lines.line_of(1), 2U);
  EXPECT_EQ(lines.line_of(3), std::nullopt);
  EXPECT_EQ(lines.group_of(3), 2U);
  EXPECT_EQ(lines.line_of(5), 6U);
  EXPECT_EQ(lines.line_of(6), std::nullopt);
}

TEST(ListLines, HavePositionsInPixels) {
  const ListLines lines(4, {{"a", 0, 1}, {"b", 1, 3}}, {});
  const ListLines::Layout layout{50, 20};
  // a 0 to 20, its scenario to 70, b to 90, its scenarios to 140, 190, 240.
  const double tops[] = {0, 20, 70, 90, 140, 190, 240};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(lines.place_of(i, layout).top, tops[i]);
    EXPECT_EQ(lines.place_of(i, layout).height, tops[i + 1] - tops[i]);
  }
  EXPECT_EQ(lines.height(layout), 240);
  EXPECT_EQ(lines.line_at(-5, layout), 0U);
  EXPECT_EQ(lines.line_at(19.9, layout), 0U);
  EXPECT_EQ(lines.line_at(20, layout), 1U);
  EXPECT_EQ(lines.line_at(139, layout), 3U);
  EXPECT_EQ(lines.line_at(1e9, layout), 5U);
  const ListLines plain(3, {}, {});
  EXPECT_EQ(plain.line_at(101, layout), 2U);
  EXPECT_EQ(plain.at(2).index, 2U);
}

/// Rows of three: a (header 0), 1 2 3, 4; b (header 5, closed); c (header 6), 7 8.
const ListLines kGrid(9, {{"a", 0, 4}, {"b", 4, 3}, {"c", 7, 2}}, {"b"});

TEST(ListLines, StandSideBySideInAGridWithHeadersAcross) {
  const ListLines::Layout layout{50, 20, 3};
  // Headers at 0, 120 and 140; rows of scenarios at 20, 70 and 160.
  const double tops[] = {0, 20, 20, 20, 70, 120, 140, 160, 160};
  const std::size_t columns[] = {0, 0, 1, 2, 0, 0, 0, 0, 1};
  ASSERT_EQ(kGrid.size(), 9U);
  for (std::size_t i = 0; i < 9; ++i) {
    const ListLines::Place place = kGrid.place_of(i, layout);
    EXPECT_EQ(place.top, tops[i]) << i;
    EXPECT_EQ(place.column, columns[i]) << i;
    EXPECT_EQ(place.columns, kGrid.at(i).group ? 1U : 3U) << i;
  }
  EXPECT_EQ(kGrid.height(layout), 210);
  EXPECT_EQ(kGrid.line_at(69, layout), 1U);
  EXPECT_EQ(kGrid.line_at(70, layout), 4U);
  EXPECT_EQ(kGrid.line_at(1e9, layout), 7U);
  EXPECT_EQ(ListLines(100000, {}, {}).height(layout), 33334 * 50.0);
  EXPECT_EQ(ListLines(100000, {}, {}).line_at(20000 * 50.0, layout), 60000U);
}

TEST(ListLines, AreReachedByRowsInAGrid) {
  const std::size_t below[] = {1, 4, 4, 4, 5, 6, 7, 7, 8};
  const std::size_t above[] = {0, 0, 0, 0, 1, 4, 5, 6, 6};
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(kGrid.line_below(i, 1, 3), below[i]) << i;
    EXPECT_EQ(kGrid.line_below(i, -1, 3), above[i]) << i;
    EXPECT_EQ(kGrid.line_below(i, 1, 1), std::min<std::size_t>(i + 1, 8)) << i;
    EXPECT_EQ(kGrid.line_below(i, -3, 1), i - std::min<std::size_t>(i, 3)) << i;
  }
  EXPECT_EQ(kGrid.line_below(2, 100, 3), 7U);
  EXPECT_EQ(ListLines(11, {}, {}).line_below(1, 2, 3), 7U);
  EXPECT_EQ(ListLines(11, {}, {}).line_below(8, 1, 3), 10U) << "the last row has two columns";
  EXPECT_EQ(ListLines(11, {}, {}).line_below(10, -2, 3), 4U);
}

}  // namespace
}  // namespace slalom
