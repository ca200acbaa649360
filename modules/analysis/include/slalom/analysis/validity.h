#pragma once

#include <slalom/analysis/cell.h>
#include <slalom/analysis/rank_statistics.h>

#include <string>
#include <vector>

namespace slalom {

/// How a scenario descriptor goes together with how a method did.
struct DescriptorValidity {
  std::string method, descriptor, metric;  ///< ids
  RankCorrelation correlation;             ///< over scenarios
};

/// How two descriptors go together: two that say the same are redundant.
struct DescriptorRedundancy {
  std::string first, second;
  RankCorrelation correlation;
};

struct ValidityTable {
  std::vector<std::string> descriptors;
  std::vector<DescriptorValidity> validity;      ///< methods outermost, then metrics
  std::vector<DescriptorRedundancy> redundancy;  ///< each pair once, and each with itself
  double confidence = 0.95;
};

/// Spearman's rho of each descriptor with each metric (mean over a scenario's runs), per method,
/// and of the descriptors among themselves. No correction for their number: intervals, not tests.
ValidityTable build_validity(const RunColumns& table, const std::vector<std::string>& metrics,
                             const AnalysisOptions& options);

}  // namespace slalom
