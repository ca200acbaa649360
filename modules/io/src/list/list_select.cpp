#include "scenario_list_impl.h"
#include "selection_sql.h"

#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr int kBatchSize = 64;

SelectionSql sql_of(ScenarioList::Impl& list, const ListSelection& selection) {
  return translate_selection(selection,
                             {[&](const auto& keys) { return list.key_condition(keys); },
                              [&](const std::string& name) { return list.index(name); }});
}

}  // namespace

SelectedScenarios::SelectedScenarios(ScenarioList::Impl& list, const ListSelection& selection)
    : list_(list), table_("temp.selected_" + std::to_string(++list.selections)) {
  reading(list_.path, [&] {
    const SelectionSql sql = sql_of(list_, selection);
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
    const SelectionSql sql = sql_of(*impl_, selection);
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
