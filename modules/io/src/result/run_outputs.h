// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <string>

namespace slalom {

/// The table of what methods printed, in files with such text only.
constexpr const char* kRunOutputs =
    "CREATE TABLE IF NOT EXISTS run_outputs (run INTEGER PRIMARY KEY, content BLOB NOT NULL, "
    "checksum INTEGER NOT NULL)";

inline bool has_run_outputs(SQLite::Database& database, const std::string& schema) {
  return database
             .execAndGet("SELECT count(*) FROM " + schema +
                         ".sqlite_master WHERE name = 'run_outputs'")
             .getInt() > 0;
}

}  // namespace slalom
