#pragma once

#include "run_pages.h"

namespace slalom {

/// data/runs.js: every run with the columns shown, as a call of slalomRuns().
std::string runs_script(const RunPages& pages);

/// data/cells.js: the groups of runs, as a call of slalomCells().
std::string cells_script(const RunPages& pages);

/// data/metrics.js: id, name and unit of each metric, as a call of slalomMetrics().
std::string metrics_script(const RunPages& pages);

/// Names of a table, looked up once.
struct RunNames {
  std::vector<std::string> metrics, methods;
};

/// data/s-HASH8.js: a scenario with its references and these runs (indexes into the table's runs),
/// as a call of slalomScenario(). The safest path, which follows cells, is drawn to one cell.
/// `directory`: of the report, for links to rawlogs.
std::string scenario_script(const RunPages& pages, const RunNames& names,
                            const ScenarioRecord& scenario, const std::vector<std::size_t>& runs,
                            const std::string& directory);

}  // namespace slalom
