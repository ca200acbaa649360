// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "memory_folder.h"

#include <slalom/core/error.h>
#include <slalom/falsification/explain.h>
#include <slalom/io/read_results.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <unistd.h>

namespace slalom {
namespace {

const QuantityInfo kDensity = {"density", 1, "Density", "-", Direction::None};
const QuantityInfo kWidth = {"width", 1, "Width", "m", Direction::None};
const QuantityInfo kSpeed = {"mean_speed", 1, "Mean speed", "m/s", Direction::Up};
const QuantityInfo kProgress = {"progress", 1, "Progress", "-", Direction::Up};

/// A result file with made-up runs of the method "mine".
class Explain : public testing::Test {
 protected:
  ~Explain() override { std::filesystem::remove_all(folder_); }
  static std::filesystem::path make_folder() {
    std::string pattern = (memory_folder() / "slalom_explain_XXXXXX").string();
    return mkdtemp(pattern.data());
  }
  std::string path() const { return (folder_ / "runs.results").string(); }

  /// A scenario with these values and a run of it; returns its hash.
  std::string add(double density, double width, Outcome outcome) {
    Primitives obstacles;
    obstacles.discs = {{{3, 3}, 0.2 + 0.001 * ++count_}};
    const Scenario scenario = Scenario::continuous("room " + std::to_string(count_), {0, 0, 6, 6},
                                                   obstacles, {1, 3, 0}, {5, 3});
    ScenarioRecord record{scenario.hash(), scenario.name(), {}};
    record.descriptors["density"] = {1, Value::of(density)};
    record.descriptors["width"] = {1, Value::of(width)};
    file_.add_scenario(record, scenario, {});
    RunRecord run;
    run.scenario_hash = scenario.hash();
    run.scenario_name = scenario.name();
    run.method = "mine";
    run.outcome = to_string(outcome);
    const bool success = outcome == Outcome::Success;
    run.metrics["progress"] = {1, Value::of(success ? 1 : 0.5)};
    run.metrics["mean_speed"] = {1, Value::of(success ? 0.9 : 0.4)};
    Trajectory trajectory;
    trajectory.samples.resize(1);
    trajectory.samples[0].pose = {2.5, 3, 0};
    trajectory.samples[0].v = 0.9;
    file_.add_run(run, {}, trajectory);
    return scenario.hash();
  }

  /// A failure with these values and two neighbors of density 0.1 and width 1.
  ExaminedFailure add_failure(double density, double width, Outcome neighbor = Outcome::Success) {
    ExaminedFailure failure;
    failure.smallest = add(9, 9, Outcome::Collision);
    failure.compared = add(density, width, Outcome::Collision);
    for (int i = 0; i < 2; ++i) failure.neighbors.push_back(add(0.1, 1, neighbor));
    failure.obstacles = 1;
    failure.bottleneck_width = 3;
    return failure;
  }

  std::vector<ReportedCluster> explain(const std::vector<ExaminedFailure>& failures) {
    file_.commit();
    return explain_failures(ResultFile::open(path()), read_results(path()), {},
                            {"mine", 0, failures});
  }

  /// `n` failures of higher density than their neighbors; half of them are wider.
  std::vector<ExaminedFailure> dense_failures(int n) {
    std::vector<ExaminedFailure> failures;
    for (int i = 0; i < n; ++i)
      failures.push_back(add_failure(0.3 + 0.01 * i, 1 + (i % 2 == 0 ? 0.1 : -0.1) * (1 + i)));
    return failures;
  }

  const std::filesystem::path folder_ = make_folder();
  ResultFile file_ = ResultFile::create(path(), {}, {kDensity, kWidth}, {kSpeed, kProgress});
  int count_ = 0;
};

TEST_F(Explain, SaysOfADescriptorWhatDiffersFromTheSuccessfulNeighbors) {
  const auto clusters = explain(dense_failures(8));
  ASSERT_EQ(clusters.size(), 1u);
  EXPECT_EQ(clusters[0].members.size(), 8u);
  // 0.3, 0.31, ..., 0.37: quartiles 0.3175 and 0.3525. p = 2 / 2^8, twice that by Holm.
  ASSERT_EQ(clusters[0].statements.size(), 1u);
  EXPECT_EQ(clusters[0].statements[0].find(
                "8 of 8 have a higher Density than their successful neighbors: 0.318 to 0.352, "
                "successful neighbors 0.1 to 0.1 (quartiles); difference 0.235 ["),
            0u)
      << clusters[0].statements[0];
  EXPECT_NE(clusters[0].statements[0].find("p = 0.0156"), std::string::npos);
  EXPECT_EQ(clusters[0].basis,
            "8 of 8 failures compared with their successful neighbors in 2 descriptors.");
}

TEST_F(Explain, LeavesOutMetricsThatFollowFromTheOutcome) {
  const auto clusters = explain(dense_failures(8));
  ASSERT_EQ(clusters.size(), 1u);
  ASSERT_EQ(clusters[0].runs.size(), 1u) << "progress is below 1 in every failure";
  EXPECT_EQ(clusters[0].runs[0].quantity.id, "mean_speed");
  EXPECT_EQ(clusters[0].runs[0].lower, 8u);
}

TEST_F(Explain, SaysNothingOfTooFewFailures) {
  const auto clusters = explain(dense_failures(6));
  ASSERT_EQ(clusters.size(), 1u);
  EXPECT_TRUE(clusters[0].statements.empty());
  // 2 * 2^(1 - n) <= 0.05 is n >= 6.3.
  EXPECT_EQ(clusters[0].basis,
            "6 of 6 failures compared with their successful neighbors in 2 descriptors, too few: "
            "significance needs at least 7.");
}

TEST_F(Explain, HasNoContrastsOfOneFailure) {
  const auto clusters = explain(dense_failures(1));
  ASSERT_EQ(clusters.size(), 1u);
  EXPECT_TRUE(clusters[0].scenarios.empty());
  EXPECT_TRUE(clusters[0].runs.empty());
  EXPECT_EQ(clusters[0].basis, "One failure has successful neighbors; contrasts need at least 7.");
}

TEST_F(Explain, ComparesOnlyIndependentFailuresAndSuccessfulNeighbors) {
  std::vector<ExaminedFailure> failures = dense_failures(8);
  failures.push_back(add_failure(0.5, 1));
  failures.back().independent = false;
  failures.push_back(add_failure(0.5, 1, Outcome::Stuck));
  const auto clusters = explain(failures);
  ASSERT_EQ(clusters.size(), 1u);
  EXPECT_EQ(clusters[0].members.size(), 10u);
  ASSERT_FALSE(clusters[0].scenarios.empty());
  EXPECT_EQ(clusters[0].scenarios[0].pairs, 8u);
  EXPECT_EQ(clusters[0].basis,
            "8 of 10 failures compared with their successful neighbors in 2 descriptors.");
}

TEST_F(Explain, WithoutNeighborsThereIsNothingToCompare) {
  std::vector<ExaminedFailure> failures = {add_failure(0.3, 1)};
  failures[0].neighbors.clear();
  const auto clusters = explain(failures);
  ASSERT_EQ(clusters.size(), 1u);
  EXPECT_TRUE(clusters[0].scenarios.empty());
  EXPECT_EQ(clusters[0].basis, "No failure has successful neighbors to compare with.");
}

TEST_F(Explain, NamesClustersByTheRunsInTheSmallestScenarios) {
  const auto clusters = explain({add_failure(0.3, 1)});
  ASSERT_EQ(clusters.size(), 1u);
  // At (2.5, 3) with heading 0, 0.3 m left of a disc, 0.9 m/s of at most 1 m/s.
  EXPECT_EQ(clusters[0].name,
            "collision, nearest obstacle in front, above half of the maximum speed, faces the "
            "goal, at most 1 obstacle needed, bottleneck of 2 to 4 robot widths");
}

TEST_F(Explain, RefusesResultsWithoutTheRuns) {
  ExaminedFailure failure = add_failure(0.3, 1);
  failure.smallest = "missing";
  EXPECT_THROW(explain({failure}), Error);
}

TEST(ExaminedFailures, AreReadAsTheyWereWritten) {
  ExaminedFailure failure;
  failure.found = "random candidate 3 of the search";
  failure.command = "slalom-evaluate \"out a/failures.ini\"";
  failure.smallest = "01";
  failure.compared = "02";
  failure.neighbors = {"03", "04"};
  failure.obstacles = 2;
  failure.bottleneck_width = 2.7000000000000002;
  failure.independent = false;
  const std::string text = to_json(ExaminedFailures{"mine", 3, {failure, {}}});
  const ExaminedFailures read = examined_failures_from_json(text, "examined.json");
  EXPECT_EQ(to_json(read), text);
  EXPECT_EQ(read.method, "mine");
  EXPECT_EQ(read.repetition, 3);
  ASSERT_EQ(read.failures.size(), 2U);
  EXPECT_EQ(read.failures[0].command, failure.command);
  EXPECT_EQ(read.failures[0].neighbors, failure.neighbors);
  EXPECT_EQ(read.failures[0].bottleneck_width, failure.bottleneck_width);
  EXPECT_FALSE(read.failures[0].independent);
  EXPECT_TRUE(read.failures[1].independent);
}

TEST(ExaminedFailures, RefuseMalformedText) {
  for (const char* text : {"", "[]", "{\"method\": \"mine\"}", "{\"method\": 1}"})
    EXPECT_TRUE(throws_error(ErrorKind::File, "examined.json", {"slalom-falsify"}, [&] {
      examined_failures_from_json(text, "examined.json");
    })) << text;
}

}  // namespace
}  // namespace slalom
