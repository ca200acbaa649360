// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/csv_columns.h>

#include <CLI/CLI.hpp>

namespace slalom {

/// Adds the options that name the columns of a CSV file by which its rows are runs.
void add_key_options(CLI::App& verb, CsvColumnOptions& options);

}  // namespace slalom
