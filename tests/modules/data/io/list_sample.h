// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io_sample.h"

#include <slalom/core/text.h>
#include <slalom/io/scenario_list.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include <map>
#include <string>

namespace slalom {

/// The complete content of a list's file as text, to compare lists.
inline std::string dump_list(const std::string& path) {
  SQLite::Database database(path);
  std::string dump;
  std::vector<std::string> tables = {"scenarios", "tags",  "descriptor_keys", "descriptor_values",
                                     "indexes",   "notes", "sqlite_master"};
  for (const char* deleted : {"deleted_scenarios", "deleted_tags", "deleted_values"})
    if (database.tableExists(deleted)) tables.push_back(deleted);
  for (const std::string& table : tables) {
    // The first deletion creates tables, which stay when it is undone.
    SQLite::Statement rows(
        database,
        "SELECT * FROM " + table +
            (table == "sqlite_master" ? " WHERE tbl_name NOT LIKE 'deleted%' ORDER BY type, name"
                                      : " ORDER BY 1, 2"));
    if (table.rfind("deleted", 0) != 0) dump += table + "\n";
    while (rows.executeStep()) {
      for (int i = 0; i < rows.getColumnCount(); ++i) {
        // The page numbers of tables are not content.
        if (std::string(rows.getColumn(i).getName()) == "rootpage") continue;
        dump += (rows.getColumn(i).isNull() ? "NULL" : rows.getColumn(i).getString()) + "|";
      }
      dump += "\n";
    }
  }
  return dump;
}

/// The keys of descriptors in these tests: grids have no resolution among their parameters.
inline DescriptorView sample_view() {
  DescriptorView view;
  for (const std::string id : {"density", "clearness", "confinement"})
    view[id] = {{id, 1, ""}, {id, 1, "resolution=0.05"}};
  return view;
}

/// The expected properties of a scenario of sample_list().
struct SampleRow {
  std::string hash, name, generator;
  std::vector<std::string> tags;
  std::map<std::string, std::optional<double>> values;  ///< none for NA
};

/// A list of `count` scenarios with random values, origins and tags; `rows` receives its content.
inline ScenarioList sample_list(const std::string& path, int count, std::uint64_t seed,
                                std::vector<SampleRow>& rows) {
  RandomEngine engine(seed);
  const std::string generators[] = {"", "maze", "forest"};
  const std::string tags[] = {"narrow", "hard", "Hard"};
  ScenarioList list = ScenarioList::create(path);
  list.in_transaction([&] {
    for (int i = 0; i < count; ++i) {
      const Scenario scenario = sample_scenario(seed * 1000000 + static_cast<std::uint64_t>(i),
                                                "room_" + std::to_string(i));
      SampleRow row{
          scenario.hash(), scenario.name(), generators[uniform_int(engine, 0, 2)], {}, {}};
      for (const std::string& tag : tags)
        if (uniform_int(engine, 0, 3) == 0) row.tags.push_back(tag);
      list.add(scenario, {row.generator, static_cast<std::uint64_t>(i), row.tags});
      for (const auto& [id, keys] : sample_view()) {
        const int kind = uniform_int(engine, 0, 9);  // 0: never computed, 1: NA
        // Rounded values, so that some comparisons for equality are true.
        const double value = uniform_int(engine, 0, 20) / 20.0;
        row.values[id] = kind < 2 ? std::nullopt : std::make_optional(value);
        const ValueKey& key = keys[static_cast<std::size_t>(uniform_int(engine, 0, 1))];
        if (kind > 0)
          list.store_value(row.hash, {key, kind == 1 ? Value::na("a reason") : Value::of(value)});
      }
      rows.push_back(row);
    }
  });
  return list;
}

}  // namespace slalom
