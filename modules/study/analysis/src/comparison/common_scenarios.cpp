// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/common_scenarios.h>
#include <slalom/core/text.h>
#include <slalom/results/privileged.h>

#include <algorithm>

namespace slalom {
namespace {

bool has_survivors_only(const ResultTable& table, const ValueColumn& values) {
  std::vector<std::size_t> runs(table.methods.size(), 0), available(table.methods.size(), 0);
  for (std::size_t run = 0; run < table.size(); ++run) {
    ++runs[table.method[run]];
    available[table.method[run]] += values.is_na(run) ? 0 : 1;
  }
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (is_survivors_only(runs[i], available[i])) return true;
  return false;
}

}  // namespace

std::vector<bool> find_common_scenarios(const ResultTable& table, const ValueColumn& values) {
  const std::size_t scenarios = table.scenario_hashes.size(), methods = table.methods.size();
  std::vector<bool> complete(scenarios, true), present(scenarios * methods, false);
  for (std::size_t run = 0; run < table.size(); ++run) {
    present[table.scenario[run] * methods + table.method[run]] = true;
    if (values.is_na(run)) complete[table.scenario[run]] = false;
  }
  for (std::size_t i = 0; i < scenarios * methods; ++i)
    if (!present[i]) complete[i / methods] = false;
  return complete;
}

CommonScenarios make_common_scenarios(const ResultTable& table, const Column& column,
                                      const AnalysisOptions& options) {
  const ValueColumn& values = *find_metric(table, column.info.id);
  const std::vector<bool> common = find_common_scenarios(table, values);
  CommonScenarios made;
  made.column = column;
  made.scenarios = static_cast<std::size_t>(std::count(common.begin(), common.end(), true));
  made.left_out = common.size() - made.scenarios;
  made.runs.resize(table.methods.size());
  for (std::size_t run = 0; run < table.size(); ++run)
    if (common[table.scenario[run]]) made.runs[table.method[run]].push_back(run);
  for (std::size_t i = 0; i < made.runs.size(); ++i)
    made.cells.push_back(make_cell(table, made.runs[i], values, options));
  return made;
}

std::vector<CommonScenarios> build_common_scenarios(const ResultTable& table,
                                                    const std::vector<std::string>& metrics,
                                                    const AnalysisOptions& options) {
  std::vector<CommonScenarios> all;
  if (table.methods.size() < 2 || metrics.empty()) return all;
  for (const Column& column : resolve_columns(table, metrics)) {
    if (column.wall_clock || !has_survivors_only(table, *find_metric(table, column.info.id)))
      continue;
    all.push_back(make_common_scenarios(table, column, options));
  }
  return all;
}

std::string title_of(const CommonScenarios& common) {
  return common.column.info.id + " on the " + count_text(common.scenarios, "scenario") +
         " that all " + count_text(common.cells.size(), "method") + " solved";
}

}  // namespace slalom
