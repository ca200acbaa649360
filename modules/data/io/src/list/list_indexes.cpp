// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_list_impl.h"

#include <slalom/core/text.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace slalom {
namespace {

constexpr std::size_t kMaxNameLength = 64;
constexpr std::size_t kMaxEdges = 10000;

bool is_identifier(const std::string& name) {
  return !name.empty() && name.size() <= kMaxNameLength &&
         std::isdigit(static_cast<unsigned char>(name[0])) == 0 &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return c == '_' || (static_cast<unsigned char>(c) < 0x80 &&
                               std::isalnum(static_cast<unsigned char>(c)) != 0);
         });
}

std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : split(text, ',')) {
    double number = 0;
    if (!parse_number(part, number)) return {};
    numbers.push_back(number);
  }
  return numbers;
}

bool are_edges(const std::vector<double>& edges) {
  return edges.size() >= 2 && edges.size() <= kMaxEdges &&
         std::adjacent_find(edges.begin(), edges.end(),
                            [](double a, double b) { return !(a < b); }) == edges.end();
}

std::string text_of(const std::vector<double>& numbers) {
  std::vector<std::string> parts;
  for (const double number : numbers) parts.push_back(format_number(number));
  return join(parts, ",");
}

std::string sql_name(const std::string& index) {
  return "index_" + index;
}

}  // namespace

std::vector<ListIndex> ScenarioList::Impl::indexes() {
  return reading(path, [&] {
    std::vector<ListIndex> indexes;
    SQLite::Statement rows(*database,
                           "SELECT name, descriptor, keys, edges FROM indexes ORDER BY name");
    while (rows.executeStep()) {
      ListIndex index{rows.getColumn(0).getString(),
                      rows.getColumn(1).getString(),
                      {},
                      numbers_of(rows.getColumn(3).getString())};
      for (const double key : numbers_of(rows.getColumn(2).getString()))
        index.keys.push_back(key_named(static_cast<std::int64_t>(key)));
      if (!is_identifier(index.name) || !are_edges(index.edges) || index.keys.empty())
        throw file_error(path, "contains an invalid index '" + index.name + "'");
      indexes.push_back(std::move(index));
    }
    return indexes;
  });
}

ListIndex ScenarioList::Impl::index(const std::string& name) {
  std::vector<std::string> known;
  for (const ListIndex& index : indexes()) {
    if (index.name == name) return index;
    known.push_back(index.name);
  }
  throw usage_error(path, "unknown index '" + name + "'",
                    expected_name(name, known, known.empty() ? "an index; the list has none" : ""));
}

std::vector<ListIndex> ScenarioList::indexes() const {
  return impl_->indexes();
}

ListIndex ScenarioList::index(const std::string& name) const {
  return impl_->index(name);
}

void ScenarioList::create_index(const ListIndex& index) {
  if (!is_identifier(index.name))
    throw usage_error("index '" + index.name + "'", "invalid index name",
                      "at most 64 letters, digits and _, not starting with a digit");
  if (!are_edges(index.edges))
    throw usage_error("index '" + index.name + "'", "invalid edges",
                      "two or more increasing edges");
  for (const ListIndex& other : indexes())
    if (lower_case(other.name) == lower_case(index.name))
      throw usage_error(impl_->path, "index '" + other.name + "' already exists",
                        "another name, or `index drop` first");
  impl_->write([&] {
    std::vector<std::string> keys;
    for (const ValueKey& key : index.keys) keys.push_back(std::to_string(impl_->key_of(key)));
    bound(*impl_->database, "INSERT INTO indexes VALUES (?, ?, ?, ?)", index.name, index.descriptor,
          join(keys, ","), text_of(index.edges))
        .exec();
    impl_->synchronize_indexes();
  });
}

void ScenarioList::drop_index(const std::string& name) {
  index(name);
  impl_->write([&] {
    bound(*impl_->database, "DELETE FROM indexes WHERE name = ?", name).exec();
    impl_->synchronize_indexes();
  });
}

void ScenarioList::Impl::synchronize_indexes() {
  std::set<std::string> existing;
  SQLite::Statement rows(*database,
                         "SELECT name FROM sqlite_master WHERE type = 'index' AND name GLOB "
                         "'index_*'");
  while (rows.executeStep()) existing.insert(rows.getColumn(0).getString());
  rows.reset();
  for (const ListIndex& index : indexes()) {
    if (existing.erase(sql_name(index.name)) > 0) continue;
    database->exec("CREATE INDEX \"" + sql_name(index.name) +
                   "\" ON descriptor_values (value, hash) WHERE key " + key_condition(index.keys));
  }
  for (const std::string& name : existing) database->exec("DROP INDEX \"" + name + "\"");
}

ListIndexCounts ScenarioList::index_counts(const std::string& name) const {
  const ListIndex selected = index(name);
  ListIndexCounts counts;
  counts.ranges.resize(selected.ranges());
  std::size_t described = 0;
  reading(impl_->path, [&] {
    SQLite::Statement rows(*impl_->database,
                           "SELECT value FROM descriptor_values JOIN scenarios USING (hash) "
                           "WHERE key " +
                               impl_->key_condition(selected.keys));
    for (; rows.executeStep(); ++described) {
      if (rows.getColumn(0).isNull()) {
        ++counts.na;
        continue;
      }
      const double value = rows.getColumn(0).getDouble();
      const auto& edges = selected.edges;
      if (value < edges.front())
        ++counts.below;
      else if (value > edges.back())
        ++counts.above;
      else {
        const auto above = std::upper_bound(edges.begin(), edges.end(), value);
        ++counts.ranges[std::min<std::size_t>(static_cast<std::size_t>(above - edges.begin()),
                                              edges.size() - 1) -
                        1];
      }
    }
  });
  counts.unknown = size() - std::min(size(), described);
  return counts;
}

}  // namespace slalom
