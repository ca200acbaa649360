// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>
#include <slalom/trajectory/trajectory.h>

#include <map>
#include <pybind11/pybind11.h>
#include <string>

namespace slalom {

/// Columns by name, one value per run: scenario, scenario_hash, method, repetition, outcome, then
/// metrics and descriptors as float64 arrays, NaN where NA. Wall-clock figures are not included.
pybind11::dict columns_of(const ResultTable& table);

/// Wall-clock figures by name: float64 arrays, one value per run. They differ from run to run.
pybind11::dict timing_of(const ResultTable& table);

/// {column: {row: reason}} of all values that are NA.
pybind11::dict reasons_of(const ResultTable& table);

/// The samples of each run in the order of the table; by run_id().
pybind11::list arrays_of(const ResultTable& table,
                         const std::map<std::string, Trajectory>& trajectories);

}  // namespace slalom
