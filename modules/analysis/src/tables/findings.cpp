#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/findings.h>
#include <slalom/core/text.h>

#include <map>
#include <utility>

namespace slalom {
namespace {

constexpr std::size_t kMinValues = 10;

bool has_enough_values(const Cell& cell) {
  return cell.available >= kMinValues && cell.interval;
}

std::string at_bin(const CrossTable& table, const CrossRow& row, std::size_t column) {
  const int digits = column_digits(table, column);
  return estimate_text(row.cells[column], digits) + " " + interval_text(row.cells[column], digits) +
         " at " + table.descriptor.id + " in " + row.bin.label();
}

/// The lowest and the highest row with enough values; null if there are fewer than two.
std::pair<const CrossRow*, const CrossRow*> end_rows(const CrossTable& table, std::size_t column) {
  std::vector<const CrossRow*> candidates;
  for (const CrossRow& row : table.rows) {
    if (has_enough_values(row.cells[column])) candidates.push_back(&row);
  }
  if (candidates.size() < 2) return {nullptr, nullptr};
  return {candidates.front(), candidates.back()};
}

}  // namespace

std::optional<Finding> find_difference(const CrossTable& table, std::size_t column) {
  if (table.rows.size() < 2) return std::nullopt;
  const std::string& metric = table.columns[column].info.id;
  const std::string head = table.method + ": " + metric;
  Finding finding{table.method, table.descriptor.id, metric, Finding::Verdict::TooFewRuns, ""};
  const auto [low, high] = end_rows(table, column);
  if (low == nullptr) {
    finding.text = head + ": too few runs to compare bins of " + table.descriptor.id;
  } else if (low->cells[column].interval->overlaps(*high->cells[column].interval)) {
    finding.verdict = Finding::Verdict::NoDifference;
    finding.text = head + ": no difference shown between " + table.descriptor.id + " in " +
                   low->bin.label() + " and in " + high->bin.label();
  } else {
    finding.verdict = Finding::Verdict::Difference;
    finding.text = head + " " + at_bin(table, *low, column) + ", " + at_bin(table, *high, column);
  }
  return finding;
}

std::vector<Finding> findings(const CrossTable& table) {
  std::vector<Finding> all;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    if (table.columns[column].wall_clock) continue;
    if (auto finding = find_difference(table, column)) all.push_back(std::move(*finding));
  }
  return all;
}

std::vector<Finding> condensed_findings(const CrossTable& table) {
  std::vector<Finding> condensed;
  std::map<Finding::Verdict, std::vector<std::string>> rest;
  for (Finding& finding : findings(table)) {
    if (finding.verdict == Finding::Verdict::Difference) {
      condensed.push_back(std::move(finding));
    } else {
      rest[finding.verdict].push_back(finding.metric);
    }
  }
  for (const auto& [verdict, metrics] : rest) {
    const bool few = verdict == Finding::Verdict::TooFewRuns;
    const std::string what = few ? ": too few runs to compare " : ": no difference shown in ";
    condensed.push_back({table.method, table.descriptor.id, join(metrics, ", "), verdict,
                         table.method + what + join(metrics, ", ") + " by " + table.descriptor.id});
  }
  return condensed;
}

}  // namespace slalom
