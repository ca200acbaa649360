#pragma once

#include <slalom/results/run_record.h>

#include <string>

namespace slalom {

/// Writes results as a benchmark database of OMPL, as ompl_benchmark_statistics.py makes it and
/// Planner Arena (plannerarena.org) opens it: tables experiments, plannerConfigs, enums, runs and
/// progress.
///
/// An experiment is a scenario: its descriptors are the experiment's parameters, further columns of
/// `experiments`. A planner configuration is a method with its .ini section. Of a run: `solved`
/// (0, 1), `status` (an enum of the outcomes), `time` (s, simulated, of runs that reached the
/// goal), and every metric under its id; what is not available is NULL. `progress` stays empty.
/// Wall-clock figures are left out, so that the same results give the same rows. Throws Error (Job)
/// when it cannot be written; `path` is whole or as it was.
void write_benchmark_database(const ResultTable& table, const std::string& path);

}  // namespace slalom
