#include <slalom/analysis/cell.h>
#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>

#include <algorithm>
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

void add_interval(Cell& cell, const Column& column, const ScenarioGroups& groups,
                  const AnalysisOptions& options, const std::string& label) {
  if (column.rate) {
    cell.interval =
        wilson_interval(*cell.estimate, effective_sample_size(groups), options.confidence);
    return;
  }
  RandomEngine engine(derive_seed(options.seed, label));
  cell.interval = mean_interval(groups, options.confidence, engine);
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
  if (!contains(metrics, kSuccess)) metrics.push_back(kSuccess);
  const std::vector<std::string> clocks = wall_clock_ids(table);
  std::vector<Column> columns;
  for (const std::string& id : ids) {
    if (contains(metrics, id) || (table.runs.empty() && table.quantities.count(id) > 0)) {
      columns.push_back({info_of(table, id), id == kSuccess, false});
    } else if (contains(clocks, id)) {
      columns.push_back({{id, 1, id, timing_unit(id), Direction::Down}, false, true});
    } else {
      metrics.insert(metrics.end(), clocks.begin(), clocks.end());
      throw unknown_column(id, metrics);
    }
  }
  if (columns.empty()) throw usage_error("columns", "none asked for", "metric ids");
  return columns;
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

Cell make_cell(const ResultTable& table, const std::vector<std::size_t>& runs, const Column& column,
               const AnalysisOptions& options, const std::string& label) {
  Cell cell;
  cell.n = runs.size();
  std::vector<double> values;
  std::map<std::string, std::vector<double>> by_scenario;
  for (const std::size_t run : runs) {
    const Value value = column_value(table, run, column);
    if (value.is_na()) {
      ++cell.na[value.reason()];
      continue;
    }
    values.push_back(value.number());
    by_scenario[table.runs[run].scenario_hash].push_back(value.number());
  }
  cell.available = values.size();
  if (values.empty()) return cell;
  ScenarioGroups groups;
  for (auto& [hash, group] : by_scenario) groups.push_back(std::move(group));
  cell.estimate = mean(values);
  cell.deviation = standard_deviation(values);
  cell.median = median(values);
  add_interval(cell, column, groups, options, label);
  return cell;
}

std::vector<std::string> method_names(const ResultTable& table) {
  std::set<std::string> names;
  for (const RunRecord& run : table.runs) names.insert(run.method);
  return {names.begin(), names.end()};
}

}  // namespace slalom
