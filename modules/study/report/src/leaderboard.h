// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common_facts.h"
#include "markup.h"
#include "report_data.h"

#include <slalom/analysis/common_scenarios.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The first screen of a report: which method is best, how sure that is, where methods fail and
/// why, and what to do next. Plain HTML, which needs no script but for the pictures of failures.
/// For scenarios that a search has selected, and for results without a success rate, the answer is
/// the name of the campaign and the rest is empty.
class Leaderboard {
 public:
  Leaderboard(const ReportInput& input, const CommonFacts& facts);

  std::string answer() const;  ///< "nd is best: it reaches the goal in 63 of 70 runs"
  Markup certainty() const;    ///< how sure it is, as a paragraph
  Markup table() const;        ///< a row per method
  Markup differences() const;  ///< of pairs in success: those that are shown, and the closest pair
  Markup next_steps() const;   ///< commands

 private:
  const ReportInput& input_;
  const CommonFacts& facts_;
  const std::vector<MethodOverview>& rows_;
  std::vector<std::vector<const PairedComparison*>> pairs_;  ///< in success, by rows; null: none
  std::size_t solved_by_any_ = 0, scenarios_ = 0;
  bool knows_outcomes_ = true;  ///< of all runs
  bool counts_runs_;
  std::size_t curve_ = 0;  ///< index of the cross tables whose trends in success are strongest
  bool has_curve_ = false;
  std::vector<CommonScenarios> common_;

  const std::string& name(std::size_t row) const { return rows_[row].standing.method.method; }
  std::string color(std::size_t row) const;
  bool beats(std::size_t row, std::size_t other) const;
  std::string runs_text(std::size_t row) const;  ///< "63 of 70 runs" with a success
  std::string names_text(const std::vector<std::size_t>& rows) const;
  std::string common_text() const;
  std::string campaign_words(const std::vector<std::string>& keys = {}) const;
  void find_pairs();
  void count_solved();
  void choose_curve();
  std::optional<std::size_t> focus() const;  ///< its row, if it is a method of the results
  const PairedComparison* open_pair() const;

  Markup head() const;
  Markup row(std::size_t index) const;
  Markup rank_cell(std::size_t row) const;
  Markup method_cell(std::size_t row) const;
  Markup success_cell(std::size_t row) const;
  Markup curve_cell(std::size_t row) const;
  Markup why_cell(std::size_t row) const;
  Markup more_scenarios() const;
  Markup look() const;
  Markup do_better() const;
};

}  // namespace slalom
