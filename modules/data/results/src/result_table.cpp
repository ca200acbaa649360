// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/expect_text.h>
#include <slalom/core/text.h>
#include <slalom/results/lack_of_time.h>
#include <slalom/results/result_table.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>
#include <tuple>

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

bool is_inconclusive(const std::string& outcome) {
  return outcome == "infrastructure_error" || outcome == "unsolvable_scenario" ||
         outcome == kUnknownOutcome;
}

template <typename T>
void reorder_values(std::vector<T>& values, const std::vector<std::size_t>& order) {
  std::vector<T> result;
  result.reserve(order.size());
  for (const std::size_t index : order) result.push_back(std::move(values[index]));
  values = std::move(result);
}

/// Reorders runs: i gets what order[i] was; those that it does not name are lost.
void reorder_runs(ResultTable& columns, const std::vector<std::size_t>& order) {
  for (auto* values : {&columns.scenario, &columns.method, &columns.outcome, &columns.repetition}) {
    reorder_values(*values, order);
  }
  if (!columns.details.empty()) reorder_values(columns.details, order);
  for (auto* values : {&columns.metrics, &columns.unconditional})
    for (ValueColumn& column : *values) column.reorder(order);
}

/// The same of scenarios; the runs refer to their new positions.
void reorder_scenarios(ResultTable& columns, const std::vector<std::size_t>& order) {
  std::vector<std::uint32_t> index(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) index[order[i]] = static_cast<std::uint32_t>(i);
  reorder_values(columns.scenario_hashes, order);
  reorder_values(columns.scenario_names, order);
  for (ValueColumn& column : columns.descriptors) column.reorder(order);
  for (std::uint32_t& scenario : columns.scenario) scenario = index[scenario];
}

/// The runs by the rank of their scenario, method and repetition; empty if they are in that order.
std::vector<std::size_t> order_of_runs(const ResultTable& columns,
                                       const std::vector<std::size_t>& rank) {
  const auto key = [&](std::size_t run) {
    return std::tuple(rank[columns.scenario[run]], columns.method[run], columns.repetition[run]);
  };
  const auto before = [&](std::size_t a, std::size_t b) { return key(a) < key(b); };
  std::vector<std::size_t> order(columns.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (std::is_sorted(order.begin(), order.end(), before)) return {};
  // Counting sort, then a sort within each scenario: much faster than sorting all runs.
  std::vector<std::size_t> ends(rank.size() + 1, 0);
  for (const std::uint32_t scenario : columns.scenario) ++ends[rank[scenario] + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  for (std::size_t run = 0; run < columns.size(); ++run)
    order[ends[rank[columns.scenario[run]]]++] = run;
  const auto run_at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t i = 0; i < rank.size(); ++i) {
    const auto begin = run_at(i == 0 ? 0 : ends[i - 1]), end = run_at(ends[i]);
    if (!std::is_sorted(begin, end, before)) std::sort(begin, end, before);
  }
  return order;
}

/// Sorts names, and updates the indexes into them.
template <typename Less>
void sort_by(Less less, std::vector<std::string>& names, std::vector<std::uint32_t>& indexes) {
  std::vector<std::string> sorted = names;
  std::sort(sorted.begin(), sorted.end(), less);
  std::vector<std::uint32_t> moved;
  for (const std::string& name : names) {
    const auto found = std::lower_bound(sorted.begin(), sorted.end(), name, less);
    moved.push_back(static_cast<std::uint32_t>(found - sorted.begin()));
  }
  names = std::move(sorted);
  for (std::uint32_t& index : indexes) index = moved[index];
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
  numbers_.push_back(na_number(reason));
}

void ValueColumn::set_na(std::size_t row, const std::string& reason) {
  numbers_[row] = na_number(reason);
}

void ValueColumn::set_kind(QuantityKind kind, const Range& range) {
  info_.kind = kind;
  info_.range = range;
}

double ValueColumn::na_number(const std::string& reason) {
  const auto [index, added] =
      indexes_.try_emplace(reason, static_cast<std::uint32_t>(reasons_.size()));
  if (added) reasons_.push_back(reason);
  return nan_with(index->second);
}

void ValueColumn::pad(std::size_t rows) {
  while (size() < rows) add_na(kNotRecorded);
}

const std::string& ValueColumn::reason(std::size_t row) const {
  return reasons_[payload_of(numbers_[row])];
}

void ValueColumn::reorder(const std::vector<std::size_t>& order) {
  reorder_values(numbers_, order);
}

std::uint32_t NameIndex::index_of(const std::string& name) {
  const auto [index, added] = indexes_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
  if (added) names_.push_back(name);
  return index->second;
}

void sort_names(ResultTable& columns) {
  sort_by(std::less<>(), columns.methods, columns.method);
  const auto rank = [](const std::string& outcome) {
    return std::tuple(outcome != "success", outcome);
  };
  sort_by([&](const auto& a, const auto& b) { return rank(a) < rank(b); }, columns.outcomes,
          columns.outcome);
}

void expect_names(const ResultTable& columns) {
  for (const std::string& method : columns.methods) expect_name(method, "a method");
  for (const std::string& scenario : columns.scenario_names) expect_name(scenario, "a scenario");
}

void sort_rows(ResultTable& columns) {
  sort_names(columns);
  const std::size_t scenarios = columns.scenario_hashes.size();
  std::vector<std::size_t> by_name(scenarios), rank(scenarios);
  std::iota(by_name.begin(), by_name.end(), std::size_t{0});
  std::sort(by_name.begin(), by_name.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(columns.scenario_names[a], columns.scenario_hashes[a]) <
           std::tie(columns.scenario_names[b], columns.scenario_hashes[b]);
  });
  for (std::size_t i = 0; i < scenarios; ++i) rank[by_name[i]] = i;
  if (const auto order = order_of_runs(columns, rank); !order.empty()) reorder_runs(columns, order);
  reorder_scenarios(columns, by_name);
}

void keep_runs_in(ResultTable& columns, const std::vector<bool>& scenarios) {
  std::vector<std::size_t> kept;
  for (std::size_t run = 0; run < columns.size(); ++run)
    if (scenarios[columns.scenario[run]]) kept.push_back(run);
  if (kept.size() < columns.size()) reorder_runs(columns, kept);
}

ValueColumn wall_clock_column(const std::string& id) {
  ValueColumn column(timing_info(id));
  column.wall_clock = true;
  return column;
}

void add_success(ResultTable& columns) {
  const QuantityInfo success = success_info();
  if (find_metric(columns, success.id) != nullptr) return;
  ValueColumn& column = columns.metrics.emplace_back(success);
  for (const std::uint32_t index : columns.outcome) column.add(success_of(columns.outcomes[index]));
}

std::string note_on_time(const ResultTable& table) {
  LacksOfTime lacks;
  for (std::size_t i = 0; i < table.scenario_hashes.size(); ++i)
    if (const auto found = table.lack_of_time.find(table.scenario_hashes[i]);
        found != table.lack_of_time.end())
      lacks.emplace_back(table.scenario_names[i], found->second);
  return lack_of_time_note(lacks, table.scenario_hashes.size());
}

bool is_imported(const Manifest& manifest) {
  return manifest.count(kImportedKey) > 0;
}

bool is_foreign(const ResultTable& table) {
  return table.manifest.empty() || is_imported(table.manifest);
}

Value success_of(const std::string& outcome) {
  if (is_inconclusive(outcome)) return Value::na(outcome);
  return Value::of(outcome == "success" ? 1 : 0);
}

const ValueColumn* find_metric(const ResultTable& columns, const std::string& id) {
  return find(columns.metrics, id);
}

const ValueColumn* find_descriptor(const ResultTable& columns, const std::string& id) {
  return find(columns.descriptors, id);
}

const ValueColumn* find_unconditional(const ResultTable& columns, const std::string& id) {
  const ValueColumn* column = find(columns.unconditional, id);
  return column == nullptr ? find_metric(columns, id) : column;
}

void mark_privileged(ResultTable& table, const PrivilegedMethods& methods) {
  const std::vector<std::string> names = methods.names();
  for (std::string& method : table.methods)
    if (contains(names, method)) method += kPrivilegedMark;
}

void mark_privileged(ResultTable& table) {
  mark_privileged(table, privileged_methods(table.manifest));
}

std::string marked_name(const ResultTable& table, const std::string& method) {
  const std::string marked = method + kPrivilegedMark;
  return !contains(table.methods, method) && contains(table.methods, marked) ? marked : method;
}

std::string unmarked_name(const ResultTable& table, const std::string& method) {
  std::string plain = unmarked_name(method);
  if (plain == method || !contains(privileged_methods(table.manifest).names(), plain))
    return method;
  return plain;
}

std::string privileged_footnote(const ResultTable& table) {
  const auto is_marked = [&](const std::string& method) {
    return method != unmarked_name(table, method);
  };
  const bool marked = std::any_of(table.methods.begin(), table.methods.end(), is_marked);
  return marked ? privileged_footnote(privileged_methods(table.manifest)) : "";
}

std::string run_id(const ResultTable& columns, std::size_t run) {
  return columns.scenario_hashes[columns.scenario[run]].substr(0, 8) + "/" +
         unmarked_name(columns, columns.methods[columns.method[run]]) + "/" +
         std::to_string(columns.repetition[run]);
}

bool is_failure(const std::string& outcome) {
  return outcome != "success" && !is_inconclusive(outcome);
}

}  // namespace slalom
