// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <tuple>

namespace slalom {

/// Identifies a kind of SQLite file of Slalom.
struct DatabaseKind {
  const char* name;  ///< for messages: "a scenario list"
  int application_id;
  int version;
  const char* schema;      ///< SQL that creates the tables
  int oldest_version = 0;  ///< that is read as well; 0: only `version`
};

/// Throws Error (File) for an existing file of another kind; an empty one can be replaced.
void expect_replaceable(const std::string& path, const DatabaseKind& kind);

/// Creates a file of that kind with what `fill` adds, replacing an existing one of the same kind.
/// Throws Error (Job) when it cannot be created, Error (File) for a file of another kind.
std::unique_ptr<SQLite::Database> create_database(
    const std::string& path, const DatabaseKind& kind,
    const std::function<void(SQLite::Database&)>& fill = nullptr);

/// Whether there is no file, or one without content, as left by an interrupted create_database().
bool is_new_database(const std::string& path);

/// Opens an existing file for writing if that is allowed. Throws Error (File) when it is missing,
/// of another kind or version, damaged, or when SQLite would execute what is stored in it (see
/// distrust()).
std::unique_ptr<SQLite::Database> open_database(const std::string& path, const DatabaseKind& kind);

/// One more connection to a file that open_database() has accepted, for reading only; `flags` are
/// added to SQLite's. Throws as it.
std::unique_ptr<SQLite::Database> open_reader(const std::string& path, int flags = 0);

/// Makes a connection safe for files of strangers, as sqlite.org/security.html advises: no trusted
/// schema, defensive, a limited number of attached files, and a limit on the steps of one statement
/// that grows with the file. Throws Error (File) if `schema` ("main", or an attached one) contains
/// views, triggers, virtual tables, computed columns or indexes of expressions; `kind` is what was
/// expected.
void distrust(SQLite::Database& database, const std::string& path,
              const std::string& schema = "main",
              const std::string& kind = "a file written by Slalom");

/// The file at a path, to notice that it was removed, renamed or replaced: SQLite does not.
class FileIdentity {
 public:
  FileIdentity() = default;
  explicit FileIdentity(const std::string& path);

  std::int64_t size() const { return size_; }  ///< bytes, when it was looked at
  bool operator<(const FileIdentity& other) const {
    return std::tie(device_, node_) < std::tie(other.device_, other.node_);
  }
  /// "was removed" or "was replaced" by another program, "" if the path still leads to the file.
  std::string change(const std::string& path) const;

 private:
  std::uint64_t device_ = 0, node_ = 0;  ///< 0: no file
  std::int64_t size_ = 0;
};

bool has_table(SQLite::Database& database, const std::string& name,
               const std::string& schema = "main");

/// A prepared statement in use; reset afterwards to release its locks.
class StatementUse {
 public:
  explicit StatementUse(SQLite::Statement& statement) : statement_(statement) {}
  ~StatementUse() {
    statement_.tryReset();
    statement_.clearBindings();
  }
  StatementUse(const StatementUse&) = delete;
  StatementUse& operator=(const StatementUse&) = delete;
  SQLite::Statement* operator->() const { return &statement_; }
  SQLite::Statement& operator*() const { return statement_; }

 private:
  SQLite::Statement& statement_;
};

/// A statement with values for its parameters.
template <typename... Values>
SQLite::Statement bound(SQLite::Database& database, const std::string& sql,
                        const Values&... values) {
  SQLite::Statement statement(database, sql);
  SQLite::bind(statement, values...);
  return statement;
}

/// "INSERT INTO table (a, b) VALUES (?, ?)"
std::string insert_sql(const std::string& table, const std::string& columns);

/// A transaction for reading, also within another one: all statements see the same state.
class ReadTransaction {
 public:
  explicit ReadTransaction(SQLite::Database& database) : database_(database) {
    database.exec("SAVEPOINT read_scope");
  }
  ~ReadTransaction() { database_.tryExec("RELEASE read_scope"); }
  ReadTransaction(const ReadTransaction&) = delete;
  ReadTransaction& operator=(const ReadTransaction&) = delete;

 private:
  SQLite::Database& database_;
};

/// Throws Error (File) unless the table `runs` of a result file has `count` rows by its index:
/// rows can be missing from a damaged table without being noticed otherwise.
void expect_count_of_runs(SQLite::Database& database, const std::string& path, std::int64_t count);

/// Runs `act`, converting SQLite's exceptions to Error: File when reading, Job when writing.
template <typename Act>
auto reading(const std::string& path, Act act) -> decltype(act());
template <typename Act>
auto writing(const std::string& path, Act act) -> decltype(act());

/// SQLite cannot tell a lock that another program has from one that the file system refuses.
Error locked_error(const std::string& path);
[[noreturn]] void throw_read_error(const std::string& path, const std::exception& e);
[[noreturn]] void throw_write_error(const std::string& path, const std::exception& e);

template <typename Act>
auto reading(const std::string& path, Act act) -> decltype(act()) {
  try {
    return act();
  } catch (const SQLite::Exception& e) {
    throw_read_error(path, e);
  }
}

template <typename Act>
auto writing(const std::string& path, Act act) -> decltype(act()) {
  try {
    return act();
  } catch (const SQLite::Exception& e) {
    throw_write_error(path, e);
  }
}

}  // namespace slalom
