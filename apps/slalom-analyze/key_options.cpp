// SPDX-License-Identifier: BSD-3-Clause
#include "key_options.h"

namespace slalom {

void add_key_options(CLI::App& verb, CsvColumnOptions& options) {
  verb.add_option("--method-column", options.method,
                  "CSV: column of the methods (default: method, planner, local_planner, algorithm "
                  "or controller)");
  verb.add_option("--scenario-column", options.scenario,
                  "CSV: column of the scenarios (default: scenario, world, map, environment or "
                  "env)");
  verb.add_option("--repetition-column", options.repetition,
                  "CSV: column of the repetitions (default: repetition, trial, run or episode)");
  verb.add_option("--outcome-column", options.outcome,
                  "CSV: column of the outcomes (default: outcome; result or status with words of "
                  "outcomes)");
  verb.add_option_function<std::string>(
      "--kind", [&options](const std::string& text) { options.kinds = parse_column_kinds(text); },
      "CSV: kind of the values of columns, COLUMN=KIND,...: rate (0 or 1), count, amount or ratio "
      "(default: rate for columns of 0 and 1)");
  verb.add_option_function<std::string>(
      "--range",
      [&options](const std::string& text) { options.ranges = parse_column_ranges(text); },
      "CSV: range of the values of columns, within which their intervals are, such as "
      "score=0..1,time=0..");
}

}  // namespace slalom
