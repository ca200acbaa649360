#pragma once

#include "run_pages.h"

namespace slalom {

/// data/runs.js: every run with the columns shown, as a call of slalomRuns().
std::string runs_script(const RunPages& pages);

/// data/cells.js: the groups of runs, as a call of slalomCells().
std::string cells_script(const RunPages& pages);

/// data/s-HASH8.js: a scenario with its references and these runs (indexes into the table's runs),
/// as a call of slalomScenario(). `directory`: of the report, for links to rawlogs.
std::string scenario_script(const RunPages& pages, const ScenarioRecord& scenario,
                            const std::vector<std::size_t>& runs, const std::string& directory);

}  // namespace slalom
