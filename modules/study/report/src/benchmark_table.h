// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The results of another benchmark as a table of runs, for columns_from_csv().
struct BenchmarkTable {
  std::string csv;
  std::vector<std::string> success_words;
};

/// Reads a benchmark database of OMPL, as ompl_benchmark_statistics.py makes it, or the results of
/// Bench-MR (JSON). nullopt for any other file. Throws Error (File) for a damaged one.
///
/// OMPL: the scenario is the experiment, the method the planner, the outcome the description of
/// `status`, of which "exact solution" is a success; all other columns of `runs` are values, with
/// "_" for blanks.
///
/// Bench-MR: the scenario is the environment with the number of its run, the method the planner.
/// Numbers and truth values of `stats` are values, of lists their length. A path that is found,
/// does not collide and ends at the goal is a success; a plan without `stats` is a failure.
/// Smoothed paths are left out.
std::optional<BenchmarkTable> read_benchmark_table(const std::string& path);
/// The text of such a JSON file; nullopt for any other text.
std::optional<BenchmarkTable> bench_mr_from_text(const std::string& text);

}  // namespace slalom
