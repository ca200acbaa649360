// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/falsification/kept_failures.h>

#include <cstdint>
#include <string>

namespace slalom {

/// Text for people: the runs and failures of both halves, why the search ended, and what was kept.
/// If the random half has no failure, the upper limit of their probability.
std::string search_text(const SearchResult& result, const KeptFailures& kept,
                        const SearchOptions& options);

/// The same as JSON, for write_failures().
std::string search_json(const SearchResult& result, const KeptFailures& kept, std::uint64_t seed);

}  // namespace slalom
