// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/results/untimely_commands.h>

namespace slalom {

std::string untimely_commands(const ResultTable& table, const std::string& method) {
  std::vector<std::string> counted;
  std::vector<bool> affected(table.size());
  for (const char* const how : {"missing", "stale", "late"}) {
    const ValueColumn* column = find_metric(table, std::string("commands_") + how);
    if (column == nullptr) continue;
    double count = 0;
    for (std::size_t row = 0; row < table.size(); ++row) {
      if (table.methods[table.method[row]] != method || !(column->number(row) > 0)) continue;
      count += column->number(row);
      affected[row] = true;
    }
    if (count > 0) counted.push_back(std::string(how) + " (" + format_number(count) + ")");
  }
  if (counted.empty()) return "";
  std::size_t runs = 0, all = 0;
  for (std::size_t row = 0; row < table.size(); ++row) {
    if (table.methods[table.method[row]] != method) continue;
    ++all;
    if (affected[row]) ++runs;
  }
  return method + ": commands were " + join(counted, " or ") + " in " + std::to_string(runs) +
         " of " + count_text(all, "run") + ", which depend on the speed of the machine";
}

}  // namespace slalom
