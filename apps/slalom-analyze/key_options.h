// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/csv_columns.h>

#include <CLI/CLI.hpp>

namespace slalom {

/// Adds the options that say how the columns of a table are read. They are those of `import`; all
/// other verbs that read a table have them, too, not `shown` in their help.
void add_key_options(CLI::App& verb, CsvColumnOptions& options, bool shown);

}  // namespace slalom
