// SPDX-License-Identifier: BSD-3-Clause
#include "report_data.h"

#include <slalom/results/untimely_commands.h>

namespace slalom {

OrderedJson overview_json(const ReportInput& input) {
  OrderedJson json = OrderedJson::array();
  for (const MethodOverview& entry : input.overview) {
    OrderedJson failures = OrderedJson::array();
    for (const NotableFailure& failure : entry.failures)
      failures.push_back({{"run", failure.run}, {"why", failure.why}});
    json.push_back({{"method", index_of_method(input.runs, entry.standing.method.method)},
                    {"best_rank", entry.standing.best},
                    {"worst_rank", entry.standing.worst},
                    {"groups", entry.standing.letters()},
                    {"text", entry.sentence},
                    {"failures", failures}});
  }
  return json;
}

OrderedJson headlines_json(const ReportInput& input) {
  OrderedJson json = OrderedJson::array();
  for (std::size_t method = 0; method < input.runs.methods.size(); ++method)
    for (const std::string& line : input.failures.lines_of(input.runs.methods[method]))
      json.push_back({{"method", method}, {"text", line}});
  for (std::size_t method = 0; method < input.runs.methods.size(); ++method)
    for (const auto& line_of : {untimely_commands, limited_commands})
      if (const std::string line = line_of(input.runs, input.runs.methods[method]); !line.empty())
        json.push_back({{"method", method}, {"text", line}});
  return json;
}

}  // namespace slalom
