// SPDX-License-Identifier: BSD-3-Clause
#include "row_table.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/performance_profile.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

double fraction_at(const PerformanceProfile& profile, double ratio) {
  double fraction = 0;
  for (const ProfileStep& step : profile.steps) {
    if (step.ratio <= ratio) fraction = step.fraction;
  }
  return fraction;
}

DataTable steps_table(const ProfileTable& profiles) {
  RowTable rows("profile_" + profiles.column.info.id, "Performance profile, steps");
  for (const PerformanceProfile& profile : profiles.profiles) {
    for (const ProfileStep& step : profile.steps) {
      rows.begin_row();
      rows.add("method", Field{profile.method});
      rows.add("ratio", std::optional(step.ratio));
      rows.add("fraction", std::optional(step.fraction));
    }
  }
  return rows.table();
}

DataTable view_table(const ProfileTable& profiles) {
  RowTable rows("profile", "Fraction of scenarios in which " + profiles.column.info.id +
                               " is within a ratio of the best method's");
  for (const PerformanceProfile& profile : profiles.profiles) {
    rows.begin_row();
    rows.add("method", Field{profile.method});
    for (const auto& [label, ratio] :
         {std::pair{"best", 1.0}, std::pair{"1.05 x", 1.05}, std::pair{"1.1 x", 1.1},
          std::pair{"1.25 x", 1.25}, std::pair{"1.5 x", 1.5}, std::pair{"2 x", 2.0},
          std::pair{"5 x", 5.0}}) {
      rows.add(label, std::optional(fraction_at(profile, ratio)));
    }
    rows.add("no value", profile.without_value);
  }
  return rows.table();
}

}  // namespace

Interpretation interpret_profile(const std::vector<ResultTable>& results,
                                 const AnalysisQuery& query) {
  selected_methods(results[0], query.method);
  Interpretation found;
  for (const std::string& metric : query.metrics) {
    ProfileTable profiles = build_profiles(results[0], metric);
    profiles.profiles = of_method(std::move(profiles.profiles), query.method);
    found.tables.push_back(steps_table(profiles));
    found.views.push_back(view_table(profiles));
    if (profiles.left_out == 0) continue;
    found.remarks.push_back(metric + ": " + std::to_string(profiles.scenarios) + " of " +
                            count_text(profiles.scenarios + profiles.left_out, "scenario") +
                            "; left out: " + std::to_string(profiles.left_out) +
                            " in which no method has a value");
  }
  return found;
}

}  // namespace slalom
