// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/paired_comparison.h>
#include <slalom/analysis/summary.h>

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// The place of a method among the others by success.
struct Standing {
  MethodSummary method;   ///< with success as its only cell
  std::size_t best = 1;   ///< rank if all that is not decided ends well: 1 + better methods
  std::size_t worst = 1;  ///< the number of methods less those that it is better than
  std::vector<std::size_t> groups = {};  ///< from 0, increasing

  std::string letters() const;  ///< of the groups: "ab"
};

/// The methods with a rate of success, by decreasing success, then by name. One is better than
/// another if the verdict of their comparison in success, in `family`, says so.
///
/// Two methods share a group exactly if neither is shown to be better: the compact letter display
/// of Piepho (2004, J. Comput. Graph. Stat. 13:456), by insertion and absorption, in the order of
/// the methods.
std::vector<Standing> build_standings(const ResultTable& table,
                                      const std::vector<PairedComparison>& family,
                                      const AnalysisOptions& options);

/// Whether success is that of single runs; otherwise its values are means of unknown numbers of
/// runs.
bool counts_runs(const ResultTable& table);

/// The comparison of two methods in success; null if there is none.
const PairedComparison* success_comparison(const std::vector<PairedComparison>& family,
                                           const std::string& one, const std::string& other);

}  // namespace slalom
