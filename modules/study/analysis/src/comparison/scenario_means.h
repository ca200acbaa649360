// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The mean of a metric over a method's runs in each scenario (the unit of all comparisons, since
/// runs of one scenario are not independent); none if no run has a value. In the order of
/// `table.scenario_hashes`.
std::vector<std::optional<double>> scenario_means(const ResultTable& table, std::uint32_t method,
                                                  const ValueColumn& values);

/// The metric with this id. Throws Error (Usage) with the nearest name.
const ValueColumn& require_metric(const ResultTable& table, const std::string& id);

}  // namespace slalom
