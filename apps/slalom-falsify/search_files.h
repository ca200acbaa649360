// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "arguments.h"

#include <slalom/falsification/search.h>
#include <slalom/falsification/shrink.h>

#include <map>
#include <string>

namespace slalom {

/// Hash of everything that the result of a search depends on: the campaign, its methods and the
/// contents of their files, and the options.
std::string search_identity(const FalsifyCampaign& campaign, const SearchOptions& options);

/// search.state in the output folder: the rounds of an interrupted search, after the identity of
/// the search that made them.
class StateFile {
 public:
  StateFile(const std::string& folder, std::string search)
      : path_(folder + "/search.state"), search_(std::move(search)) {}

  /// Throws Error (Usage) for the state of another search, unless it is to be overwritten.
  SearchState load(ExistingResults existing) const;
  void save(const SearchState& state) const;

 private:
  std::string path_, search_;
};

/// search.shrunk in the output folder: failures of the search that are shrunk already. Failures of
/// other searches or options are ignored.
class ShrunkFile {
 public:
  ShrunkFile(const std::string& folder, const std::string& search,
             const FalsifyArguments& arguments);

  /// The shrunk failure, or null.
  const ShrinkResult* find(const FoundFailure& found) const;
  void save(const FoundFailure& found, const ShrinkResult& small);

 private:
  std::string path_, identity_;
  std::map<std::string, ShrinkResult> known_;  ///< by half and candidate
};

}  // namespace slalom
