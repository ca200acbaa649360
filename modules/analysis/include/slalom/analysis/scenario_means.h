#pragma once

#include <slalom/results/run_columns.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The mean of a metric over a method's runs in each scenario (the unit of all comparisons, since
/// runs of one scenario are not independent); none where no run has a value. By place in
/// `table.scenario_hashes`.
std::vector<std::optional<double>> scenario_means(const RunColumns& table, std::uint32_t method,
                                                  const ValueColumn& values);

/// The metric of this id. Throws Error (Usage) with the nearest name.
const ValueColumn& require_metric(const RunColumns& table, const std::string& id);

}  // namespace slalom
