#include "list_schema.h"
#include "write_scope.h"

#include <slalom/core/error.h>

namespace slalom {
namespace {

constexpr int kVersion = 2;

/// `content` is the last column, so that selections do not read it.
#define SLALOM_LIST_TABLES                                                                  \
  "CREATE TABLE scenarios (position INTEGER PRIMARY KEY, hash TEXT NOT NULL UNIQUE,"        \
  " name TEXT NOT NULL, representation TEXT NOT NULL, generator TEXT, seed INTEGER,"        \
  " content BLOB NOT NULL);"                                                                \
  "CREATE TABLE tags (hash TEXT NOT NULL, tag TEXT NOT NULL, PRIMARY KEY (hash, tag))"      \
  " WITHOUT ROWID;"                                                                         \
  "CREATE INDEX scenarios_by_tag ON tags (tag, hash);"                                      \
  "CREATE TABLE descriptor_keys (key INTEGER PRIMARY KEY, id TEXT NOT NULL,"                \
  " version INTEGER NOT NULL, parameters TEXT NOT NULL, UNIQUE (id, version, parameters));" \
  "CREATE TABLE descriptor_values (hash TEXT NOT NULL, key INTEGER NOT NULL, value REAL,"   \
  " standard_error REAL, reason TEXT, PRIMARY KEY (hash, key)) WITHOUT ROWID;"              \
  "CREATE TABLE indexes (name TEXT PRIMARY KEY COLLATE NOCASE, descriptor TEXT NOT NULL,"   \
  " keys TEXT NOT NULL, edges TEXT NOT NULL);"

constexpr const char* kFromVersion1 =
    "ALTER TABLE scenarios RENAME TO old_scenarios;"
    "ALTER TABLE descriptors RENAME TO old_descriptors;" SLALOM_LIST_TABLES
    "INSERT INTO scenarios (position, hash, name, representation, content)"
    " SELECT position, hash, name, representation, content FROM old_scenarios;"
    "INSERT INTO descriptor_keys (id, version, parameters)"
    " SELECT DISTINCT id, version, parameters FROM old_descriptors ORDER BY 1, 2, 3;"
    "INSERT INTO descriptor_values (hash, key, value, standard_error, reason)"
    " SELECT hash, key, value, standard_error, reason FROM old_descriptors"
    " JOIN descriptor_keys USING (id, version, parameters);"
    "DROP TABLE old_scenarios;"
    "DROP TABLE old_descriptors;"
    "PRAGMA user_version = 2;";

int version_of(SQLite::Database& database) {
  return database.execAndGet("PRAGMA user_version").getInt();
}

}  // namespace

const DatabaseKind kScenarioList = {
    "a scenario list (.scenarios)", 0x534c534c /* "SLSL" */, kVersion,
    SLALOM_LIST_TABLES "CREATE TABLE notes (key TEXT PRIMARY KEY, text TEXT NOT NULL);", 1};

void upgrade_list(SQLite::Database& database, const std::string& path) {
  if (version_of(database) == kVersion) return;
  try {
    WriteScope scope(database);
    // Another program may have upgraded it in the meantime.
    if (version_of(database) != kVersion) database.exec(kFromVersion1);
    scope.commit();
  } catch (const SQLite::Exception& e) {
    throw file_error(path,
                     "is a list of version 1 and cannot be upgraded to version 2 (" +
                         std::string(e.what()) + ")",
                     "a writable copy");
  }
}

void refuse_foreign_schema(SQLite::Database& database, const std::string& path) {
  SQLite::Statement row(database,
                        "SELECT name FROM sqlite_master WHERE type NOT IN ('table', 'index')");
  if (row.executeStep())
    throw file_error(path, "contains a view or trigger '" + row.getColumn(0).getString() + "'",
                     "a scenario list written by Slalom");
}

}  // namespace slalom
