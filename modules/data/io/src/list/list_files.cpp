// SPDX-License-Identifier: BSD-3-Clause
#include "list_schema.h"
#include "scenario_list_impl.h"
#include "sibling_temp_file.h"

#include <slalom/core/printable.h>

#include <cerrno>
#include <cstring>
#include <mutex>
#include <set>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

namespace slalom {
namespace {

/// The old list, locked, with incomplete transactions rolled back; null if there is no SQLite file.
std::unique_ptr<SQLite::Database> lock_old(const std::string& path) {
  constexpr int kLockTimeoutMs = 10000;
  if (access(path.c_str(), F_OK) != 0) return nullptr;
  try {
    auto old = std::make_unique<SQLite::Database>(path, SQLite::OPEN_READWRITE, kLockTimeoutMs);
    old->exec("BEGIN EXCLUSIVE");
    return old;
  } catch (const SQLite::Exception& e) {
    if (e.getErrorCode() == SQLITE_BUSY) throw locked_error(path);
    return nullptr;
  }
}

/// Replaces the old list while holding a lock on it: a program that waits for the lock then detects
/// that the file was replaced.
void publish(SiblingTempFile& draft, const std::string& path) {
  const auto old = lock_old(path);
  draft.publish();
}

/// Once for each file: rows of damaged pages, or missing from an index, would be left out silently.
void expect_sound(SQLite::Database& database, const std::string& path, const FileIdentity& file) {
  static std::mutex mutex;
  static std::set<FileIdentity> sound;
  const std::lock_guard lock(mutex);
  if (sound.count(file) > 0) return;
  const std::string found =
      reading(path, [&] { return database.execAndGet("PRAGMA integrity_check(1)").getString(); });
  if (found != "ok")
    throw file_error(path, "is damaged (" + printable_line(found) + ")", "an unmodified file");
  sound.insert(file);
}

}  // namespace

ScenarioList ScenarioList::create(const std::string& path) {
  write(path, [](ScenarioList&) {});
  return open(path);
}

void ScenarioList::write(const std::string& path, const std::function<void(ScenarioList&)>& fill) {
  expect_replaceable(path);
  SiblingTempFile draft(path);
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->database = create_database(draft.name(), kScenarioList);
  // The draft is private, so it need not be durable before it is published.
  impl->database->exec("PRAGMA synchronous = OFF");
  impl->database->exec("PRAGMA journal_mode = MEMORY");
  impl->draft = true;
  {
    ScenarioList list(std::move(impl));
    list.in_transaction([&] { fill(list); });
  }
  publish(draft, path);
}

ScenarioList ScenarioList::open(const std::string& path) {
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->file = FileIdentity(path);
  impl->database = open_database(path, kScenarioList);
  expect_sound(*impl->database, path, impl->file);
  return ScenarioList(std::move(impl));
}

void ScenarioList::save_as(const std::string& path) {
  expect_replaceable(path);
  SiblingTempFile draft(path);
  writing(path, [&] {
    unlink(draft.name().c_str());
    bound(*impl_->database, "VACUUM INTO ?", draft.name()).exec();
    if (!has_table(*impl_->database, "deleted_scenarios")) return;
    SQLite::Database target(draft.name(), SQLite::OPEN_READWRITE);
    for (const char* table : {"deleted_scenarios", "deleted_tags", "deleted_values"})
      target.exec(std::string("DROP TABLE IF EXISTS ") + table);
    target.exec("VACUUM");
  });
  chmod(draft.name().c_str(), 0644);
  publish(draft, path);
}

void ScenarioList::expect_replaceable(const std::string& path) {
  slalom::expect_replaceable(path, kScenarioList);
}

void ScenarioList::remove_file(const std::string& path) {
  open(path);  // throws unless it is a list, and rolls back incomplete transactions
  for (const char* suffix : {"", "-journal"})
    if (unlink((path + suffix).c_str()) != 0 && errno != ENOENT)
      throw job_error(path, std::string("cannot be removed (") + std::strerror(errno) + ")");
}

void ScenarioList::Impl::expect_same_file() const {
  if (draft) return;
  const std::string change = file.change(path);
  if (!change.empty()) throw job_error(path, change, "the list to be reopened");
}

}  // namespace slalom
