// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/contrast.h>

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// A failure of a cluster. Runs are indexes into the runs of the report.
struct ReportedFailure {
  std::size_t run = 0;       ///< in the smallest scenario
  std::string found;         ///< where: "random candidate 52 of the search"
  std::string command;       ///< that repeats and shows it
  std::string departure;     ///< where it leaves the path of a success; "" if none has one
  std::size_t compared = 0;  ///< the failing run that is compared with the neighbors
  std::vector<std::size_t> neighbors;  ///< successful runs of the same method
};

/// Failures that are alike, with what distinguishes them from successes: a page of the report.
struct ReportedCluster {
  std::string name;
  std::vector<std::string> statements;  ///< contrasts that hold, as sentences
  std::string basis;                    ///< how many pairs were compared, and how many are needed
  std::vector<Contrast> scenarios;      ///< of descriptors
  std::vector<Contrast> runs;           ///< of metrics
  std::vector<ReportedFailure> members;
};

}  // namespace slalom
