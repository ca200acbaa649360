// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

namespace slalom {

/// A transaction: changes during its lifetime are rolled back unless commit() was called. Scopes
/// can be nested; only the outermost commits to disk. It acquires the write lock immediately, so
/// that concurrent writers wait for each other instead of failing midway.
class Transaction {
 public:
  explicit Transaction(SQLite::Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void commit();

 private:
  SQLite::Database& database_;
  bool outermost_;
  bool done_ = false;
};

}  // namespace slalom
