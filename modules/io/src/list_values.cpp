#include "scenario_list_impl.h"
#include "value_columns.h"
#include "write_scope.h"

namespace slalom {

std::int64_t ScenarioList::Impl::key_of(const std::string& id, int version,
                                        const std::string& parameters) {
  const auto bind = [&](StatementUse& row) {
    row->bind(1, id);
    row->bind(2, version);
    row->bind(3, parameters);
  };
  StatementUse known =
      use("SELECT key FROM descriptor_keys WHERE id = ? AND version = ? AND parameters = ?");
  bind(known);
  if (known->executeStep()) return known->getColumn(0).getInt64();
  StatementUse insert =
      use("INSERT INTO descriptor_keys (id, version, parameters) VALUES (?, ?, ?)");
  bind(insert);
  insert->exec();
  return database->getLastInsertRowid();
}

std::optional<Value> ScenarioList::find(const std::string& scenario_hash, const std::string& id,
                                        int version, const std::string& parameters) {
  return reading(impl_->path, [&]() -> std::optional<Value> {
    StatementUse row = impl_->use(
        "SELECT value, standard_error, reason FROM descriptor_keys JOIN descriptor_values "
        "USING (key) WHERE hash = ? AND id = ? AND version = ? AND parameters = ?");
    row->bind(1, scenario_hash);
    row->bind(2, id);
    row->bind(3, version);
    row->bind(4, parameters);
    if (!row->executeStep()) return std::nullopt;
    return value_from_columns(*row, 0);
  });
}

void ScenarioList::keep(const std::string& scenario_hash, const std::string& id, int version,
                        const std::string& parameters, const Value& value) {
  writing(impl_->path, [&] {
    WriteScope scope(*impl_->database);
    const std::int64_t key = impl_->key_of(id, version, parameters);
    {
      StatementUse row =
          impl_->use("INSERT OR REPLACE INTO descriptor_values VALUES (?, ?, ?, ?, ?)");
      row->bind(1, scenario_hash);
      row->bind(2, key);
      bind_value(*row, 3, value);
      row->exec();
    }
    scope.commit();
  });
}

}  // namespace slalom
