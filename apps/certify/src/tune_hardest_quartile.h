// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/inquiry/tune_search.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The scenarios at one end of a descriptor: about a quarter of them.
struct HardestQuartile {
  std::string condition;       ///< "density >= 0.12"
  std::vector<bool> contains;  ///< of each sealed scenario
};

/// The end of the descriptor `id` at which the default has less success in the finals, and the
/// sealed scenarios beyond their quartile there. Independent of the outcomes in these, so that
/// success in them is not chosen. None if the quartiles are the same, or no run of the finals is
/// beyond one. Values are NaN where they are not available.
std::optional<HardestQuartile> hardest_quartile(const std::string& id,
                                                const std::vector<double>& sealed,
                                                const std::vector<double>& finals,
                                                const std::vector<TuneOutcome>& default_finals);

}  // namespace slalom
