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
}

}  // namespace slalom
