#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/findings.h>
#include <slalom/core/text.h>

#include <map>
#include <utility>

namespace slalom {
namespace {

constexpr std::size_t kFewestValues = 10;

bool speaks(const Cell& cell) {
  return cell.available >= kFewestValues && cell.interval;
}

std::string at_bin(const CrossTable& table, const CrossRow& row, std::size_t column) {
  const int digits = column_digits(table, column);
  return estimate_text(row.cells[column], digits) + " " + interval_text(row.cells[column], digits) +
         " at " + table.descriptor.id + " in " + row.bin.label();
}

/// The lowest and the highest row with enough values; null where there are not two.
std::pair<const CrossRow*, const CrossRow*> ends(const CrossTable& table, std::size_t column) {
  std::vector<const CrossRow*> speaking;
  for (const CrossRow& row : table.rows) {
    if (speaks(row.cells[column])) speaking.push_back(&row);
  }
  if (speaking.size() < 2) return {nullptr, nullptr};
  return {speaking.front(), speaking.back()};
}

}  // namespace

std::optional<Finding> find_difference(const CrossTable& table, std::size_t column) {
  if (table.rows.size() < 2) return std::nullopt;
  const std::string& metric = table.columns[column].info.id;
  const std::string head = table.method + ": " + metric;
  Finding finding{table.method, table.descriptor.id, metric, Finding::Verdict::TooFewRuns, ""};
  const auto [low, high] = ends(table, column);
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
