#include <slalom/analysis/cell.h>
#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <functional>
#include <set>

namespace slalom {
namespace {

const std::string kSuccess = "success";

/// Success as the outcome tells it, for results that do not have it among their metrics. Runs that
/// say nothing about the method count neither way.
Value success_of_outcome(const std::string& outcome) {
  if (outcome == "infrastructure_error" || outcome == "unsolvable_scenario") {
    return Value::na(outcome);
  }
  return Value::of(outcome == kSuccess ? 1 : 0);
}

bool contains(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

QuantityInfo info_of(const ResultTable& table, const std::string& id) {
  const auto known = table.quantities.find(id);
  if (known != table.quantities.end()) return known->second;
  if (id == kSuccess) return {id, 1, "Success", "-", Direction::Up};
  return {id, 1, id, "-", Direction::None};
}

Error unknown_column(const std::string& id, std::vector<std::string> candidates) {
  const std::string nearest = nearest_name(id, candidates);
  return usage_error("columns", "no metric '" + id + "' in these results",
                     nearest.empty() ? "one of " + join(candidates, ", ") : "'" + nearest + "'");
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
  if (cell.interval) cell.interval = within(range_of(values.info().id), *cell.interval);
}

/// The values of some runs, and their sums by scenario.
struct Gathered {
  std::vector<double> numbers;
  GroupSums groups;
};

/// Runs come by scenario as a rule, so that equal neighbours make a group; otherwise groups are
/// merged by scenario.
Gathered gather(Cell& cell, const RunColumns& table, const std::vector<std::size_t>& runs,
                const ValueColumn& values) {
  Gathered gathered;
  gathered.numbers.reserve(runs.size());
  std::vector<std::uint32_t> scenarios;
  GroupSums& groups = gathered.groups;
  const std::string* reason = nullptr;  // of the last value that was missing
  std::size_t* missing = nullptr;       // and how often it was
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

/// Columns with these ids, of those that there are.
std::vector<Column> choose_columns(const std::vector<Column>& there,
                                   const std::vector<std::string>& ids) {
  std::vector<Column> columns;
  for (const std::string& id : ids) {
    const auto found = std::find_if(there.begin(), there.end(),
                                    [&id](const Column& column) { return column.info.id == id; });
    if (found == there.end()) {
      std::vector<std::string> names;
      for (const Column& column : there) names.push_back(column.info.id);
      throw unknown_column(id, names);
    }
    columns.push_back(*found);
  }
  if (columns.empty()) throw usage_error("columns", "none asked for", "metric ids");
  return columns;
}

}  // namespace

void require_valid(const AnalysisOptions& options) {
  if (options.confidence > 0 && options.confidence < 1) return;
  throw usage_error("confidence", format_number(options.confidence), "a number between 0 and 1");
}

std::vector<std::string> metric_ids(const ResultTable& table) {
  std::set<std::string> ids;
  for (const RunRecord& run : table.runs) {
    for (const auto& [id, value] : run.metrics) ids.insert(id);
  }
  return {ids.begin(), ids.end()};
}

std::vector<std::string> wall_clock_ids(const ResultTable& table) {
  std::set<std::string> ids;
  for (const RunTiming& timing : table.timings) {
    for (const auto& [id, value] : timing.values) ids.insert(id);
  }
  return {ids.begin(), ids.end()};
}

std::vector<Column> resolve_columns(const ResultTable& table, const std::vector<std::string>& ids) {
  std::vector<std::string> metrics = metric_ids(table);
  if (table.runs.empty()) {
    for (const auto& [id, info] : table.quantities) metrics.push_back(id);
  }
  if (!contains(metrics, kSuccess)) metrics.push_back(kSuccess);
  std::vector<Column> there;
  for (const std::string& id : metrics) {
    there.push_back({info_of(table, id), id == kSuccess, false});
  }
  for (const std::string& id : wall_clock_ids(table)) {
    there.push_back({{id, 1, id, timing_unit(id), Direction::Down}, false, true});
  }
  return choose_columns(there, ids);
}

std::vector<Column> resolve_columns(const RunColumns& table, const std::vector<std::string>& ids) {
  std::vector<Column> there;
  for (const ValueColumn& column : table.metrics) {
    there.push_back({column.info(), column.rate, column.wall_clock});
  }
  return choose_columns(there, ids);
}

Value column_value(const ResultTable& table, std::size_t run, const Column& column) {
  const std::string& id = column.info.id;
  if (column.wall_clock) {
    if (run >= table.timings.size()) return Value::na("not recorded");
    const auto& values = table.timings[run].values;
    const auto found = values.find(id);
    return found == values.end() ? Value::na("not recorded") : Value::of(found->second);
  }
  const auto& metrics = table.runs[run].metrics;
  const auto found = metrics.find(id);
  if (found == metrics.end()) {
    return column.rate ? success_of_outcome(table.runs[run].outcome) : Value::na("not recorded");
  }
  if (found->second.version != column.info.version && !found->second.value.is_na()) {
    return Value::na("other version " + std::to_string(found->second.version));
  }
  return found->second.value;
}

std::size_t count_failures(const RunColumns& table, const std::vector<std::size_t>& runs) {
  std::vector<bool> failure;
  for (const std::string& outcome : table.outcomes) failure.push_back(is_failure(outcome));
  std::size_t failures = 0;
  for (const std::size_t run : runs) failures += failure[table.outcome[run]] ? 1 : 0;
  return failures;
}

Cell make_cell(const RunColumns& table, const std::vector<std::size_t>& runs,
               const ValueColumn& values, const AnalysisOptions& options,
               const std::string& label) {
  return make_cell(table, runs, count_failures(table, runs), values, options, label);
}

Cell make_cell(const RunColumns& table, const std::vector<std::size_t>& runs, std::size_t failures,
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

std::vector<std::string> method_names(const ResultTable& table) {
  std::set<std::string> names;
  for (const RunRecord& run : table.runs) names.insert(run.method);
  return {names.begin(), names.end()};
}

}  // namespace slalom
