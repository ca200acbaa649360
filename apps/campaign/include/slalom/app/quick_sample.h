// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/campaign_program.h>
#include <slalom/core/progress.h>
#include <slalom/scenario/scenario.h>
#include <slalom/statistics/stratified_sample.h>

#include <map>
#include <string>
#include <vector>

namespace slalom {

/// A stratified sample of the scenarios of a campaign, and what is known of all of them.
struct QuickSample {
  std::vector<std::string> hashes;  ///< of all scenarios
  std::string stratified_by;        ///< as text
  Strata strata;
  Allocation sampled;
  /// Success of shipped methods in all scenarios, by name; empty if unknown.
  std::map<std::string, double> shipped;

  std::size_t size() const;
  std::string text() const;  ///< "50 of 200 scenarios, stratified by ..."
};

/// Throws Error (Usage) for a sample that is too small for an interval.
void check_quick_size(int size);

/// A sample of `size` in proportion to the strata, the same for any number of jobs; larger ones
/// contain smaller ones. Scenarios of a test bed with a table of difficulty have strata of these,
/// others of their turn_density. Throws Error: Usage for more than there are, File for a table that
/// cannot be read.
QuickSample choose_quick_sample(const std::vector<Scenario>& scenarios, int size,
                                const CampaignConfig& config, int jobs, Progress& progress);

/// The scenarios in the sample, in the order of all.
std::vector<Scenario> sampled_scenarios(const QuickSample& sample, std::vector<Scenario> scenarios);

}  // namespace slalom
