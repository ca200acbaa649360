// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/coverage.h>

#include <memory>

namespace slalom {

/// Creates generators with random options around their defaults: lengths scaled with the workspace,
/// whose sides lie between min_extent and max_extent, and numbers varied by up to a factor of 4,
/// within their ranges. Options set in the .ini, texts without choices, seeds, the cell size and
/// whether there are people are unchanged.
class OptionSampler {
 public:
  OptionSampler(const CoveragePlan& plan, const MapLoader& load_map);

  /// A generator of a random family, or null if no valid options were drawn.
  std::unique_ptr<Generator> draw(RandomEngine& engine) const;

 private:
  const CoveragePlan& plan_;
  MapLoader load_map_;  ///< reads each file once
};

}  // namespace slalom
