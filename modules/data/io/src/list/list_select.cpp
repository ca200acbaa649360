// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_list_impl.h"
#include "selection_sql.h"

#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr int kBatchSize = 64;

/// The fields of a selection that are not in the list, as temporary tables.
class FieldTables {
 public:
  FieldTables(ScenarioList::Impl& list, const ListSelection& selection) : list_(list) {
    for (const auto& [name, field] : selection.fields) create(name, *field);
  }
  ~FieldTables() {
    for (const auto& [field, table] : tables_)
      list_.database->tryExec("DROP TABLE IF EXISTS " + table);
  }
  FieldTables(const FieldTables&) = delete;
  FieldTables& operator=(const FieldTables&) = delete;
  std::string of(const std::string& field) const { return tables_.at(field); }

 private:
  void create(const std::string& name, const ListField& field) {
    const std::string table = "temp.field_" + std::to_string(tables_.size());
    tables_[name] = table;
    list_.database->exec("CREATE TABLE " + table +
                         " (hash TEXT, value, PRIMARY KEY (hash, value)) WITHOUT ROWID");
    SQLite::Statement insert(*list_.database, "INSERT INTO " + table + " VALUES (?, ?)");
    const auto add = [&](const std::string& hash, const auto& value) {
      insert.reset();
      insert.bind(1, hash);
      insert.bind(2, value);
      insert.exec();
    };
    for (const auto& [hash, value] : field.numbers)
      if (!value.is_na()) add(hash, value.number());
    for (const auto& [hash, texts] : field.texts)
      for (const std::string& text : texts) add(hash, text);
  }

  ScenarioList::Impl& list_;
  std::map<std::string, std::string> tables_;  ///< by field
};

SelectionSql sql_of(ScenarioList::Impl& list, const ListSelection& selection,
                    const FieldTables& fields) {
  return translate_selection(selection,
                             {[&](const auto& keys) { return list.key_condition(keys); },
                              [&](const std::string& name) { return list.index(name); },
                              [&](const std::string& field) { return fields.of(field); }});
}

}  // namespace

SelectedScenarios::SelectedScenarios(ScenarioList::Impl& list, const ListSelection& selection)
    : list_(list), table_("temp.selected_" + std::to_string(++list.selections)) {
  reading(list_.path, [&] {
    const FieldTables fields(list_, selection);
    const SelectionSql sql = sql_of(list_, selection, fields);
    list_.database->exec("CREATE TABLE " + table_ +
                         " (rank INTEGER PRIMARY KEY, hash TEXT NOT NULL UNIQUE)");
    SQLite::Statement insert(*list_.database,
                             "INSERT OR IGNORE INTO " + table_ + " (hash) " + sql.text);
    sql.bind(insert);
    insert.exec();
  });
}

SelectedScenarios::~SelectedScenarios() {
  list_.database->tryExec("DROP TABLE IF EXISTS " + table_);
}

std::size_t SelectedScenarios::size() const {
  return reading(list_.path, [&] {
    return static_cast<std::size_t>(
        list_.database->execAndGet("SELECT COUNT(*) FROM " + table_).getInt64());
  });
}

std::vector<ScenarioList::Entry> SelectedScenarios::next() {
  return reading(list_.path, [&] {
    std::vector<ScenarioList::Entry> entries;
    SQLite::Statement rows(
        *list_.database,
        "SELECT hash, name, representation, generator, seed, checksum, rank FROM " + table_ +
            " JOIN scenarios USING (hash) WHERE rank > ? ORDER BY rank LIMIT ?");
    rows.bind(1, rank_);
    rows.bind(2, kBatchSize);
    while (rows.executeStep()) {
      entries.push_back(list_.entry_of(rows));
      rank_ = rows.getColumn(6).getInt64();
    }
    return entries;
  });
}

SelectionVocabulary ScenarioList::vocabulary(std::vector<std::string> numbers) const {
  SelectionVocabulary vocabulary{
      std::move(numbers), {"name", "id", "tag", "generator", "representation"}, {}};
  for (const ListIndex& index : indexes()) vocabulary.indexes[index.name] = index.ranges();
  for (const Descriptor& descriptor : all_descriptors())
    if (contains(vocabulary.numbers, descriptor.info.id))
      name_field(vocabulary, descriptor.info.name, descriptor.info.id);
  return vocabulary;
}

void ScenarioList::for_each(const ListSelection& selection,
                            const std::function<bool(const Entry&)>& visit) const {
  SelectedScenarios selected(*impl_, selection);
  for (auto entries = selected.next(); !entries.empty(); entries = selected.next())
    for (const Entry& entry : entries)
      if (!visit(entry)) return;
}

std::vector<ScenarioList::Entry> ScenarioList::select(const ListSelection& selection) const {
  std::vector<Entry> entries;
  for_each(selection, [&](const Entry& entry) {
    entries.push_back(entry);
    return true;
  });
  return entries;
}

std::size_t ScenarioList::count(const ListSelection& selection) const {
  return SelectedScenarios(*impl_, selection).size();
}

std::string ScenarioList::query_plan(const ListSelection& selection) const {
  return reading(impl_->path, [&] {
    const FieldTables fields(*impl_, selection);
    const SelectionSql sql = sql_of(*impl_, selection, fields);
    SQLite::Statement rows(*impl_->database, "EXPLAIN QUERY PLAN " + sql.text);
    sql.bind(rows);
    std::string plan;
    while (rows.executeStep()) plan += rows.getColumn(3).getString() + "\n";
    return plan;
  });
}

std::vector<std::string> ScenarioList::missing_values(const std::vector<ValueKey>& keys) const {
  return reading(impl_->path, [&] {
    std::vector<std::string> hashes;
    SQLite::Statement rows(*impl_->database,
                           "SELECT hash FROM scenarios s WHERE NOT EXISTS (SELECT 1 FROM "
                           "descriptor_values d WHERE d.hash = s.hash AND d.key " +
                               impl_->key_condition(keys) + ") ORDER BY position");
    while (rows.executeStep()) hashes.push_back(rows.getColumn(0).getString());
    return hashes;
  });
}

}  // namespace slalom
