// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "failure_files.h"
#include "search_files.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace slalom {

/// The failures that are reported.
struct KeptFailures {
  std::vector<Failure> failures;    ///< the simplest first
  std::size_t near_duplicates = 0;  ///< dropped, see ObstacleArea
  std::optional<double> diversity;  ///< of the smallest scenarios; of two failures or more
};

/// Shrinks the found failures in this order until `count` are kept. Drops unfair ones, and
/// near-duplicates of a kept one with the same outcome (ObstacleArea). Throws Interrupted.
KeptFailures shrink_found(const std::vector<FoundFailure>& found, std::size_t count,
                          const TestBench& bench, const FalsifyArguments& arguments,
                          ShrunkFile shrunk);

}  // namespace slalom
