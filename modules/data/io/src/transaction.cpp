// SPDX-License-Identifier: BSD-3-Clause
#include "transaction.h"

#include <sqlite3.h>

namespace slalom {

Transaction::Transaction(SQLite::Database& database)
    : database_(database), outermost_(sqlite3_get_autocommit(database.getHandle()) != 0) {
  // No lock for read-only files: readers can proceed, and writing fails.
  done_ = outermost_ && sqlite3_db_readonly(database.getHandle(), "main") == 1;
  if (!done_) database_.exec(outermost_ ? "BEGIN IMMEDIATE" : "SAVEPOINT inner_scope");
}

Transaction::~Transaction() {
  if (done_) return;
  // SQLite may have rolled back already, for example on a full disk.
  if (sqlite3_get_autocommit(database_.getHandle()) != 0) return;
  database_.tryExec(outermost_ ? "ROLLBACK" : "ROLLBACK TO inner_scope; RELEASE inner_scope");
}

void Transaction::commit() {
  if (done_) return;
  database_.exec(outermost_ ? "COMMIT" : "RELEASE inner_scope");
  done_ = true;
}

}  // namespace slalom
