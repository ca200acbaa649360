// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_means.h"

#include <slalom/analysis/cell.h>

namespace slalom {

std::vector<std::optional<double>> scenario_means(const ResultTable& table, std::uint32_t method,
                                                  const ValueColumn& values) {
  const std::size_t scenarios = table.scenario_hashes.size();
  std::vector<double> sums(scenarios, 0), sizes(scenarios, 0);
  for (std::size_t run = 0; run < table.size(); ++run) {
    if (table.method[run] != method || values.is_na(run)) continue;
    sums[table.scenario[run]] += values.number(run);
    sizes[table.scenario[run]] += 1;
  }
  std::vector<std::optional<double>> means(scenarios);
  for (std::size_t i = 0; i < scenarios; ++i) {
    if (sizes[i] > 0) means[i] = sums[i] / sizes[i];
  }
  return means;
}

const ValueColumn& require_metric(const ResultTable& table, const std::string& id) {
  resolve_columns(table, {id});
  return *find_metric(table, id);
}

}  // namespace slalom
