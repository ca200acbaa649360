#include "database.h"

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>

#include <cerrno>
#include <cstring>
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
  const int oldest = kind.oldest > 0 ? kind.oldest : kind.version;
  if (version < oldest || version > kind.version)
    throw file_error(path, "unsupported version " + std::to_string(version),
                     std::string(kind.name) + " of version " + std::to_string(kind.version));
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

std::unique_ptr<SQLite::Database> create_database(const std::string& path,
                                                  const DatabaseKind& kind) {
  for (const char* suffix : {"", "-journal", "-wal"})
    if (unlink((path + suffix).c_str()) != 0 && errno != ENOENT)
      throw job_error(path, std::string("cannot be replaced (") + std::strerror(errno) + ")",
                      "a writable path");
  return writing(path, [&] {
    auto database = std::make_unique<SQLite::Database>(
        path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kBusyTimeoutMs);
    database->exec("PRAGMA application_id = " + std::to_string(kind.application_id));
    database->exec("PRAGMA user_version = " + std::to_string(kind.version));
    database->exec(kind.schema);
    return database;
  });
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
