// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "io_sample.h"

#include <slalom/core/read_file.h>
#include <slalom/io/find_run.h>
#include <slalom/io/imported_table.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace slalom {
namespace {

/// Ids that SQLite could mistake for each other, or for more than a name.
const char* const kIds[] = {
    "time", "Time", "TIME",   "path length",        "%74ime", "a\"); DROP TABLE runs",
    "",     "é",    "m_time", "unconditional time", "1"};

class ImportedTable : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "x.results";

  /// `columns` rows of random values, in no order, of three methods in two scenarios.
  static ResultTable random_table(std::mt19937& random) {
    ResultTable table;
    table.source = "x.csv";
    table.scenario_hashes = {"row9 of x.csv", "hall"};
    table.scenario_names = {"row9", "hall"};
    table.methods = {"c", "a", "b*"};
    table.outcomes = {kUnknownOutcome, "failure", "success", "collision"};
    std::vector<std::uint32_t> keys(24);
    std::iota(keys.begin(), keys.end(), 0);
    std::shuffle(keys.begin(), keys.end(), random);
    for (const std::uint32_t key : keys) {
      table.scenario.push_back(key % 2);
      table.method.push_back(key / 2 % 3);
      table.repetition.push_back(key / 6 * 700000000);
      table.outcome.push_back(static_cast<std::uint32_t>(random() % 4));
    }
    for (const char* id : kIds) {
      const QuantityInfo info{
          id, 2, "name", "m", Direction::Down, QuantityKind::Ratio, Range::at_least(-2)};
      table.metrics.push_back(random_column(info, table.size(), random));
      if (random() % 2 == 0)
        table.unconditional.push_back(random_column(info, table.size(), random));
    }
    sort_names(table);
    return table;
  }

  static ValueColumn random_column(const QuantityInfo& info, std::size_t rows,
                                   std::mt19937& random) {
    ValueColumn column(info);
    while (column.size() < rows) {
      if (random() % 3 == 0)
        column.add_na(random() % 2 == 0 ? "inf" : "outcome: timeout");
      else
        column.add_number(std::uniform_real_distribution(-2.0, 9.0)(random));
    }
    return column;
  }

  static void expect_equal(const std::vector<ValueColumn>& there,
                           const std::vector<ValueColumn>& here) {
    ASSERT_EQ(there.size(), here.size());
    for (const ValueColumn& column : here) {
      const auto found = std::find_if(there.begin(), there.end(), [&](const ValueColumn& other) {
        return other.info().id == column.info().id;
      });
      ASSERT_NE(found, there.end()) << column.info().id;
      EXPECT_EQ(found->info().unit, "m");
      EXPECT_EQ(found->info().version, 2);
      EXPECT_EQ(found->info().kind, QuantityKind::Ratio);
      EXPECT_EQ(range_notation(found->info().range), "-2..");
      for (std::size_t row = 0; row < column.size(); ++row) {
        ASSERT_EQ(found->is_na(row), column.is_na(row));
        if (column.is_na(row))
          EXPECT_EQ(found->reason(row), column.reason(row));
        else
          EXPECT_EQ(found->number(row), column.number(row));
      }
    }
  }
};

TEST_F(ImportedTable, IsReadAsItWasWritten) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const ResultTable table = random_table(random);
    write_imported(table, path_);
    const ResultTable read = read_results(path_);
    EXPECT_EQ(read.methods, table.methods);
    EXPECT_EQ(read.outcomes, table.outcomes);
    EXPECT_EQ(read.method, table.method);
    EXPECT_EQ(read.outcome, table.outcome);
    EXPECT_EQ(read.repetition, table.repetition);
    ASSERT_EQ(read.size(), table.size());
    for (std::size_t run = 0; run < table.size(); ++run) {
      EXPECT_EQ(read.scenario_hashes[read.scenario[run]],
                table.scenario_hashes[table.scenario[run]]);
      EXPECT_EQ(read.scenario_names[read.scenario[run]], table.scenario_names[table.scenario[run]]);
    }
    expect_equal(read.metrics, table.metrics);
    expect_equal(read.unconditional, table.unconditional);
    EXPECT_TRUE(read.damaged.empty());
    EXPECT_TRUE(read.details.empty());
  }
}

TEST_F(ImportedTable, HasTheValuesOfFailuresOfARequestedColumn) {
  std::mt19937 random(2);
  ResultTable table = random_table(random);
  table.unconditional = {random_column(table.metrics[3].info(), table.size(), random)};
  write_imported(table, path_);
  const ResultTable read = read_results(path_, {{"path length"}});
  expect_equal(read.metrics, {table.metrics[3]});
  expect_equal(read.unconditional, table.unconditional);
}

TEST_F(ImportedTable, FindsRunsByNamesOfScenariosThatAreShorterThanAHash) {
  std::mt19937 random(3);
  write_imported(random_table(random), path_);
  const ResultFile file = ResultFile::open(path_);
  EXPECT_EQ(find_run(file, "hall/b*/0").method, "b*");
  EXPECT_EQ(find_run(file, "row9/a/700000000").repetition, 700000000);
}

TEST_F(ImportedTable, SaysThatItHasNoScenarios) {
  std::mt19937 random(4);
  write_imported(random_table(random), path_);
  const ResultFile file = ResultFile::open(path_);
  const std::string expected =
      path_ +
      ": is an imported table, without scenarios and settings; expected results of "
      "slalom-evaluate or slalom-simulate";
  EXPECT_EQ(error_text(ErrorKind::File, [&] { file.read_scenario("hall"); }), expected);
  EXPECT_EQ(error_text(ErrorKind::File, [&] { file.read_references("hall"); }), expected);
}

TEST_F(ImportedTable, DoesNotReplaceTheRunsOfACampaign) {
  std::mt19937 random(6);
  const ResultTable table = random_table(random);
  ResultFile::create(path_, {{"campaign", "mine"}}, {}, {});
  EXPECT_EQ(error_text(ErrorKind::File, [&] { write_imported(table, path_); }),
            path_ + ": contains runs of a campaign; expected an imported table, or a new file");
  EXPECT_EQ(ResultFile::open(path_).read_manifest().at("campaign"), "mine");
}

TEST_F(ImportedTable, RefusesTwoRowsOfOneRepetition) {
  std::mt19937 random(5);
  ResultTable table = random_table(random);
  for (std::size_t run = 0; run < 2; ++run) {
    table.scenario[run] = table.method[run] = 1;
    table.repetition[run] = 7;
  }
  EXPECT_EQ(error_text(ErrorKind::Usage, [&] { write_imported(table, path_); }),
            "x.csv: hall, b*: two rows of repetition 7; expected each once; another column with "
            "--repetition-column NAME");
  table.repetition[0] = std::numeric_limits<std::uint32_t>::max();
  EXPECT_NE(error_text(ErrorKind::Usage, [&] { write_imported(table, path_); })
                .find("at most 2147483647"),
            std::string::npos);
  EXPECT_FALSE(ResultFile::exists(path_));
}

TEST_F(ImportedTable, ReplacesNoFileOfAnotherKind) {
  std::mt19937 random(6);
  write_file_atomically(path_, "my thesis");
  EXPECT_TRUE(throws_error(ErrorKind::File, path_, {"result file"},
                           [&] { write_imported(random_table(random), path_); }));
  EXPECT_EQ(read_text(path_, "a text"), "my thesis");
}

}  // namespace
}  // namespace slalom
