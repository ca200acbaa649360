#pragma once

#include <slalom/results/run_record.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Counts the runs that methods ended by errors of their own: the outcomes method_error,
/// method_crash, method_deadline and method_invalid_command.
class MethodFailures {
 public:
  void add(const RunRecord& run);

  /// One line for each method and outcome, by name: "mine: 3 of 3 runs ended with method_error:
  /// AttributeError: ... (first: random_0000/mine/0)". The first run is that with the first name.
  std::vector<std::string> lines() const;

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
};

/// Whether the outcome is one of those.
bool is_method_failure(const std::string& outcome);

}  // namespace slalom
