#include "database.h"
#include "write_scope.h"

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/io/read_results.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sqlite3.h>
#include <unistd.h>

namespace slalom {
namespace {

constexpr int kBusyTimeoutMs = 10000;

int pragma(SQLite::Database& database, const std::string& name) {
  return database.execAndGet("PRAGMA " + name).getInt();
}

void expect_kind(SQLite::Database& database, const std::string& path, const DatabaseKind& kind) {
  if (pragma(database, "application_id") != kind.application_id)
    throw file_error(path, "is a different kind of file", kind.name);
  const int version = pragma(database, "user_version");
  if (version != kind.version)
    throw file_error(path, "unsupported version " + std::to_string(version),
                     std::string(kind.name) + " of version " + std::to_string(kind.version));
}

bool is_empty(SQLite::Database& database) {
  return database.execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0;
}

/// Removes everything from a database, even a damaged one. Unlike removal of the file and its
/// journal, it waits for other programs and is undone if it is interrupted.
void reset(SQLite::Database& database) {
  sqlite3_db_config(database.getHandle(), SQLITE_DBCONFIG_RESET_DATABASE, 1, nullptr);
  database.exec("VACUUM");
  sqlite3_db_config(database.getHandle(), SQLITE_DBCONFIG_RESET_DATABASE, 0, nullptr);
}

}  // namespace

void throw_read_error(const std::string& path, const std::exception& e) {
  throw file_error(path, std::string("cannot be read (") + e.what() + ")");
}

void throw_write_error(const std::string& path, const std::exception& e) {
  throw job_error(path, std::string("cannot be written (") + e.what() + ")");
}

void expect_count_of_runs(SQLite::Database& database, const std::string& path, std::int64_t count) {
  const std::int64_t indexed = database.execAndGet("SELECT COUNT(*) FROM runs").getInt64();
  if (indexed != count)
    throw file_error(path,
                     "is damaged (contains " + std::to_string(count) + " runs, " +
                         std::to_string(indexed) + " in its index)",
                     "a file as it was written");
}

void expect_replaceable(const std::string& path, const DatabaseKind& kind) {
  constexpr std::streamoff kApplicationId = 68;  // SQLite's file format
  if (access(path.c_str(), F_OK) != 0) return;
  require_regular_file(path, kind.name);
  std::ifstream file(path, std::ios::binary);
  if (!file || file.peek() == std::ifstream::traits_type::eof()) return;
  unsigned char id[4] = {};
  file.seekg(kApplicationId);
  file.read(reinterpret_cast<char*>(id), sizeof id);
  int number = 0;
  for (const unsigned char byte : id) number = (number << 8) | byte;
  if (!is_database(path) || number != kind.application_id)
    throw file_error(path, "is a different kind of file and is not replaced",
                     std::string("a new file, or ") + kind.name);
}

std::unique_ptr<SQLite::Database> create_database(
    const std::string& path, const DatabaseKind& kind,
    const std::function<void(SQLite::Database&)>& fill) {
  expect_replaceable(path, kind);
  return writing(path, [&] {
    auto database = std::make_unique<SQLite::Database>(
        path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kBusyTimeoutMs);
    if (!is_empty(*database)) reset(*database);
    // One transaction: a file is either empty or complete, whenever the program is killed.
    WriteScope scope(*database);
    database->exec("PRAGMA application_id = " + std::to_string(kind.application_id));
    database->exec("PRAGMA user_version = " + std::to_string(kind.version));
    database->exec(kind.schema);
    if (fill) fill(*database);
    scope.commit();
    return database;
  });
}

bool is_new_database(const std::string& path) {
  if (access(path.c_str(), F_OK) != 0) return true;
  try {
    // Opened for writing, so that a transaction that was interrupted is rolled back.
    SQLite::Database database(path, SQLite::OPEN_READWRITE, kBusyTimeoutMs);
    return is_empty(database);
  } catch (const SQLite::Exception&) {
    return false;
  }
}

std::unique_ptr<SQLite::Database> open_database(const std::string& path, const DatabaseKind& kind) {
  require_regular_file(path, kind.name);
  const int mode = access(path.c_str(), W_OK) == 0 ? SQLite::OPEN_READWRITE : SQLite::OPEN_READONLY;
  return reading(path, [&] {
    auto database = std::make_unique<SQLite::Database>(path, mode, kBusyTimeoutMs);
    try {
      expect_kind(*database, path, kind);
    } catch (const SQLite::Exception&) {
      throw file_error(path, "is damaged or not an SQLite file", kind.name);
    }
    return database;
  });
}

}  // namespace slalom
