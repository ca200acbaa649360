#pragma once

#include <slalom/results/run_columns.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The runs of a result file as columns, in the order of ResultFile::read_table(): what that would
/// give, for many more runs in much less memory. Only the metrics, wall-clock figures and
/// descriptors in `ids` are read, or all of them where it is none or names one that is not there
/// (so that a message can name the nearest). Throws Error (File).
RunColumns read_run_columns(const std::string& path,
                            const std::optional<std::vector<std::string>>& ids = std::nullopt);

/// Whether the file says that it is an SQLite database.
bool is_database(const std::string& path);

}  // namespace slalom
