// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/precision_rule.h>
#include <slalom/campaign/campaign_recorder.h>

#include <cstddef>
#include <vector>

namespace slalom {

/// The scenarios of a sequential campaign by bin, taken batch by batch in their order.
class ScenarioPool {
 public:
  /// The next number of scenarios of a bin of which `taken` were taken.
  using BatchSize = std::size_t (*)(std::size_t taken);

  /// One bin with all scenarios.
  ScenarioPool(std::vector<Scenario> scenarios, BatchSize batch_size);

  /// The bins of `rows`, by descriptors that are computed here; fixes the edges of `rows`. No bins
  /// if interrupted.
  ScenarioPool(std::vector<Scenario> scenarios, BatchSize batch_size, BinSpec& rows,
               const CampaignOptions& options, const Execution& execution);

  std::size_t bins() const { return bins_.size(); }
  std::size_t scenarios() const { return scenarios_.size(); }

  /// The next batch of scenarios from the open bins.
  std::vector<Scenario> next_batch(const std::vector<bool>& open);

 private:
  /// Indexes of scenarios; the first `taken` have been taken.
  struct BinScenarios {
    Bin bin;
    std::vector<std::size_t> scenarios;
    std::size_t taken = 0;
  };

  void assign_to_bin(std::size_t scenario, const Value& value);
  std::vector<Bin> all_bins() const;

  std::vector<Scenario> scenarios_;
  BatchSize batch_size_;
  std::vector<BinScenarios> bins_;
};

}  // namespace slalom
