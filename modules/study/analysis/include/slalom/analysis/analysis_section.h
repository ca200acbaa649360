// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>

#include <string>

namespace slalom {

/// Section [analysis] of a campaign's .ini: contents of tables and report.
struct AnalysisSection {
  std::string rows;          ///< descriptor bins, separated by ';'; empty: density:q4 if available
  std::string columns;       ///< metric ids, comma separated; empty: success, optimality, safety
  double confidence = 0.95;  ///< of intervals
  bool report = true;        ///< slalom-evaluate writes the HTML report
  std::string focus;         ///< the method for which the report proposes what next; empty: any

  void visit(OptionVisitor& v);
};

}  // namespace slalom
