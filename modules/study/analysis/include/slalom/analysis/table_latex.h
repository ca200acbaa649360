// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/summary.h>

#include <set>
#include <string>
#include <vector>

namespace slalom {

/// Tables for a paper: `tabular` environments inside `table`, each cell "0.95 [0.94, 0.96]", with
/// the number of runs, missing values, the confidence in the caption, and a label. Their rules are
/// those of the package booktabs; names of methods and metrics are escaped.
std::string render_latex(const SummaryTable& table);
std::string render_latex(const CrossTable& table);

/// A table of LaTeX texts: the first column flush left, the others flush right. Its label is
/// "tab:NAME", with "-" for what is neither a letter nor a digit.
std::string latex_tabular(const std::string& caption, const std::string& name,
                          const std::vector<std::string>& header,
                          const std::vector<std::vector<std::string>>& rows);

/// Numbers labels that occur again, "tab:NAME_2"; `used` has those of texts before, and gets these.
std::string number_labels(const std::string& text, std::set<std::string>& used);

/// A standalone document with these tables; without booktabs their rules are plain lines.
std::string latex_document(const std::vector<std::string>& tables);

/// `text` with LaTeX's special characters escaped; characters beyond U+00FF, which its fonts may
/// not have, are "?".
std::string latex_text(const std::string& text);

}  // namespace slalom
