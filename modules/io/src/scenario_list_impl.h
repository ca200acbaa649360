#pragma once

#include "database.h"
#include "write_scope.h"

#include <slalom/core/error.h>
#include <slalom/io/scenario_list.h>

#include <map>
#include <sys/stat.h>

namespace slalom {

/// A prepared statement in use; reset afterwards, so that no lock outlives it.
class StatementUse {
 public:
  explicit StatementUse(SQLite::Statement& statement) : statement_(statement) {}
  ~StatementUse() {
    statement_.tryReset();
    statement_.clearBindings();
  }
  StatementUse(const StatementUse&) = delete;
  StatementUse& operator=(const StatementUse&) = delete;
  SQLite::Statement* operator->() { return &statement_; }
  SQLite::Statement& operator*() { return statement_; }

 private:
  SQLite::Statement& statement_;
};

/// An open list. The files scenario_list.cpp and list_*.cpp share it.
struct ScenarioList::Impl {
  std::string path;
  struct stat file = {};  ///< what was at `path` when it was opened
  bool draft = false;     ///< not yet at the path
  std::unique_ptr<SQLite::Database> database;
  std::map<const char*, std::unique_ptr<SQLite::Statement>> statements;
  unsigned long selections = 0;  ///< made so far; names their tables

  /// The statement of a literal: prepared once.
  StatementUse use(const char* sql);

  /// From the columns hash, name, representation, generator, seed.
  Entry entry_of(SQLite::Statement& row);
  /// False when the content was there before; the tags are added then too.
  bool insert(const Entry& entry, const std::string& content);
  bool add_tag(const std::string& hash, const std::string& tag);  ///< false when it was there
  bool remove(const std::string& hash);                           ///< false when it was not there
  std::string content(const std::string& hash);
  std::vector<std::string> names();

  /// The number of a descriptor under given parameters; made when there is none.
  std::int64_t key_of(const DescriptorKey& key);
  std::optional<std::int64_t> known_key(const DescriptorKey& key);
  /// Where the parameters are a pattern, all that match.
  std::vector<std::int64_t> known_keys(const DescriptorKey& key);
  DescriptorKey key_named(std::int64_t number);
  /// "IN (7,8)", the numbers in increasing order.
  std::string key_condition(const std::vector<DescriptorKey>& keys);

  std::vector<ListIndex> indexes();
  ListIndex index(const std::string& name);
  /// Makes the SQLite indexes those that the table of indexes tells.
  void match_indexes();

  /// Throws Error (Job) when another program has put another file at the path.
  void expect_same_file() const;

  /// Runs `act` as one change: all of it or nothing.
  template <typename Act>
  auto write(Act act) -> decltype(act());
};

/// What of a list was chosen, kept in a temporary table: scenarios are read from there one by one,
/// and the list may be changed meanwhile.
class ChosenScenarios {
 public:
  ChosenScenarios(ScenarioList::Impl& list, const ListSelection& selection);
  ~ChosenScenarios();
  ChosenScenarios(const ChosenScenarios&) = delete;
  ChosenScenarios& operator=(const ChosenScenarios&) = delete;

  std::size_t size() const;
  /// The next ones, some at a time; none at the end. Scenarios that are gone are left out.
  std::vector<ScenarioList::Entry> next();

 private:
  ScenarioList::Impl& list_;
  std::string table_;
  std::int64_t rank_ = 0;
};

/// Throws Error (Usage) when this cannot be a tag.
void check_tag(const std::string& tag);

template <typename Act>
auto ScenarioList::Impl::write(Act act) -> decltype(act()) {
  return writing(path, [&] {
    WriteScope scope(*database);
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
