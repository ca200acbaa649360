// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cross_table.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>

namespace slalom {

/// Null if there is none.
nlohmann::ordered_json number_or_null(const std::optional<double>& number);

/// [low, high], or null if there is none.
nlohmann::ordered_json interval_json(const std::optional<Interval>& interval);

/// n, na (counts by reason), mean, deviation, median and interval, as in all exports and reports.
nlohmann::ordered_json cell_json(const Cell& cell);

/// One entry per column with a trend: metric, test, z, p, adjusted_p, numbers of bins and
/// scenarios, and whether the trend is shown.
nlohmann::ordered_json trends_json(const CrossTable& table);

}  // namespace slalom
