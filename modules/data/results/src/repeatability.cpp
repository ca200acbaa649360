// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/results/repeatability.h>

#include <algorithm>

namespace slalom {

std::string to_string(const Repeatability& measured) {
  return "repeatable in " + std::to_string(measured.equal) + " of " +
         count_text(measured.repeated, "run") +
         (measured.difference.empty() ? "" : "; " + measured.difference);
}

std::string repeated_method(const std::string& key) {
  const std::size_t begin = key.find('/'), end = key.rfind('/');
  if (!starts_with(key, kRepeatedPrefix) || begin == end) return "";
  return key.substr(begin + 1, end - begin - 1);
}

std::map<std::string, Repeatability> repeatability_of(const Manifest& manifest) {
  std::map<std::string, Repeatability> methods;
  for (const auto& [key, difference] : manifest) {
    const std::string method = repeated_method(key);
    if (method.empty()) continue;
    Repeatability& measured = methods[method];
    ++measured.repeated;
    if (difference.empty())
      ++measured.equal;
    else if (measured.difference.empty())
      measured.difference = key.substr(std::string(kRepeatedPrefix).size()) + " " + difference;
  }
  return methods;
}

std::vector<std::string> repeatability_notes(const ResultTable& table) {
  const bool repetitions = std::any_of(table.repetition.begin(), table.repetition.end(),
                                       [](std::uint32_t repetition) { return repetition > 0; });
  std::vector<std::string> notes;
  for (const auto& [method, measured] : repeatability_of(table.manifest))
    if (!measured.is_repeatable() && contains(table.methods, marked_name(table, method)))
      notes.push_back(method + ": " + to_string(measured) +
                      "; its values, and their differences between files, contain this variation" +
                      (repetitions ? "" : ", which [campaign] repetitions would show"));
  return notes;
}

std::string note_on_stopping(const Manifest& manifest) {
  const auto rule = manifest.find("until");
  if (rule == manifest.end()) return "";
  return "the results decided when the campaign ended, by --until \"" + rule->second +
         "\": p-values and intervals here assume a number of runs that was chosen beforehand; "
         "until.txt has those of the rule";
}

std::vector<std::string> notes_on_runs(const ResultTable& table) {
  std::vector<std::string> notes = repeatability_notes(table);
  for (const std::string& note : {note_on_stopping(table.manifest), note_on_time(table)})
    if (!note.empty()) notes.push_back(note);
  return notes;
}

}  // namespace slalom
