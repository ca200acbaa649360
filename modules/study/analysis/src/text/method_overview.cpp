// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/findings.h>
#include <slalom/analysis/method_overview.h>
#include <slalom/analysis/standings.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace slalom {
namespace {

constexpr const char* kSuccess = "success";
constexpr std::size_t kMaxNamedMethods = 3;

std::string percent(double fraction) {
  return share_text(fraction) + " %";
}

std::string success_clause(const MethodSummary& method, bool of_runs) {
  const Cell& cell = method.cells[0];
  std::string text = method.method + (of_runs ? " succeeds in " : " has a mean success of ") +
                     percent(*cell.estimate);
  if (cell.interval)
    text += " [" + format_fixed(100 * cell.interval->low, 0) + ", " +
            format_fixed(100 * cell.interval->high, 0) + "]";
  return text + (of_runs ? " of " : " over ") +
         count_text(cell.available, of_runs ? "run" : "value");
}

/// "it falls from 100 % to 42 % with density (in [0, 0.1) and [0.3, 0.4], p = 0.0046)"; empty if no
/// trend is shown.
std::string trend_clause(const CrossTable& table) {
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    if (table.columns[column].info.id != kSuccess) continue;
    const std::optional<Trend>& trend = table.trends[column];
    if (!is_shown(trend, table.confidence)) return "";
    const bool rises = trend->test.z > 0;
    const std::string verb = rises ? "it rises" : "it falls", p = p_text(trend->adjusted_p);
    const auto ends = trend_ends(table, column, rises);
    if (!ends) return verb + " with " + table.descriptor.id + " (" + p + ")";
    const auto& [first, last] = *ends;
    return verb + " from " + percent(*first->cells[column].estimate) + " to " +
           percent(*last->cells[column].estimate) + " with " + table.descriptor.id + " (in " +
           first->bin.label() + " and " + last->bin.label() + ", " + p + ")";
  }
  return "";
}

std::string verb_of(const std::string& outcome) {
  if (outcome == "collision") return "collides";
  if (outcome == "stuck") return "gets stuck";
  if (outcome == "timeout") return "times out";
  if (outcome == "left_workspace") return "leaves the workspace";
  if (outcome == "failure") return "fails";
  return "ends with " + outcome;
}

/// The largest rate of what happened in none of the scenarios, by the exact test of zero in n.
double bound_of_none(std::size_t scenarios, double confidence) {
  return 1 - math::exp(math::log(1 - confidence) / static_cast<double>(scenarios));
}

std::size_t count_scenarios(const std::string& method, const ResultTable& table) {
  std::set<std::uint32_t> scenarios;
  for (std::size_t i = 0; i < table.size(); ++i)
    if (table.methods[table.method[i]] == method &&
        !success_of(table.outcomes[table.outcome[i]]).is_na())
      scenarios.insert(table.scenario[i]);
  return scenarios.size();
}

/// Whether the runs of a method are known to end otherwise: the table tells collisions from other
/// ends, and has the kind of each end.
bool never_collides(const MethodSummary& method, const ResultTable& table) {
  for (const char* end : {"collision", "failure", kUnknownOutcome})
    if (method.outcomes.count(end) > 0) return false;
  return !is_foreign(table) || contains(table.outcomes, std::string("collision"));
}

/// "it gets stuck in 20 %, collides in none (at most 4.2 %)"; empty if no run is known to fail.
std::string outcome_clause(const MethodSummary& method, const ResultTable& table,
                           double confidence) {
  std::vector<std::pair<std::size_t, std::string>> failures;
  for (const auto& [outcome, n] : method.outcomes)
    if (outcome != kSuccess && outcome != kUnknownOutcome && n > 0)
      failures.emplace_back(n, outcome);
  if (failures.empty()) return "";
  std::stable_sort(failures.begin(), failures.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> parts;
  for (const auto& [n, outcome] : failures)
    parts.push_back(verb_of(outcome) + " in " +
                    percent(static_cast<double>(n) / static_cast<double>(method.n)));
  if (never_collides(method, table))
    parts.push_back(
        "collides in none (at most " +
        format_fixed(
            std::ceil(1000 * bound_of_none(count_scenarios(method.method, table), confidence)) / 10,
            1) +
        " %)");
  return "it " + join(parts, ", ");
}

/// The other side of a comparison that `method` belongs to; null if it does not.
const std::string* other_side(const PairedComparison& comparison, const std::string& method) {
  if (comparison.a == method) return &comparison.b;
  return comparison.b == method ? &comparison.a : nullptr;
}

/// "p = 0.0430, Holm over 6 pairs".
std::string corrected_text(const PairedComparison& comparison) {
  return p_text(comparison.adjusted_p) + ", " + family_text(comparison);
}

/// The differences in success that are shown, largest first.
std::vector<std::string> difference_clauses(const std::string& method,
                                            const std::vector<PairedComparison>& family) {
  std::vector<std::tuple<double, std::string, std::string>> shown;
  for (const PairedComparison& c : family) {
    const std::string* other = other_side(c, method);
    if (other == nullptr || c.column.info.id != kSuccess) continue;
    if (c.verdict != Verdict::Better && c.verdict != Verdict::Worse) continue;
    const bool better = (c.verdict == Verdict::Better) == (c.b == method);
    const double size = std::abs(*c.difference);
    shown.emplace_back(-size, *other,
                       "against " + *other + " it is " + format_fixed(size, 2) +
                           (better ? " better" : " worse") + " in success on the same scenarios, " +
                           corrected_text(c));
  }
  std::sort(shown.begin(), shown.end());
  std::vector<std::string> clauses;
  for (const auto& [order, other, text] : shown) {
    if (clauses.size() == kMaxNamedMethods) break;
    clauses.push_back(text);
  }
  if (shown.size() > clauses.size())
    clauses.push_back("differs from " + std::to_string(shown.size() - clauses.size()) + " more");
  return clauses;
}

/// Methods whose values equal those of `method` in every metric that was compared, in all of their
/// runs.
std::string identical_clause(const std::string& method,
                             const std::vector<PairedComparison>& family) {
  std::map<std::string, bool> identical;
  for (const PairedComparison& c : family) {
    const std::string* other = other_side(c, method);
    if (other == nullptr) continue;
    const auto known = identical.try_emplace(*other, true).first;
    known->second = known->second && c.verdict == Verdict::Identical && c.unpaired == 0 &&
                    (c.column.info.id != kSuccess || c.without_value == 0);
  }
  std::vector<std::string> names;
  for (const auto& [name, is_identical] : identical)
    if (is_identical) names.push_back(name);
  return names.empty() ? "" : "its values are identical to those of " + join(names, ", ");
}

/// The successes of each scenario, by method: of the runs of all other methods.
struct ScenarioCounts {
  std::vector<std::size_t> solved_by, run_by;  ///< numbers of methods
  std::vector<bool> solved;                    ///< scenario by method: all its runs succeed
};

ScenarioCounts count_scenarios(const ResultTable& table) {
  const std::size_t methods = table.methods.size(), scenarios = table.scenario_hashes.size();
  std::vector<bool> present(scenarios * methods, false);
  ScenarioCounts counts{std::vector<std::size_t>(scenarios, 0),
                        std::vector<std::size_t>(scenarios, 0),
                        std::vector<bool>(scenarios * methods, true)};
  for (std::size_t run = 0; run < table.size(); ++run) {
    const std::size_t index = table.scenario[run] * methods + table.method[run];
    present[index] = true;
    if (table.outcomes[table.outcome[run]] != kSuccess) counts.solved[index] = false;
  }
  for (std::size_t i = 0; i < present.size(); ++i) {
    counts.solved[i] = counts.solved[i] && present[i];
    counts.run_by[i / methods] += present[i] ? 1 : 0;
    counts.solved_by[i / methods] += counts.solved[i] ? 1 : 0;
  }
  return counts;
}

/// The failed runs of a method, and those that are notable, most notable first, one per scenario.
void add_failures(const ResultTable& table, const ScenarioCounts& counts, std::uint32_t method,
                  MethodOverview& entry) {
  std::vector<std::tuple<double, bool, std::size_t>> failed;  // in increasing order
  for (std::size_t run = 0; run < table.size(); ++run) {
    const std::string& outcome = table.outcomes[table.outcome[run]];
    if (table.method[run] != method || !is_failure(outcome)) continue;
    const std::size_t scenario = table.scenario[run], others = counts.run_by[scenario] - 1;
    const double solved =
        others == 0 ? 0
                    : static_cast<double>(counts.solved_by[scenario]) / static_cast<double>(others);
    ++entry.failed;
    if (solved > 0) ++entry.solved_by_others;
    if (others == 0 || solved > 0) failed.emplace_back(-solved, outcome != "collision", run);
  }
  std::sort(failed.begin(), failed.end());
  std::set<std::size_t> scenarios;
  for (const auto& [order, collided, run] : failed) {
    const std::size_t scenario = table.scenario[run];
    if (entry.failures.size() == kMaxNotableFailures) break;
    if (!scenarios.insert(scenario).second) continue;
    NotableFailure& failure = entry.failures.emplace_back();
    failure.run = run;
    failure.others = counts.run_by[scenario] - 1;
    failure.solved = counts.solved_by[scenario];
    failure.why = table.outcomes[table.outcome[run]];
    if (failure.others > 0)
      failure.why += "; others that succeed here: " + std::to_string(failure.solved) + " of " +
                     std::to_string(failure.others);
  }
}

/// "0.08 [0.01, 0.16] better over 70 scenarios, p = 0.0430, Holm over 6 pairs", of `method`.
std::string advantage_text(const PairedComparison& c, const std::string& method) {
  const double sign = c.b == method ? 1 : -1;
  const double advantage = sign * *c.difference;
  std::string text = format_fixed(std::abs(advantage), 2);
  if (c.interval) {
    double low = sign * c.interval->low, high = sign * c.interval->high;
    if (advantage < 0) low = -low, high = -high;
    text += " [" + format_fixed(std::min(low, high), 2) + ", " +
            format_fixed(std::max(low, high), 2) + "]";
  }
  return text + (advantage < 0 ? " worse" : " better") + " over " +
         count_text(c.scenarios, "scenario") + ", " + corrected_text(c);
}

/// Whether the first method is better than the second.
std::string answer(const PairedComparison* c, const std::string& first, const std::string& second) {
  if (c == nullptr || c->scenarios == 0)
    return "not compared with " + second + ": no common scenario";
  switch (c->verdict) {
    case Verdict::Identical:
      return "identical to " + second + " in " + count_text(c->pairs, "pair") + " of runs";
    case Verdict::Better:
    case Verdict::Worse:
      return "confirmed against " + second + ": " + advantage_text(*c, first);
    default:
      return "not confirmed against " + second + ": " + advantage_text(*c, first);
  }
}

}  // namespace

std::string leader_sentence(const ResultTable& table, const std::vector<PairedComparison>& family,
                            const AnalysisOptions& options) {
  const std::vector<Standing> order = build_standings(table, family, options);
  if (order.size() < 2) return "";
  const MethodSummary &first = order[0].method, &second = order[1].method;
  const double best = *first.cells[0].estimate, next = *second.cells[0].estimate;
  const bool of_runs = counts_runs(table);
  return first.method + (of_runs ? " succeeds most often (" : " has the largest mean success (") +
         percent(best) + (of_runs ? " of " + count_text(first.cells[0].available, "run") : "") +
         "), " + second.method +
         (next != best ? " second"
          : of_runs    ? " as often"
                       : " the same") +
         " (" + percent(next) + "): " +
         answer(success_comparison(family, first.method, second.method), first.method,
                second.method);
}

std::vector<MethodOverview> build_overview(const ResultTable& table,
                                           const std::vector<CrossTable>& tables,
                                           const std::vector<PairedComparison>& family,
                                           const AnalysisOptions& options) {
  std::vector<MethodOverview> overview;
  const ScenarioCounts counts = count_scenarios(table);
  for (Standing& standing : build_standings(table, family, options)) {
    const MethodSummary& method = standing.method;
    std::vector<std::string> clauses = {success_clause(method, counts_runs(table))};
    for (const CrossTable& cross : tables)
      if (cross.method == method.method) clauses.push_back(trend_clause(cross));
    clauses.push_back(outcome_clause(method, table, options.confidence));
    for (std::string& clause : difference_clauses(method.method, family))
      clauses.push_back(std::move(clause));
    clauses.push_back(identical_clause(method.method, family));
    clauses.erase(std::remove(clauses.begin(), clauses.end(), ""), clauses.end());
    MethodOverview& entry = overview.emplace_back();
    entry.sentence = join(clauses, "; ");
    add_failures(table, counts, index_of_method(table, method.method), entry);
    entry.standing = std::move(standing);
  }
  return overview;
}

}  // namespace slalom
