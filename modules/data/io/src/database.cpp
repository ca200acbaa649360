// SPDX-License-Identifier: BSD-3-Clause
#include "compression.h"
#include "database.h"
#include "transaction.h"

#include <slalom/core/error.h>
#include <slalom/core/file_format.h>
#include <slalom/core/read_file.h>
#include <slalom/io/bundle.h>
#include <slalom/io/foreign_database.h>
#include <slalom/io/read_results.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

namespace slalom {
namespace {

constexpr int kBusyTimeoutMs = 10000;
constexpr std::string_view kDatabaseMagic("SQLite format 3\0", 16);

/// SQLite also opens the files beside a database, and waits for the writer of a pipe.
void require_regular_files(const std::string& path, const std::string& kind) {
  require_regular_file(path, kind);
  for (const char* const suffix : {"-journal", "-wal"}) {
    const std::string companion = path + suffix;
    struct stat found = {};  // a writer may remove it at any time
    if (stat(companion.c_str(), &found) == 0 && !S_ISREG(found.st_mode))
      require_regular_file(companion, "the journal of " + kind);
  }
}

/// The path within a URI.
std::string uri_path(const std::string& path) {
  std::string text;
  for (const char c : path)
    text += c == '%' ? "%25" : c == '?' ? "%3f" : c == '#' ? "%23" : std::string(1, c);
  return text;
}

int pragma(SQLite::Database& database, const std::string& name) {
  return database.execAndGet("PRAGMA " + name).getInt();
}

void expect_kind(SQLite::Database& database, const std::string& path, const DatabaseKind& kind) {
  if (pragma(database, "application_id") != kind.application_id)
    throw file_error(path, "is a different kind of file", kind.name);
  const int version = pragma(database, "user_version");
  const int oldest = kind.oldest_version > 0 ? kind.oldest_version : kind.version;
  if (version < oldest || version > kind.version)
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

namespace {

/// The steps of SQLite's virtual machine between two calls of the progress handler.
constexpr int kStepsPerCheck = 1000000;

/// Ends a statement that executes far more steps than its file has room for rows: the pages of a
/// crafted file can lead to each other, so that reading them does not end.
class StepLimit {
 public:
  static void install(sqlite3* handle) {
    auto* const limit = new StepLimit(handle);  // deleted when the connection is closed
    sqlite3_progress_handler(handle, kStepsPerCheck, check, limit);
    sqlite3_trace_v2(handle, SQLITE_TRACE_STMT | SQLITE_TRACE_CLOSE, observe, limit);
  }

 private:
  explicit StepLimit(sqlite3* handle) : handle_(handle) {}

  static int observe(unsigned event, void* self, void* statement, void*) {
    if (event == SQLITE_TRACE_CLOSE)
      delete static_cast<StepLimit*>(self);
    else
      static_cast<StepLimit*>(self)->checks_.erase(static_cast<sqlite3_stmt*>(statement));
    return 0;
  }

  static int check(void* self) { return static_cast<StepLimit*>(self)->is_exceeded() ? 1 : 0; }

  bool is_exceeded() {
    constexpr std::int64_t kMinSteps = 10000000, kStepsPerByte = 100;
    const char* const path = sqlite3_db_filename(handle_, "main");
    sqlite3_int64 size = 0;
    if (sqlite3_serialize(handle_, "main", &size, SQLITE_SERIALIZE_NOCOPY) == nullptr)
      size = FileIdentity(path == nullptr ? "" : path).size();  // not in memory
    const std::int64_t allowed = (kMinSteps + kStepsPerByte * size) / kStepsPerCheck;
    sqlite3_stmt* statement = nullptr;
    while ((statement = sqlite3_next_stmt(handle_, statement)) != nullptr)
      if (sqlite3_stmt_busy(statement) != 0 && ++checks_[statement] > allowed) return true;
    return false;
  }

  sqlite3* handle_;
  std::map<sqlite3_stmt*, std::int64_t> checks_;  ///< during the present execution
};

/// The database in a bundle, in memory.
std::unique_ptr<SQLite::Database> open_bundle(const std::string& path, int flags = 0) {
  const std::string content = decompress(read_file(path, "a bundle (.slalom)"), path);
  auto database = std::make_unique<SQLite::Database>(
      ":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE | flags);
  auto* const pages = static_cast<unsigned char*>(sqlite3_malloc64(content.size() + 1));
  if (pages == nullptr) throw std::bad_alloc();
  std::copy(content.begin(), content.end(), pages);
  const auto size = static_cast<sqlite3_int64>(content.size());
  const int status =
      sqlite3_deserialize(database->getHandle(), "main", pages, size, size,
                          SQLITE_DESERIALIZE_READONLY | SQLITE_DESERIALIZE_FREEONCLOSE);
  if (status != SQLITE_OK) throw SQLite::Exception(database->getHandle(), status);
  return database;
}

void refuse_foreign_schema(SQLite::Database& database, const std::string& path,
                           const std::string& schema, const std::string& kind) {
  const auto refuse = [&](const std::string& sql, const std::string& what) {
    SQLite::Statement found(database, sql);
    if (found.executeStep())
      throw file_error(path, "contains " + what + " '" + found.getColumn(0).getString() + "'",
                       kind);
  };
  const std::string objects = schema + ".sqlite_master";
  const ReadTransaction scope(database);  // one lock for all statements
  refuse("SELECT name FROM " + objects + " WHERE type NOT IN ('table', 'index')",
         "a view or trigger");
  refuse("SELECT name FROM " + objects +
             " WHERE type = 'table' AND (rootpage IS NULL OR rootpage = 0)",
         "a virtual table");
  const std::string argument = ", '" + schema + "')";
  refuse("SELECT c.name FROM " + objects + " AS o, pragma_table_xinfo(o.name" + argument +
             " AS c WHERE o.type = 'table' AND c.hidden <> 0",
         "a computed column");
  refuse("SELECT o.name FROM " + objects + " AS o, pragma_index_xinfo(o.name" + argument +
             " AS c WHERE o.type = 'index' AND c.cid = -2",
         "an index of an expression");
}

}  // namespace

void distrust(SQLite::Database& database, const std::string& path, const std::string& schema,
              const std::string& kind) {
  sqlite3* const handle = database.getHandle();
  for (const auto& [option, value] :
       {std::pair{SQLITE_DBCONFIG_DEFENSIVE, 1}, std::pair{SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
        std::pair{SQLITE_DBCONFIG_ENABLE_TRIGGER, 0}, std::pair{SQLITE_DBCONFIG_ENABLE_VIEW, 0},
        std::pair{SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0}})
    sqlite3_db_config(handle, option, value, nullptr);
  sqlite3_limit(handle, SQLITE_LIMIT_ATTACHED, 1);
  if (schema == "main") StepLimit::install(handle);
  refuse_foreign_schema(database, path, schema, kind);
}

bool has_table(SQLite::Database& database, const std::string& name, const std::string& schema) {
  return bound(database, "SELECT 1 FROM " + schema + ".sqlite_master WHERE name = ?", name)
      .executeStep();
}

std::string insert_sql(const std::string& table, const std::string& columns) {
  std::string values = "?";
  for (const char c : columns)
    if (c == ',') values += ", ?";
  return "INSERT INTO " + table + " (" + columns + ") VALUES (" + values + ")";
}

FileIdentity::FileIdentity(const std::string& path) {
  struct stat found = {};
  if (stat(path.c_str(), &found) != 0) return;
  device_ = static_cast<std::uint64_t>(found.st_dev);
  node_ = static_cast<std::uint64_t>(found.st_ino);
  size_ = found.st_size;
}

std::string FileIdentity::change(const std::string& path) const {
  const FileIdentity now(path);
  if (now.device_ == device_ && now.node_ == node_) return "";
  return now.node_ == 0 ? "was removed by another program" : "was replaced by another program";
}

namespace {

int code_of(const std::exception& e) {
  const auto* const of_database = dynamic_cast<const SQLite::Exception*>(&e);
  return of_database == nullptr ? SQLITE_OK : of_database->getErrorCode();
}

}  // namespace

Error locked_error(const std::string& path) {
  return job_error(path,
                   "is locked by another program, or its file system has no locks (as NFS without "
                   "lockd)",
                   "the end of that program, or a local disk");
}

void throw_read_error(const std::string& path, const std::exception& e) {
  if (code_of(e) == SQLITE_BUSY) throw locked_error(path);
  if (code_of(e) == SQLITE_INTERRUPT)
    throw file_error(path, "is damaged (reading it does not end)", "a file written by Slalom");
  throw file_error(path, std::string("cannot be read (") + e.what() + ")");
}

void throw_write_error(const std::string& path, const std::exception& e) {
  if (code_of(e) == SQLITE_BUSY) throw locked_error(path);
  throw job_error(path, std::string("cannot be written (") + e.what() + ")");
}

void expect_count_of_runs(SQLite::Database& database, const std::string& path, std::int64_t count) {
  const std::int64_t indexed = database.execAndGet("SELECT COUNT(*) FROM runs").getInt64();
  if (indexed != count)
    throw file_error(path,
                     "is damaged (contains " + std::to_string(count) + " runs, " +
                         std::to_string(indexed) + " in its index)",
                     "an unmodified file");
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
    Transaction scope(*database);
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
  require_regular_files(path, "a file of Slalom");
  try {
    // Opened for writing, so that a transaction that was interrupted is rolled back.
    SQLite::Database database(path, SQLite::OPEN_READWRITE, kBusyTimeoutMs);
    return is_empty(database);
  } catch (const SQLite::Exception&) {
    return false;
  }
}

bool is_database(const std::string& path) {
  require_regular_file(path, "a result file (.results) or a table (.csv)");
  std::string head(kDatabaseMagic.size(), ' ');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  return file && head == kDatabaseMagic;
}

bool is_bundle(const std::string& path) {
  require_regular_file(path, "a result file (.results), a bundle (.slalom) or a table (.csv)");
  std::string head(4, ' ');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  if (!file || head != "\x28\xB5\x2F\xFD") return false;  // of zstd
  head.resize(kHeadOfBlock);
  file.read(head.data() + 4, static_cast<std::streamsize>(head.size() - 4));
  head.resize(4 + static_cast<std::size_t>(file.gcount()));
  return decompress_head(head, kDatabaseMagic.size()) == kDatabaseMagic;
}

std::unique_ptr<SQLite::Database> open_reader(const std::string& path, int flags) {
  require_regular_files(path, "a file written by Slalom");
  auto database = is_bundle(path) ? open_bundle(path, flags)
                                  : std::make_unique<SQLite::Database>(
                                        path, SQLite::OPEN_READONLY | flags, kBusyTimeoutMs);
  distrust(*database, path);
  return database;
}

std::unique_ptr<SQLite::Database> open_foreign_database(const std::string& path,
                                                        const std::string& kind) {
  require_regular_files(path, kind);
  return reading(path, [&] {
    std::string name = path;
    int mode = SQLite::OPEN_READONLY;
    // SQLite would make a new log beside a file whose writer used one and closed it.
    if (access((path + "-wal").c_str(), F_OK) != 0) {
      name = "file:" + uri_path(path) + "?immutable=1";
      mode |= SQLite::OPEN_URI;
    }
    auto database = std::make_unique<SQLite::Database>(name, mode, kBusyTimeoutMs);
    distrust(*database, path, "main", kind);
    return database;
  });
}

namespace {

/// How a table becomes a result file.
std::string table_hint(const std::string& path, const DatabaseKind& kind) {
  if (!ends_with(kind.name, "(.results)")) return "";
  for (const char* ending : {".csv", ".tsv", ".txt", ".json", ".xlsx"})
    if (ends_with(path, ending)) return ", which slalom-analyze import makes of a table";
  return "";
}

}  // namespace

std::unique_ptr<SQLite::Database> open_database(const std::string& path, const DatabaseKind& kind) {
  require_regular_files(path, kind.name);
  const bool packed = is_bundle(path);
  if (!packed) refuse_foreign_file(path, kind.name);
  const int mode = access(path.c_str(), W_OK) == 0 ? SQLite::OPEN_READWRITE : SQLite::OPEN_READONLY;
  return reading(path, [&] {
    auto database =
        packed ? open_bundle(path) : std::make_unique<SQLite::Database>(path, mode, kBusyTimeoutMs);
    try {
      expect_kind(*database, path, kind);
      distrust(*database, path);
    } catch (const SQLite::Exception&) {
      throw file_error(path, "is damaged or not an SQLite file",
                       kind.name + table_hint(path, kind));
    }
    return database;
  });
}

}  // namespace slalom
