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

}  // namespace

std::string finding(const CrossTable& table, std::size_t column) {
  if (table.rows.size() < 2) return "";
  std::size_t speaking = 0;
  const CrossRow *first = nullptr, *second = nullptr;
  double largest = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Cell& a = table.rows[i].cells[column];
    if (!speaks(a)) continue;
    ++speaking;
    for (std::size_t j = i + 1; j < table.rows.size(); ++j) {
      const Cell& b = table.rows[j].cells[column];
      if (!speaks(b) || a.interval->overlaps(*b.interval)) continue;
      const double difference = std::abs(*a.estimate - *b.estimate);
      if (difference <= largest) continue;
      largest = difference;
      first = &table.rows[i];
      second = &table.rows[j];
    }
  }
  const std::string head = table.method + ": " + table.columns[column].info.id + " ";
  if (first != nullptr) {
    return head + at_bin(table, *first, column) + ", " + at_bin(table, *second, column);
  }
  if (speaking < 2) return head + "- too few runs to compare bins of " + table.descriptor.id;
  return head + "- no difference shown between bins of " + table.descriptor.id;
}

std::vector<std::string> findings(const CrossTable& table) {
  std::vector<std::string> sentences;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    if (table.columns[column].wall_clock) continue;
    std::string sentence = finding(table, column);
    if (!sentence.empty()) sentences.push_back(std::move(sentence));
  }
  return sentences;
}

}  // namespace slalom
