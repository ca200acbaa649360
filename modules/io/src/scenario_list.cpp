#include "list_schema.h"
#include "scenario_list_impl.h"
#include "write_scope.h"

#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/io/scenario_list.h>

#include <stdexcept>

namespace slalom {
ScenarioList::ScenarioList(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ScenarioList::~ScenarioList() = default;
ScenarioList::ScenarioList(ScenarioList&&) noexcept = default;
ScenarioList& ScenarioList::operator=(ScenarioList&&) noexcept = default;

ScenarioList ScenarioList::create(const std::string& path) {
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->database = create_database(path, kScenarioList);
  return ScenarioList(std::move(impl));
}

ScenarioList ScenarioList::open(const std::string& path) {
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->database = open_database(path, kScenarioList);
  refuse_foreign_schema(*impl->database, path);
  upgrade_list(*impl->database, path);
  return ScenarioList(std::move(impl));
}

std::vector<ScenarioList::Entry> ScenarioList::entries() const {
  return reading(impl_->path, [&] {
    std::vector<Entry> entries;
    StatementUse rows = impl_->use(
        "SELECT hash, name, representation, generator, seed FROM scenarios ORDER BY position");
    while (rows->executeStep()) entries.push_back(impl_->entry_of(*rows));
    return entries;
  });
}

std::size_t ScenarioList::size() const {
  return reading(impl_->path, [&] {
    return static_cast<std::size_t>(
        impl_->database->execAndGet("SELECT COUNT(*) FROM scenarios").getInt64());
  });
}

Scenario ScenarioList::read(const std::string& hash) const {
  const std::string content = reading(impl_->path, [&] {
    SQLite::Statement row(*impl_->database, "SELECT content FROM scenarios WHERE hash = ?");
    row.bind(1, hash);
    if (!row.executeStep()) throw file_error(impl_->path, "has no scenario " + hash);
    return row.getColumn(0).getString();
  });
  Scenario scenario = deserialize_scenario(content, impl_->path + ": scenario " + hash);
  if (scenario.hash() != hash)
    throw file_error(impl_->path + ": scenario " + hash, "its content has another hash");
  return scenario;
}

ScenarioList::Entry ScenarioList::find_entry(const std::string& id_or_name) const {
  const std::vector<Entry> all = entries();
  std::vector<std::string> known;
  const Entry* by_prefix = nullptr;
  int prefixed = 0;
  for (const Entry& entry : all) {
    if (entry.hash == id_or_name || entry.name == id_or_name) return entry;
    if (!id_or_name.empty() && entry.hash.compare(0, id_or_name.size(), id_or_name) == 0) {
      by_prefix = &entry;
      ++prefixed;
    }
    known.push_back(entry.name);
  }
  if (prefixed == 1) return *by_prefix;
  if (prefixed > 1)
    throw usage_error(impl_->path, "'" + id_or_name + "' begins several ids", "more of its digits");
  const std::string nearest = nearest_name(id_or_name, known);
  throw usage_error(
      impl_->path, "no scenario '" + id_or_name + "'",
      nearest.empty() ? "an id or a name that `slalom-scenarios list` shows" : "'" + nearest + "'");
}

bool ScenarioList::add(const Scenario& scenario, const ScenarioOrigin& origin) {
  for (const std::string& tag : origin.tags) check_tag(tag);
  const std::string content = serialize(scenario);
  return writing(impl_->path, [&] {
    WriteScope scope(*impl_->database);
    const bool added =
        impl_->insert({"", scenario.hash(), scenario.name(), scenario.representation(),
                       origin.generator, origin.seed, origin.tags},
                      content);
    scope.commit();
    return added;
  });
}

std::vector<std::string> ScenarioList::add_all(const std::vector<Scenario>& scenarios,
                                               const std::vector<ScenarioOrigin>& origins) {
  if (!origins.empty() && origins.size() != scenarios.size())
    throw std::invalid_argument("add_all: origins for some scenarios only");
  return writing(impl_->path, [&] {
    std::vector<std::string> added;
    WriteScope scope(*impl_->database);
    for (std::size_t i = 0; i < scenarios.size(); ++i)
      if (add(scenarios[i], origins.empty() ? ScenarioOrigin{} : origins[i]))
        added.push_back(scenarios[i].hash());
    scope.commit();
    return added;
  });
}

bool ScenarioList::remove(const std::string& hash) {
  return writing(impl_->path, [&] {
    WriteScope scope(*impl_->database);
    bool removed = false;
    for (const char* sql :
         {"DELETE FROM tags WHERE hash = ?", "DELETE FROM descriptor_values WHERE hash = ?",
          "DELETE FROM scenarios WHERE hash = ?"}) {
      StatementUse row = impl_->use(sql);
      row->bind(1, hash);
      removed = row->exec() > 0;
    }
    scope.commit();
    return removed;
  });
}

void ScenarioList::set_note(const std::string& key, const std::string& text) {
  writing(impl_->path, [&] {
    SQLite::Statement row(*impl_->database, "INSERT OR REPLACE INTO notes VALUES (?, ?)");
    row.bind(1, key);
    row.bind(2, text);
    row.exec();
  });
}

std::optional<std::string> ScenarioList::note(const std::string& key) const {
  return reading(impl_->path, [&]() -> std::optional<std::string> {
    SQLite::Statement row(*impl_->database, "SELECT text FROM notes WHERE key = ?");
    row.bind(1, key);
    if (!row.executeStep()) return std::nullopt;
    return row.getColumn(0).getString();
  });
}

}  // namespace slalom
