// SPDX-License-Identifier: BSD-3-Clause
#include "run_ends.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/results/outcome_words.h>

#include <algorithm>
#include <cctype>
#include <optional>

namespace slalom {
namespace {

const std::string kSuccess = "success", kFailure = "failure";

/// The words of a name in lower case: "pathLength [m]" is path, length, m.
std::vector<std::string> words_of(const std::string& name) {
  std::string text;
  bool after_small = false;
  for (const unsigned char c : name) {
    if (after_small && std::isupper(c) != 0) text += ' ';
    text += std::isalnum(c) != 0 ? static_cast<char>(std::tolower(c)) : ' ';
    after_small = std::islower(c) != 0;
  }
  return split_nonempty(text, ' ');
}

bool has_any(const std::vector<std::string>& words, const std::vector<std::string>& of) {
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& word) { return contains(of, word); });
}

/// The outcome that a rate of this name counts: "Static Collisions" are collisions.
std::optional<std::string> outcome_of_name(const std::string& name) {
  static const std::vector<std::string> others = {
      "is",       "has",   "was",    "did",        "any",         "flag", "static", "dynamic",
      "obstacle", "human", "people", "pedestrian", "pedestrians", "wall", "walls"};
  std::string word;
  for (const std::string& part : words_of(name))
    if (!contains(others, part)) word += part;
  auto outcome = outcome_of_word(word);
  if (!outcome && ends_with(word, "s")) outcome = outcome_of_word(word.substr(0, word.size() - 1));
  const bool is_end = outcome && (*outcome == kSuccess || is_failure(*outcome));
  return is_end ? outcome : std::nullopt;
}

/// A column of 0 and 1 that says of each run whether it ended so.
struct EndColumn {
  const ValueColumn* values;
  std::string outcome;

  bool is(std::size_t run, double number) const {
    return !values->is_na(run) && values->number(run) == number;
  }
  const std::string& id() const { return values->info().id; }
  std::string text(std::size_t run) const {
    return "'" + id() + "' is " + format_number(values->number(run));
  }
};

/// The columns of outcomes. One of success counts only without a column "success".
std::vector<EndColumn> end_columns(const ResultTable& table) {
  std::vector<EndColumn> columns;
  const ValueColumn* success = find_metric(table, kSuccess);
  if (success != nullptr && success->info().is_rate()) columns.push_back({success, kSuccess});
  for (const ValueColumn& values : table.metrics) {
    if (!values.info().is_rate() || &values == success) continue;
    const auto outcome = outcome_of_name(values.info().id);
    if (outcome && (*outcome != kSuccess || success == nullptr))
      columns.push_back({&values, *outcome});
  }
  return columns;
}

/// Finds the outcome of each run, and contradictions.
class RunEnds {
 public:
  RunEnds(const ResultTable& table, const CsvTable& csv, std::vector<EndColumn> columns)
      : table_(table), csv_(csv), columns_(std::move(columns)) {}

  std::string operator()(std::size_t run) {
    outcome_ = table_.outcomes[table_.outcome[run]];
    text_ = "the outcome is " + outcome_;
    for (const EndColumn& column : columns_)
      if (column.is(run, 1)) add(run, column, column.outcome);
    for (const EndColumn& column : columns_)
      if (column.outcome == kSuccess && column.is(run, 0)) add(run, column, kFailure);
    return outcome_;
  }

 private:
  const ResultTable& table_;
  const CsvTable& csv_;
  std::vector<EndColumn> columns_;
  std::string outcome_, text_;  ///< of the run, and the field that says it

  /// A failure of known kind is a failure, too.
  void add(std::size_t run, const EndColumn& column, const std::string& end) {
    const bool is_known = outcome_ != kUnknownOutcome;
    const bool may_fail = outcome_ != kSuccess;
    if (is_known && (end == kFailure ? may_fail : outcome_ == end)) return;
    if (is_known && !(outcome_ == kFailure && end != kSuccess))
      throw file_error(csv_.where(run), text_ + ", but " + column.text(run),
                       "one end of each run, or --kind " + column.id() +
                           "=count for a column that does not say how runs end");
    outcome_ = end;
    text_ = column.text(run);
  }
};

/// Whether a name is that of a time, a length or the like of a run up to its end.
bool is_conditional_name(const std::string& name) {
  static const std::vector<std::string> measures = {
      "time",      "times", "duration", "elapsed",      "length",  "travelled",
      "traveled",  "speed", "velocity", "acceleration", "jerk",    "smoothness",
      "curvature", "steps", "distance", "dist",         "seconds", "sec"};
  // Extremes, parts, limits, properties of scenarios and programs.
  static const std::vector<std::string> others = {
      "min",      "minimum", "max",     "maximum",   "limit",      "allowed",     "budget",
      "out",      "stamp",   "step",    "start",     "begin",      "end",         "initial",
      "shortest", "optimal", "ideal",   "reference", "collision",  "contact",     "collisions",
      "impact",   "cpu",     "wall",    "compute",   "computing",  "computation", "inference",
      "planning", "cycle",   "control", "obstacle",  "obstacles",  "human",       "humans",
      "people",   "person",  "mover",   "movers",    "pedestrian", "pedestrians", "scenario",
      "corridor"};
  static const std::vector<std::string> of_distances = {"goal",  "target",    "to",      "from",
                                                        "final", "remaining", "closest", "nearest"};
  const std::vector<std::string> words = words_of(name);
  if (words.empty() || has_any(words, others)) return false;
  if (has_any(words, {"distance", "dist"})) return !has_any(words, of_distances);
  return has_any(words, measures) || words.back() == "s";  // its unit
}

/// Whether the values are those of scenarios: equal in all runs of each, and in a success and a
/// failure of one.
bool is_of_scenarios(const ResultTable& table, const ValueColumn& values,
                     const std::vector<bool>& failed) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> first(table.scenario_hashes.size(), kNone);
  bool has_both = false;
  for (std::size_t run = 0; run < table.size(); ++run) {
    if (values.is_na(run)) continue;
    std::size_t& other = first[table.scenario[run]];
    if (other == kNone) other = run;
    if (values.number(run) != values.number(other)) return false;
    has_both = has_both || failed[run] != failed[other];
  }
  return has_both;
}

}  // namespace

std::vector<std::string> complete_outcomes(ResultTable& table, const CsvTable& csv,
                                           bool has_outcomes) {
  const std::vector<EndColumn> columns = end_columns(table);
  std::vector<std::string> taken, outcomes;
  std::vector<std::uint32_t> outcome;
  NameIndex index(outcomes);
  RunEnds end_of(table, csv, columns);
  for (std::size_t run = 0; run < table.size(); ++run)
    outcome.push_back(index.index_of(end_of(run)));
  bool has_success = has_outcomes;
  for (const EndColumn& column : columns) {
    has_success = has_success || column.outcome == kSuccess;
    if (column.outcome != kSuccess) index.index_of(column.outcome);  // also if no run ended so
    if (column.id() != column.outcome) taken.push_back(column.id() + " as " + column.outcome);
  }
  table.outcomes = std::move(outcomes);
  table.outcome = std::move(outcome);
  sort_names(table);
  if (has_success) add_success(table);
  return taken;
}

std::vector<std::string> make_conditional(ResultTable& table, const CsvColumnOptions& options) {
  std::vector<bool> failed;
  for (const std::uint32_t outcome : table.outcome)
    failed.push_back(is_failure(table.outcomes[outcome]));
  const auto is_known = [&](const std::string& id) {
    return std::any_of(options.known.begin(), options.known.end(),
                       [&](const QuantityInfo& info) { return info.id == id; });
  };
  std::vector<std::string> ids;
  for (ValueColumn& values : table.metrics) {
    const std::string& id = values.info().id;
    const bool is_conditional =
        is_known(id) ? contains(options.known_conditional, id) : is_conditional_name(id);
    if (!is_conditional || values.info().is_rate() || contains(options.unconditional, id) ||
        is_of_scenarios(table, values, failed))
      continue;
    const ValueColumn before = values;
    bool any = false;
    for (std::size_t run = 0; run < table.size(); ++run) {
      if (!failed[run] || values.is_na(run)) continue;
      values.set_na(run, "outcome: " + table.outcomes[table.outcome[run]]);
      any = true;
    }
    if (!any) continue;
    table.unconditional.push_back(before);
    ids.push_back(id);
  }
  return ids;
}

}  // namespace slalom
