// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/summary.h>
#include <slalom/results/result_table.h>

#include <string>
#include <vector>

namespace slalom {

/// Files of a paper about results in a folder: tables and figures to input, a paragraph about how
/// the runs were made (methods.tex), slalom.bib, and paper.tex, a document with all of it. Throws
/// Error (Job) when a file cannot be written, or rsvg-convert is missing.
void write_paper(const ResultTable& results, const SummaryTable& summary,
                 const std::vector<CrossTable>& tables, const std::string& folder);

}  // namespace slalom
