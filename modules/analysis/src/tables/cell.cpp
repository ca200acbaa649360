#include <slalom/analysis/cell.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <functional>

namespace slalom {
namespace {

Error unknown_column(const std::string& id, const ResultTable& table) {
  std::vector<std::string> candidates;
  for (const ValueColumn& column : table.metrics) candidates.push_back(column.info().id);
  return usage_error("columns", "no metric '" + id + "' in these results",
                     expected_name(id, candidates));
}

void add_interval(Cell& cell, const ValueColumn& values, const GroupSums& groups,
                  const AnalysisOptions& options, const std::string& label) {
  if (values.rate) {
    cell.interval =
        wilson_interval(*cell.estimate, effective_sample_size(groups), options.confidence);
    return;
  }
  RandomEngine engine(derive_seed(options.seed, label));
  cell.interval = mean_interval(groups, options.confidence, engine);
  if (cell.interval) cell.interval = clip_to_range(range_of(values.info().id), *cell.interval);
}

/// The values of some runs, and their sums by scenario.
struct Gathered {
  std::vector<double> numbers;
  GroupSums groups;
};

/// Runs are usually ordered by scenario, so that consecutive runs form a group; otherwise groups
/// are merged by scenario.
Gathered gather(Cell& cell, const ResultTable& table, const std::vector<std::size_t>& runs,
                const ValueColumn& values) {
  Gathered gathered;
  gathered.numbers.reserve(runs.size());
  std::vector<std::uint32_t> scenarios;
  GroupSums& groups = gathered.groups;
  const std::string* reason = nullptr;  // of the last missing value
  std::size_t* missing = nullptr;       // the count of that reason
  for (const std::size_t run : runs) {
    if (values.is_na(run)) {
      if (reason != &values.reason(run)) missing = &cell.na[values.reason(run)];
      reason = &values.reason(run);
      ++*missing;
      continue;
    }
    const double number = values.number(run);
    gathered.numbers.push_back(number);
    if (scenarios.empty() || scenarios.back() != table.scenario[run]) {
      scenarios.push_back(table.scenario[run]);
      groups.sums.push_back(0);
      groups.sizes.push_back(0);
    }
    groups.sums.back() += number;
    groups.sizes.back() += 1;
  }
  if (std::adjacent_find(scenarios.begin(), scenarios.end(), std::greater_equal<>()) ==
      scenarios.end()) {
    return gathered;
  }
  std::map<std::uint32_t, std::pair<double, double>> merged;
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    merged[scenarios[i]].first += groups.sums[i];
    merged[scenarios[i]].second += groups.sizes[i];
  }
  groups = {};
  for (const auto& [scenario, group] : merged) {
    groups.sums.push_back(group.first);
    groups.sizes.push_back(group.second);
  }
  return gathered;
}

}  // namespace

void require_valid(const AnalysisOptions& options) {
  if (options.confidence > 0 && options.confidence < 1) return;
  throw usage_error("confidence", format_number(options.confidence), "a number between 0 and 1");
}

std::vector<Column> resolve_columns(const ResultTable& table, const std::vector<std::string>& ids) {
  std::vector<Column> columns;
  for (const std::string& id : ids) {
    const ValueColumn* column = find_metric(table, id);
    if (column == nullptr) throw unknown_column(id, table);
    columns.push_back({column->info(), column->rate, column->wall_clock});
  }
  if (columns.empty()) throw usage_error("columns", "no columns specified", "metric ids");
  return columns;
}

std::size_t count_failures(const ResultTable& table, const std::vector<std::size_t>& runs) {
  std::vector<bool> failure;
  for (const std::string& outcome : table.outcomes) failure.push_back(is_failure(outcome));
  std::size_t failures = 0;
  for (const std::size_t run : runs) failures += failure[table.outcome[run]] ? 1 : 0;
  return failures;
}

Cell make_cell(const ResultTable& table, const std::vector<std::size_t>& runs,
               const ValueColumn& values, const AnalysisOptions& options,
               const std::string& label) {
  return make_cell(table, runs, count_failures(table, runs), values, options, label);
}

Cell make_cell(const ResultTable& table, const std::vector<std::size_t>& runs, std::size_t failures,
               const ValueColumn& values, const AnalysisOptions& options,
               const std::string& label) {
  Cell cell;
  cell.n = runs.size();
  cell.failures = failures;
  Gathered gathered = gather(cell, table, runs, values);
  cell.available = gathered.numbers.size();
  if (gathered.numbers.empty()) return cell;
  cell.estimate = mean(gathered.numbers);
  cell.deviation = standard_deviation(gathered.numbers);
  const MiddleValues middle = middle_values(std::move(gathered.numbers));
  cell.median = middle.median;
  cell.interquartile_mean = middle.interquartile_mean;
  add_interval(cell, values, gathered.groups, options, label);
  return cell;
}

}  // namespace slalom
