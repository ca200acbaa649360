// SPDX-License-Identifier: BSD-3-Clause
#include "report_data.h"

#include <slalom/analysis/method_overview.h>
#include <slalom/results/untimely_commands.h>

namespace slalom {

OrderedJson overview_json(const ReportInput& input,
                          const std::vector<PairedComparison>& comparisons) {
  std::vector<CrossTable> tables;
  for (const auto& group : input.tables) tables.insert(tables.end(), group.begin(), group.end());
  OrderedJson json = OrderedJson::array();
  for (const MethodOverview& entry :
       build_overview(input.runs, tables, comparisons, input.options.analysis)) {
    OrderedJson failures = OrderedJson::array();
    for (const NotableFailure& failure : entry.failures)
      failures.push_back({{"run", failure.run}, {"why", failure.why}});
    json.push_back({{"method", index_of_method(input.runs, entry.method)},
                    {"text", entry.sentence},
                    {"failures", failures}});
  }
  return json;
}

OrderedJson headlines_json(const ReportInput& input,
                           const std::vector<PairedComparison>& comparisons) {
  OrderedJson json = OrderedJson::array();
  const std::string leader =
      input.is_selected() ? "" : leader_sentence(input.runs, comparisons, input.options.analysis);
  for (std::size_t method = 0; method < input.runs.methods.size(); ++method)
    for (const std::string& line : input.failures.lines_of(input.runs.methods[method]))
      json.push_back({{"method", method}, {"text", line}});
  for (std::size_t method = 0; method < input.runs.methods.size(); ++method)
    for (const auto& line_of : {untimely_commands, limited_commands})
      if (const std::string line = line_of(input.runs, input.runs.methods[method]); !line.empty())
        json.push_back({{"method", method}, {"text", line}});
  if (!leader.empty()) json.push_back({{"method", nullptr}, {"text", leader}});
  return json;
}

}  // namespace slalom
