// SPDX-License-Identifier: BSD-3-Clause
#include "leaderboard.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/findings.h>
#include <slalom/analysis/table_types.h>
#include <slalom/core/text.h>
#include <slalom/io/svg_scene.h>
#include <slalom/results/repeatability.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace slalom {
namespace {

constexpr const char* kSuccess = "success";
constexpr std::size_t kFullRows = 4;  ///< with pictures, unless there are more methods
constexpr std::size_t kRowsBeforeFold = 6;
constexpr std::size_t kDifferences = 4;  ///< that are listed
constexpr std::size_t kOtherCurves = 6;

Markup tag(const std::string& name, const std::vector<Markup>& children,
           const std::string& classes = "") {
  return Markup::element(name, children, classes);
}

Markup node(const std::string& name, const Attributes& attributes,
            const std::vector<Markup>& children = {}) {
  return Markup::element(name, attributes, children);
}

std::string interval_of_percent(const Interval& interval) {
  return "[" + format_fixed(100 * interval.low, 0) + ", " + format_fixed(100 * interval.high, 0) +
         "]";
}

std::string signed_text(double number) {
  return (number < 0 ? "−" : "+") + format_fixed(std::abs(number), 2);
}

/// The class of an outcome in report.css, as in common.js.
std::string outcome_kind(const std::string& outcome) {
  if (outcome == kSuccess) return "good";
  if (outcome == "collision") return "hit";
  if (outcome == "left_workspace") return "left";
  if (outcome == "timeout") return "late";
  if (outcome == "stuck") return "stuck";
  return starts_with(outcome, "method_") ? "fault" : "odd";
}

std::size_t column_of_success(const std::vector<Column>& columns) {
  const auto is_success = [](const Column& column) { return column.info.id == kSuccess; };
  return static_cast<std::size_t>(std::find_if(columns.begin(), columns.end(), is_success) -
                                  columns.begin());
}

std::string point(double x, double y) {
  return fmt::format("{:.1f},{:.1f}", x, y);
}

/// The place of a bin in a curve of 190 by 66 pixels, whose axes are at 12 (1) and 48 (0).
double x_of(const CrossTable& table, std::size_t bin) {
  constexpr double kLeft = 26, kRight = 176;
  return kLeft + (static_cast<double>(bin) + 0.5) * (kRight - kLeft) /
                     static_cast<double>(table.rows.size());
}

double y_of(double rate) {
  constexpr double kTop = 12, kBottom = 48;
  return kBottom - rate * (kBottom - kTop);
}

/// The success over the bins of a table.
Markup curve_of(const CrossTable& table, const std::string& classes) {
  std::string points;
  for (std::size_t bin = 0; bin < table.rows.size(); ++bin)
    if (const auto& rate = table.rows[bin].cells[column_of_success(table.columns)].estimate)
      points += (points.empty() ? "" : " ") + point(x_of(table, bin), y_of(*rate));
  return node("polyline", {{"class", classes}, {"points", points}});
}

/// Adds the points of a curve, with intervals, values and the edges between bins. Returns the same
/// in words.
std::string add_points(const CrossTable& table, std::vector<Markup>& drawn) {
  std::string label = "success by " + table.descriptor.name + ":";
  for (std::size_t bin = 0; bin < table.rows.size(); ++bin) {
    const CrossRow& line = table.rows[bin];
    const Cell& cell = line.cells[column_of_success(table.columns)];
    const auto add_text = [&](const char* name, double x, double y, const std::string& text) {
      drawn.push_back(node("text",
                           {{"class", name},
                            {"x", fmt::format("{:.1f}", x)},
                            {"y", fmt::format("{:.1f}", y)},
                            {"text-anchor", "middle"}},
                           {text}));
    };
    const double x = x_of(table, bin);
    if (bin > 0 && line.bin.low)
      add_text("edge", (x + x_of(table, bin - 1)) / 2, 62, format_number(*line.bin.low));
    if (!cell.estimate) continue;
    const double y = y_of(*cell.estimate);
    label += " " + line.bin.label() + " " + share_text(*cell.estimate) + " %;";
    if (cell.interval)
      drawn.push_back(
          node("path", {{"class", "error"},
                        {"d", fmt::format("M{:.1f} {:.1f}V{:.1f}", x, y_of(cell.interval->high),
                                          y_of(cell.interval->low))}}));
    drawn.push_back(
        node("circle",
             {{"cx", fmt::format("{:.1f}", x)}, {"cy", fmt::format("{:.1f}", y)}, {"r", "3"}}));
    add_text("value", x, y + (*cell.estimate > 0.5 ? 13 : -6), share_text(*cell.estimate));
  }
  return label;
}

/// A paired difference as that of a method over the other side, with its interval.
struct Advantage {
  double value;
  std::string text;  ///< "+0.11 [0.03, 0.21]"
  std::optional<Interval> interval;
};

Advantage advantage_of(const PairedComparison& c, const std::string& method) {
  const double sign = c.b == method ? 1 : -1;
  Advantage found{sign * *c.difference, "", {}};
  found.text = signed_text(found.value);
  if (!c.interval) return found;
  found.interval = sign > 0 ? *c.interval : Interval{-c.interval->high, -c.interval->low};
  found.text +=
      " [" + signed_text(found.interval->low) + ", " + signed_text(found.interval->high) + "]";
  return found;
}

bool is_decided(const PairedComparison& c) {
  return c.verdict == Verdict::Better || c.verdict == Verdict::Worse;
}

std::string shell_word(const std::string& text) {
  const bool plain = !text.empty() && text.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_./@:+=,-") == std::string::npos;
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

Markup command(const std::string& line) {
  return tag("code", {line}, "command");
}

}  // namespace

Leaderboard::Leaderboard(const ReportInput& input, const CommonFacts& facts)
    : input_(input),
      facts_(facts),
      rows_(input.overview),
      pairs_(input.overview.size(),
             std::vector<const PairedComparison*>(input.overview.size(), nullptr)),
      counts_runs_(counts_runs(input.runs)) {
  find_pairs();
  count_solved();
  choose_curve();
  std::vector<std::string> metrics;
  for (const char* id : {"time_to_goal", "optimality"})
    if (find_metric(input.runs, id) != nullptr) metrics.emplace_back(id);
  if (rows_.empty() || metrics.empty()) return;
  for (const Column& column : resolve_columns(input.runs, metrics))
    common_.push_back(make_common_scenarios(input.runs, column, input.options.analysis));
}

void Leaderboard::find_pairs() {
  std::map<std::string, std::size_t> row_of;
  for (std::size_t row = 0; row < rows_.size(); ++row) row_of[name(row)] = row;
  for (const PairedComparison& c : input_.comparisons) {
    const auto a = row_of.find(c.a), b = row_of.find(c.b);
    if (c.column.info.id != kSuccess || a == row_of.end() || b == row_of.end()) continue;
    pairs_[a->second][b->second] = pairs_[b->second][a->second] = &c;
  }
}

bool Leaderboard::beats(std::size_t row, std::size_t other) const {
  const PairedComparison* c = pairs_[row][other];
  return c != nullptr && is_decided(*c) && (c->verdict == Verdict::Better) == (c->b == name(row));
}

void Leaderboard::count_solved() {
  const ResultTable& runs = input_.runs;
  std::set<std::uint32_t> all, solved;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    all.insert(runs.scenario[run]);
    const std::string& outcome = runs.outcomes[runs.outcome[run]];
    if (outcome == kSuccess) solved.insert(runs.scenario[run]);
    knows_outcomes_ = knows_outcomes_ && outcome != kUnknownOutcome;
  }
  scenarios_ = all.size();
  solved_by_any_ = solved.size();
}

void Leaderboard::choose_curve() {
  double most = -1;
  for (std::size_t i = 0; i < input_.tables.size(); ++i) {
    double sum = 0;
    bool has_bins = false;
    for (const CrossTable& table : input_.tables[i]) {
      const std::size_t column = column_of_success(table.columns);
      if (column == table.columns.size()) continue;
      has_bins = has_bins || table.rows.size() > 1;
      const auto& trend = table.trends[column];
      if (trend) sum += trend->test.z * trend->test.z;
    }
    if (!has_bins || sum <= most) continue;
    most = sum;
    curve_ = i;
    has_curve_ = true;
  }
}

std::string Leaderboard::color(std::size_t row) const {
  return method_color(index_of_method(input_.runs, name(row)));
}

std::string Leaderboard::runs_text(std::size_t row) const {
  const Cell& cell = rows_[row].standing.method.cells[0];
  const auto successes =
      static_cast<std::size_t>(std::llround(*cell.estimate * static_cast<double>(cell.available)));
  return std::to_string(successes) + " of " + count_text(cell.available, "run");
}

/// "a", or "a and 3 more"; requires one.
std::string Leaderboard::names_text(const std::vector<std::size_t>& rows) const {
  return name(rows[0]) +
         (rows.size() > 1 ? " and " + std::to_string(rows.size() - 1) + " more" : "");
}

std::string Leaderboard::answer() const {
  if (rows_.empty()) return campaign_name(input_.runs.manifest);
  if (solved_by_any_ == 0 && knows_outcomes_)
    return "No method reaches the goal in any of " + count_text(input_.runs.size(), "run");
  const double rate = *rows_[0].standing.method.cells[0].estimate;
  const std::string mean = "a mean success of " + format_fixed(rate, 2);
  const std::string reaches = counts_runs_ ? "reaches the goal in " + runs_text(0) : "has " + mean;
  if (rows_.size() == 1) return name(0) + " " + reaches;
  std::vector<std::size_t> equal, open, better;
  for (std::size_t row = 1; row < rows_.size(); ++row) {
    if (beats(0, row)) continue;
    (beats(row, 0) ? better : open).push_back(row);
    if (*rows_[row].standing.method.cells[0].estimate == rate) equal.push_back(row);
  }
  if (!better.empty())
    return name(0) +
           (counts_runs_ ? " succeeds most often, in " + runs_text(0)
                         : " has the largest mean success, " + format_fixed(rate, 2)) +
           ", but " + names_text(better) + (better.size() == 1 ? " is" : " are") +
           " better in the scenarios of both";
  if (!equal.empty())
    return name(0) + (equal.size() > 1 ? ", " : " and ") + names_text(equal) +
           " lead with a success of " + share_text(rate) + " %: they are not told apart";
  if (open.empty()) return name(0) + " is best: it " + reaches;
  return name(0) + " leads with " + (counts_runs_ ? runs_text(0) : mean) + ", but " +
         names_text(open) + (open.size() == 1 ? " is" : " are") + " not told apart from it";
}

Markup Leaderboard::certainty() const {
  if (rows_.empty()) return {};
  std::vector<std::string> sentences;
  const PairedComparison* c = rows_.size() < 2 ? nullptr : pairs_[0][1];
  if (rows_.size() == 1 && rows_[0].standing.method.cells[0].interval)
    sentences.push_back(
        "Its " + std::string(counts_runs_ ? "success rate" : "mean success") + " is within " +
        interval_of_percent(*rows_[0].standing.method.cells[0].interval) + " % with " +
        percent_text(input_.options.analysis.confidence) + " % confidence.");
  if (c != nullptr && c->scenarios > 0 && c->difference) {
    const bool b_first = c->b == name(0);
    const std::size_t more = b_first ? c->higher : c->lower, fewer = b_first ? c->lower : c->higher;
    sentences.push_back(
        "It does better than " + name(1) + ", the second, in " + count_text(more, "scenario") +
        ", and worse in " + std::to_string(fewer) + ": " + advantage_of(*c, name(0)).text + ", " +
        p_text(c->adjusted_p) + ". The lead is " +
        (beats(0, 1)                        ? (!note_on_stopping(input_.runs.manifest).empty()
                                                   ? "shown for a number of scenarios that was chosen beforehand, but "
                                                     "--until chose it by the results: see until.txt."
                                               : c->adjusted_p > 0.01 ? "shown, but narrowly."
                                                                      : "shown clearly.")
         : c->verdict == Verdict::Identical ? "none: their values are identical."
                                            : "not shown."));
  } else if (rows_.size() > 1) {
    sentences.push_back(name(0) + " and " + name(1) + " have no scenario in common.");
  }
  if (knows_outcomes_ && solved_by_any_ < scenarios_)
    sentences.push_back("In " + std::to_string(scenarios_ - solved_by_any_) + " of " +
                        count_text(scenarios_, "scenario") + " no method reaches the goal.");
  return tag("p", {tag("b", {"How sure?"}), " " + join(sentences, " ")}, "sure");
}

Markup Leaderboard::rank_cell(std::size_t row) const {
  const Standing& standing = rows_[row].standing;
  const std::string rank =
      std::to_string(standing.best) +
      (standing.worst > standing.best ? "–" + std::to_string(standing.worst) : "");
  return tag("td", {tag("b", {rank}), tag("span", {"group " + standing.letters()}, "support")},
             "rank");
}

Markup Leaderboard::method_cell(std::size_t row) const {
  const std::size_t method = index_of_method(input_.runs, name(row));
  std::vector<Markup> parts = {
      node("i", {{"class", "swatch"}, {"style", "background:" + color(row)}}),
      node("a", {{"href", "method.html#" + std::to_string(method + 1)}, {"title", name(row)}},
           {name(row)})};
  for (const CommonScenarios& common : common_) {
    const Cell& cell = common.cells[method];
    std::vector<const Cell*> all;
    for (const Cell& other : common.cells) all.push_back(&other);
    const int digits = digits_for(all, common.column);
    const std::string unit = common.column.info.unit == "-" ? "" : " " + common.column.info.unit;
    parts.push_back(tag(
        "span",
        {tag("b", {cell.estimate ? format_fixed(states_median(common.column.info) ? *cell.median
                                                                                  : *cell.estimate,
                                                digits) +
                                       unit
                                 : "–"}),
         " " + interval_text(cell, digits)},
        "support"));
  }
  return node("th", {{"scope", "row"}, {"class", "method"}}, parts);
}

Markup Leaderboard::success_cell(std::size_t row) const {
  constexpr double kWidth = 290, kAxis = 6;
  const MethodSummary& method = rows_[row].standing.method;
  const Cell& cell = method.cells[0];
  std::size_t most = 0;
  for (const MethodOverview& other : rows_) most = std::max(most, other.standing.method.n);
  std::vector<Markup> drawn = {
      node("path", {{"class", "grid"}, {"d", "M.5 0V12M145 0V12M289.5 0V12"}})};
  if (knows_outcomes_ && rows_.size() > 1) {
    const double any = kWidth * static_cast<double>(solved_by_any_) /
                       static_cast<double>(std::max<std::size_t>(scenarios_, 1));
    drawn.push_back(node("path", {{"class", "any"}, {"d", fmt::format("M{:.1f} 0V12", any)}}));
  }
  if (cell.interval)
    drawn.push_back(node(
        "path", {{"class", "interval"},
                 {"d", fmt::format("M{0:.1f} 6H{1:.1f}M{0:.1f} 2v8M{1:.1f} 2v8",
                                   kWidth * cell.interval->low, kWidth * cell.interval->high)}}));
  drawn.push_back(node("circle", {{"cx", fmt::format("{:.1f}", kWidth * *cell.estimate)},
                                  {"cy", fmt::format("{}", kAxis)},
                                  {"r", "4.5"}}));
  std::vector<Markup> parts, keys;
  std::string label;
  for (const std::string& outcome : input_.summary.outcomes) {  // success first
    const auto found = method.outcomes.find(outcome);
    if (found == method.outcomes.end() || found->second == 0) continue;
    const std::string n = std::to_string(found->second), kind = outcome_kind(outcome);
    parts.push_back(node("i", {{"class", kind}, {"style", "flex:" + n}}));
    keys.push_back(node(
        "span", {{"class", "key"}},
        {node("span", {{"class", "bar"}}, {node("i", {{"class", kind}})}), n + " " + outcome}));
    label += (label.empty() ? "" : ", ") + n + " " + outcome;
  }
  const std::string height = fmt::format(
      "height:{:.0f}px", std::max(4.0, 14.0 * static_cast<double>(method.n) /
                                           static_cast<double>(std::max<std::size_t>(most, 1))));
  return node(
      "td", {{"class", "success"}},
      {tag("span", {share_text(*cell.estimate) + " %"}, "big"),
       tag("span", {cell.interval ? " " + interval_of_percent(*cell.interval) : ""}, "soft"),
       node("svg", {{"class", "axis"}, {"viewBox", "0 0 290 12"}, {"aria-hidden", "true"}}, drawn),
       node("div", {{"class", "bar"}, {"style", height}, {"role", "img"}, {"aria-label", label}},
            parts),
       tag("div", keys, "keys")});
}

Markup Leaderboard::curve_cell(std::size_t row) const {
  std::vector<Markup> drawn = {
      node("path", {{"class", "grid"}, {"d", "M26 12H176M26 48H176"}}),
      node("text", {{"x", "22"}, {"y", "16"}, {"text-anchor", "end"}}, {"100"}),
      node("text", {{"x", "22"}, {"y", "52"}, {"text-anchor", "end"}}, {"0"})};
  const CrossTable* own = nullptr;
  for (const CrossTable& table : input_.tables[curve_]) {
    if (table.method == name(row)) own = &table;
    const bool is_drawn = rows_.size() <= kOtherCurves ? table.method != name(row)
                                                       : table.method == name(0) && row > 0;
    if (is_drawn) drawn.push_back(curve_of(table, "other"));
  }
  if (own == nullptr) return tag("td", {"–"});
  const std::optional<Trend>& trend = own->trends[column_of_success(own->columns)];
  const bool shown = is_shown(trend, own->confidence);
  drawn.push_back(curve_of(*own, shown ? "own" : "own unsure"));
  const std::string label = add_points(*own, drawn);
  const Markup caption =
      shown ? tag("span",
                  {tag("b", {trend->test.z > 0 ? "rises" : "falls"}),
                   ", " + p_text(trend->adjusted_p)},
                  "support")
            : tag("span", {trend ? "no trend shown" : "too few runs for a trend"}, "support");
  return node(
      "td", {{"class", "curve"}},
      {node("svg", {{"viewBox", "0 0 190 66"}, {"role", "img"}, {"aria-label", label}}, drawn),
       caption});
}

Markup Leaderboard::why_cell(std::size_t row) const {
  const MethodOverview& entry = rows_[row];
  const std::size_t method = index_of_method(input_.runs, name(row));
  std::vector<Markup> text;
  if (entry.standing.method.outcomes.count(kUnknownOutcome) > 0) {
    text.push_back("How its runs end is not recorded.");
  } else if (entry.failed == 0) {
    text.push_back("No failure in these runs.");
  } else {
    text.push_back(tag("b", {count_text(entry.failed, "failure")}));
    if (rows_.size() > 1)
      text.push_back("; other methods solve " + std::to_string(entry.solved_by_others) +
                     " of them");
    text.push_back(". ");
    if (const auto common = facts_.of(method)) {
      text.push_back(
          tag("b", {std::to_string(common->count) + " of " + std::to_string(common->failures)}));
      text.push_back(" " + common->text + (ends_with(common->text, "?") ? "" : "."));
    }
  }
  std::vector<Markup> parts = {tag("p", text)};
  const bool has_pictures = (rows_.size() <= kFullRows || row == 0) && !is_foreign(input_.runs);
  std::vector<Markup> figures;
  for (const NotableFailure& failure : entry.failures) {
    const std::size_t run = failure.run, scenario = input_.runs.scenario[run];
    figures.push_back(
        node("a",
             {{"href", "run.html#" + run_id(input_.runs, run)},
              {"title", input_.runs.scenario_names[scenario] + ": " + failure.why}},
             {node("span", {{"class", "picture"}, {"data-failure", std::to_string(run)}}),
              tag("span",
                  {failure.others == 0 ? input_.runs.outcomes[input_.runs.outcome[run]]
                                       : std::to_string(failure.solved) + " of " +
                                             std::to_string(failure.others) + " solve"},
                  "support")}));
  }
  const std::size_t unsolved = entry.failed - entry.solved_by_others;
  if (figures.size() < kMaxNotableFailures && rows_.size() > 1 && unsolved > 0)
    figures.push_back(node("a", {{"class", "more"}, {"href", "runs.html"}},
                           {std::to_string(unsolved) + " that no other method solves"}));
  if (has_pictures && !figures.empty()) parts.push_back(tag("div", figures, "failures"));
  return node("td", {{"class", "why"}}, {tag("div", parts)});
}

Markup Leaderboard::row(std::size_t index) const {
  std::vector<Markup> cells;
  if (rows_.size() > 1) cells.push_back(rank_cell(index));
  cells.push_back(method_cell(index));
  cells.push_back(success_cell(index));
  if (has_curve_) cells.push_back(curve_cell(index));
  cells.push_back(why_cell(index));
  return node("tr", {{"id", "m-" + name(index)}}, cells);
}

/// "on the 37 scenarios where all succeed: median time_to_goal, optimality".
std::string Leaderboard::common_text() const {
  if (common_.empty()) return "";
  const bool same = std::all_of(common_.begin(), common_.end(), [this](const CommonScenarios& one) {
    return one.scenarios == common_[0].scenarios;
  });
  std::vector<std::string> columns;
  for (const CommonScenarios& common : common_)
    columns.push_back((states_median(common.column.info) ? "median " : "") + common.column.info.id +
                      (same ? "" : " (" + count_text(common.scenarios, "scenario") + ")"));
  return (same ? "on the " + count_text(common_[0].scenarios, "scenario") + " " : "") +
         (rows_.size() > 1 ? "where all succeed: " : "where it succeeds: ") + join(columns, ", ");
}

Markup Leaderboard::head() const {
  const auto column = [](const std::string& question, const std::string& note) {
    return node("th", {{"scope", "col"}}, {question, tag("small", {note})});
  };
  std::vector<Markup> cells;
  if (rows_.size() > 1) cells.push_back(column("Rank", ""));
  cells.push_back(column("Method", common_text()));
  cells.push_back(column(
      "How good, how sure?",
      "success with its " + percent_text(input_.options.analysis.confidence) +
          " % interval; outcomes of the runs" +
          (knows_outcomes_ && rows_.size() > 1
               ? fmt::format("; dashed: solved by any of the {}, {} %", rows_.size(),
                             share_text(static_cast<double>(solved_by_any_) /
                                        static_cast<double>(std::max<std::size_t>(scenarios_, 1))))
               : "")));
  if (has_curve_) {
    const QuantityInfo& by = input_.tables[curve_].front().descriptor;
    cells.push_back(column(
        "Where does it fail?",
        "success in % by " + lower_case(by.name) + (by.unit == "-" ? "" : " [" + by.unit + "]")));
  }
  cells.push_back(column("Why?", rows_.size() > 1
                                     ? "what its failures have in common; failures that "
                                       "others solve (grey: another method)"
                                     : "what its failures have in common"));
  return tag("thead", {tag("tr", cells)});
}

Markup Leaderboard::table() const {
  if (rows_.empty()) return {};
  const std::size_t visible = rows_.size() <= kRowsBeforeFold + 1 ? rows_.size() : kRowsBeforeFold;
  std::vector<Markup> first, others;
  for (std::size_t i = 0; i < rows_.size(); ++i) (i < visible ? first : others).push_back(row(i));
  const std::string classes = rows_.size() > kFullRows ? "board compact" : "board";
  std::vector<Markup> parts = {tag("table", {head(), tag("tbody", first)}, classes)};
  if (!others.empty())
    parts.push_back(tag("details", {tag("summary", {count_text(others.size(), "more method")}),
                                    tag("table", {tag("tbody", others)}, classes)}));
  return tag("div", parts, "card");
}

Markup Leaderboard::differences() const {
  std::vector<const PairedComparison*> shown;
  const PairedComparison* closest = nullptr;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    for (std::size_t j = i + 1; j < rows_.size(); ++j) {
      const PairedComparison* c = pairs_[i][j];
      if (c == nullptr || !c->difference) continue;
      ++pairs;
      if (!is_decided(*c)) {
        if (closest == nullptr || c->adjusted_p > closest->adjusted_p) closest = c;
        continue;
      }
      bool implied = false;
      for (std::size_t k = i + 1; k < j; ++k) implied = implied || (beats(i, k) && beats(k, j));
      if (!implied) shown.push_back(c);
    }
  if (pairs == 0) return {};
  const std::size_t left_out = shown.size() > kDifferences ? shown.size() - kDifferences : 0;
  shown.resize(shown.size() - left_out);
  if (closest != nullptr) shown.push_back(closest);
  std::vector<Markup> lines;
  double largest = 0.05;
  for (const PairedComparison* c : shown)
    for (const double end :
         {c->interval ? c->interval->low : 0, c->interval ? c->interval->high : 0, *c->difference})
      largest = std::max(largest, std::abs(end));
  for (const PairedComparison* c : shown) {
    const bool b_first = *c->difference > 0;
    const std::string &better = b_first ? c->b : c->a, &other = b_first ? c->a : c->b;
    const Advantage advantage = advantage_of(*c, better);
    const auto x_of = [&](double value) {
      return fmt::format("{:.1f}", 55 + 52 * value / largest);
    };
    std::vector<Markup> drawn = {node("path", {{"class", "grid"}, {"d", "M55 0V14"}})};
    if (advantage.interval)
      drawn.push_back(node("path", {{"class", "interval"},
                                    {"d", "M" + x_of(advantage.interval->low) + " 7H" +
                                              x_of(advantage.interval->high)}}));
    drawn.push_back(node("circle", {{"cx", x_of(advantage.value)}, {"cy", "7"}, {"r", "2.5"}}));
    lines.push_back(
        tag("li", {tag("span", {better + (is_decided(*c) ? " > " : " ≈ ") + other}),
                   node("svg", {{"viewBox", "0 0 110 14"}, {"aria-hidden", "true"}}, drawn),
                   tag("span", {advantage.text}), tag("span", {p_text(c->adjusted_p)}, "soft")}));
  }
  const std::string rest =
      left_out > 0 ? " " + std::to_string(left_out) + " more are shown below." : "";
  return tag("section",
             {tag("h2", {"Which differences are shown"}), tag("ul", lines, "differences"),
              tag("p",
                  {"Difference in success on the same scenarios; > shown, ≈ not told apart. Those "
                   "that follow from two others are left out." +
                   rest + " Corrected by Holm over " + count_text(pairs, "pair") + "."},
                  "support")});
}

std::optional<std::size_t> Leaderboard::focus() const {
  for (std::size_t row = 0; row < rows_.size(); ++row)
    if (unmarked_name(input_.runs, name(row)) == input_.options.focus) return row;
  return std::nullopt;
}

/// The first in the order that is not decided, one of the focus before all others.
const PairedComparison* Leaderboard::open_pair() const {
  const PairedComparison* first = nullptr;
  const std::optional<std::size_t> own = focus();
  for (std::size_t i = 0; i < rows_.size(); ++i)
    for (std::size_t j = i + 1; j < rows_.size(); ++j) {
      const PairedComparison* c = pairs_[i][j];
      if (c == nullptr || !c->difference || is_decided(*c) || c->identical) continue;
      if (!own || i == *own || j == *own) return c;
      if (first == nullptr) first = c;
    }
  return first;
}

/// " my.ini --set robot.radius=0.3", without overrides of the keys that a command sets itself.
std::string Leaderboard::campaign_words(const std::vector<std::string>& keys) const {
  std::string words;
  const std::vector<std::string>& all = input_.options.campaign;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_set = all[i] == "--set" && i + 1 < all.size();
    if (is_set && contains(keys, all[i + 1].substr(0, all[i + 1].find('='))))
      ++i;
    else
      words += " " + shell_word(all[i]);
  }
  return words;
}

Markup Leaderboard::more_scenarios() const {
  const PairedComparison* c = open_pair();
  const bool is_open = c != nullptr;
  if (!is_open && rows_.size() > 1) c = pairs_[0][1];
  const std::size_t count =
      c != nullptr && c->required_scenarios > 0 ? c->required_scenarios : std::size_t{400};
  const std::string what = rows_.size() == 1 ? "narrow the interval"
                           : c == nullptr    ? "compare the methods"
                           : is_open ? "tell " + c->a + " from " + c->b + " if they differ by " +
                                           format_fixed(c->relevant, 2) + " (" +
                                           percent_text(c->power) + " % power)"
                                     : "compare " + name(0) + " with " + name(1) + " again";
  return tag("li",
             {tag("b", {"Make sure: "}),
              count_text(count, "new scenario") + " (" + count_text(count * rows_.size(), "run") +
                  ") " + what + ".",
              command("slalom-evaluate" + campaign_words({"campaign.seed", "scenarios.count"}) +
                      " -o " + shell_word(input_.options.output + "-2") +
                      " --set campaign.seed=" + std::to_string(input_.options.seed + 1) +
                      " --set scenarios.count=" + std::to_string(count))});
}

Markup Leaderboard::look() const {
  std::size_t chosen = rows_.size();
  for (std::size_t row = 0; row < rows_.size(); ++row)
    if (rows_[row].failed > 0 &&
        (chosen == rows_.size() || rows_[row].solved_by_others > rows_[chosen].solved_by_others))
      chosen = row;
  if (chosen == rows_.size()) chosen = 0;
  chosen = focus().value_or(chosen);
  const std::string method = unmarked_name(input_.runs, name(chosen));
  const MethodOverview& entry = rows_[chosen];
  const std::string why =
      entry.failed == 0   ? "no failure of " + name(chosen) + " is known; search for one."
      : rows_.size() == 1 ? "search for the smallest scenarios in which " + name(chosen) + " fails."
                          : "others solve " + std::to_string(entry.solved_by_others) + " of the " +
                                count_text(entry.failed, "failure") + " of " + name(chosen) +
                                "; the smallest scenarios that show it:";
  return tag("li", {tag("b", {"Look: "}), why,
                    command("slalom-falsify search" + campaign_words() + " --method " +
                            shell_word(method) + " --runs 200 -o " +
                            shell_word(input_.options.output + "-failures"))});
}

Markup Leaderboard::do_better() const {
  const std::size_t own = focus().value_or(0);
  const MethodOverview& first = rows_[own];
  const std::string method = unmarked_name(input_.runs, name(own));
  const auto& interval = first.standing.method.cells[0].interval;
  if (interval && interval->low >= 0.9)
    return tag("li", {tag("b", {"Find its limit: "}),
                      "the narrowest passage that " + name(own) + " passes reliably.",
                      command("slalom-certify limit" + campaign_words() + " --method " +
                              shell_word(method) + " --of passage.width -o " +
                              shell_word(input_.options.output + ".certificate.json"))});
  return tag("li", {tag("b", {"Do better: "}),
                    "other values of the parameters that " + name(own) +
                        " declares, tested on scenarios that the search does not see.",
                    command("slalom-tune" + campaign_words() + " --method " + shell_word(method) +
                            " --runs 1000 -o " + shell_word(input_.options.output + "-tuned"))});
}

Markup Leaderboard::next_steps() const {
  if (rows_.empty() || input_.options.campaign.empty()) return {};
  std::vector<Markup> steps;
  if (input_.options.generates) steps.push_back(more_scenarios());
  steps.push_back(look());
  steps.push_back(do_better());
  return tag("section", {tag("h2", {"What next"}), tag("ol", steps, "next")});
}

}  // namespace slalom
