// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "temporary_folder.h"

#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/metrics/metric.h>
#include <slalom/report/analysis_input.h>
#include <slalom/results/outcome_words.h>
#include <slalom/trajectory/trajectory.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

class AnalysisInput : public testing::Test {
 protected:
  const TemporaryFolder folder_;
};

TEST_F(AnalysisInput, AnyTextIsATableUnlessItsNameIsThatOfResults) {
  const std::string table = "method,cost\na,1\nb,2\n";
  write_file_atomically(folder_ / "trials.csv", table);
  write_file_atomically(folder_ / "out.txt", table);
  write_file_atomically(folder_ / "trials.results", table);
  EXPECT_EQ(read_analysis_input(folder_ / "trials.csv", std::nullopt, false, {}).size(), 2U);
  EXPECT_EQ(read_analysis_input(folder_ / "out.txt", std::nullopt, false, {}).size(), 2U);
  EXPECT_EQ(read_analysis_input(folder_ / "trials.results", std::nullopt, true, {}).size(), 2U);
  EXPECT_TRUE(throws_error(ErrorKind::File, folder_ / "trials.results", {}, [&] {
    read_analysis_input(folder_ / "trials.results", std::nullopt, false, {});
  }));
}

TEST_F(AnalysisInput, AByteOrderMarkIsNotPartOfTheFirstName) {
  write_file_atomically(folder_ / "trials.csv", "\xEF\xBB\xBFmethod,cost\na,1\nb,2\n");
  EXPECT_EQ(read_analysis_input(folder_ / "trials.csv", std::nullopt, false, {}).methods,
            (std::vector<std::string>{"a", "b"}));
}

TEST_F(AnalysisInput, ColumnsOfTablesWithTheIdOfAMetricHaveItsRangeIfTheirValuesAllowIt) {
  const std::string path = folder_ / "trials.csv";
  write_file_atomically(path, "method,spl,optimality,cost\na,0.5,90,1.5\nb,0.9,85,2\n");
  const ResultTable table = read_analysis_input(path, std::nullopt, false, {});
  EXPECT_EQ(range_notation(find_metric(table, "spl")->info().range), "0..1");
  EXPECT_EQ(range_notation(find_metric(table, "optimality")->info().range), "..");  // percent
  EXPECT_EQ(range_notation(find_metric(table, "cost")->info().range), "..");
}

TEST_F(AnalysisInput, EachOutcomeOfARunIsAWordOfTables) {
  for (const std::string& name : names_of<Outcome>()) EXPECT_EQ(outcome_of_word(name), name);
}

TEST_F(AnalysisInput, ResultFilesAreReadAsSuchWhateverTheirName) {
  const std::string path = folder_ / "runs.csv";
  ResultFile::create(path, {{"campaign", "test"}}, {}, {});
  EXPECT_EQ(read_analysis_input(path, std::nullopt, true, {}).manifest.at("campaign"), "test");
}

TEST_F(AnalysisInput, IndexesBecomeTheirEdges) {
  const std::string path = folder_ / "a.scenarios";
  ScenarioList::create(path).create_index(
      {"by_density", "density", {{"density", 1, ""}}, {0, 0.25, 1}});
  const auto specs = resolve_indexes(parse_bin_specs("all;density:@by_density"), path);
  ASSERT_EQ(specs.size(), 2U);
  EXPECT_EQ(specs[0].kind, BinSpec::Kind::All);
  EXPECT_EQ(specs[1].kind, BinSpec::Kind::Edges);
  EXPECT_EQ(specs[1].edges, (std::vector<double>{0, 0.25, 1}));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "rows 'density:@by_density'", {"--scenarios"},
                           [] { resolve_indexes(parse_bin_specs("density:@by_density"), ""); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "rows 'clearness:@by_density'", {"density"}, [&] {
    resolve_indexes(parse_bin_specs("clearness:@by_density"), path);
  }));
}

TEST(KnownQuantities, HaveDifferentIds) {
  for (const std::string& id : descriptor_ids()) EXPECT_FALSE(contains(metric_ids(), id)) << id;
}

TEST(KnownQuantities, ContainTheSuccessThatTablesDeriveFromTheOutcome) {
  const QuantityInfo &registered = metric("success").info, derived = success_info();
  EXPECT_EQ(registered.id, derived.id);
  EXPECT_EQ(registered.version, derived.version);
  EXPECT_EQ(registered.name, derived.name);
  EXPECT_EQ(registered.unit, derived.unit);
  EXPECT_EQ(registered.direction, derived.direction);
  EXPECT_EQ(registered.kind, derived.kind);
  EXPECT_EQ(range_notation(registered.range), range_notation(derived.range));
}

}  // namespace
}  // namespace slalom
