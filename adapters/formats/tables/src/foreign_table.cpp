// SPDX-License-Identifier: BSD-3-Clause
#include "foreign_table.h"

#include <slalom/analysis/table_export.h>
#include <slalom/core/error.h>
#include <slalom/core/file_format.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/io/foreign_database.h>
#include <slalom/io/read_results.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <map>

namespace slalom {
namespace {

constexpr std::uint64_t kMaxJsonSize = 200 * kMegabyte;

/// The tables of ompl_benchmark_statistics.py.
class OmplDatabase {
 public:
  explicit OmplDatabase(SQLite::Database& database) : database_(database) {}

  bool is_one() const {
    return database_
               .execAndGet(
                   "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name IN "
                   "('experiments', 'plannerConfigs', 'enums', 'runs')")
               .getInt() == 4;
  }

  ForeignTable read() {
    read_descriptions();
    find_columns();
    std::vector<std::string> names = {"scenario", "method"};
    // A run whose experiment or planner is missing counts, too.
    std::vector<std::string> selected = {
        "coalesce(e.name, 'experiment ' || ifnull(r.experimentid, ''))",
        "coalesce(p.name, 'planner ' || ifnull(r.plannerid, ''))"};
    for (const std::string& column : columns_) {
      names.push_back(column == "status" ? "outcome" : plain(column));
      selected.push_back("r.\"" + column + "\"");
    }
    std::string csv = csv_line(names);
    SQLite::Statement rows(database_, "SELECT " + join(selected, ", ") +
                                          " FROM runs r LEFT JOIN experiments e ON e.id = "
                                          "r.experimentid LEFT JOIN plannerConfigs p ON p.id = "
                                          "r.plannerid ORDER BY r.id");
    while (rows.executeStep()) {
      std::vector<std::string> fields = {rows.getColumn(0).getString(),
                                         rows.getColumn(1).getString()};
      for (std::size_t i = 0; i < columns_.size(); ++i)
        fields.push_back(text_of(columns_[i], rows.getColumn(static_cast<int>(i) + 2)));
      csv += csv_line(fields);
    }
    return {csv, {"exact solution"}};
  }

 private:
  static std::string plain(std::string name) {
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  }

  void read_descriptions() {
    SQLite::Statement rows(database_, "SELECT name, value, description FROM enums");
    while (rows.executeStep())
      descriptions_[rows.getColumn(0).getString()][rows.getColumn(1).getInt64()] =
          rows.getColumn(2).getString();
  }

  void find_columns() {
    SQLite::Statement rows(database_, "SELECT name FROM pragma_table_info('runs')");
    while (rows.executeStep()) {
      const std::string name = rows.getColumn(0).getString();
      const bool is_id = name == "id" || name == "experimentid" || name == "plannerid";
      if (!is_id && name.find('"') == std::string::npos) columns_.push_back(name);
    }
  }

  std::string text_of(const std::string& name, const SQLite::Column& value) const {
    if (value.isNull()) return "";
    const auto words = descriptions_.find(name);
    if (words != descriptions_.end() && value.isInteger()) {
      const auto word = words->second.find(value.getInt64());
      if (word != words->second.end()) return word->second;
    }
    return value.isFloat() ? format_number(value.getDouble()) : value.getString();
  }

  SQLite::Database& database_;
  std::map<std::string, std::map<std::int64_t, std::string>> descriptions_;
  std::vector<std::string> columns_;
};

std::optional<ForeignTable> read_ompl_database(const std::string& path) {
  const auto file = open_foreign_database(path, "a benchmark database of OMPL");
  try {
    OmplDatabase database(*file);
    if (!database.is_one()) return std::nullopt;
    return database.read();
  } catch (const SQLite::Exception& e) {
    throw file_error(path, std::string("cannot be read: ") + e.what(),
                     "a benchmark database of OMPL");
  }
}

}  // namespace

std::optional<ForeignTable> read_foreign_table(const std::string& path, const std::string& sheet) {
  if (is_database(path)) return read_ompl_database(path);
  const auto format = recognize_file(path);
  if (ends_with(path, ".xlsx") || (format && ends_with(format->name, "(.xlsx)")))
    return table_from_workbook(path, sheet);
  if (!ends_with(path, ".json")) return std::nullopt;
  return table_from_json(read_text(path, "a table (.json)", kMaxJsonSize), path);
}

}  // namespace slalom
