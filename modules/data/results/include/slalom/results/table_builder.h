// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Builds a table from records in any order, such as those of a campaign that writes no file. The
/// table equals that read from a result file with these records.
class TableBuilder {
 public:
  TableBuilder(std::vector<QuantityInfo> descriptors, std::vector<QuantityInfo> metrics);
  TableBuilder(const TableBuilder&) = delete;
  TableBuilder& operator=(const TableBuilder&) = delete;

  void add_scenario(const ScenarioRecord& record);
  void add_run(const RunRecord& run, const RunTiming& timing);
  ResultTable finish();  ///< to be called once

 private:
  ResultTable table_;
  NameIndex scenarios_{table_.scenario_hashes};
  NameIndex methods_{table_.methods};
  NameIndex outcomes_{table_.outcomes};
  std::map<std::string, ScenarioRecord> records_;  ///< by hash
  std::map<std::string, ValueColumn> figures_;     ///< wall-clock, by id

  std::uint32_t index_of_scenario(const std::string& hash, const std::string& name);
};

}  // namespace slalom
