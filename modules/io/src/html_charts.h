#pragma once

#include "html_tables.h"
#include "report_contents.h"

#include <slalom/io/html_report.h>
#include <slalom/results/run_columns.h>

#include <string>
#include <vector>

namespace slalom {

/// What the sections below are made from.
struct ChartContext {
  const RunColumns& runs;
  const ResultTable& table;  ///< the same runs in the same order
  const ReportOptions& options;
  const ReportContents& contents;
  RunsLink link;
};

/// How many runs had arrived by when, a curve per method; "" where no times are known.
std::string completion_section(const ChartContext& context);

/// Performance profiles and critical-difference diagrams of the report's columns that have a
/// direction, as far as there are two methods to compare.
std::string ranking_section(const ChartContext& context);

/// Method against method, in sentences that claim no more than was shown: what was shown first.
std::string comparison_section(const ChartContext& context);

/// Maps of the success rate (or the first column) over the first two descriptors of the report's
/// rows, one per method; "" where there is one descriptor only. `method`: only this one.
std::string map_section(const ChartContext& context, const std::string& method = "");

/// How each descriptor of the scenarios goes together with each column, for one method.
std::string validity_table(const ChartContext& context, const std::string& method);

/// The comparisons that are about one method.
std::string comparisons_of(const ChartContext& context, const std::string& method);

}  // namespace slalom
