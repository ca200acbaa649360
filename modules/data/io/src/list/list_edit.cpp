// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_list_impl.h"
#include "value_columns.h"

#include <slalom/core/printable.h>

namespace slalom {

std::size_t ScenarioList::remove(const ListSelection& selection, bool restorable) {
  return impl_->write([&] {
    const std::size_t count = this->count(selection);
    const bool kept = restorable && !impl_->draft && count > 0;
    const std::int64_t deletion = kept ? impl_->begin_deletion() : 0;
    std::size_t removed = 0;
    for_each(selection, [&](const Entry& entry) {
      if (kept && removed + kMaxDeleted >= count) impl_->keep_deleted(entry.hash, deletion);
      impl_->remove(entry.hash);
      ++removed;
      return true;
    });
    if (kept) impl_->limit_deleted();
    return removed;
  });
}

std::size_t ScenarioList::tag(const ListSelection& selection, const std::vector<std::string>& add,
                              const std::vector<std::string>& remove) {
  for (const std::string& tag : add) check_tag(tag);
  return impl_->write([&] {
    std::size_t touched = 0;
    for_each(selection, [&](const Entry& entry) {
      bool changed = false;
      for (const std::string& tag : remove) {
        StatementUse row = impl_->use("DELETE FROM tags WHERE hash = ? AND tag = ?");
        row->bind(1, entry.hash);
        row->bind(2, tag);
        changed = row->exec() > 0 || changed;
      }
      for (const std::string& tag : add) changed = impl_->add_tag(entry.hash, tag) || changed;
      if (changed) impl_->update_checksum(entry.hash);
      if (changed) ++touched;
      return true;
    });
    return touched;
  });
}

void ScenarioList::replace(const std::string& hash, const Scenario& scenario) {
  const bool same_content = scenario.hash() == hash;
  const std::string content = serialize(scenario);
  impl_->write([&] {
    read(hash);  // throws if it does not exist
    impl_->expect_undamaged(hash);
    if (!same_content) change_content(hash, scenario.hash());
    StatementUse row = impl_->use(
        "UPDATE scenarios SET hash = ?, name = ?, representation = ?, content = ? WHERE hash = ?");
    row->bind(1, scenario.hash());
    row->bind(2, scenario.name());
    row->bind(3, to_string(scenario.representation()));
    row->bind(4, content.data(), static_cast<int>(content.size()));
    row->bind(5, hash);
    row->exec();
    impl_->update_checksum(scenario.hash());
  });
}

void ScenarioList::rename(const std::string& hash, const std::string& name) {
  if (name.empty() || name.find_first_of("\n\r\t") != std::string::npos || find_invalid_utf8(name))
    throw usage_error("name '" + name + "'", "invalid name", "one line of text in UTF-8");
  replace(hash, read(hash).renamed(name));
}

void ScenarioList::change_content(const std::string& hash, const std::string& next) {
  StatementUse existing = impl_->use("SELECT name FROM scenarios WHERE hash = ?");
  existing->bind(1, next);
  if (existing->executeStep())
    throw usage_error(
        impl_->path,
        "the list already contains this scenario as '" + existing->getColumn(0).getString() + "'",
        "a different content");
  for (const char* sql : {"DELETE FROM descriptor_values WHERE hash = ?",
                          "UPDATE scenarios SET generator = NULL, seed = NULL WHERE hash = ?"}) {
    StatementUse row = impl_->use(sql);
    row->bind(1, hash);
    row->exec();
  }
  StatementUse tags = impl_->use("UPDATE tags SET hash = ? WHERE hash = ?");
  tags->bind(1, next);
  tags->bind(2, hash);
  tags->exec();
}

bool ScenarioList::copy_from(ScenarioList& source, const Entry& entry) {
  const std::string content =
      reading(source.path(), [&] { return source.impl_->content(entry.hash); });
  return impl_->write([&] {
    const bool added = impl_->insert(entry, content);
    StatementUse values = source.impl_->use(
        "SELECT id, version, parameters, value, standard_error, reason, checksum "
        "FROM descriptor_values "
        "JOIN descriptor_keys USING (key) WHERE hash = ?");
    values->bind(1, entry.hash);
    while (values->executeStep()) {
      StatementUse row =
          impl_->use("INSERT OR IGNORE INTO descriptor_values VALUES (?, ?, ?, ?, ?, ?)");
      row->bind(1, entry.hash);
      row->bind(2, impl_->key_of({values->getColumn(0).getString(), values->getColumn(1).getInt(),
                                  values->getColumn(2).getString()}));
      bind_value(*row, 3, value_from_columns(*values, 3));
      row->bind(6, values->getColumn(6).getInt64());
      row->exec();
    }
    return added;
  });
}

}  // namespace slalom
