// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <string>

namespace slalom {

/// Writes results as an OMPL benchmark database, as created by ompl_benchmark_statistics.py and
/// opened by Planner Arena (plannerarena.org): tables experiments, plannerConfigs, enums, runs and
/// progress.
///
/// An experiment is a scenario: its descriptors are the experiment's parameters, further columns of
/// `experiments`. A planner configuration is a method with its .ini section. Columns of a run:
/// `solved` (0, 1, NULL if the outcome is unknown or inconclusive), `status` (an enum of the
/// outcomes), `time` (s, simulated, of runs that reached the goal), and every metric under its id;
/// NA is NULL. `progress` stays empty. Wall-clock measurements are omitted, so that the same
/// results give the same rows. Throws Error (Job) if it cannot be written; `path` is then
/// unchanged.
void write_benchmark_database(const ResultTable& table, const std::string& path);

}  // namespace slalom
