// SPDX-License-Identifier: BSD-3-Clause
#include "foreign_table.h"

#include <slalom/analysis/table_export.h>
#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace slalom {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMaxDepth = 50;  // what is deeper is left out

/// A number, 1 or 0, or the length of a list; empty for anything else.
std::string value_text(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  if (value.is_number()) return format_number(value.get<double>());
  return value.is_array() ? std::to_string(value.size()) : "";
}

bool is_true(const Json& stats, const char* key) {
  const auto found = stats.find(key);
  return found != stats.end() && found->is_boolean() && found->get<bool>();
}

std::string outcome_of(const Json& stats) {
  if (!is_true(stats, "path_found")) return "failure";
  if (is_true(stats, "path_collides")) return "collision";
  return is_true(stats, "exact_goal_path") ? "success" : "failure";
}

std::string environment_of(const Json& run) {
  const auto environment = run.find("environment");
  if (environment == run.end() || !environment->is_object()) return "environment";
  const auto name = environment->find("name");
  return name != environment->end() && name->is_string() ? name->get<std::string>() : "environment";
}

/// Calls use(environment, planner, stats) for each plan; one without stats has none of them.
template <typename Use>
void for_each_plan(const Json& runs, Use use) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Json& run = runs[i];
    const std::string environment = environment_of(run) + " " + std::to_string(i);
    const auto plans = run.find("plans");
    if (plans == run.end() || !plans->is_object()) continue;
    for (const auto& [planner, plan] : plans->items()) {
      const bool has_stats =
          plan.is_object() && plan.contains("stats") && plan["stats"].is_object();
      use(environment, planner, has_stats ? plan["stats"] : Json::object());
    }
  }
}

bool is_bench_mr(const Json& file) {
  const auto runs = file.find("runs");
  return file.is_object() && runs != file.end() && runs->is_array() && !runs->empty() &&
         std::all_of(runs->begin(), runs->end(), [](const Json& run) { return run.is_object(); }) &&
         runs->front().contains("plans");
}

ForeignTable bench_mr_table(const Json& file) {
  std::vector<std::string> keys;
  for_each_plan(file["runs"], [&](const std::string&, const std::string&, const Json& stats) {
    for (const auto& [key, value] : stats.items())
      if (!value.is_string() && !value.is_object() && !contains(keys, key)) keys.push_back(key);
  });
  std::vector<std::string> names = {"scenario", "method", "outcome"};
  names.insert(names.end(), keys.begin(), keys.end());
  std::string csv = csv_line(names);
  for_each_plan(file["runs"],
                [&](const std::string& environment, const std::string& planner, const Json& stats) {
                  std::vector<std::string> fields = {environment, planner, outcome_of(stats)};
                  for (const std::string& key : keys)
                    fields.push_back(stats.contains(key) ? value_text(stats[key]) : "");
                  csv += csv_line(fields);
                });
  return {csv};
}

/// The text with null for what Python writes and JSON does not have: NaN, Infinity, -Infinity.
std::string without_nan(const std::string& text) {
  using namespace std::string_view_literals;
  std::string result;
  result.reserve(text.size());
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') quoted = !quoted;
    if (quoted && c == '\\' && i + 1 < text.size()) result += text[i++];
    std::size_t length = 0;
    if (!quoted && (c == 'N' || c == 'I' || c == '-'))
      for (const auto word : {"NaN"sv, "Infinity"sv, "-Infinity"sv})
        if (text.compare(i, word.size(), word) == 0) length = word.size();
    if (length > 0)
      result += "null", i += length - 1;
    else
      result += text[i];
  }
  return result;
}

/// A field: a text, a number, 1 or 0; empty for anything else.
std::string field_text(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.is_array() ? "" : value_text(value);
}

/// Fields with the names of their columns.
using Row = std::vector<std::pair<std::string, std::string>>;

/// Rows with columns of their own; all columns are in the order in which they appear.
class Rows {
 public:
  void add(const Row& row) {
    auto& fields = rows_.emplace_back();
    for (const auto& [name, text] : row) {
      const auto [found, is_new] = columns_.try_emplace(name, names_.size());
      if (is_new) names_.push_back(name);
      fields.emplace_back(found->second, text);
    }
  }

  bool empty() const { return rows_.empty(); }
  std::size_t fields() const { return rows_.size() * names_.size(); }

  std::string csv() const {
    std::string text = csv_line(names_);
    for (const auto& row : rows_) {
      std::vector<std::string> fields(names_.size());
      for (const auto& [column, field] : row) fields[column] = field;
      text += csv_line(fields);
    }
    return text;
  }

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::size_t> columns_;
  std::vector<std::vector<std::pair<std::size_t, std::string>>> rows_;
};

bool is_object(const Json& value) {
  return value.is_object();
}

bool has_rows(const Json& value) {
  return value.is_array() && !value.empty() && std::all_of(value.begin(), value.end(), is_object);
}

/// Whether each member of an object is a column: of lists, as positions, there is none.
bool has_columns(const Json& object) {
  return !object.empty() && std::all_of(object.begin(), object.end(), [](const Json& value) {
    return value.is_array() && std::none_of(value.begin(), value.end(),
                                            [](const Json& one) { return one.is_structured(); });
  });
}

/// The method, and the scenario, that the name of a table gives its rows.
Row named_row(const std::string& name) {
  if (name.empty()) return {};
  const std::size_t end = name.find("--");
  if (end == std::string::npos || end == 0 || end + 2 == name.size()) return {{"method", name}};
  return {{"method", name.substr(0, end)}, {"scenario", name.substr(end + 2)}};
}

/// The values of an object, and of those within it.
void add_values(const Json& object, const std::string& prefix, Row& row) {
  for (const auto& [key, value] : object.items())
    if (value.is_object())
      add_values(value, prefix + key + ".", row);
    else if (!value.is_array())
      row.emplace_back(prefix + key, field_text(value));
}

/// Finds a key that an object has twice, of which a reader would see one.
class KeysOfObjects {
 public:
  void see(std::size_t depth, Json::parse_event_t event, const Json& value) {
    if (depth > kMaxDepth) return;
    if (event == Json::parse_event_t::object_start) keys_[depth + 1].clear();
    if (event == Json::parse_event_t::key && !keys_[depth].insert(value.get<std::string>()).second)
      twice_ = value.get<std::string>();
  }
  const std::string& twice() const { return twice_; }

 private:
  std::array<std::set<std::string>, kMaxDepth + 2> keys_;  ///< of the objects that are open
  std::string twice_;
};

/// The rows of all tables of a file.
class JsonTables {
 public:
  explicit JsonTables(const std::string& file) : file_(file) {}

  /// `table` is the key of the table that has the value, empty where the whole file is one.
  void read(const Json& value, const std::string& table) {
    if (has_rows(value)) return read_rows(value, table);
    if (!value.is_object()) return;
    if (has_columns(value)) return read_columns(value, table);
    for (const auto& [key, part] : value.items())
      read(part, !table.empty() || (has_rows(part) && value.size() == 1) ? table : key);
  }

  const Rows& rows() const { return rows_; }

 private:
  const std::string& file_;
  Rows rows_;

  void read_rows(const Json& array, const std::string& table) {
    for (const Json& object : array) {
      Row row = named_row(table);
      add_values(object, "", row);
      rows_.add(row);
    }
  }

  void read_columns(const Json& object, const std::string& table) {
    const std::size_t length = object.begin().value().size();
    for (const auto& [key, value] : object.items())
      if (value.size() != length)
        throw file_error(file_ + (table.empty() ? "" : ": " + table),
                         "'" + key + "' has " + count_text(value.size(), "value") + " and '" +
                             object.begin().key() + "' " + std::to_string(length),
                         "columns of the same length");
    for (std::size_t i = 0; i < length; ++i) {
      Row row = named_row(table);
      for (const auto& [key, value] : object.items()) row.emplace_back(key, field_text(value[i]));
      rows_.add(row);
    }
  }
};

}  // namespace

std::optional<ForeignTable> table_from_json(const std::string& text, const std::string& name) {
  KeysOfObjects keys;
  const auto is_kept = [&](int depth, Json::parse_event_t event, Json& value) {
    keys.see(static_cast<std::size_t>(depth), event, value);
    return depth <= kMaxDepth;
  };
  const Json file = Json::parse(without_nan(text), is_kept, false);
  if (!keys.twice().empty())
    throw file_error(name, "an object has two values of '" + printable_line(keys.twice()) + "'",
                     "each key once");
  if (is_bench_mr(file)) return bench_mr_table(file);
  JsonTables tables(name);
  tables.read(file, "");
  if (tables.rows().fields() > kMaxFields)
    throw file_error(name, "more than " + std::to_string(kMaxFields) + " fields",
                     "a smaller table");
  if (tables.rows().empty()) return std::nullopt;
  return ForeignTable{tables.rows().csv()};
}

}  // namespace slalom
