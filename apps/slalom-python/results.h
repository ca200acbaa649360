// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <pybind11/pybind11.h>
#include <string>

namespace slalom {

/// Parts of the class Results: (columns, timing, reasons, trajectories, table, path).
/// Columns by name have one value per run: scenario, scenario_hash, method, repetition, outcome,
/// detail, reasons, then metrics and descriptors as float64 arrays, NaN where NA. `timing` are
/// those of wall-clock figures, which differ from run to run; `reasons` are {column: {row: reason}}
/// of all values that are NA; `trajectories` the samples of each run, read from the result file or
/// folder at `path`, or None. Throws Error (File).
pybind11::tuple results_of(const ResultTable& table, const std::string& path, bool trajectories);

/// Class ResultTable, read_results(), save_results(), summary() and cross_table().
void bind_results(pybind11::module_& module);

}  // namespace slalom
