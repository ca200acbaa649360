// SPDX-License-Identifier: BSD-3-Clause
#include "dump_text.h"
#include "error_text.h"
#include "io_sample.h"
#include "open_files.h"

#include <slalom/analysis/data_table.h>
#include <slalom/core/error.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/io/merge_results.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/io/result_files.h>
#include <slalom/io/result_parts.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sys/resource.h>

namespace slalom {
namespace {

const std::vector<QuantityInfo> kMergedDescriptors = {
    {"density", 1, "Density", "-", Direction::None}};
const std::vector<QuantityInfo> kMergedMetrics = {
    {"optimality", 3, "Optimality", "-", Direction::Up}};

class MergeResults : public testing::Test {
 protected:
  /// A result file with one run of each method in the scenario with this seed.
  std::string write(const std::string& name, std::uint64_t scenario, double optimality = 0.5,
                    const std::string& max_v = "0.5",
                    const std::string& outcome = "timeout") const {
    const std::string path = folder_ / name;
    ResultFile file = ResultFile::create(
        path,
        {{"campaign", "test"}, {kEffectiveKey, "[robot]\nmax_v = " + max_v}, {"shard", "1/2"}},
        kMergedDescriptors, kMergedMetrics);
    add(file, sample_scenario(scenario), optimality, outcome);
    file.commit();
    return path;
  }

  static void add(ResultFile& file, const Scenario& scenario, double optimality,
                  const std::string& outcome = "timeout") {
    References references;
    references.shortest_reason = "too narrow";
    references.timing = {optimality, 0, 0};  // differs even where the results do not
    file.add_scenario({scenario.hash(), scenario.name(), {{"density", {1, Value::of(0.1)}}}},
                      scenario, references);
    Trajectory trajectory;
    trajectory.samples.push_back({0, {1, 1, 0}, 0, 0, 0, 0});
    for (const char* method : {"nd", "gap"}) {
      RunRecord run;
      run.scenario_hash = scenario.hash();
      run.scenario_name = scenario.name();
      run.method = method;
      run.outcome = outcome;
      run.trajectory_hash = trajectory.hash();
      run.metrics["optimality"] = {3, Value::of(optimality)};
      const std::string output = method == std::string("gap") ? "of " + scenario.name() : "";
      file.add_run(run, {1, {}, output}, trajectory);
    }
  }

  std::string dump_of(const std::string& path) const { return dump_text(ResultFile::open(path)); }

  /// The content of tables and exports as CSV, except the name of the source.
  static std::string tables_of(const std::string& path) {
    const ResultTable results = read_detailed_results(path);
    std::string text;
    for (const auto& table : {runs_table, scenarios_table, timings_table, manifest_table})
      text += render_csv(table(results));
    return text;
  }

  TemporaryFolder folder_;
};

TEST_F(MergeResults, TheMergedFileHasTheDumpAndTheBlobsOfOneFileWithAllRuns) {
  const std::string first = write("1.results", 1), second = write("2.results", 2);
  const std::string whole = write("whole.results", 1);
  {
    ResultFile file = ResultFile::open(whole);
    add(file, sample_scenario(2), 0.5);
    file.commit();
  }
  MergedResults merged(folder_ / "all.results", second);
  EXPECT_EQ(merged.add(second), 2U);
  EXPECT_EQ(merged.add(first), 2U);
  EXPECT_EQ(merged.runs(), 4U);
  EXPECT_EQ(merged.duplicates(), 0U);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "all.results")) << "before publish()";
  merged.publish();
  EXPECT_EQ(dump_of(folder_ / "all.results"), dump_of(whole));
  const ResultFile file = ResultFile::open(folder_ / "all.results");
  EXPECT_EQ(file.read_manifest().count("shard"), 0U);
  file.for_each_run([&](const RunRecord& run) {
    EXPECT_EQ(file.read_trajectory(run).hash(), run.trajectory_hash);
    EXPECT_EQ(file.read_timing(run).wall_seconds, 1);
    EXPECT_EQ(file.read_timing(run).output, run.method == "gap" ? "of " + run.scenario_name : "");
    EXPECT_EQ(file.read_scenario(run.scenario_hash).hash(), run.scenario_hash);
    EXPECT_EQ(file.read_references(run.scenario_hash).shortest_reason, "too narrow");
  });
}

TEST_F(MergeResults, EqualDuplicatesAreCountedAndUnequalOnesAreRefused) {
  const std::string first = write("1.results", 1);
  MergedResults merged(folder_ / "all.results", first);
  merged.add(first);
  EXPECT_EQ(merged.add(write("again.results", 1)), 2U);
  EXPECT_EQ(merged.runs(), 2U);
  EXPECT_EQ(merged.duplicates(), 2U);
  const std::string other = write("other.results", 1, 0.25);
  EXPECT_TRUE(
      throws_error(ErrorKind::File, other, {"runs: ", "/0 differs"}, [&] { merged.add(other); }));
}

TEST_F(MergeResults, ADifferenceByATimeLimitIsOneOfTheMachines) {
  const std::string whole = write("1.results", 1),
                    limited = write("2.results", 1, 0.5, "0.5", "method_deadline");
  for (const auto& files : {std::pair(whole, limited), std::pair(limited, whole)}) {
    const std::string second = files.second;
    MergedResults merged(folder_ / "all.results", files.first);
    merged.add(files.first);
    EXPECT_TRUE(throws_error(ErrorKind::File, second,
                             {"/0 differs", "ended at a time limit on one of the machines",
                              "[limits] that the slowest machine keeps"},
                             [&] { merged.add(second); }));
  }
  const std::string folder = std::filesystem::path(whole).parent_path();
  EXPECT_TRUE(throws_error(ErrorKind::File, limited, {"ended at a time limit on one of"},
                           [&] { read_detailed_results(folder); }));
}

TEST_F(MergeResults, OtherCampaignsAndDamagedFilesAreRefusedAndTheOutputIsKept) {
  const std::string first = write("1.results", 1), output = write("all.results", 3);
  const std::string before = dump_of(output);
  {
    MergedResults merged(output, first);
    merged.add(first);
    const std::string other = write("other.results", 2, 0.5, "0.6");
    EXPECT_TRUE(throws_error(ErrorKind::File, other, {"robot.max_v is 0.5 here and 0.6"},
                             [&] { merged.add(other); }));
    const std::string cut = write("cut.results", 2);
    std::filesystem::resize_file(cut, std::filesystem::file_size(cut) / 2);
    EXPECT_TRUE(throws_error(ErrorKind::File, cut, {}, [&] { merged.add(cut); }));
  }
  EXPECT_EQ(dump_of(output), before);
  std::ofstream(folder_ / "notes.txt") << "precious";
  EXPECT_TRUE(throws_error(ErrorKind::File, folder_ / "notes.txt", {"result file"},
                           [&] { MergedResults(folder_ / "notes.txt", first); }));
  EXPECT_EQ(campaign_files(std::filesystem::path(first).parent_path()).size(), 4U)
      << "no temporary file is left";
}

TEST_F(MergeResults, ATableOfAFolderIsThatOfTheMergedFile) {
  // The second file contains the run of the first one again.
  const std::string first = write("2.results", 1), second = write("1.results", 2);
  const std::string folder = std::filesystem::path(first).parent_path();
  {
    ResultFile file = ResultFile::open(second);
    add(file, sample_scenario(1), 0.5);
    file.commit();
  }
  MergedResults merged(folder_ / "all.results", second);
  merged.add(second);
  merged.add(first);
  EXPECT_EQ(merged.duplicates(), 2U);
  merged.publish();
  EXPECT_EQ(tables_of(folder), tables_of(folder_ / "all.results"));
  const ResultTable some = read_results(folder, std::vector<std::string>{"success"});
  EXPECT_EQ(some.source, folder);
  EXPECT_EQ(some.size(), 4U) << "2 scenarios, 2 methods";
  EXPECT_EQ(some.metrics.size(), 1U) << "only the requested ones";
}

TEST_F(MergeResults, ATableOfAFolderRefusesOtherCampaignsDifferencesAndDamagedFiles) {
  const std::string first = write("1.results", 1);
  const std::string folder = std::filesystem::path(first).parent_path();
  const auto refuses = [&](const std::string& file, std::initializer_list<std::string> words) {
    const auto result = throws_error(ErrorKind::File, file, words, [&] { read_results(folder); });
    std::filesystem::remove(file);
    return result;
  };
  EXPECT_EQ(read_results(folder).size(), 2U);
  EXPECT_TRUE(refuses(write("2.results", 2, 0.5, "0.6"), {"robot.max_v is 0.5 here and 0.6"}));
  EXPECT_TRUE(refuses(write("2.results", 1, 0.25), {"run ", "/0 differs"}));
  const std::string other = folder_ / "2.results";
  std::ofstream(other) << "not a result file";
  EXPECT_TRUE(refuses(other, {"result file"}));
  EXPECT_TRUE(throws_error(ErrorKind::File, folder, {"is a folder", "slalom-simulate merge"},
                           [&] { ResultFile::open(folder); }));
  std::filesystem::remove(first);
  EXPECT_TRUE(throws_error(ErrorKind::File, folder, {"contains no result files"},
                           [&] { read_results(folder); }));
}

TEST_F(MergeResults, AFolderHasTheFilesOfItsShardsOrElseAllFiles) {
  const std::string first = write("1.results", 1), second = write("2.results", 2);
  const std::string folder = std::filesystem::path(first).parent_path();
  {
    MergedResults merged(folder_ / "all.results", first);
    merged.add(first);
    merged.publish();
  }
  EXPECT_EQ(campaign_files(folder), (std::vector<std::string>{first, second}));
  std::filesystem::remove(first);
  std::filesystem::remove(second);
  EXPECT_EQ(campaign_files(folder), std::vector<std::string>{folder_ / "all.results"});
  EXPECT_TRUE(throws_error(ErrorKind::File, "/no/folder", {"cannot be read"},
                           [] { campaign_files("/no/folder"); }));
  EXPECT_EQ(count_results(folder_ / "all.results").runs, 2U);
  EXPECT_EQ(count_results(folder_ / "all.results").outcomes.at("timeout"), 2U);
  EXPECT_EQ(count_results(folder_ / "all.results").wall_seconds, 2);
}

TEST_F(MergeResults, AFolderIsReadFileByFile) {
  write("1.results", 1, 0.25);
  write("2.results", 2, 0.75);
  const std::string folder = folder_ / "";
  ResultParts parts(folder);
  EXPECT_TRUE(parts.are_disjoint());
  EXPECT_EQ(parts.files(), 2U);
  EXPECT_EQ(parts.outline().size(), 0U);
  EXPECT_EQ(parts.outline().manifest.count("shard"), 0U);
  EXPECT_NE(find_metric(parts.outline(), "success"), nullptr);
  parts.read_values("density");
  parts.read_values("density");
  const ValueColumn& density = *find_descriptor(parts.outline(), "density");
  ASSERT_EQ(density.size(), 2U) << "once for each scenario";
  EXPECT_EQ(density.number(1), 0.1);
  for (const int jobs : {1, 2, 5}) {
    std::vector<double> values;
    ResultParts(folder, jobs).for_each({"optimality"}, [&](const ResultTable& part) {
      EXPECT_EQ(part.size(), 2U);
      for (const std::size_t run : {0, 1}) values.push_back(part.metrics[0].number(run));
    });
    EXPECT_EQ(values, (std::vector<double>{0.25, 0.25, 0.75, 0.75}));
  }
  write("3.results", 1, 0.25);
  EXPECT_FALSE(ResultParts(folder).are_disjoint());
  write("4.results", 4, 0.5, "0.6");
  for (const int jobs : {1, 4})
    EXPECT_TRUE(throws_error(ErrorKind::File, folder_ / "4.results",
                             {"another campaign", "robot.max_v"},
                             [&] { ResultParts parts_of_two(folder, jobs); }));
}

TEST_F(MergeResults, AFolderMayContainMoreFilesThanAProcessCanOpen) {
  constexpr int kFiles = 24, kJobs = 2;
  constexpr rlim_t kFree = 12;  // of each thread two connections and the journal of one
  for (int i = 1; i <= kFiles; ++i)
    write(std::to_string(i) + ".results", static_cast<std::uint64_t>(i));
  rlimit before = {};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const std::vector<int> open = open_files();
  const auto used = static_cast<rlim_t>(*std::max_element(open.begin(), open.end())) + 1;
  const rlimit few = {used + kFree, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &few), 0);
  std::size_t runs = 0;
  EXPECT_NO_THROW({
    ResultParts parts(folder_ / "", kJobs);
    parts.read_values("density");
    parts.for_each({"optimality"}, [&](const ResultTable& part) { runs += part.size(); });
    EXPECT_EQ(read_results(folder_ / "").size(), 2U * kFiles);
  });
  EXPECT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_EQ(runs, 2U * kFiles);
}

TEST_F(MergeResults, ScenariosAreFoundInTheFilesOfAFolder) {
  write("1.results", 1);
  write("2.results", 2);
  write("3.results", 2);
  ResultFiles files(folder_ / "");
  const auto first = files.with_scenario(sample_scenario(1).hash());
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0]->read_scenario(sample_scenario(1).hash()).hash(), sample_scenario(1).hash());
  EXPECT_EQ(files.with_scenario(sample_scenario(2).hash()).size(), 2U);
  EXPECT_TRUE(files.with_scenario(sample_scenario(3).hash()).empty());
  ResultFiles one(folder_ / "2.results");
  EXPECT_EQ(one.with_scenario(sample_scenario(2).hash()).size(), 1U);
}

}  // namespace
}  // namespace slalom
