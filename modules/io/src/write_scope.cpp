#include "write_scope.h"

#include <sqlite3.h>

namespace slalom {

WriteScope::WriteScope(SQLite::Database& database)
    : database_(database), outermost_(sqlite3_get_autocommit(database.getHandle()) != 0) {
  // A file that cannot be written needs no lock: whoever only looks goes on, and writing fails.
  done_ = outermost_ && sqlite3_db_readonly(database.getHandle(), "main") == 1;
  if (!done_) database_.exec(outermost_ ? "BEGIN IMMEDIATE" : "SAVEPOINT inner_scope");
}

WriteScope::~WriteScope() {
  if (done_) return;
  // SQLite may have rolled back by itself, on a full disk for one: then there is nothing to undo.
  if (sqlite3_get_autocommit(database_.getHandle()) != 0) return;
  database_.tryExec(outermost_ ? "ROLLBACK" : "ROLLBACK TO inner_scope; RELEASE inner_scope");
}

void WriteScope::commit() {
  if (done_) return;
  database_.exec(outermost_ ? "COMMIT" : "RELEASE inner_scope");
  done_ = true;
}

}  // namespace slalom
