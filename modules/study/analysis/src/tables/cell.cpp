// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cell.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

void add_interval(Cell& cell, const CellSums& sums, const QuantityInfo& info, double confidence,
                  const std::function<std::size_t(std::uint32_t)>& rank_of) {
  const GroupMoments moments = sums.moments();
  if (info.is_rate()) {
    cell.interval = rate_interval(moments, confidence);
  } else if (!info.range.is_bounded()) {
    cell.interval_na = missing_bound(info.range);
  } else if (!is_within(info.range, moments.mean)) {
    cell.interval_na = "values outside " + range_notation(info.range);
  } else if (info.kind == QuantityKind::Score) {
    cell.interval = hurdle_interval(sums.score_moments(), info.range.high, confidence);
  } else {
    cell.interval = gaffke_interval(moments, sums.groups(rank_of), info.range, confidence);
    if (!cell.interval) cell.interval_na = "values outside " + range_notation(info.range);
  }
}

/// The runs by scenario; those of a scenario keep their order.
std::vector<std::size_t> by_scenario(const ResultTable& table, std::vector<std::size_t> runs) {
  std::stable_sort(runs.begin(), runs.end(), [&](std::size_t a, std::size_t b) {
    return table.scenario[a] < table.scenario[b];
  });
  return runs;
}

std::size_t count_failures(const ResultTable& table, const std::vector<std::size_t>& runs) {
  std::vector<bool> failure;
  for (const std::string& outcome : table.outcomes) failure.push_back(is_failure(outcome));
  std::size_t failures = 0;
  for (const std::size_t run : runs) failures += failure[table.outcome[run]] ? 1 : 0;
  return failures;
}

}  // namespace

void require_valid(const AnalysisOptions& options) {
  if (options.confidence > 0 && options.confidence < 1) return;
  throw usage_error("confidence", format_number(options.confidence), "a number between 0 and 1");
}

Error unknown_metric(const std::string& id, const std::vector<std::string>& known) {
  const std::string reason =
      starts_with(id, "cycle_time_") ? ": methods that follow the wall clock have none" : "";
  return usage_error("metric '" + id + "'", "not in these results" + reason,
                     expected_name(id, known));
}

void require_readable(const ResultTable& table, const std::string& where, const std::string& id) {
  for (const auto& [name, why] : table.unread)
    if (name == id)
      throw usage_error(where, "'" + id + "' of " + table.source + " is not used (" + why + ")",
                        "numbers, or words such as NA");
}

bool states_median(const QuantityInfo& info) {
  return !info.is_rate() && !info.range.is_bounded();
}

bool is_survivors_only(std::size_t runs, std::size_t available) {
  return available > 0 && 10 * (runs - available) > runs;
}

std::vector<Column> resolve_columns(const ResultTable& table, const std::vector<std::string>& ids) {
  std::vector<Column> columns;
  for (const std::string& id : ids) {
    const ValueColumn* column = find_metric(table, id);
    if (column == nullptr) {
      require_readable(table, "columns", id);
      std::vector<std::string> known;
      for (const ValueColumn& other : table.metrics) known.push_back(other.info().id);
      throw unknown_metric(id, known);
    }
    columns.push_back({column->info(), column->wall_clock});
  }
  if (columns.empty()) throw usage_error("columns", "no columns specified", "metric ids");
  return columns;
}

Cell make_cell(const CellSums& sums, std::size_t runs, std::size_t failures, const Column& column,
               const AnalysisOptions& options,
               const std::function<std::size_t(std::uint32_t)>& rank_of) {
  Cell cell;
  cell.n = runs;
  cell.failures = failures;
  cell.available = sums.available();
  cell.na = sums.na();
  if (cell.available == 0) return cell;
  cell.estimate = sums.mean();
  cell.deviation = sums.deviation();
  add_interval(cell, sums, column.info, options.confidence, rank_of);
  return cell;
}

std::vector<double> numbers_of(const ValueColumn& values, const std::vector<std::size_t>& runs) {
  std::vector<double> numbers;
  numbers.reserve(runs.size());
  for (const std::size_t run : runs)
    if (!values.is_na(run)) numbers.push_back(values.number(run));
  return numbers;
}

void add_medians(Cell& cell, const ResultTable& table, const std::vector<std::size_t>& runs,
                 const ValueColumn& values, double confidence) {
  std::vector<double> numbers = numbers_of(values, runs);
  if (numbers.empty()) return;
  if (states_median(values.info())) {
    std::vector<std::size_t> sizes;
    std::vector<double> ordered;
    std::uint32_t last = 0;
    for (const std::size_t run : by_scenario(table, runs)) {
      if (values.is_na(run)) continue;
      if (ordered.empty() || table.scenario[run] != last) sizes.push_back(0);
      last = table.scenario[run];
      ++sizes.back();
      ordered.push_back(values.number(run));
    }
    cell.median_interval = median_interval(ordered, sizes, confidence);
  }
  const MiddleValues middle = middle_values(std::move(numbers));
  cell.median = middle.median;
  cell.interquartile_mean = middle.interquartile_mean;
}

Cell make_cell(const ResultTable& table, const std::vector<std::size_t>& runs,
               const ValueColumn& values, const AnalysisOptions& options) {
  RowSums sums(1);
  std::vector<double> value(RowSums::padded(1));
  for (const std::size_t run : by_scenario(table, runs)) {
    value[0] = values.number(run);
    if (values.is_na(run)) sums.add_na(0, values.reason(run));
    sums.add(value.data(), table.scenario[run]);
  }
  sums.end_part([](std::uint32_t scenario) { return scenario; });
  Cell cell = make_cell(sums.cell(0), runs.size(), count_failures(table, runs),
                        {values.info(), values.wall_clock}, options);
  add_medians(cell, table, runs, values, options.confidence);
  return cell;
}

}  // namespace slalom
