// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_list_impl.h"

#include <algorithm>

namespace slalom {
namespace {

constexpr std::int64_t kMaxDeletedBytes = std::int64_t{64} * 1024 * 1024;

/// The rows of deleted scenarios as they were, with the number of the deletion. Created by the
/// first one, and unknown to earlier versions of Slalom, which leave the tables unchanged.
constexpr const char* kTables =
    "CREATE TABLE IF NOT EXISTS deleted_scenarios (hash TEXT NOT NULL PRIMARY KEY,"
    " deletion INTEGER NOT NULL, position INTEGER NOT NULL, name TEXT NOT NULL,"
    " representation TEXT NOT NULL, generator TEXT, seed INTEGER, checksum INTEGER NOT NULL,"
    " content BLOB NOT NULL);"
    "CREATE TABLE IF NOT EXISTS deleted_tags (hash TEXT NOT NULL, tag TEXT NOT NULL,"
    " PRIMARY KEY (hash, tag)) WITHOUT ROWID;"
    "CREATE TABLE IF NOT EXISTS deleted_values (hash TEXT NOT NULL, key INTEGER NOT NULL,"
    " value REAL, standard_error REAL, reason TEXT, checksum INTEGER NOT NULL,"
    " PRIMARY KEY (hash, key)) WITHOUT ROWID;";

}  // namespace

std::int64_t ScenarioList::Impl::begin_deletion() {
  database->exec(kTables);
  return database->execAndGet("SELECT ifnull(max(deletion), 0) + 1 FROM deleted_scenarios")
      .getInt64();
}

void ScenarioList::Impl::keep_deleted(const std::string& hash, std::int64_t deletion) {
  forget_deleted(hash);  // an earlier deletion
  for (const char* sql :
       {"INSERT INTO deleted_scenarios SELECT hash, ?2, position, name, representation, generator, "
        "seed, checksum, content FROM scenarios WHERE hash = ?1",
        "INSERT INTO deleted_tags SELECT hash, tag FROM tags WHERE hash = ?1",
        "INSERT INTO deleted_values SELECT hash, key, value, standard_error, reason, checksum "
        "FROM descriptor_values WHERE hash = ?1"}) {
    StatementUse rows = use(sql);
    rows->bind(1, hash);
    if (rows->getBindParameterCount() > 1) rows->bind(2, deletion);
    rows->exec();
  }
}

void ScenarioList::Impl::forget_deleted(const std::string& hash) {
  for (const char* sql :
       {"DELETE FROM deleted_tags WHERE hash = ?", "DELETE FROM deleted_values WHERE hash = ?",
        "DELETE FROM deleted_scenarios WHERE hash = ?"}) {
    StatementUse rows = use(sql);
    rows->bind(1, hash);
    rows->exec();
  }
}

void ScenarioList::Impl::limit_deleted() {
  std::vector<std::string> oldest;
  {
    StatementUse rows =
        use("SELECT hash FROM (SELECT hash, row_number() OVER latest AS n, "
            "total(length(content)) OVER latest AS bytes FROM deleted_scenarios "
            "WINDOW latest AS (ORDER BY deletion DESC, position DESC ROWS UNBOUNDED PRECEDING)) "
            "WHERE n > ? OR bytes > ?");
    rows->bind(1, static_cast<std::int64_t>(kMaxDeleted));
    rows->bind(2, kMaxDeletedBytes);
    while (rows->executeStep()) oldest.push_back(rows->getColumn(0).getString());
  }
  for (const std::string& hash : oldest) forget_deleted(hash);
}

bool ScenarioList::Impl::restore(const std::string& hash) {
  bool restored = false;
  for (const char* sql :
       {"INSERT OR IGNORE INTO scenarios (hash, name, representation, generator, seed, checksum, "
        "content) SELECT hash, name, representation, generator, seed, checksum, content "
        "FROM deleted_scenarios WHERE hash = ?",
        "UPDATE OR IGNORE scenarios SET position = (SELECT position FROM deleted_scenarios AS d "
        "WHERE d.hash = scenarios.hash) WHERE hash = ?",
        "INSERT OR IGNORE INTO tags SELECT hash, tag FROM deleted_tags WHERE hash = ?",
        "INSERT OR IGNORE INTO descriptor_values SELECT hash, key, value, standard_error, reason, "
        "checksum FROM deleted_values WHERE hash = ?"}) {
    StatementUse rows = use(sql);
    rows->bind(1, hash);
    const bool changed = rows->exec() > 0;
    if (!restored && !changed) return false;  // not deleted, or added again
    restored = true;
  }
  forget_deleted(hash);
  expect_undamaged(hash);
  return true;
}

bool ScenarioList::has_deletions() const {
  return reading(impl_->path, [&] {
    return has_table(*impl_->database, "deleted_scenarios") &&
           impl_->database
                   ->execAndGet(
                       "SELECT EXISTS (SELECT 1 FROM deleted_scenarios WHERE hash NOT IN "
                       "(SELECT hash FROM scenarios))")
                   .getInt() > 0;
  });
}

std::vector<std::vector<ScenarioList::Entry>> ScenarioList::deletions() const {
  return reading(impl_->path, [&] {
    std::vector<std::vector<Entry>> deletions;
    if (!has_table(*impl_->database, "deleted_scenarios")) return deletions;
    StatementUse rows = impl_->use(
        "SELECT hash, name, representation, generator, seed, checksum, deletion "
        "FROM deleted_scenarios WHERE hash NOT IN (SELECT hash FROM scenarios) "
        "ORDER BY deletion DESC, position");
    std::int64_t last = 0;
    while (rows->executeStep()) {
      const std::int64_t deletion = rows->getColumn(6).getInt64();
      if (deletions.empty() || deletion != last) deletions.emplace_back();
      last = deletion;
      deletions.back().push_back(
          impl_->entry_of(*rows, "SELECT tag FROM deleted_tags WHERE hash = ? ORDER BY tag"));
    }
    return deletions;
  });
}

std::size_t ScenarioList::restore(const std::vector<std::string>& hashes) {
  return impl_->write([&] {
    if (!has_table(*impl_->database, "deleted_scenarios")) return std::size_t{0};
    return static_cast<std::size_t>(
        std::count_if(hashes.begin(), hashes.end(), [&](const std::string& hash) {
          if (!impl_->restore(hash)) return false;
          read(hash);  // throws if the content is damaged
          return true;
        }));
  });
}

}  // namespace slalom
