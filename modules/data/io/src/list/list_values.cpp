// SPDX-License-Identifier: BSD-3-Clause
#include "checked_row.h"
#include "scenario_list_impl.h"
#include "value_columns.h"

#include <algorithm>

namespace slalom {

namespace {

std::int64_t value_checksum(const std::string& hash, const ValueKey& key, const Value& value) {
  RowChecksum checksum;
  checksum.add(hash).add(key.id).add(static_cast<std::int64_t>(key.version)).add(key.parameters);
  value.is_na() ? checksum.add(value.reason()) : checksum.add(value.number());
  if (value.standard_error()) checksum.add(*value.standard_error());
  return checksum.value();
}

}  // namespace

Value ScenarioList::Impl::value_of(SQLite::Statement& row, const std::string& hash) {
  Value value = value_from_columns(row, 0);
  const ValueKey key = {row.getColumn(4).getString(), row.getColumn(5).getInt(),
                        row.getColumn(6).getString()};
  if (value_checksum(hash, key, value) != row.getColumn(3).getInt64())
    throw file_error(path + ": " + key.id + " of scenario " + hash,
                     "is damaged (does not match its checksum)", "an unmodified file");
  return value;
}

std::optional<std::int64_t> ScenarioList::Impl::known_key(const ValueKey& key) {
  StatementUse known =
      use("SELECT key FROM descriptor_keys WHERE id = ? AND version = ? AND parameters = ?");
  known->bind(1, key.id);
  known->bind(2, key.version);
  known->bind(3, key.parameters);
  if (!known->executeStep()) return std::nullopt;
  return known->getColumn(0).getInt64();
}

std::int64_t ScenarioList::Impl::key_of(const ValueKey& key) {
  if (const auto known = known_key(key)) return *known;
  StatementUse insert =
      use("INSERT INTO descriptor_keys (id, version, parameters) VALUES (?, ?, ?)");
  insert->bind(1, key.id);
  insert->bind(2, key.version);
  insert->bind(3, key.parameters);
  insert->exec();
  return database->getLastInsertRowid();
}

ValueKey ScenarioList::Impl::key_named(std::int64_t number) {
  StatementUse row = use("SELECT id, version, parameters FROM descriptor_keys WHERE key = ?");
  row->bind(1, number);
  if (!row->executeStep()) throw file_error(path, "contains an index of an unknown descriptor");
  return {row->getColumn(0).getString(), row->getColumn(1).getInt(), row->getColumn(2).getString()};
}

std::vector<std::int64_t> ScenarioList::Impl::known_keys(const ValueKey& key) {
  if (key.parameters.find('*') == std::string::npos) {
    const auto known = known_key(key);
    return known ? std::vector<std::int64_t>{*known} : std::vector<std::int64_t>{};
  }
  std::vector<std::int64_t> numbers;
  StatementUse rows =
      use("SELECT key FROM descriptor_keys WHERE id = ? AND version = ? AND parameters GLOB ?");
  rows->bind(1, key.id);
  rows->bind(2, key.version);
  rows->bind(3, key.parameters);
  while (rows->executeStep()) numbers.push_back(rows->getColumn(0).getInt64());
  return numbers;
}

std::string ScenarioList::Impl::key_condition(const std::vector<ValueKey>& keys) {
  std::vector<std::int64_t> numbers;
  for (const ValueKey& key : keys)
    for (const std::int64_t number : known_keys(key)) numbers.push_back(number);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  std::string list;
  for (const std::int64_t number : numbers)
    list += (list.empty() ? "" : ",") + std::to_string(number);
  return "IN (" + list + ")";
}

std::optional<Value> ScenarioList::find(const std::string& scenario_hash, const ValueKey& key) {
  return reading(impl_->path, [&]() -> std::optional<Value> {
    StatementUse row = impl_->use(
        "SELECT value, standard_error, reason, checksum, id, version, parameters "
        "FROM descriptor_keys JOIN descriptor_values "
        "USING (key) WHERE hash = ? AND id = ? AND version = ? AND parameters = ?");
    row->bind(1, scenario_hash);
    row->bind(2, key.id);
    row->bind(3, key.version);
    row->bind(4, key.parameters);
    if (!row->executeStep()) return std::nullopt;
    return impl_->value_of(*row, scenario_hash);
  });
}

std::optional<Value> ScenarioList::find(const std::string& scenario_hash,
                                        const std::vector<ValueKey>& keys) {
  return reading(impl_->path, [&]() -> std::optional<Value> {
    SQLite::Statement row(
        *impl_->database,
        "SELECT value, standard_error, reason, checksum, id, version, parameters "
        "FROM descriptor_values JOIN descriptor_keys USING (key) WHERE hash = ? AND key " +
            impl_->key_condition(keys));
    row.bind(1, scenario_hash);
    if (!row.executeStep()) return std::nullopt;
    return impl_->value_of(row, scenario_hash);
  });
}

void ScenarioList::store_value(const std::string& scenario_hash, const KeyedValue& value) {
  impl_->write([&] {
    const std::int64_t key = impl_->key_of(value.key);
    StatementUse row =
        impl_->use("INSERT OR REPLACE INTO descriptor_values VALUES (?, ?, ?, ?, ?, ?)");
    row->bind(1, scenario_hash);
    row->bind(2, key);
    bind_value(*row, 3, value.value);
    row->bind(6, value_checksum(scenario_hash, value.key, value.value));
    row->exec();
  });
}

}  // namespace slalom
