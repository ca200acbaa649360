// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_list_impl.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_list.h>

#include <stdexcept>

namespace slalom {
ScenarioList::ScenarioList(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ScenarioList::~ScenarioList() = default;
ScenarioList::ScenarioList(ScenarioList&&) noexcept = default;
ScenarioList& ScenarioList::operator=(ScenarioList&&) noexcept = default;

const std::string& ScenarioList::path() const {
  return impl_->path;
}

std::vector<ScenarioList::Entry> ScenarioList::entries() const {
  return reading(impl_->path, [&] {
    std::vector<Entry> entries;
    StatementUse rows = impl_->use(
        "SELECT hash, name, representation, generator, seed, checksum FROM scenarios ORDER BY "
        "position");
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
  const std::string content = reading(impl_->path, [&] { return impl_->content(hash); });
  Scenario scenario = deserialize_scenario(content, impl_->path + ": scenario " + hash);
  if (scenario.hash() != hash)
    throw file_error(impl_->path + ": scenario " + hash, "hash does not match the content");
  return scenario;
}

ScenarioList::Entry ScenarioList::find_entry(const std::string& id_or_name) const {
  const auto found = reading(impl_->path, [&] {
    std::vector<Entry> matches;
    StatementUse exact = impl_->use(
        "SELECT hash, name, representation, generator, seed, checksum FROM scenarios "
        "WHERE hash = ?1 OR name = ?1 ORDER BY position LIMIT 1");
    exact->bind(1, id_or_name);
    if (exact->executeStep()) return std::vector<Entry>{impl_->entry_of(*exact)};
    StatementUse prefixed = impl_->use(
        "SELECT hash, name, representation, generator, seed, checksum FROM scenarios "
        "WHERE hash >= ?1 AND hash < ?1 || 'g' AND ?1 <> '' ORDER BY hash LIMIT 2");
    prefixed->bind(1, id_or_name);
    while (prefixed->executeStep()) matches.push_back(impl_->entry_of(*prefixed));
    return matches;
  });
  if (found.size() == 1) return found.front();
  if (found.size() > 1)
    throw usage_error(impl_->path, "ambiguous id '" + id_or_name + "'", "more digits");
  throw usage_error(impl_->path, "unknown scenario '" + id_or_name + "'",
                    expected_name(id_or_name, impl_->names(),
                                  "an id or a name listed by `slalom-scenarios list`"));
}

bool ScenarioList::add(const Scenario& scenario, const ScenarioOrigin& origin) {
  for (const std::string& tag : origin.tags) check_tag(tag);
  const std::string content = serialize(scenario);
  return impl_->write([&] {
    return impl_->insert({"", scenario.hash(), scenario.name(), scenario.representation(),
                          origin.generator, origin.seed, origin.tags},
                         content);
  });
}

std::vector<std::string> ScenarioList::add_all(const std::vector<Scenario>& scenarios,
                                               const std::vector<ScenarioOrigin>& origins) {
  if (!origins.empty() && origins.size() != scenarios.size())
    throw std::invalid_argument("add_all: number of origins differs from number of scenarios");
  return impl_->write([&] {
    std::vector<std::string> added;
    for (std::size_t i = 0; i < scenarios.size(); ++i)
      if (add(scenarios[i], origins.empty() ? ScenarioOrigin{} : origins[i]))
        added.push_back(scenarios[i].hash());
    return added;
  });
}

bool ScenarioList::remove(const std::string& hash) {
  return impl_->write([&] {
    {  // what is kept of an earlier deletion stays
      StatementUse row = impl_->use("SELECT 1 FROM scenarios WHERE hash = ?");
      row->bind(1, hash);
      if (!row->executeStep()) return false;
    }
    if (!impl_->draft) impl_->keep_deleted(hash, impl_->begin_deletion());
    impl_->remove(hash);
    if (!impl_->draft) impl_->limit_deleted();
    return true;
  });
}

void ScenarioList::set_note(const std::string& key, const std::string& text) {
  impl_->write([&] {
    // Keeps the row of an existing note: the bytes of a list do not depend on how often it was
    // written.
    bound(*impl_->database,
          "INSERT INTO notes VALUES (?, ?) ON CONFLICT (key) DO UPDATE SET text = excluded.text",
          key, text)
        .exec();
  });
}

std::optional<std::string> ScenarioList::note(const std::string& key) const {
  return reading(impl_->path, [&]() -> std::optional<std::string> {
    auto row = bound(*impl_->database, "SELECT text FROM notes WHERE key = ?", key);
    if (!row.executeStep()) return std::nullopt;
    return row.getColumn(0).getString();
  });
}

}  // namespace slalom
