#pragma once

#include <slalom/analysis/precision_rule.h>
#include <slalom/campaign/campaign_recorder.h>

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// When a sequential campaign stops.
struct StoppingRule {
  std::string text;  ///< as given: "interval(success) < 0.1 in density:10"
  PrecisionRule precision;
  std::size_t max_runs = 0;  ///< no further batch after this number of runs; 0: no limit
};

/// Throws Error (Usage) for a malformed rule, and for ids that the campaign does not compute.
StoppingRule parse_stopping_rule(const std::string& text, std::size_t max_runs,
                                 const CampaignOptions& options);

/// The result of a sequential campaign.
struct SequentialReport {
  bool complete = false;  ///< false if interrupted
  bool reached = false;   ///< every cell has the required precision
  std::string text;       ///< the cells, and the reason for stopping
};

/// Runs a campaign in batches until each method's interval is narrow enough in each bin. The
/// descriptors of the `pool` are computed first, so that bins are fixed before any run. Each
/// interim analysis (look) is followed by a batch of scenarios from the open bins, those without
/// the required precision, in the order of the pool. All methods run in all scenarios of a batch,
/// so that comparisons are paired. The first batch has kFirstBatch scenarios of each bin, each
/// further one half as many as the bin has so far. Looks spend the error probability 1 -
/// `confidence` according to look_confidence(). Stops if the required precision is reached, the
/// pool is exhausted for the open bins, or max_runs is reached. Deterministic for any number of
/// workers, and if the recorder's file already holds a part of the runs.
SequentialReport run_until(CampaignRecorder& recorder, const StoppingRule& rule,
                           std::vector<Scenario> pool, double confidence,
                           const Execution& execution);

constexpr std::size_t kFirstBatch = 10;

}  // namespace slalom
