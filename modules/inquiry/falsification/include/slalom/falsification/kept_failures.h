// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/progress.h>
#include <slalom/falsification/failure.h>
#include <slalom/falsification/search_files.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The failures of a search that are reported.
struct KeptFailures {
  std::vector<Failure> failures;    ///< the simplest first
  std::size_t near_duplicates = 0;  ///< dropped, see ObstacleArea
  std::optional<double> diversity;  ///< of the smallest scenarios; of two failures or more
};

struct KeepOptions {
  std::size_t count = 10;  ///< failures to keep
  ShrinkOptions shrink;
  ShrunkFile* known = nullptr;  ///< failures that need not be shrunk again; null: none
  /// Called with a line about each failure that is left out because it is unfair.
  std::function<void(const std::string&)> notify = {};
};

/// Shrinks the found failures in this order until `options.count` are kept. Drops unfair ones, and
/// near-duplicates of a kept one with the same outcome (ObstacleArea). nullopt when interrupted.
/// Throws as shrink().
std::optional<KeptFailures> shrink_found(const std::vector<FoundFailure>& found,
                                         const FalsificationSetup& setup,
                                         const KeepOptions& options, Progress& progress);

}  // namespace slalom
