#pragma once

#include "database.h"

#include <slalom/io/scenario_list.h>

#include <map>

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
  std::unique_ptr<SQLite::Database> database;
  std::map<const char*, std::unique_ptr<SQLite::Statement>> statements;

  /// The statement of a literal: prepared once.
  StatementUse use(const char* sql);

  /// From the columns hash, name, representation, generator, seed.
  Entry entry_of(SQLite::Statement& row);
  /// False when the content was there before; the tags are added then too.
  bool insert(const Entry& entry, const std::string& content);
  bool add_tag(const std::string& hash, const std::string& tag);  ///< false when it was there

  /// The number of a descriptor under given parameters; made when there is none.
  std::int64_t key_of(const std::string& id, int version, const std::string& parameters);
};

/// Throws Error (Usage) when this cannot be a tag.
void check_tag(const std::string& tag);

}  // namespace slalom
