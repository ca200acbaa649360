// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/open_results.h>
#include <slalom/falsification/search.h>
#include <slalom/falsification/shrink.h>

#include <map>
#include <string>

namespace slalom {

/// Hash of everything that the result of a search depends on: the setup, the options, and
/// `methods`, a hash of its settings and of what its methods are: their parameters and files.
std::string search_identity(const std::string& methods, const FalsificationSetup& setup,
                            const SearchOptions& options);

/// search.state in a folder: the rounds of an interrupted search, after the identity of the search
/// that made them.
class StateFile {
 public:
  StateFile(const std::string& folder, std::string search)
      : path_(folder + "/search.state"), search_(std::move(search)) {}

  /// The empty state, if there is none or it is to be overwritten. Throws Error (Usage) for the
  /// state of another search, or if it is required and missing; Error (File) for a damaged one.
  SearchState load(ExistingResults existing) const;
  void save(const SearchState& state) const;  ///< throws Error (Job) when it cannot be written

 private:
  std::string path_, search_;
};

/// search.shrunk in a folder: failures of the search that are shrunk already. Failures of other
/// searches or options are ignored.
class ShrunkFile {
 public:
  /// Throws Error (File) for a damaged file.
  ShrunkFile(const std::string& folder, const std::string& search, const ShrinkOptions& options,
             ExistingResults existing);

  /// The shrunk failure, or null.
  const ShrinkResult* find(const FoundFailure& found) const;
  void save(const FoundFailure& found, const ShrinkResult& small);

 private:
  std::string path_, identity_;
  std::map<std::string, ShrinkResult> known_;  ///< by strategy and candidate
};

}  // namespace slalom
