#include "database.h"
#include "value_columns.h"

#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/io/scenario_list.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr DatabaseKind kScenarioList = {"a scenario list (.scenarios)", 0x534c534c /* "SLSL" */, 1,
                                        R"(
CREATE TABLE scenarios (position INTEGER PRIMARY KEY, hash TEXT NOT NULL UNIQUE, name TEXT NOT NULL,
                        representation TEXT NOT NULL, content BLOB NOT NULL);
CREATE TABLE descriptors (hash TEXT NOT NULL, id TEXT NOT NULL, version INTEGER NOT NULL,
                          parameters TEXT NOT NULL, value REAL, standard_error REAL, reason TEXT,
                          PRIMARY KEY (hash, id, version, parameters)) WITHOUT ROWID;
CREATE TABLE notes (key TEXT PRIMARY KEY, text TEXT NOT NULL);
)"};

constexpr std::size_t kIdDigits = 12;

}  // namespace

struct ScenarioList::Impl {
  std::string path;
  std::unique_ptr<SQLite::Database> database;
};

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
  return ScenarioList(std::move(impl));
}

std::vector<ScenarioList::Entry> ScenarioList::entries() const {
  return reading(impl_->path, [&] {
    std::vector<Entry> entries;
    SQLite::Statement rows(*impl_->database,
                           "SELECT hash, name, representation FROM scenarios ORDER BY position");
    while (rows.executeStep()) {
      const std::string hash = rows.getColumn(0).getString();
      entries.push_back({hash.substr(0, kIdDigits), hash, rows.getColumn(1).getString(),
                         representation_from_string(rows.getColumn(2).getString())});
    }
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

bool ScenarioList::add(const Scenario& scenario) {
  return writing(impl_->path, [&] {
    SQLite::Statement insert(
        *impl_->database,
        "INSERT OR IGNORE INTO scenarios (hash, name, representation, content) "
        "VALUES (?, ?, ?, ?)");
    insert.bind(1, scenario.hash());
    insert.bind(2, scenario.name());
    insert.bind(3, to_string(scenario.representation()));
    const std::string content = serialize(scenario);
    insert.bind(4, content.data(), static_cast<int>(content.size()));
    return insert.exec() > 0;
  });
}

std::vector<std::string> ScenarioList::add_all(const std::vector<Scenario>& scenarios) {
  return writing(impl_->path, [&] {
    std::vector<std::string> added;
    SQLite::Transaction transaction(*impl_->database);
    for (const Scenario& scenario : scenarios)
      if (add(scenario)) added.push_back(scenario.hash());
    transaction.commit();
    return added;
  });
}

bool ScenarioList::remove(const std::string& hash) {
  return writing(impl_->path, [&] {
    SQLite::Statement row(*impl_->database, "DELETE FROM scenarios WHERE hash = ?");
    row.bind(1, hash);
    return row.exec() > 0;
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

std::optional<Value> ScenarioList::find(const std::string& scenario_hash, const std::string& id,
                                        int version, const std::string& parameters) {
  return reading(impl_->path, [&]() -> std::optional<Value> {
    SQLite::Statement row(*impl_->database,
                          "SELECT value, standard_error, reason FROM descriptors "
                          "WHERE hash = ? AND id = ? AND version = ? AND parameters = ?");
    row.bind(1, scenario_hash);
    row.bind(2, id);
    row.bind(3, version);
    row.bind(4, parameters);
    if (!row.executeStep()) return std::nullopt;
    return value_from_columns(row, 0);
  });
}

void ScenarioList::keep(const std::string& scenario_hash, const std::string& id, int version,
                        const std::string& parameters, const Value& value) {
  writing(impl_->path, [&] {
    SQLite::Statement row(*impl_->database,
                          "INSERT OR REPLACE INTO descriptors VALUES (?, ?, ?, ?, ?, ?, ?)");
    row.bind(1, scenario_hash);
    row.bind(2, id);
    row.bind(3, version);
    row.bind(4, parameters);
    bind_value(row, 5, value);
    row.exec();
  });
}

}  // namespace slalom
