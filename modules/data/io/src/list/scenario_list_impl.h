// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "database.h"
#include "transaction.h"

#include <slalom/core/error.h>
#include <slalom/io/scenario_list.h>

#include <map>

namespace slalom {

/// The implementation of an open list, used by scenario_list.cpp and list_*.cpp.
struct ScenarioList::Impl {
  std::string path;
  FileIdentity file;   ///< the file at `path` when it was opened
  bool draft = false;  ///< not yet published
  std::unique_ptr<SQLite::Database> database;
  std::map<const char*, std::unique_ptr<SQLite::Statement>> statements;
  unsigned long selections = 0;  ///< counter for the names of temporary tables

  /// The prepared statement of a string literal, cached by its address.
  StatementUse use(const char* sql);

  /// From the columns hash, name, representation, generator, seed, checksum. Throws Error (File) if
  /// they or the tags are damaged.
  Entry entry_of(SQLite::Statement& row, const char* tags_sql = kTagsOf);
  std::vector<std::string> tags_of(const std::string& hash,
                                   const char* tags_sql = kTagsOf);  ///< in their order
  static constexpr const char* kTagsOf = "SELECT tag FROM tags WHERE hash = ? ORDER BY tag";
  /// Throws Error (File) if the row or the tags of a scenario are damaged. Before
  /// update_checksum(), which would make damage valid.
  void expect_undamaged(const std::string& hash);
  void update_checksum(const std::string& hash);  ///< after a change of the row or the tags
  /// Returns false if the content already exists; tags are added in any case.
  bool insert(const Entry& entry, const std::string& content);
  /// Returns false if it already exists. The caller updates the checksum.
  bool add_tag(const std::string& hash, const std::string& tag);
  bool remove(const std::string& hash);  ///< false if it does not exist

  std::int64_t begin_deletion();  ///< returns its number
  /// Keeps a scenario that is about to be removed, for restore().
  void keep_deleted(const std::string& hash, std::int64_t deletion);
  void forget_deleted(const std::string& hash);
  void limit_deleted();  ///< forgets the oldest
  /// Returns false if it is not kept, or in the list again. Throws Error (File) if it is damaged.
  bool restore(const std::string& hash);

  std::string content(const std::string& hash);
  std::vector<std::string> names();

  /// From the columns value, standard_error, reason, checksum, id, version, parameters. Throws
  /// Error (File) if they are damaged.
  Value value_of(SQLite::Statement& row, const std::string& hash);

  /// The number of a descriptor key; created if it does not exist.
  std::int64_t key_of(const ValueKey& key);
  std::optional<std::int64_t> known_key(const ValueKey& key);
  /// All matching keys if the parameters are a pattern.
  std::vector<std::int64_t> known_keys(const ValueKey& key);
  ValueKey key_named(std::int64_t number);
  /// "IN (7,8)" with the key numbers in increasing order.
  std::string key_condition(const std::vector<ValueKey>& keys);

  std::vector<ListIndex> indexes();
  ListIndex index(const std::string& name);
  /// Creates and drops SQLite indexes according to the table of indexes.
  void synchronize_indexes();

  /// Throws Error (Job) when another program has removed or replaced the file.
  void expect_same_file() const;

  /// Runs `act` in a transaction.
  template <typename Act>
  auto write(Act act) -> decltype(act());
};

/// The result of a selection in a temporary table. Its scenarios are read in batches, and the list
/// may be changed meanwhile.
class SelectedScenarios {
 public:
  SelectedScenarios(ScenarioList::Impl& list, const ListSelection& selection);
  ~SelectedScenarios();
  SelectedScenarios(const SelectedScenarios&) = delete;
  SelectedScenarios& operator=(const SelectedScenarios&) = delete;

  std::size_t size() const;
  /// The next batch; empty at the end. Removed scenarios are skipped.
  std::vector<ScenarioList::Entry> next();

 private:
  ScenarioList::Impl& list_;
  std::string table_;
  std::int64_t rank_ = 0;
};

/// Throws Error (Usage) for an invalid tag.
void check_tag(const std::string& tag);

template <typename Act>
auto ScenarioList::Impl::write(Act act) -> decltype(act()) {
  return writing(path, [&] {
    Transaction scope(*database);
    expect_same_file();
    if constexpr (std::is_void_v<decltype(act())>) {
      act();
      scope.commit();
    } else {
      auto result = act();
      scope.commit();
      return result;
    }
  });
}

}  // namespace slalom
