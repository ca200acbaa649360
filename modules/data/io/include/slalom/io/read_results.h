// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Reads the runs of a result file, sorted by scenario name, hash, method and repetition, without
/// details. For a folder, reads its campaign_files() one after the other into the table of the file
/// merged from them; runs that several files contain must be equal. Reads only the metrics, timings
/// and descriptors in `ids`, or all if it is none or contains an unknown id (so that an error
/// message can suggest the nearest). Damaged runs are left out and listed in `damaged`. A value of
/// a version other than the file's is NA ("other version 1"), one that the file does not contain is
/// NA ("not recorded"). Throws Error (File), also for files of different campaigns in a folder.
ResultTable read_results(const std::string& path,
                         const std::optional<std::vector<std::string>>& ids = std::nullopt);

/// All columns, and the details of the runs.
ResultTable read_detailed_results(const std::string& path);

/// Whether the file has the signature of an SQLite database.
bool is_database(const std::string& path);

/// Whether the file or folder is one for read_results(): a folder, or an SQLite database
/// that is none of another program.
bool is_result_input(const std::string& path);

}  // namespace slalom
