// SPDX-License-Identifier: BSD-3-Clause
#include "checked_row.h"
#include "scenario_list_impl.h"

#include <slalom/core/error.h>

#include <cctype>

namespace slalom {
namespace {

constexpr std::size_t kIdDigits = 12;
constexpr std::size_t kMaxTagLength = 100;

/// Checksum of the columns hash, name, representation, generator and seed, and of the tags.
std::int64_t checksum_of(SQLite::Statement& row, const std::vector<std::string>& tags) {
  RowChecksum checksum;
  checksum.add_columns(row, 0, 5);
  for (const std::string& tag : tags) checksum.add(tag);
  return checksum.value();
}

/// In lists of earlier versions of Slalom the checksum does not contain the tags.
bool has_checksum(SQLite::Statement& row, const std::vector<std::string>& tags,
                  std::int64_t checksum) {
  return checksum == checksum_of(row, tags) || checksum == checksum_of(row, {});
}

}  // namespace

StatementUse ScenarioList::Impl::use(const char* sql) {
  std::unique_ptr<SQLite::Statement>& statement = statements[sql];
  if (!statement) statement = std::make_unique<SQLite::Statement>(*database, sql);
  return StatementUse(*statement);
}

std::vector<std::string> ScenarioList::Impl::tags_of(const std::string& hash,
                                                     const char* tags_sql) {
  std::vector<std::string> tags;
  StatementUse rows = use(tags_sql);
  rows->bind(1, hash);
  while (rows->executeStep()) tags.push_back(rows->getColumn(0).getString());
  return tags;
}

ScenarioList::Entry ScenarioList::Impl::entry_of(SQLite::Statement& row, const char* tags_sql) {
  Entry entry;
  entry.hash = row.getColumn(0).getString();
  entry.id = entry.hash.substr(0, kIdDigits);
  entry.name = row.getColumn(1).getString();
  entry.tags = tags_of(entry.hash, tags_sql);
  const auto representation = from_name<Representation>(row.getColumn(2).getString());
  if (!representation || !has_checksum(row, entry.tags, row.getColumn(5).getInt64()))
    throw file_error(path + ": scenario '" + entry.hash + "'",
                     "is damaged (does not match its checksum)", "an unmodified file");
  entry.representation = *representation;
  entry.generator = row.getColumn(3).getString();
  if (!row.getColumn(4).isNull())
    entry.seed = static_cast<std::uint64_t>(row.getColumn(4).getInt64());
  return entry;
}

void ScenarioList::Impl::expect_undamaged(const std::string& hash) {
  StatementUse row = use(
      "SELECT hash, name, representation, generator, seed, checksum FROM scenarios WHERE hash = ?");
  row->bind(1, hash);
  if (row->executeStep()) entry_of(*row);
}

void ScenarioList::Impl::update_checksum(const std::string& hash) {
  StatementUse row =
      use("SELECT hash, name, representation, generator, seed FROM scenarios WHERE hash = ?");
  row->bind(1, hash);
  if (!row->executeStep()) return;
  StatementUse update = use("UPDATE scenarios SET checksum = ? WHERE hash = ?");
  update->bind(1, checksum_of(*row, tags_of(hash)));
  update->bind(2, hash);
  update->exec();
}

bool ScenarioList::Impl::insert(const Entry& entry, const std::string& content) {
  StatementUse row =
      use("INSERT OR IGNORE INTO scenarios (hash, name, representation, generator, seed, checksum, "
          "content) VALUES (?, ?, ?, ?, ?, ?, ?)");
  RowChecksum checksum;
  checksum.add(entry.hash).add(entry.name).add(to_string(entry.representation));
  row->bind(1, entry.hash);
  row->bind(2, entry.name);
  row->bind(3, to_string(entry.representation));
  if (!entry.generator.empty()) row->bind(4, entry.generator);
  entry.generator.empty() ? checksum.add_null() : checksum.add(entry.generator);
  if (entry.seed) row->bind(5, static_cast<std::int64_t>(*entry.seed));
  entry.seed ? checksum.add(static_cast<std::int64_t>(*entry.seed)) : checksum.add_null();
  row->bind(6, checksum.value());
  row->bind(7, content.data(), static_cast<int>(content.size()));
  const bool added = row->exec() > 0;
  if (entry.tags.empty()) return added;
  if (!added) expect_undamaged(entry.hash);
  for (const std::string& tag : entry.tags) add_tag(entry.hash, tag);
  update_checksum(entry.hash);
  return added;
}

bool ScenarioList::Impl::add_tag(const std::string& hash, const std::string& tag) {
  StatementUse row = use("INSERT OR IGNORE INTO tags VALUES (?, ?)");
  row->bind(1, hash);
  row->bind(2, tag);
  return row->exec() > 0;
}

bool ScenarioList::Impl::remove(const std::string& hash) {
  bool removed = false;
  for (const char* sql :
       {"DELETE FROM tags WHERE hash = ?", "DELETE FROM descriptor_values WHERE hash = ?",
        "DELETE FROM scenarios WHERE hash = ?"}) {
    StatementUse row = use(sql);
    row->bind(1, hash);
    removed = row->exec() > 0;
  }
  return removed;
}

std::string ScenarioList::Impl::content(const std::string& hash) {
  StatementUse row = use("SELECT content FROM scenarios WHERE hash = ?");
  row->bind(1, hash);
  if (!row->executeStep()) throw file_error(path, "contains no scenario " + hash);
  return row->getColumn(0).getString();
}

std::vector<std::string> ScenarioList::Impl::names() {
  return reading(path, [&] {
    std::vector<std::string> names;
    StatementUse rows = use("SELECT name FROM scenarios ORDER BY position");
    while (rows->executeStep()) names.push_back(rows->getColumn(0).getString());
    return names;
  });
}

void check_tag(const std::string& tag) {
  const std::string allowed = "at most 100 letters, digits and _ - . : / +";
  bool good = !tag.empty() && tag.size() <= kMaxTagLength;
  for (const char c : tag)
    good = good && (std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                    std::string("_-.:/+").find(c) != std::string::npos ||
                    static_cast<unsigned char>(c) >= 0x80);
  if (!good) throw usage_error("tag '" + tag + "'", "invalid tag", allowed);
}

}  // namespace slalom
