// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <string>

namespace slalom {

/// Writes the runs of a foreign table as a result file, from which read_results() reads the same
/// table: its rows in their order, its columns under their names, outcomes of foreign tables, and
/// the notes on how it was read. The file has no scenarios, trajectories, seeds and settings.
/// Throws Error: Usage, with the run, for two rows of one repetition of a method in a scenario, and
/// for more columns than a file can have; File for a file at `path` that is not an imported table;
/// Job when it cannot be written.
void write_imported(const ResultTable& table, const std::string& path);

/// Throws Error (File) at `path` if the manifest is that of one.
void expect_scenarios(const Manifest& manifest, const std::string& path);

}  // namespace slalom
