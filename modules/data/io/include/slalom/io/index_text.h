// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/list_selection.h>

#include <optional>
#include <string>

namespace slalom {

/// The number of scenarios in each range of an index, one line per range; then those in none.
std::string render_text(const ListIndex& index, const ListIndexCounts& counts);

/// Name, descriptor, edges and parameters of the index, and the counts if they are given, as one
/// line.
std::string render_json(const ListIndex& index,
                        const std::optional<ListIndexCounts>& counts = std::nullopt);

}  // namespace slalom
