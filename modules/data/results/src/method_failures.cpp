// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/results/method_failures.h>
#include <slalom/results/privileged.h>

#include <tuple>

namespace slalom {

bool is_method_failure(const std::string& outcome) {
  return starts_with(outcome, "method_");
}

void MethodFailures::add(const RunRecord& run) {
  add_runs(run.method, 1, run);
}

void MethodFailures::add(const ResultTable& table, const DetailOf& detail_of) {
  const auto name_of = [&table](std::size_t run) {
    return std::tie(table.scenario_names[table.scenario[run]],
                    table.scenario_hashes[table.scenario[run]], table.repetition[run]);
  };
  struct Runs {
    std::size_t n = 0, first = 0;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Runs> groups;  // by method and outcome
  for (std::size_t run = 0; run < table.size(); ++run) {
    Runs& group = groups[{table.method[run], table.outcome[run]}];
    if (group.n++ == 0 || name_of(run) < name_of(group.first)) group.first = run;
  }
  for (const auto& [key, group] : groups) {
    RunRecord first;
    first.method = unmarked_name(table, table.methods[key.first]);
    first.outcome = table.outcomes[key.second];
    if (is_method_failure(first.outcome)) {
      const std::uint32_t scenario = table.scenario[group.first];
      first.scenario_hash = table.scenario_hashes[scenario];
      first.scenario_name = table.scenario_names[scenario];
      first.repetition = static_cast<int>(table.repetition[group.first]);
      first.outcome_detail = detail_of(first.scenario_hash, first.method, first.repetition);
    }
    add_runs(table.methods[key.first], group.n, first);
  }
}

void MethodFailures::add_runs(const std::string& name, std::size_t runs, const RunRecord& first) {
  Method& method = methods_[name];
  method.runs += runs;
  if (!is_method_failure(first.outcome)) return;
  method.failed += runs;
  Failure& failure = method.failures[first.outcome];
  const auto key = [](const RunRecord& one) {
    return std::tie(one.scenario_name, one.scenario_hash, one.repetition);
  };
  if (failure.runs == 0 || key(first) < key(failure.first)) failure.first = first;
  failure.runs += runs;
}

std::vector<std::string> MethodFailures::lines() const {
  std::vector<std::string> lines;
  for (const auto& [name, method] : methods_)
    for (std::string& line : lines_of(name)) lines.push_back(std::move(line));
  return lines;
}

std::vector<std::string> MethodFailures::lines_of(const std::string& name) const {
  std::vector<std::string> lines;
  const auto found = methods_.find(name);
  if (found == methods_.end()) return lines;
  const std::size_t runs = found->second.runs;
  for (const auto& [outcome, failure] : found->second.failures) {
    const RunRecord& first = failure.first;
    const std::string detail = first.outcome_detail.empty() ? "" : ": " + first.outcome_detail;
    lines.push_back(printable_line(name + ": " + std::to_string(failure.runs) + " of " +
                                   count_text(runs, "run") + " ended with " + outcome + detail +
                                   " (first: " + first.scenario_name + "/" + first.method + "/" +
                                   std::to_string(first.repetition) + ")"));
  }
  return lines;
}

std::size_t MethodFailures::runs_of(const std::string& method) const {
  const auto found = methods_.find(method);
  return found == methods_.end() ? 0 : found->second.runs;
}

std::vector<std::string> MethodFailures::methods_without_a_sound_run() const {
  std::vector<std::string> names;
  for (const auto& [name, method] : methods_)
    if (method.failed == method.runs) names.push_back(name);
  return names;
}

}  // namespace slalom
