// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cell.h>
#include <slalom/statistics/rank_statistics.h>

#include <string>
#include <vector>

namespace slalom {

/// Correlation of a scenario descriptor with a metric of a method.
struct DescriptorValidity {
  std::string method, descriptor, metric;  ///< ids
  RankCorrelation correlation;             ///< over scenarios
};

/// Correlation of two descriptors; near +-1 they are redundant.
struct DescriptorRedundancy {
  std::string first, second;
  RankCorrelation correlation;
};

struct ValidityTable {
  std::vector<std::string> descriptors;
  std::vector<DescriptorValidity> validity;      ///< methods outermost, then metrics
  std::vector<DescriptorRedundancy> redundancy;  ///< each pair once, including each with itself
  double confidence = 0.95;
};

/// Spearman's rho of each descriptor with each metric (mean over a scenario's runs), per method,
/// and of the descriptors with each other. Intervals are not corrected for multiplicity.
ValidityTable build_validity(const ResultTable& table, const std::vector<std::string>& metrics,
                             const AnalysisOptions& options);

}  // namespace slalom
