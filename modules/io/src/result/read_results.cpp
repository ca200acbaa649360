#include "database.h"
#include "value_columns.h"

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>
#include <sqlite3.h>

namespace slalom {
namespace {

using Json = nlohmann::json;

constexpr const char* kKeys = "run, scenario, scenario_name, method, repetition, outcome";
constexpr int kKeyColumns = 6;

std::vector<QuantityInfo> sorted_by_id(std::vector<QuantityInfo> infos) {
  std::sort(infos.begin(), infos.end(),
            [](const QuantityInfo& a, const QuantityInfo& b) { return a.id < b.id; });
  return infos;
}

/// A thin wrapper of an SQLite statement for reading millions of rows.
class FastRows {
 public:
  FastRows(SQLite::Database& database, const std::string& sql) {
    const int error =
        sqlite3_prepare_v2(database.getHandle(), sql.c_str(), -1, &statement_, nullptr);
    if (error != SQLITE_OK) throw SQLite::Exception(database.getHandle(), error);
    handle_ = database.getHandle();
  }
  ~FastRows() { sqlite3_finalize(statement_); }
  FastRows(const FastRows&) = delete;
  FastRows& operator=(const FastRows&) = delete;

  bool next() {
    const int result = sqlite3_step(statement_);
    if (result != SQLITE_ROW && result != SQLITE_DONE) throw SQLite::Exception(handle_, result);
    return result == SQLITE_ROW;
  }
  bool is_null(int column) { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }
  double number(int column) { return sqlite3_column_double(statement_, column); }
  std::int64_t integer(int column) { return sqlite3_column_int64(statement_, column); }
  const char* text(int column) {
    const auto* bytes = sqlite3_column_text(statement_, column);
    return bytes == nullptr ? "" : reinterpret_cast<const char*>(bytes);
  }

 private:
  sqlite3_stmt* statement_ = nullptr;
  sqlite3* handle_ = nullptr;
};

/// Looks up the index of a name, caching that of the previous row.
class CachedNameIndex {
 public:
  explicit CachedNameIndex(std::vector<std::string>& names) : names_(names) {}
  std::uint32_t index_of(const char* name) {
    if (empty_ || last_ != name) {
      last_ = name;
      last_index_ = names_.index_of(last_);
      empty_ = false;
    }
    return last_index_;
  }

 private:
  NameIndex names_;
  std::string last_;
  std::uint32_t last_index_ = 0;
  bool empty_ = true;
};

/// Reasons of missing values. Caches the parsed JSON, since few different texts occur.
class Reasons {
 public:
  Reasons(const std::vector<QuantityInfo>& metrics, const std::string& path)
      : metrics_(metrics), path_(path) {}

  const std::string& of(const char* text, std::size_t metric) {
    if (last_ == nullptr || last_->first != text) {
      auto found = known_.find(text);
      if (found == known_.end()) found = known_.emplace(text, parse(text)).first;
      last_ = &*found;
    }
    return last_->second[metric];
  }

 private:
  const std::vector<QuantityInfo>& metrics_;
  std::string path_;
  std::map<std::string, std::vector<std::string>> known_;
  const std::pair<const std::string, std::vector<std::string>>* last_ = nullptr;

  std::vector<std::string> parse(const std::string& text) const {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) throw file_error(path_, "contains a damaged row", "a JSON object");
    std::vector<std::string> reasons;
    for (const QuantityInfo& info : metrics_) {
      const auto found = json.find(info.id);
      const bool known = found != json.end() && found->is_string();
      reasons.push_back(known ? found->get<std::string>() : kNotRecorded);
    }
    return reasons;
  }
};

class ColumnReader {
 public:
  ColumnReader(const ResultFile& file, SQLite::Database& database)
      : path_(file.path()),
        database_(database),
        metrics_(sorted_by_id(file.metrics())),
        descriptors_(sorted_by_id(file.descriptors())) {
    columns_.source = path_;
    columns_.manifest = file.read_manifest();
  }

  /// Keeps only the requested quantities. Other ids may be timings; an unknown id causes everything
  /// to be read.
  void select(const std::vector<std::string>& ids) {
    const auto all_metrics = metrics_, all_descriptors = descriptors_;
    std::set<std::string> remaining(ids.begin(), ids.end());
    keep(metrics_, remaining);
    keep(descriptors_, remaining);
    remaining.erase("success");
    timings_ = !remaining.empty();
    const bool only_timings =
        std::all_of(remaining.begin(), remaining.end(), [](const std::string& id) {
          return id.rfind("cycle_time_", 0) == 0 || id == "deadline_miss_ratio";
        });
    if (only_timings) return;
    metrics_ = all_metrics;
    descriptors_ = all_descriptors;
  }

  void read_details() { details_ = true; }

  ResultTable read() {
    read_runs();
    if (timings_) read_timings();
    read_scenarios();
    sort_rows(columns_);  // merged files have runs in any order
    add_success(columns_);
    return std::move(columns_);
  }

 private:
  std::string path_;
  SQLite::Database& database_;
  std::vector<QuantityInfo> metrics_, descriptors_;
  bool timings_ = true, details_ = false;
  ResultTable columns_;
  std::vector<std::int64_t> keys_;  ///< of the runs, referenced by the timings

  static void keep(std::vector<QuantityInfo>& infos, std::set<std::string>& requested) {
    std::vector<QuantityInfo> kept;
    for (QuantityInfo& info : infos) {
      if (requested.erase(info.id) > 0) kept.push_back(std::move(info));
    }
    infos = std::move(kept);
  }

  void read_runs() {
    std::string sql = std::string("SELECT ") + kKeys;
    for (const QuantityInfo& info : metrics_) {
      sql += ", \"m_" + info.id + "\"";
      columns_.metrics.emplace_back(info).rate = info.id == "success";
    }
    if (details_) sql += ", seed, outcome_detail, trajectory_hash";
    FastRows rows(database_, sql + ", reasons FROM runs");
    CachedNameIndex scenarios(columns_.scenario_hashes), methods(columns_.methods),
        outcomes(columns_.outcomes);
    Reasons reasons(metrics_, path_);
    const int details_column = kKeyColumns + static_cast<int>(metrics_.size());
    const int reasons_column = details_column + (details_ ? 3 : 0);
    while (rows.next()) {
      keys_.push_back(rows.integer(0));
      columns_.scenario.push_back(scenarios.index_of(rows.text(1)));
      if (columns_.scenario.back() == columns_.scenario_names.size()) {
        columns_.scenario_names.emplace_back(rows.text(2));
      }
      columns_.method.push_back(methods.index_of(rows.text(3)));
      columns_.repetition.push_back(static_cast<std::uint32_t>(rows.integer(4)));
      columns_.outcome.push_back(outcomes.index_of(rows.text(5)));
      for (std::size_t i = 0; i < metrics_.size(); ++i) {
        const int column = kKeyColumns + static_cast<int>(i);
        if (rows.is_null(column)) {
          columns_.metrics[i].add_na(reasons.of(rows.text(reasons_column), i));
        } else {
          columns_.metrics[i].add_number(rows.number(column));
        }
      }
      if (!details_) continue;
      columns_.details.push_back({std::strtoull(rows.text(details_column), nullptr, 10),
                                  rows.text(details_column + 1), rows.text(details_column + 2), 0});
    }
  }

  void read_timings() {
    std::map<std::string, std::vector<std::pair<std::size_t, double>>> figures;
    SQLite::Statement rows(database_,
                           "SELECT run, figures, wall_seconds FROM run_timings ORDER BY run");
    std::size_t row = 0;
    while (rows.executeStep()) {
      const std::int64_t run = rows.getColumn(0).getInt64();
      while (row < keys_.size() && keys_[row] < run) ++row;
      if (row == keys_.size()) break;
      if (keys_[row] != run) continue;
      if (details_) columns_.details[row].wall_seconds = rows.getColumn(2).getDouble();
      const Json json = Json::parse(rows.getColumn(1).getString(), nullptr, false);
      if (!json.is_object()) throw file_error(path_, "contains a damaged row", "a JSON object");
      for (const auto& [id, value] : json.items()) {
        if (value.is_number()) figures[id].emplace_back(row, value.get<double>());
      }
    }
    for (const auto& [id, values] : figures) {
      ValueColumn& column = columns_.metrics.emplace_back(wall_clock_column(id));
      for (const auto& [run, value] : values) {
        column.pad(run);
        column.add_number(value);
      }
      column.pad(keys_.size());
    }
  }

  void read_scenarios() {
    std::map<std::string, std::size_t> indexes;
    SQLite::Statement names(database_, "SELECT hash, name FROM scenarios ORDER BY hash");
    for (std::size_t i = 0; i < columns_.scenario_hashes.size(); ++i) {
      indexes[columns_.scenario_hashes[i]] = i;
    }
    while (names.executeStep()) {
      const std::string hash = names.getColumn(0).getString();
      if (!indexes.try_emplace(hash, columns_.scenario_hashes.size()).second) continue;
      columns_.scenario_hashes.push_back(hash);
      columns_.scenario_names.push_back(names.getColumn(1).getString());
    }
    for (const QuantityInfo& info : descriptors_) read_descriptor(info, indexes);
  }

  void read_descriptor(const QuantityInfo& info,
                       const std::map<std::string, std::size_t>& indexes) {
    std::vector<Value> values(columns_.scenario_hashes.size(), Value::na(kNotRecorded));
    SQLite::Statement rows(
        database_,
        "SELECT hash, version, value, standard_error, reason FROM descriptors WHERE id = ?");
    rows.bind(1, info.id);
    while (rows.executeStep()) {
      const auto found = indexes.find(rows.getColumn(0).getString());
      if (found == indexes.end()) continue;
      values[found->second] =
          value_of_version({rows.getColumn(1).getInt(), value_from_columns(rows, 2)}, info.version);
    }
    ValueColumn& column = columns_.descriptors.emplace_back(info);
    for (const Value& value : values) column.add(value);
  }
};

template <typename Configure>
ResultTable read_with(const std::string& path, Configure configure) {
  const ResultFile file = ResultFile::open(path);
  return reading(path, [&] {
    SQLite::Database database(path, SQLite::OPEN_READONLY, 10000);
    ColumnReader reader(file, database);
    configure(reader);
    return reader.read();
  });
}

}  // namespace

ResultTable read_results(const std::string& path,
                         const std::optional<std::vector<std::string>>& ids) {
  return read_with(path, [&](ColumnReader& reader) {
    if (ids) reader.select(*ids);
  });
}

ResultTable read_detailed_results(const std::string& path) {
  return read_with(path, [](ColumnReader& reader) { reader.read_details(); });
}

bool is_database(const std::string& path) {
  require_regular_file(path, "a result file (.results) or a table (.csv)");
  const std::string magic("SQLite format 3\0", 16);
  std::string head(magic.size(), ' ');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  return file && head == magic;
}

}  // namespace slalom
