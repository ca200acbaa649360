// SPDX-License-Identifier: BSD-3-Clause
#include "key_options.h"

#include <slalom/core/text.h>

namespace slalom {
namespace {

CLI::Option* add_words(CLI::App& verb, const std::string& name, std::vector<std::string>& words,
                       const std::string& help) {
  return verb.add_option_function<std::string>(
      name, [&words](const std::string& text) { words = split(text, ','); }, help);
}

}  // namespace

void add_key_options(CLI::App& verb, CsvColumnOptions& options, bool shown) {
  CLI::Option* all[] = {
      verb.add_option("--method-column", options.method,
                      "Column of the methods (default: method, planner, local_planner, algorithm "
                      "or controller)"),
      verb.add_option(
          "--scenario-column", options.scenario,
          "Column of the scenarios (default: scenario, world, map, environment or env)"),
      verb.add_option("--repetition-column", options.repetition,
                      "Column of the repetitions (default: repetition, trial, run or episode)"),
      verb.add_option(
          "--outcome-column", options.outcome,
          "Column of the outcomes (default: outcome; result, status, state or done_reason "
          "with words of outcomes)"),
      add_words(verb, "--success-word", options.success_words,
                "Outcomes that mean success, comma-separated; unknown ones are then failures"),
      verb.add_option("--sheet", options.sheet,
                      "Sheet of a workbook (.xlsx) (default: its only one with cells)"),
      add_words(verb, "--names", options.names,
                "The names of the columns of a table without a header line, such as "
                "world,success,collided,timeout,time,metric"),
      add_words(verb, "--up", options.up, "Columns of which more is better"),
      add_words(verb, "--down", options.down, "Columns of which less is better"),
      add_words(verb, "--conditional", options.conditional,
                "Columns that do not count in runs that failed (default: times, lengths and the "
                "like)"),
      add_words(verb, "--unconditional", options.unconditional,
                "Columns that count in runs that failed, too"),
      verb.add_option_function<std::string>(
          "--kind",
          [&options](const std::string& text) { options.kinds = parse_column_kinds(text); },
          "Kind of the values of columns, COLUMN=KIND,...: rate (0 or 1), count, amount, ratio or "
          "score (0 in failures) (default: rate for columns of 0 and 1)"),
      verb.add_option_function<std::string>(
          "--range",
          [&options](const std::string& text) { options.ranges = parse_column_ranges(text); },
          "Range of the values of columns, within which their intervals are, such as "
          "score=0..1,time=0.."),
  };
  for (CLI::Option* option : all)
    if (!shown) option->group("");
}

}  // namespace slalom
