#include <slalom/results/run_columns.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <set>

namespace slalom {
namespace {

constexpr std::uint64_t kQuietNan = 0x7FF8000000000000u;

double nan_with(std::uint32_t payload) {
  const std::uint64_t bits = kQuietNan | payload;
  double number = 0;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

std::uint32_t payload_of(double nan) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &nan, sizeof bits);
  return static_cast<std::uint32_t>(bits);
}

bool says_nothing_of_method(const std::string& outcome) {
  return outcome == "infrastructure_error" || outcome == "unsolvable_scenario" ||
         outcome == kUnknownOutcome;
}

QuantityInfo info_of(const ResultTable& table, const std::string& id) {
  const auto known = table.quantities.find(id);
  if (known != table.quantities.end()) return known->second;
  return {id, 1, id, "-", Direction::None};
}

void add_versioned(ValueColumn& column, const std::map<std::string, VersionedValue>& values,
                   const char* otherwise) {
  const auto found = values.find(column.info().id);
  if (found == values.end()) {
    column.add_na(otherwise);
  } else if (found->second.version != column.info().version && !found->second.value.is_na()) {
    column.add_na("other version " + std::to_string(found->second.version));
  } else {
    column.add(found->second.value);
  }
}

void add_metrics(RunColumns& columns, const ResultTable& table) {
  std::set<std::string> ids;
  for (const RunRecord& run : table.runs) {
    for (const auto& [id, value] : run.metrics) ids.insert(id);
  }
  // Without runs nobody knows which quantities are metrics: all may be asked for.
  if (table.runs.empty()) {
    for (const auto& [id, info] : table.quantities) ids.insert(id);
  }
  for (const std::string& id : ids) {
    ValueColumn& column = columns.metrics.emplace_back(info_of(table, id));
    column.rate = id == "success";
    column.reserve(table.runs.size());
    for (const RunRecord& run : table.runs) add_versioned(column, run.metrics, "not recorded");
  }
}

void add_timings(RunColumns& columns, const ResultTable& table) {
  std::set<std::string> ids;
  for (const RunTiming& timing : table.timings) {
    for (const auto& [id, value] : timing.values) ids.insert(id);
  }
  for (const std::string& id : ids) {
    ValueColumn& column =
        columns.metrics.emplace_back(QuantityInfo{id, 1, id, timing_unit(id), Direction::Down});
    column.wall_clock = true;
    for (std::size_t run = 0; run < table.runs.size(); ++run) {
      const bool there = run < table.timings.size() && table.timings[run].values.count(id) > 0;
      column.add(there ? Value::of(table.timings[run].values.at(id)) : Value::na("not recorded"));
    }
  }
}

void add_descriptors(RunColumns& columns, const ResultTable& table) {
  std::set<std::string> ids;
  for (const auto& [hash, scenario] : table.scenarios) {
    for (const auto& [id, value] : scenario.descriptors) ids.insert(id);
  }
  const ScenarioRecord unknown;
  for (const std::string& id : ids) {
    ValueColumn& column = columns.descriptors.emplace_back(info_of(table, id));
    for (const std::string& hash : columns.scenario_hashes) {
      const auto found = table.scenarios.find(hash);
      const ScenarioRecord& scenario = found == table.scenarios.end() ? unknown : found->second;
      add_versioned(column, scenario.descriptors, "not computed");
    }
  }
}

template <typename T>
void reorder_values(std::vector<T>& values, const std::vector<std::size_t>& order) {
  std::vector<T> result;
  result.reserve(values.size());
  for (const std::size_t place : order) result.push_back(values[place]);
  values = std::move(result);
}

const ValueColumn* find(const std::vector<ValueColumn>& columns, const std::string& id) {
  const auto found = std::find_if(columns.begin(), columns.end(), [&id](const ValueColumn& column) {
    return column.info().id == id;
  });
  return found == columns.end() ? nullptr : &*found;
}

}  // namespace

void ValueColumn::add(const Value& value) {
  if (value.is_na()) {
    add_na(value.reason());
  } else {
    add_number(value.number());
  }
}

void ValueColumn::add_number(double number) {
  if (std::isfinite(number)) {
    numbers_.push_back(number);
  } else {
    add_na("not a finite number");
  }
}

void ValueColumn::add_na(const std::string& reason) {
  const auto [place, added] =
      places_.try_emplace(reason, static_cast<std::uint32_t>(reasons_.size()));
  if (added) reasons_.push_back(reason);
  numbers_.push_back(nan_with(place->second));
}

const std::string& ValueColumn::reason(std::size_t row) const {
  return reasons_[payload_of(numbers_[row])];
}

void ValueColumn::reorder(const std::vector<std::size_t>& order) {
  reorder_values(numbers_, order);
}

void reorder_runs(RunColumns& columns, const std::vector<std::size_t>& order) {
  for (auto* values : {&columns.scenario, &columns.method, &columns.outcome, &columns.repetition}) {
    reorder_values(*values, order);
  }
  for (ValueColumn& column : columns.metrics) column.reorder(order);
}

void reorder_scenarios(RunColumns& columns, const std::vector<std::size_t>& order) {
  std::vector<std::uint32_t> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = static_cast<std::uint32_t>(i);
  reorder_values(columns.scenario_hashes, order);
  reorder_values(columns.scenario_names, order);
  for (ValueColumn& column : columns.descriptors) column.reorder(order);
  for (std::uint32_t& scenario : columns.scenario) scenario = place[scenario];
}

std::uint32_t NameIndex::place_of(const std::string& name) {
  const auto [place, added] = places_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
  if (added) names_.push_back(name);
  return place->second;
}

void sort_methods(RunColumns& columns) {
  std::vector<std::string> sorted = columns.methods;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> place;
  for (const std::string& name : columns.methods) {
    const auto found = std::lower_bound(sorted.begin(), sorted.end(), name);
    place.push_back(static_cast<std::uint32_t>(found - sorted.begin()));
  }
  columns.methods = std::move(sorted);
  for (std::uint32_t& method : columns.method) method = place[method];
}

RunColumns to_columns(const ResultTable& table) {
  RunColumns columns;
  columns.manifest = table.manifest;
  NameIndex scenarios(columns.scenario_hashes), methods(columns.methods),
      outcomes(columns.outcomes);
  for (const RunRecord& run : table.runs) {
    columns.scenario.push_back(scenarios.place_of(run.scenario_hash));
    if (columns.scenario.back() == columns.scenario_names.size()) {
      columns.scenario_names.push_back(run.scenario_name);
    }
    columns.method.push_back(methods.place_of(run.method));
    columns.outcome.push_back(outcomes.place_of(run.outcome));
    columns.repetition.push_back(static_cast<std::uint32_t>(run.repetition));
  }
  // Bins are made of all scenarios, driven or not.
  for (const auto& [hash, scenario] : table.scenarios) {
    if (scenarios.place_of(hash) == columns.scenario_names.size()) {
      columns.scenario_names.push_back(scenario.name);
    }
  }
  sort_methods(columns);
  add_metrics(columns, table);
  add_success(columns);
  add_timings(columns, table);
  add_descriptors(columns, table);
  return columns;
}

void add_success(RunColumns& columns) {
  if (find_metric(columns, "success") != nullptr) return;
  ValueColumn& column =
      columns.metrics.emplace_back(QuantityInfo{"success", 1, "Success", "-", Direction::Up});
  column.rate = true;
  for (const std::uint32_t place : columns.outcome) {
    const std::string& outcome = columns.outcomes[place];
    if (says_nothing_of_method(outcome)) {
      column.add_na(outcome);
    } else {
      column.add_number(outcome == "success" ? 1 : 0);
    }
  }
}

const ValueColumn* find_metric(const RunColumns& columns, const std::string& id) {
  return find(columns.metrics, id);
}

const ValueColumn* find_descriptor(const RunColumns& columns, const std::string& id) {
  return find(columns.descriptors, id);
}

std::string run_id(const RunColumns& columns, std::size_t run) {
  return columns.scenario_hashes[columns.scenario[run]].substr(0, 8) + "/" +
         columns.methods[columns.method[run]] + "/" + std::to_string(columns.repetition[run]);
}

bool is_failure(const std::string& outcome) {
  return outcome != "success" && !says_nothing_of_method(outcome);
}

}  // namespace slalom
