// SPDX-License-Identifier: BSD-3-Clause
#include "run_ends.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/results/outcome_words.h>

#include <algorithm>
#include <cctype>
#include <cmath>
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
      "is",    "has",         "was",        "did",  "any",   "flag",     "static", "dynamic",
      "human", "people",      "pedestrian", "wall", "walls", "obstacle", "num",    "number",
      "of",    "pedestrians", "count",      "n",    "rate",  "0",        "1"};
  std::string word;
  for (const std::string& part : words_of(name.substr(name.rfind('.') + 1)))
    if (!contains(others, part)) word += part;
  if (word == "completed" || word == "finished") return kSuccess;
  auto outcome = outcome_of_word(word);
  if (!outcome && ends_with(word, "s")) outcome = outcome_of_word(word.substr(0, word.size() - 1));
  const bool is_end = outcome && (*outcome == kSuccess || is_failure(*outcome));
  return is_end ? outcome : std::nullopt;
}

/// A column that says of each run whether it ended so: of 0 and 1, or a count of such events.
struct EndColumn {
  const ValueColumn* values;
  std::string outcome;

  bool is(std::size_t run) const { return !values->is_na(run) && values->number(run) >= 1; }
  bool is_not(std::size_t run) const { return !values->is_na(run) && values->number(run) == 0; }
  const std::string& id() const { return values->info().id; }
  std::string text(std::size_t run) const {
    return "'" + id() + "' is " + format_number(values->number(run));
  }
};

/// Whether the values are counts of events of which none is in a run that succeeded.
bool counts_ends(const ResultTable& table, const ValueColumn& values, const ValueColumn* success) {
  for (std::size_t run = 0; run < table.size(); ++run) {
    if (values.is_na(run)) continue;
    const double count = values.number(run);
    const bool succeeded = table.outcomes[table.outcome[run]] == kSuccess ||
                           (success != nullptr && EndColumn{success, kSuccess}.is(run));
    if (count < 0 || count != std::floor(count) || (count > 0 && succeeded)) return false;
  }
  return true;
}

/// The columns of outcomes. One of success counts only without a column "success".
std::vector<EndColumn> end_columns(const ResultTable& table, const CsvColumnOptions& options) {
  std::vector<EndColumn> columns;
  const ValueColumn* success = find_metric(table, kSuccess);
  if (success != nullptr && success->info().is_rate()) columns.push_back({success, kSuccess});
  for (const ValueColumn& values : table.metrics) {
    const bool is_rate = values.info().is_rate();
    if (&values == success || (!is_rate && options.kinds.count(values.info().id) > 0)) continue;
    const auto outcome = outcome_of_name(values.info().id);
    if (!outcome || (*outcome == kSuccess && (success != nullptr || !is_rate))) continue;
    if (is_rate || counts_ends(table, values, success)) columns.push_back({&values, *outcome});
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
      if (column.is(run)) add(run, column, column.outcome);
    for (const EndColumn& column : columns_)
      if (column.outcome == kSuccess && column.is_not(run)) add(run, column, kFailure);
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

const std::vector<std::string>& words_of_times() {
  static const std::vector<std::string> words = {
      "time",  "times",   "duration", "elapsed", "seconds", "sec",        "secs", "minutes",
      "hours", "runtime", "makespan", "tt",      "ttg",     "traveltime", "dur"};
  return words;
}

/// Whether the words are those of a time or a length, which is never negative.
bool is_extent(const std::vector<std::string>& words) {
  static const std::vector<std::string> lengths = {"length",   "len",  "travelled", "traveled",
                                                   "distance", "dist", "odom",      "steps",
                                                   "frames",   "ticks"};
  static const std::vector<std::string> units = {"m", "km", "cm", "meters", "metres"};
  return has_any(words, words_of_times()) || has_any(words, lengths) ||
         (words.size() == 2 && words[0] == "path" && contains(units, words[1]));
}

/// Whether the first word is t, or the last one a unit of times.
bool has_mark_of_time(const std::vector<std::string>& words) {
  return words.front() == "t" || words.back() == "s" || words.back() == "ms";
}

/// Whether the words are those of an extreme, a part, a limit, or of a property of scenarios,
/// people and programs.
bool is_of_no_run(const std::vector<std::string>& words) {
  static const std::vector<std::string> others = {
      "minimum", "max",       "maximum",    "limit",       "allowed",    "budget",   "initial",
      "out",     "stamp",     "step",       "start",       "begin",      "shortest", "optimal",
      "ideal",   "reference", "collision",  "contact",     "collisions", "impact",   "cpu",
      "wall",    "compute",   "computing",  "computation", "inference",  "planning", "cycle",
      "control", "obstacle",  "obstacles",  "human",       "humans",     "people",   "person",
      "mover",   "movers",    "pedestrian", "pedestrians", "scenario",   "corridor", "width",
      "density", "seed",      "id"};
  return words.empty() || has_any(words, others) || words.front() == "min";
}

/// Whether a name is that of a time, a length or the like of a run up to its end.
bool is_conditional_name(const std::string& name) {
  static const std::vector<std::string> measures = {
      "speed",      "velocity",  "vel",        "v",      "acceleration", "jerk",
      "smoothness", "curvature", "iterations", "energy", "effort"};
  static const std::vector<std::string> of_distances = {
      "goal", "target", "to", "from", "end", "min", "final", "remaining", "closest", "nearest"};
  const std::vector<std::string> words = words_of(name);
  if (is_of_no_run(words)) return false;
  if (has_any(words, {"distance", "dist"})) return !has_any(words, of_distances);
  return has_any(words, measures) || is_extent(words) || has_mark_of_time(words);
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

bool has_value(const ValueColumn& values, const std::vector<bool>& runs) {
  for (std::size_t run = 0; run < runs.size(); ++run)
    if (runs[run] && !values.is_na(run)) return true;
  return false;
}

/// Whether a quantity is one of failures, too: a score, or a count such as collisions.
bool is_event(const QuantityInfo& info) {
  return info.kind == QuantityKind::Score || info.kind == QuantityKind::Count ||
         outcome_of_name(info.id).has_value();
}

/// A time or length of -1 stands for a missing one.
void expect_no_negative(const ValueColumn& values, const std::vector<bool>& lost,
                        const CsvTable& csv) {
  if (!is_extent(words_of(values.info().id))) return;
  for (std::size_t run = 0; run < lost.size(); ++run)
    if (!lost[run] && !values.is_na(run) && values.number(run) < 0)
      throw file_error(csv.where(run),
                       "'" + values.info().id + "' is " + format_number(values.number(run)),
                       "a number from 0, or NA");
}

/// Scores are 0 in runs that failed.
void expect_scores(const ResultTable& table, const CsvTable& csv) {
  for (const ValueColumn& values : table.metrics)
    for (std::size_t run = 0; run < table.size(); ++run) {
      const std::string& outcome = table.outcomes[table.outcome[run]];
      if (values.info().kind == QuantityKind::Score && is_failure(outcome) && !values.is_na(run) &&
          values.number(run) != 0)
        throw file_error(
            csv.where(run),
            "the outcome is " + outcome + ", but '" + values.info().id + "' is " +
                format_number(values.number(run)),
            "0, as a score is in runs that failed, or --kind " + values.info().id + "=ratio");
    }
}

}  // namespace

bool is_end_name(const std::string& name) {
  return outcome_of_name(name).has_value();
}

bool is_time_name(const std::string& name) {
  const std::vector<std::string> words = words_of(name);
  return is_conditional_name(name) && (has_any(words, words_of_times()) || has_mark_of_time(words));
}

const ValueColumn* collision_column(const ResultTable& table) {
  for (const EndColumn& column : end_columns(table, {}))
    if (column.outcome == "collision") return column.values;
  return nullptr;
}

std::vector<std::string> complete_outcomes(ResultTable& table, const CsvTable& csv,
                                           bool has_outcomes, const CsvColumnOptions& options) {
  const std::vector<EndColumn> columns = end_columns(table, options);
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
  expect_scores(table, csv);
  return taken;
}

std::vector<std::string> make_conditional(ResultTable& table, const CsvTable& csv, bool is_export,
                                          const CsvColumnOptions& options) {
  std::vector<bool> failed, lost;  // all but successes; unknown ends if successes are known
  const bool has_success = find_metric(table, kSuccess) != nullptr;
  bool any_known = false;
  for (const std::uint32_t outcome : table.outcome) {
    const std::string& end = table.outcomes[outcome];
    const bool is_known = end != kUnknownOutcome;
    failed.push_back(is_failure(end));
    lost.push_back(is_known ? end != kSuccess : has_success);
    any_known = any_known || is_known;
  }
  const auto is_known = [&](const std::string& id) {
    return std::any_of(options.known.begin(), options.known.end(),
                       [&](const QuantityInfo& info) { return info.id == id; });
  };
  std::vector<std::string> conditional, counting, of_all;
  for (ValueColumn& values : table.metrics) {
    const std::string id = values.info().id;
    const bool is_stated = contains(options.conditional, id);
    const bool is_measure = is_stated || contains(options.known_conditional, id) ||
                            (!(is_export && is_known(id)) && is_conditional_name(id));
    if ((values.info().is_rate() && !is_stated) || contains(options.unconditional, id)) continue;
    if (!any_known) {
      if (is_measure) of_all.push_back(id);
      continue;
    }
    if (!is_stated && is_of_scenarios(table, values, failed)) continue;
    const bool is_lost = has_value(values, lost);
    if (is_measure) {
      expect_no_negative(values, lost, csv);
      if (is_lost) table.unconditional.push_back(values);
      for (std::size_t run = 0; run < table.size(); ++run)
        if (lost[run] && !values.is_na(run))
          values.set_na(run, "outcome: " + table.outcomes[table.outcome[run]]);
    }
    const bool is_told =
        is_measure || !(is_event(values.info()) || is_known(id) || is_of_no_run(words_of(id)));
    if (is_lost && is_told) (is_measure ? conditional : counting).push_back(id);
  }
  std::vector<std::string> notes;
  const auto note = [&](const std::string& what, const std::vector<std::string>& ids,
                        const std::string& way) {
    if (!ids.empty()) notes.push_back(what + join(ids, ", ") + " (" + way + ")");
  };
  note("not available in runs that failed: ", conditional, "--unconditional");
  note("counted in runs that failed, too: ", counting, "--conditional");
  note("how runs ended is not known, so that failures count in ", of_all, "--outcome-column");
  return notes;
}

}  // namespace slalom
