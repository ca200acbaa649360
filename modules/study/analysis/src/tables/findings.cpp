// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/findings.h>
#include <slalom/core/text.h>

#include <map>
#include <utility>

namespace slalom {
namespace {

std::string in_bin(const CrossTable& table, const CrossRow& row, std::size_t column) {
  return value_text(row.cells[column], column_digits(table, column)) + " in " + row.bin.label();
}

/// ", from 0.9 [...] in [0, 1) to 0.5 [...] in [3, 4]": the outer bins with values; empty if they
/// do not differ in the direction of the trend.
std::string ends_text(const CrossTable& table, std::size_t column, bool rises) {
  const auto ends = trend_ends(table, column, rises);
  if (!ends) return "";
  return ", from " + in_bin(table, *ends->first, column) + " to " +
         in_bin(table, *ends->second, column);
}

/// "; of the 40 of 60 runs with a value" if more than a tenth have none.
std::string missing_note(const CrossTable& table, std::size_t column) {
  std::size_t runs = 0, available = 0;
  for (const CrossRow& row : table.rows) {
    runs += row.cells[column].n;
    available += row.cells[column].available;
  }
  if (!is_survivors_only(runs, available)) return "";
  return "; of the " + std::to_string(available) + " of " + count_text(runs, "run") +
         " with a value";
}

std::string trend_sentence(const CrossTable& table, std::size_t column, const Trend& trend) {
  const bool rises = trend.test.z > 0;
  return table.method + ": " + table.columns[column].info.id + (rises ? " rises" : " falls") +
         " with " + table.descriptor.id + ends_text(table, column, rises) + ", " +
         p_text(trend.adjusted_p) + " (" + to_string(trend.test.kind) + ", Holm)" +
         missing_note(table, column);
}

std::string rest_sentence(const std::string& method, Finding::Verdict verdict,
                          const std::string& metrics, const std::string& descriptor) {
  if (verdict == Finding::Verdict::TooFewRuns)
    return method + ": too few runs for a trend of " + metrics + " by " + descriptor;
  return method + ": no trend shown in " + metrics + " by " + descriptor;
}

}  // namespace

std::optional<std::pair<const CrossRow*, const CrossRow*>> trend_ends(const CrossTable& table,
                                                                      std::size_t column,
                                                                      bool rises) {
  const CrossRow *first = nullptr, *last = nullptr;
  for (const CrossRow& row : table.rows) {
    if (!row.cells[column].estimate) continue;
    if (first == nullptr) first = &row;
    last = &row;
  }
  if (first == nullptr) return std::nullopt;
  const double from = *first->cells[column].estimate, to = *last->cells[column].estimate;
  if (rises ? to <= from : to >= from) return std::nullopt;
  return std::pair(first, last);
}

bool is_shown(const std::optional<Trend>& trend, double confidence) {
  return trend && trend->test.kind != TrendTest::Kind::NoVariation &&
         trend->adjusted_p <= test_level(confidence);
}

std::vector<Finding> findings(const CrossTable& table) {
  std::vector<Finding> all;
  if (table.rows.size() < 2) return all;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    if (table.columns[column].wall_clock) continue;
    const std::string& metric = table.columns[column].info.id;
    const std::optional<Trend>& trend = table.trends[column];
    Finding found{table.method, table.descriptor.id, metric,
                  trend ? Finding::Verdict::NoTrend : Finding::Verdict::TooFewRuns, ""};
    if (is_shown(trend, table.confidence)) {
      found.verdict = Finding::Verdict::Trend;
      found.text = trend_sentence(table, column, *trend);
    } else {
      found.text = rest_sentence(table.method, found.verdict, metric, table.descriptor.id);
    }
    all.push_back(std::move(found));
  }
  return all;
}

std::vector<Finding> condensed_findings(const CrossTable& table) {
  std::vector<Finding> condensed;
  std::map<Finding::Verdict, std::vector<std::string>> rest;
  for (Finding& finding : findings(table)) {
    if (finding.verdict == Finding::Verdict::Trend) {
      condensed.push_back(std::move(finding));
    } else {
      rest[finding.verdict].push_back(finding.metric);
    }
  }
  for (const auto& [verdict, metrics] : rest) {
    const std::string list = join(metrics, ", ");
    condensed.push_back({table.method, table.descriptor.id, list, verdict,
                         rest_sentence(table.method, verdict, list, table.descriptor.id)});
  }
  return condensed;
}

}  // namespace slalom
