// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "database.h"
#include "transaction.h"

#include <slalom/io/result_file.h>

#include <map>

namespace slalom {

struct OpenResultFile {
  std::string path;
  std::unique_ptr<SQLite::Database> database;
  std::vector<QuantityInfo> descriptors, metrics;

  template <typename... Values>
  SQLite::Statement select(const std::string& sql, const Values&... values) const {
    return bound(*database, "SELECT " + sql, values...);
  }
};

/// result_reader.cpp reads the file, result_writer.cpp changes it; result_schema.h has its tables.
struct ResultFile::Impl : OpenResultFile {
  std::string columns_of_runs;                       ///< to insert; empty before the first
  std::map<std::string, SQLite::Statement> inserts;  ///< by table, used for all of its rows
  std::unique_ptr<Transaction> transaction;          ///< open while there are uncommitted changes
  FileIdentity file;                                 ///< after the last commit

  /// Throws Error (Job) unless the file is as it was after the last commit.
  void expect_unchanged() const;
  std::string rescue() const;
  /// `columns`: "a, b", the same for all rows of a table.
  SQLite::Statement& insert_into(const std::string& table, const std::string& columns);
  /// Begins a transaction unless there is one.
  void begin();
  /// Adds the row of a run and returns its checksum.
  std::int64_t add(const RunRecord& run);
};

}  // namespace slalom
