// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/analysis_section.h>

namespace slalom {

void AnalysisSection::visit(OptionVisitor& v) {
  v.option("rows", rows,
           "bins of cross tables: ID:EDGE,EDGE,..., ID:COUNT or ID:qCOUNT, separated by ';'");
  v.option("columns", columns, "metrics of cross tables: ids, comma-separated");
  v.option("confidence", confidence, "-", "confidence of intervals", Range::between(0.5, 0.9999));
  v.option("report", report, "slalom-evaluate writes the HTML report");
  v.option("focus", focus, "your method, for which the report proposes what next; empty: any");
}

}  // namespace slalom
