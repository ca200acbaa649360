// SPDX-License-Identifier: BSD-3-Clause
#include "../comparison/scenario_means.h"

#include <slalom/analysis/validity.h>

#include <optional>

namespace slalom {
namespace {

using Values = std::vector<std::optional<double>>;

Values values_of(const ValueColumn& column) {
  Values values;
  for (std::size_t row = 0; row < column.size(); ++row) {
    values.push_back(column.is_na(row) ? std::nullopt : std::optional(column.number(row)));
  }
  return values;
}

RankCorrelation correlate(const Values& x, const Values& y, double confidence) {
  std::vector<double> a, b;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!x[i] || !y[i]) continue;
    a.push_back(*x[i]);
    b.push_back(*y[i]);
  }
  return spearman(a, b, confidence);
}

}  // namespace

ValidityTable build_validity(const ResultTable& table, const std::vector<std::string>& metrics,
                             const AnalysisOptions& options) {
  require_valid(options);
  ValidityTable result;
  result.confidence = options.confidence;
  std::vector<Values> descriptors;
  for (const ValueColumn& column : table.descriptors) {
    result.descriptors.push_back(column.info().id);
    descriptors.push_back(values_of(column));
  }
  for (std::uint32_t method = 0; method < table.methods.size(); ++method) {
    for (const std::string& metric : metrics) {
      const Values outcome = scenario_means(table, method, require_metric(table, metric));
      for (std::size_t i = 0; i < descriptors.size(); ++i) {
        result.validity.push_back({table.methods[method], result.descriptors[i], metric,
                                   correlate(descriptors[i], outcome, options.confidence)});
      }
    }
  }
  for (std::size_t i = 0; i < descriptors.size(); ++i) {
    for (std::size_t j = i; j < descriptors.size(); ++j) {
      result.redundancy.push_back({result.descriptors[i], result.descriptors[j],
                                   correlate(descriptors[i], descriptors[j], options.confidence)});
    }
  }
  return result;
}

}  // namespace slalom
