// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>
#include <slalom/results/run_record.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Manifest keys of the runs that were executed a second time: this and the id of the run. The text
/// says what differs; it is empty if nothing does.
constexpr const char* kRepeatedPrefix = "repeated.";

/// How many runs of a method were executed a second time, and how many of those were the same.
struct Repeatability {
  std::size_t repeated = 0, equal = 0;
  std::string difference;  ///< of the first that was not: "0123abcd/nd/0 differs after 1.3 s: ..."

  bool is_repeatable() const { return equal == repeated; }
};

/// "repeatable in 3 of 5 runs", and the first difference.
std::string to_string(const Repeatability& measured);

/// The method of a manifest key with kRepeatedPrefix; "" for other keys.
std::string repeated_method(const std::string& key);

/// The results by method; one that was not measured is absent.
std::map<std::string, Repeatability> repeatability_of(const Manifest& manifest);

/// One sentence for each method of the table that is not repeatable.
std::vector<std::string> repeatability_notes(const ResultTable& table);

/// Says that the results decided when the campaign ended (--until), which p-values and intervals
/// do not take into account; empty otherwise.
std::string note_on_stopping(const Manifest& manifest);

/// These, note_on_stopping() and note_on_time(): what a reader of any value has to know.
std::vector<std::string> notes_on_runs(const ResultTable& table);

}  // namespace slalom
