#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

namespace slalom {

/// All or nothing: what is written while it lives is undone unless commit() was called. Scopes may
/// be nested; only the outermost makes things last. It takes the lock at once, so that two programs
/// that write wait for each other instead of failing halfway.
class WriteScope {
 public:
  explicit WriteScope(SQLite::Database& database);
  ~WriteScope();
  WriteScope(const WriteScope&) = delete;
  WriteScope& operator=(const WriteScope&) = delete;

  void commit();

 private:
  SQLite::Database& database_;
  bool outermost_;
  bool done_ = false;
};

}  // namespace slalom
