#include "database.h"

#include <slalom/core/error.h>
#include <slalom/io/result_columns.h>
#include <slalom/io/result_file.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <numeric>
#include <set>
#include <sqlite3.h>
#include <tuple>

namespace slalom {
namespace {

using Json = nlohmann::json;

constexpr int kKeyColumns = 6;  ///< run, scenario, name, method, repetition, outcome

Direction direction_of(const std::string& text) {
  for (const Direction direction : {Direction::Up, Direction::Down}) {
    if (to_string(direction) == text) return direction;
  }
  return Direction::None;
}

std::vector<QuantityInfo> quantities(SQLite::Database& database, const std::string& kind) {
  std::vector<QuantityInfo> infos;
  SQLite::Statement rows(database,
                         "SELECT id, version, name, unit, direction FROM quantities "
                         "WHERE kind = ? ORDER BY id");
  rows.bind(1, kind);
  while (rows.executeStep()) {
    infos.push_back({rows.getColumn(0).getString(), rows.getColumn(1).getInt(),
                     rows.getColumn(2).getString(), rows.getColumn(3).getString(),
                     direction_of(rows.getColumn(4).getString())});
  }
  return infos;
}

/// SQLite's own statement: a million rows of forty columns are read through it.
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

/// A name and its place, looked up only where it differs from the row before.
class RememberedName {
 public:
  explicit RememberedName(std::vector<std::string>& names) : index_(names) {}
  std::uint32_t place_of(const char* name) {
    if (fresh_ || last_ != name) {
      last_ = name;
      place_ = index_.place_of(last_);
      fresh_ = false;
    }
    return place_;
  }

 private:
  NameIndex index_;
  std::string last_;
  std::uint32_t place_ = 0;
  bool fresh_ = true;
};

/// Reasons of missing values: the same few texts of JSON come again and again.
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
    if (!json.is_object()) throw file_error(path_, "holds a damaged row", "a JSON object");
    std::vector<std::string> reasons;
    for (const QuantityInfo& info : metrics_) {
      const auto found = json.find(info.id);
      const bool there = found != json.end() && found->is_string();
      reasons.push_back(there ? found->get<std::string>() : "not computed");
    }
    return reasons;
  }
};

class ColumnReader {
 public:
  ColumnReader(const std::string& path, SQLite::Database& database,
               const std::optional<std::vector<std::string>>& ids)
      : path_(path), database_(database) {
    if (ids) wished_ = std::set<std::string>(ids->begin(), ids->end());
    metrics_ = quantities(database, "metric");
    descriptors_ = quantities(database, "descriptor");
    if (wished_) choose();
  }

  RunColumns read() {
    columns_.source = path_;
    SQLite::Statement manifest(database_, "SELECT key, text FROM manifest");
    while (manifest.executeStep()) {
      columns_.manifest[manifest.getColumn(0).getString()] = manifest.getColumn(1).getString();
    }
    read_runs();
    if (timings_) read_timings();
    read_scenarios();
    sort_methods(columns_);
    sort_rows();
    add_success(columns_);
    return std::move(columns_);
  }

 private:
  std::string path_;
  SQLite::Database& database_;
  std::optional<std::set<std::string>> wished_;
  std::vector<QuantityInfo> metrics_, descriptors_;
  bool timings_ = true;
  RunColumns columns_;
  std::vector<std::int64_t> keys_;  ///< of the runs, as the timings have them

  static void keep(std::vector<QuantityInfo>& infos, std::set<std::string>& wished) {
    std::vector<QuantityInfo> kept;
    for (QuantityInfo& info : infos) {
      if (wished.erase(info.id) > 0) kept.push_back(std::move(info));
    }
    infos = std::move(kept);
  }

  /// Leaves only what was asked for. What is neither metric nor descriptor may be a wall-clock
  /// figure; what is not even that makes everything be read.
  void choose() {
    const auto all_metrics = metrics_, all_descriptors = descriptors_;
    std::set<std::string> rest = *wished_;
    keep(metrics_, rest);
    keep(descriptors_, rest);
    rest.erase("success");
    timings_ = !rest.empty();
    const bool clocks = std::all_of(rest.begin(), rest.end(), [](const std::string& id) {
      return id.rfind("cycle_time_", 0) == 0 || id == "deadline_miss_ratio";
    });
    if (clocks) return;
    metrics_ = all_metrics;
    descriptors_ = all_descriptors;
  }

  void read_runs() {
    std::string sql = "SELECT run, scenario, scenario_name, method, repetition, outcome";
    for (const QuantityInfo& info : metrics_) {
      sql += ", \"m_" + info.id + "\"";
      columns_.metrics.emplace_back(info).rate = info.id == "success";
    }
    FastRows rows(database_, sql + ", reasons FROM runs");
    RememberedName scenarios(columns_.scenario_hashes), methods(columns_.methods),
        outcomes(columns_.outcomes);
    Reasons reasons(metrics_, path_);
    const int reasons_column = kKeyColumns + static_cast<int>(metrics_.size());
    while (rows.next()) {
      keys_.push_back(rows.integer(0));
      columns_.scenario.push_back(scenarios.place_of(rows.text(1)));
      if (columns_.scenario.back() == columns_.scenario_names.size()) {
        columns_.scenario_names.emplace_back(rows.text(2));
      }
      columns_.method.push_back(methods.place_of(rows.text(3)));
      columns_.repetition.push_back(static_cast<std::uint32_t>(rows.integer(4)));
      columns_.outcome.push_back(outcomes.place_of(rows.text(5)));
      for (std::size_t i = 0; i < metrics_.size(); ++i) {
        const int column = kKeyColumns + static_cast<int>(i);
        if (rows.is_null(column)) {
          columns_.metrics[i].add_na(reasons.of(rows.text(reasons_column), i));
        } else {
          columns_.metrics[i].add_number(rows.number(column));
        }
      }
    }
  }

  void read_timings() {
    std::map<std::string, std::vector<std::pair<std::size_t, double>>> figures;
    SQLite::Statement rows(database_, "SELECT run, figures FROM run_timings ORDER BY run");
    std::size_t place = 0;
    while (rows.executeStep()) {
      const std::int64_t run = rows.getColumn(0).getInt64();
      while (place < keys_.size() && keys_[place] < run) ++place;
      if (place == keys_.size()) break;
      if (keys_[place] != run) continue;
      const Json json = Json::parse(rows.getColumn(1).getString(), nullptr, false);
      if (!json.is_object()) throw file_error(path_, "holds a damaged row", "a JSON object");
      for (const auto& [id, value] : json.items()) {
        if (value.is_number()) figures[id].emplace_back(place, value.get<double>());
      }
    }
    for (const auto& [id, values] : figures) {
      ValueColumn& column =
          columns_.metrics.emplace_back(QuantityInfo{id, 1, id, timing_unit(id), Direction::Down});
      column.wall_clock = true;
      for (const auto& [run, value] : values) {
        while (column.size() < run) column.add_na("not recorded");
        column.add_number(value);
      }
      while (column.size() < keys_.size()) column.add_na("not recorded");
    }
  }

  void read_scenarios() {
    std::map<std::string, std::size_t> places;
    SQLite::Statement names(database_, "SELECT hash, name FROM scenarios ORDER BY hash");
    for (std::size_t i = 0; i < columns_.scenario_hashes.size(); ++i) {
      places[columns_.scenario_hashes[i]] = i;
    }
    while (names.executeStep()) {
      const std::string hash = names.getColumn(0).getString();
      if (!places.try_emplace(hash, columns_.scenario_hashes.size()).second) continue;
      columns_.scenario_hashes.push_back(hash);
      columns_.scenario_names.push_back(names.getColumn(1).getString());
    }
    for (const QuantityInfo& info : descriptors_) read_descriptor(info, places);
  }

  void read_descriptor(const QuantityInfo& info, const std::map<std::string, std::size_t>& places) {
    std::vector<Value> values(columns_.scenario_hashes.size(), Value::na("not computed"));
    SQLite::Statement rows(database_,
                           "SELECT hash, version, value, reason FROM descriptors WHERE id = ?");
    rows.bind(1, info.id);
    while (rows.executeStep()) {
      const auto place = places.find(rows.getColumn(0).getString());
      if (place == places.end()) continue;
      const int version = rows.getColumn(1).getInt();
      values[place->second] = rows.getColumn(2).isNull() ? Value::na(rows.getColumn(3).getString())
                              : version == info.version
                                  ? Value::of(rows.getColumn(2).getDouble())
                                  : Value::na("other version " + std::to_string(version));
    }
    ValueColumn& column = columns_.descriptors.emplace_back(info);
    for (const Value& value : values) column.add(value);
  }

  /// By scenario name and hash, method and repetition: a merged file has its runs in any order.
  void sort_rows() {
    const std::size_t scenarios = columns_.scenario_hashes.size();
    std::vector<std::size_t> by_name(scenarios), rank(scenarios);
    std::iota(by_name.begin(), by_name.end(), std::size_t{0});
    std::sort(by_name.begin(), by_name.end(), [this](std::size_t a, std::size_t b) {
      return std::tie(columns_.scenario_names[a], columns_.scenario_hashes[a]) <
             std::tie(columns_.scenario_names[b], columns_.scenario_hashes[b]);
    });
    for (std::size_t i = 0; i < scenarios; ++i) rank[by_name[i]] = i;
    const auto before = [&](std::size_t a, std::size_t b) {
      return std::make_tuple(rank[columns_.scenario[a]], columns_.method[a],
                             columns_.repetition[a]) < std::make_tuple(rank[columns_.scenario[b]],
                                                                       columns_.method[b],
                                                                       columns_.repetition[b]);
    };
    std::vector<std::size_t> order(columns_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!std::is_sorted(order.begin(), order.end(), before)) {
      std::sort(order.begin(), order.end(), before);
      reorder_runs(columns_, order);
    }
    reorder_scenarios(columns_, by_name);
  }
};

}  // namespace

RunColumns read_run_columns(const std::string& path,
                            const std::optional<std::vector<std::string>>& ids) {
  ResultFile::open(path);  // refuses other kinds and versions
  return reading(path, [&] {
    SQLite::Database database(path, SQLite::OPEN_READONLY, 10000);
    return ColumnReader(path, database, ids).read();
  });
}

bool is_database(const std::string& path) {
  const std::string magic("SQLite format 3\0", 16);
  std::string begin(magic.size(), ' ');
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return file && begin == magic;
}

}  // namespace slalom
