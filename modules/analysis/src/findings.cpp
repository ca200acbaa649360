#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/findings.h>

#include <cmath>

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

/// The two rows that differ most; null where no intervals are apart.
struct Contrast {
  const CrossRow* first = nullptr;
  const CrossRow* second = nullptr;
  std::size_t speaking = 0;  ///< rows with enough values
};

Contrast largest_contrast(const CrossTable& table, std::size_t column) {
  Contrast contrast;
  double largest = 0;
  for (auto a = table.rows.begin(); a != table.rows.end(); ++a) {
    const Cell& left = a->cells[column];
    if (!speaks(left)) continue;
    ++contrast.speaking;
    for (auto b = a + 1; b != table.rows.end(); ++b) {
      const Cell& right = b->cells[column];
      if (!speaks(right) || left.interval->overlaps(*right.interval)) continue;
      const double difference = std::abs(*left.estimate - *right.estimate);
      if (difference <= largest) continue;
      largest = difference;
      contrast.first = &*a;
      contrast.second = &*b;
    }
  }
  return contrast;
}

}  // namespace

std::optional<Finding> find_difference(const CrossTable& table, std::size_t column) {
  if (table.rows.size() < 2) return std::nullopt;
  const std::string& metric = table.columns[column].info.id;
  Finding finding{table.method, table.descriptor.id, metric, Finding::Verdict::TooFewRuns, ""};
  const Contrast contrast = largest_contrast(table, column);
  const std::string head = table.method + ": " + metric;
  if (contrast.first != nullptr) {
    finding.verdict = Finding::Verdict::Difference;
    finding.text = head + " " + at_bin(table, *contrast.first, column) + ", " +
                   at_bin(table, *contrast.second, column);
  } else if (contrast.speaking < 2) {
    finding.text = head + ": too few runs to compare bins of " + table.descriptor.id;
  } else {
    finding.verdict = Finding::Verdict::NoDifference;
    finding.text = head + ": no difference shown between bins of " + table.descriptor.id;
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

}  // namespace slalom
