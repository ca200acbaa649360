// SPDX-License-Identifier: BSD-3-Clause
#include "row_table.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/method_ranks.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <numeric>

namespace slalom {
namespace {

std::vector<std::size_t> best_first(const MethodRanks& ranks) {
  std::vector<std::size_t> order(ranks.methods.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&ranks](std::size_t a, std::size_t b) {
    return ranks.test.mean_ranks[a] < ranks.test.mean_ranks[b];
  });
  return order;
}

/// Numbers of the groups, from 1, that contain a method: "1 2".
std::string groups_of(const MethodRanks& ranks, std::size_t method) {
  std::string text;
  for (std::size_t i = 0; i < ranks.test.groups.size(); ++i) {
    const auto& group = ranks.test.groups[i];
    if (std::find(group.begin(), group.end(), method) == group.end()) continue;
    text += (text.empty() ? "" : " ") + std::to_string(i + 1);
  }
  return text;
}

DataTable rank_table(const MethodRanks& ranks, const std::string& only) {
  const std::string& metric = ranks.column.info.id;
  RowTable rows("ranks_" + metric, "Mean ranks in " + metric + ", 1 is best");
  for (const std::size_t method : best_first(ranks)) {
    if (!only.empty() && ranks.methods[method] != only) continue;
    rows.begin_row();
    rows.add("method", Field{ranks.methods[method]});
    rows.add("mean_rank", std::optional(ranks.test.mean_ranks[method]));
    rows.add("groups", Field{groups_of(ranks, method)});
  }
  return rows.table();
}

DataTable test_table(const MethodRanks& ranks) {
  RowTable rows("friedman_" + ranks.column.info.id, "Friedman's test");
  rows.begin_row();
  rows.add("scenarios", ranks.test.scenarios);
  rows.add("left_out", ranks.left_out);
  rows.add("without_value", ranks.without_value);
  rows.add("chi_squared", std::optional(ranks.test.chi_squared));
  rows.add("p", std::optional(ranks.test.p));
  rows.add("iman_davenport_f", std::optional(ranks.test.iman_davenport_f));
  rows.add("iman_davenport_p", std::optional(ranks.test.iman_davenport_p));
  rows.add("alpha", std::optional(ranks.alpha));
  rows.add("critical_difference", std::optional(ranks.test.critical_difference));
  return rows.table();
}

std::string sentence(const MethodRanks& ranks) {
  const bool shown = ranks.test.p <= ranks.alpha;
  return ranks.column.info.id + ": " +
         (shown ? "the ranks of the methods differ" : "no difference of ranks shown") + " over " +
         count_text(ranks.test.scenarios, "scenario") + " (Friedman, " + p_text(ranks.test.p) +
         "); mean ranks differ significantly if they are more than " +
         format_fixed(ranks.test.critical_difference, 2) + " apart (Nemenyi)";
}

}  // namespace

Interpretation interpret_ranks(const std::vector<ResultTable>& results,
                               const AnalysisQuery& query) {
  selected_methods(results[0], query.method);
  Interpretation found;
  for (const std::string& metric : query.metrics) {
    const MethodRanks ranks = build_method_ranks(results[0], metric, query.comparison.analysis);
    found.tables.push_back(rank_table(ranks, query.method));
    found.tables.push_back(test_table(ranks));
    found.remarks.push_back(sentence(ranks));
    const std::string left_out = left_out_text(ranks);
    if (left_out.empty()) continue;
    found.remarks.push_back(metric + ": " + std::to_string(ranks.test.scenarios) + " of " +
                            count_text(ranks.all_scenarios(), "scenario") +
                            "; left out: " + left_out);
  }
  return found;
}

}  // namespace slalom
