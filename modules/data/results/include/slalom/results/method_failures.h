// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Counts the runs that methods ended by errors of their own: the outcomes method_error,
/// method_crash, method_deadline and method_invalid_command.
class MethodFailures {
 public:
  void add(const RunRecord& run);

  /// Adds the runs of a table. `detail_of` returns the text of a failure, given the hash of its
  /// scenario, its method and repetition; it is called once for each method and outcome.
  using DetailOf =
      std::function<std::string(const std::string& hash, const std::string& method, int)>;
  void add(const ResultTable& table, const DetailOf& detail_of);

  /// One line for each method and outcome, by name: "mine: 3 of 3 runs ended with method_error:
  /// AttributeError: ... (first: random_0000/mine/0)". The first run is that with the first name.
  std::vector<std::string> lines() const;
  std::vector<std::string> lines_of(const std::string& method) const;

  /// All runs of the method, with those that ended otherwise.
  std::size_t runs_of(const std::string& method) const;

  /// The methods that ended all of their runs so, by name.
  std::vector<std::string> methods_without_a_sound_run() const;

 private:
  struct Failure {
    std::size_t runs = 0;
    RunRecord first;
  };
  struct Method {
    std::size_t runs = 0, failed = 0;
    std::map<std::string, Failure> failures;  ///< by outcome
  };
  std::map<std::string, Method> methods_;

  /// Adds runs of the method, the first of which is this one.
  void add_runs(const std::string& name, std::size_t runs, const RunRecord& first);
};

/// Whether the outcome is one of those.
bool is_method_failure(const std::string& outcome);

}  // namespace slalom
