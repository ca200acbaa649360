// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "result_fixture.h"

#include <slalom/analysis/table_export.h>
#include <slalom/analysis/table_sums.h>
#include <slalom/analysis/table_text.h>
#include <slalom/core/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slalom {
namespace {

TEST(PreciseSum, DoesNotDependOnTheOrderOfItsTerms) {
  PreciseSum canceling;
  for (const double term : {1e16, 1.0, 1e-5, -1e16}) canceling.add(term);
  EXPECT_EQ(canceling.value(), 1 + 1e-5);
  RandomEngine engine(1);
  std::vector<double> terms;
  for (int i = 0; i < 5000; ++i) terms.push_back(std::pow(10, uniform_real(engine, -6, 6)));
  PreciseSum sum, reversed, squares, squares_reversed;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const double last = terms[terms.size() - 1 - i];
    sum.add(terms[i]);
    reversed.add(last);
    squares.add_product(terms[i], terms[i]);
    squares_reversed.add_product(last, last);
  }
  EXPECT_EQ(sum.value(), reversed.value());
  EXPECT_EQ(squares.value(), squares_reversed.value());
}

/// The sums of a row with one cell.
class OneCell {
 public:
  void add(double value, std::uint32_t scenario) {
    values_[0] = value;
    row_.add(values_.data(), scenario);
  }
  CellSums sums() {
    row_.end_part([](std::uint32_t scenario) { return scenario; });
    return row_.cell(0);
  }

 private:
  RowSums row_{1};
  std::vector<double> values_ = std::vector<double>(RowSums::padded(1));
};

TEST(CellSums, EqualValuesHaveNoDeviation) {
  OneCell cell;
  for (std::uint32_t i = 0; i < 1000; ++i) cell.add(0.1, i / 3);
  const CellSums sums = cell.sums();
  EXPECT_EQ(sums.mean(), 0.1);
  EXPECT_EQ(*sums.deviation(), 0);
}

TEST(CellSums, AgreesWithTheFormulasOverAllValues) {
  RandomEngine engine(3);
  OneCell cell;
  std::vector<double> values;
  ScenarioGroups groups;
  for (std::uint32_t i = 0; i < 40; ++i) {
    groups.emplace_back();
    for (std::uint32_t r = 0; r <= i % 3; ++r) {
      values.push_back(1000 + uniform_real(engine, 0, 1));
      groups.back().push_back(values.back());
      cell.add(values.back(), i);
    }
  }
  const CellSums sums = cell.sums();
  EXPECT_EQ(sums.available(), values.size());
  EXPECT_NEAR(sums.mean(), mean(values), 1e-10);
  EXPECT_NEAR(*sums.deviation(), *standard_deviation(values), 1e-10);
  const GroupMoments moments = sums.moments(), expected = moments_of(sums_of(groups));
  EXPECT_EQ(moments.groups, 40);
  EXPECT_EQ(moments.values, expected.values);
  EXPECT_NEAR(moments.residuals, expected.residuals, 1e-9);
  EXPECT_EQ(sums.groups().sums, sums_of(groups).sums);
}

TEST(RowSums, HasTheSumsOfEachCellAlone) {
  constexpr std::size_t kCells = 11;  // more than a vector has lanes, and no multiple of it
  const double none = std::numeric_limits<double>::quiet_NaN();
  RandomEngine engine(7);
  RowSums row(kCells);
  PreciseSum sums[kCells], squares[kCells];
  std::size_t available[kCells] = {}, scenarios[kCells] = {};
  std::vector<double> values(RowSums::padded(kCells), none);
  for (std::uint32_t scenario = 0; scenario < 300; ++scenario) {
    bool seen[kCells] = {};
    for (std::uint32_t run = 0; run <= scenario % 4; ++run) {
      for (std::size_t i = 0; i < kCells; ++i) {
        const bool is_na = uniform_real(engine, 0, 1) * kCells < static_cast<double>(i);
        values[i] = is_na ? none : std::pow(10, uniform_real(engine, -6, 6));
        if (is_na) continue;
        sums[i].add(values[i]);
        squares[i].add_product(values[i], values[i]);
        ++available[i];
        scenarios[i] += seen[i] ? 0 : 1;
        seen[i] = true;
      }
      row.add(values.data(), scenario);
    }
  }
  row.end_part([](std::uint32_t scenario) { return scenario; });
  for (std::size_t i = 0; i < kCells; ++i) {
    const CellSums cell = row.cell(i);
    const auto n = static_cast<double>(available[i]);
    ASSERT_EQ(cell.available(), available[i]);
    EXPECT_EQ(cell.mean(), sums[i].value() / n);
    EXPECT_EQ(cell.moments().groups, static_cast<double>(scenarios[i]));
    // The sum of squares by definition; the deviations from the mean lose none of its digits here.
    const double variance = (squares[i].value() - sums[i].value() * cell.mean()) / (n - 1);
    EXPECT_NEAR(*cell.deviation(), std::sqrt(variance), 1e-9 * std::sqrt(variance));
  }
}

/// The same random results as one table and as parts by scenario.
struct Divided {
  ResultTable whole;
  std::vector<ResultTable> parts;
};

Divided random_results(int scenarios) {
  RandomEngine engine(5);
  ResultFixture whole;
  std::vector<ResultFixture> parts(3);
  for (int i = 0; i < scenarios; ++i) {
    ResultFixture& part = parts[static_cast<std::size_t>(i * 7 % 3)];
    const Value density =
        i % 11 == 0 ? Value::na("too big") : Value::of(uniform_real(engine, 0, 1));
    const std::string hash = whole.add_scenario(density);
    part.add_scenario(density);
    part.table.scenario_hashes.back() = hash;
    part.table.scenario_names.back() = whole.table.scenario_names.back();
    for (const char* method : {"vff", "nd"}) {
      for (int repetition = i % 3; repetition >= 0; --repetition) {
        const double optimality = uniform_real(engine, -0.2, 1);
        whole.add_run(hash, method, optimality, repetition);
        part.add_run(hash, method, optimality, repetition);
      }
    }
  }
  Divided divided{whole.table, {parts[2].table, parts[0].table, parts[1].table}};
  sort_rows(divided.whole);
  for (ResultTable& part : divided.parts) sort_rows(part);
  return divided;
}

TEST(TableSums, PartsHaveTheTablesOfTheWhole) {
  const std::vector<std::string> metrics = {"success", "optimality", "cycle_time_mean"};
  const auto specs = parse_bin_specs("density:0,0.3,0.8;density:q3;all");
  AnalysisOptions options;
  options.run_ids = options.medians = false;
  for (const int scenarios : {12, 200, 1800}) {  // also more than kMaxKeptScenarios
    const Divided results = random_results(scenarios);
    std::vector<BinnedRows> rows;
    for (const BinSpec& spec : specs) rows.push_back(bin_rows(spec, results.whole));
    TableSums sums(rows, metrics);
    for (const ResultTable& part : results.parts) sums.add(part);
    EXPECT_EQ(render_csv(sums.cross_tables(options)),
              render_csv(build_cross_tables(results.whole, specs, metrics, options)));
    EXPECT_EQ(render_summary_text(sums.summary(2, options)),
              render_summary_text(build_summary(results.whole, metrics, options)));
    TableSums nd(rows, metrics, "nd");
    for (const ResultTable& part : results.parts) nd.add(part);
    EXPECT_EQ(render_csv(nd.cross_tables(options)),
              render_csv(build_cross_tables(results.whole, specs, metrics, options, "nd")));
  }
}

TEST(TableSums, AMetricThatAPartLacksIsMissingThere) {
  Divided results = random_results(30);
  auto& metrics = results.parts[0].metrics;
  metrics.erase(metrics.begin() + 3);  // cycle_time_mean
  TableSums sums({bin_rows({}, results.whole)}, {"cycle_time_mean"});
  for (const ResultTable& part : results.parts) sums.add(part);
  const Cell cell = sums.cross_tables({})[0].rows[0].cells[0];
  EXPECT_EQ(cell.na.at(kNotRecorded), cell.n - cell.available);
  EXPECT_GT(cell.available, 0U);
  EXPECT_GT(cell.n, cell.available);
}

TEST(TableSums, AnUnknownMetricSuggestsTheNearest) {
  const Divided results = random_results(3);
  TableSums sums({bin_rows({}, results.whole)}, {"optimalty"});
  sums.add(results.parts[0]);
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "metric 'optimalty': ", {"expected 'optimality'"},
                           [&] { sums.cross_tables({}); }));
}

}  // namespace
}  // namespace slalom
