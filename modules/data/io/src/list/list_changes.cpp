// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_list_impl.h"

#include <sqlite3.h>

namespace slalom {
namespace {

void expect_ok(int code, SQLite::Database& database) {
  if (code != SQLITE_OK) throw SQLite::Exception(database.getHandle(), code);
}

/// Records the changes to a list during its lifetime.
class Recorder {
 public:
  explicit Recorder(SQLite::Database& database) : database_(database) {
    expect_ok(sqlite3session_create(database.getHandle(), "main", &session_), database);
    expect_ok(sqlite3session_attach(session_, nullptr), database);  // every table
  }
  ~Recorder() { sqlite3session_delete(session_); }
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  std::string changes() {
    int size = 0;
    void* bytes = nullptr;
    expect_ok(sqlite3session_changeset(session_, &size, &bytes), database_);
    const std::string changes(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
    sqlite3_free(bytes);
    return changes;
  }

 private:
  SQLite::Database& database_;
  sqlite3_session* session_ = nullptr;
};

std::string inverted(const std::string& changes, SQLite::Database& database) {
  int size = 0;
  void* bytes = nullptr;
  expect_ok(
      sqlite3changeset_invert(static_cast<int>(changes.size()), changes.data(), &size, &bytes),
      database);
  const std::string inverse(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
  sqlite3_free(bytes);
  return inverse;
}

/// Aborts on conflicts with changes by other programs: the list is left unchanged.
int refuse_conflict(void* conflict, int, sqlite3_changeset_iter*) {
  *static_cast<bool*>(conflict) = true;
  return SQLITE_CHANGESET_ABORT;
}

void apply_bytes(const std::string& changes, SQLite::Database& database, const std::string& path) {
  bool conflict = false;
  std::string bytes = changes;
  const int code = sqlite3changeset_apply(database.getHandle(), static_cast<int>(bytes.size()),
                                          bytes.data(), nullptr, refuse_conflict, &conflict);
  if (conflict)
    throw job_error(path, "was changed by another program; left unchanged", "exclusive access");
  expect_ok(code, database);
}

}  // namespace

ListChange ScenarioList::record(const std::function<void()>& act) {
  return impl_->write([&] {
    Recorder recorder(*impl_->database);
    act();
    return ListChange(recorder.changes());
  });
}

void ScenarioList::apply(const ListChange& change) {
  impl_->write([&] {
    apply_bytes(change.bytes(), *impl_->database, impl_->path);
    impl_->synchronize_indexes();
  });
}

void ScenarioList::revert(const ListChange& change) {
  impl_->write([&] {
    apply_bytes(inverted(change.bytes(), *impl_->database), *impl_->database, impl_->path);
    impl_->synchronize_indexes();
  });
}

void ScenarioList::in_transaction(const std::function<void()>& act) {
  impl_->write([&] { act(); });
}

}  // namespace slalom
