// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "interpret_options.h"

namespace slalom {

/// The tables of a folder with the shards of a campaign, computed file by file, with the number of
/// runs that are missing on standard error. None if they need all runs at once: in JSON, with rows
/// by metrics, of files that share scenarios or are damaged; and for invalid requests, which are
/// reported when all runs are read.
std::optional<Interpretation> tables_of_shards(const InterpretArguments& arguments,
                                               const Interpreter& interpreter);

}  // namespace slalom
