// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/output_marks.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/results/untimely_commands.h>

namespace slalom {
namespace {

/// Commands of the runs of a method, added over kinds.
struct Counts {
  std::vector<std::string> of_kinds;  ///< "missing (35)"
  double commands = 0;
  std::size_t affected = 0, runs = 0;
};

Counts count(const ResultTable& table, const std::string& method,
             const std::vector<std::string>& kinds) {
  Counts counts;
  std::vector<bool> affected(table.size());
  for (const std::string& kind : kinds) {
    const ValueColumn* column = find_metric(table, "commands_" + kind);
    if (column == nullptr) continue;
    double commands = 0;
    for (std::size_t row = 0; row < table.size(); ++row) {
      if (table.methods[table.method[row]] != method || !(column->number(row) > 0)) continue;
      commands += column->number(row);
      affected[row] = true;
    }
    counts.commands += commands;
    if (commands > 0) counts.of_kinds.push_back(kind + " (" + format_number(commands) + ")");
  }
  for (std::size_t row = 0; row < table.size(); ++row) {
    if (table.methods[table.method[row]] != method) continue;
    ++counts.runs;
    if (affected[row]) ++counts.affected;
  }
  return counts;
}

std::string runs_text(const Counts& counts) {
  return " in " + std::to_string(counts.affected) + " of " + count_text(counts.runs, "run");
}

}  // namespace

std::string untimely_commands(const ResultTable& table, const std::string& method) {
  const Counts counts = count(table, method, {"missing", "stale", "late", "expired"});
  if (counts.of_kinds.empty()) return "";
  return method + ": commands were " + join(counts.of_kinds, " or ") + runs_text(counts) +
         ", which depend on the speed of the machine";
}

std::string last_error_printed(const std::string& output) {
  std::string last;
  bool is_ending = false;
  for (const std::string& line : split(output, '\n')) {
    if (line + "\n" == kEndingOutput) is_ending = true;
    if (line + "\n" == kEndedOutput) is_ending = false;
    if (is_ending) continue;
    if (line.find("ERROR") != std::string::npos || line.find("FATAL") != std::string::npos)
      last = line;
  }
  return printable_line(last);
}

std::string error_printed_clause(const std::string& output) {
  const std::string error = last_error_printed(output);
  return error.empty() ? "" : "; the last error that it printed: " + error;
}

std::string limited_commands(const ResultTable& table, const std::string& method) {
  const Counts counts = count(table, method, {"limited"});
  if (counts.of_kinds.empty()) return "";
  return method + ": " + count_text(static_cast<std::size_t>(counts.commands), "command") +
         runs_text(counts) + " beyond the robot's limits, which changed them";
}

}  // namespace slalom
