// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/results/outcome_words.h>
#include <slalom/results/run_record.h>

#include <algorithm>
#include <cctype>

namespace slalom {
namespace {

struct OutcomeWords {
  const char* outcome;
  std::vector<const char*> others;  ///< as letters_of() returns them
};

const std::vector<OutcomeWords>& outcome_table() {
  static const std::vector<OutcomeWords> table = {
      {"success",
       {"succeeded", "succeed", "successful", "goalreached", "reachedgoal", "reached", "goal",
        "arrived", "statussucceeded"}},
      {"collision", {"collided", "collide", "collisiondetected"}},
      {"timeout",
       {"timedout", "timelimit", "timelimitreached", "timelimitexceeded", "timeexceeded",
        "maxtimeexceeded"}},
      {"stuck", {"robotstuck", "gotstuck"}},
      {"left_workspace", {"outofbounds", "leftmap"}},
      {"failure",
       {"failed", "fail", "aborted", "abort", "crashed", "crash", "unsuccessful", "dnf",
        "didnotfinish", "notfinish", "notfinished", "statusaborted"}},
      {"method_crash", {}},
      {"method_deadline", {}},
      {"method_invalid_command", {}},
      {"method_error", {}},
      {"unsolvable_scenario", {}},
      {"infrastructure_error", {}},
      {kNotRecorded, {}}};
  return table;
}

/// In lower case, without what separates words.
std::string letters_of(const std::string& word) {
  std::string letters;
  for (const unsigned char c : word)
    if (c != ' ' && c != '_' && c != '-' && c != '\t')
      letters += static_cast<char>(std::tolower(c));
  return letters;
}

}  // namespace

std::optional<std::string> outcome_of_word(const std::string& word) {
  const std::string letters = letters_of(word);
  for (const OutcomeWords& words : outcome_table())
    if (letters == letters_of(words.outcome) ||
        std::find(words.others.begin(), words.others.end(), letters) != words.others.end())
      return words.outcome;
  return std::nullopt;
}

std::vector<std::string> known_outcomes() {
  std::vector<std::string> names;
  for (const OutcomeWords& words : outcome_table()) names.emplace_back(words.outcome);
  return names;
}

}  // namespace slalom
