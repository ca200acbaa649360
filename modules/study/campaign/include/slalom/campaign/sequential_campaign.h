// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/decision_rule.h>
#include <slalom/analysis/precision_rule.h>
#include <slalom/campaign/campaign_recorder.h>

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace slalom {

/// When a sequential campaign stops.
struct StoppingRule {
  std::string text;  ///< as given: "interval(success) < 0.1 in density:10"
  std::variant<PrecisionRule, DecisionRule> rule;
  std::size_t max_runs = 0;  ///< no further batch after this number of runs; 0: no limit
};

/// Reads either kind. Throws Error (Usage) for a malformed rule, and for ids that the campaign does
/// not compute or methods that are not among `methods`.
StoppingRule parse_stopping_rule(const std::string& text, std::size_t max_runs,
                                 const CampaignOptions& options,
                                 const std::vector<NamedMethod>& methods);

/// The result of a sequential campaign.
struct SequentialReport {
  bool complete = false;  ///< false if interrupted
  bool reached = false;   ///< every cell has the required precision, or the decision is made
  std::size_t runs = 0;   ///< after which it stopped
  std::string text;       ///< the cells or the decision, and the reason for stopping
};

/// The order in which a sequential campaign takes the scenarios with these hashes: what it has seen
/// must be a random sample of the pool, whatever the order of its lists. Returns indexes. The order
/// of two scenarios depends on their hashes and the campaign's seed only.
std::vector<std::size_t> random_order(const std::vector<std::string>& hashes, std::uint64_t seed);

/// Runs a campaign in batches until its rule is met. All methods run in all scenarios of a batch,
/// so that comparisons are paired; batches take the pool in random_order(). The first one has
/// kFirstBatch scenarios of each bin, and each is followed by an interim analysis (look).
///
/// Precision: each method's interval, of look_confidence(), is narrow enough in each bin. The
/// descriptors of the `pool` are computed first, so that bins are fixed before any run. The next
/// batch takes half as many scenarios as the bin has so far, from the open bins, those without the
/// required precision.
///
/// Decision: see decide(). The next batch takes a tenth of the scenarios so far, at least
/// kFirstBatch: looks cost nothing, scenarios behind the decision do.
///
/// Stops also if the pool is exhausted for the open bins, or max_runs is reached. Deterministic for
/// any number of workers, and if the recorder's file already holds a part of the runs.
SequentialReport run_until(CampaignRecorder& recorder, const StoppingRule& rule,
                           std::vector<Scenario> pool, double confidence,
                           const Execution& execution);

constexpr std::size_t kFirstBatch = 10;

}  // namespace slalom
