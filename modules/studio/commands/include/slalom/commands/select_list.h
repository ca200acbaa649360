// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/commands/describe_list.h>

#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// A selection of scenarios as specified by a user; empty texts select and order nothing.
struct SelectionRequest {
  std::string where;     ///< a condition, see parse_selection()
  std::string ids;       ///< ids or names, comma-separated
  std::string order_by;  ///< see parse_selection_order()
  long long limit = -1;  ///< maximum number of scenarios; negative: none
  std::string results;   ///< a result file, whose ResultFields can be used; may be empty

  bool has_condition() const { return !where.empty() || !ids.empty(); }
};

/// "where density < 0.2, ids a,b" without order and limit.
std::string condition_text(const SelectionRequest& request);
/// " where density < 0.2 ids a,b order by name limit 3", for the note about the origin of a list.
std::string origin_text(const SelectionRequest& request);

/// Computes the missing values of these descriptors, stores them in the list and returns their
/// keys. options.ids has no effect.
DescriptorView describe_list(ScenarioList& list, DescribeOptions options,
                             std::vector<std::string> ids, Progress& progress);

/// Parses the request; computes and stores the missing values that it requires. Throws Error
/// (Usage) for malformed texts and unknown ids, and if the options are not those of an index that
/// is used; Error (File) if the results cannot be read.
ListSelection select_scenarios(ScenarioList& list, const SelectionRequest& request,
                               const DescribeOptions& options, Progress& progress);

/// Reads "density:0.01,confinement:0.02", see make_deduplicate(). Throws Error (Usage) at the
/// option `where`.
std::vector<std::pair<std::string, double>> parse_min_differences(const std::string& text,
                                                                  const std::string& where);

}  // namespace slalom
