// SPDX-License-Identifier: BSD-3-Clause
#include "checked_row.h"
#include "combined_results.h"
#include "database.h"
#include "result_schema.h"
#include "value_columns.h"

#include <slalom/core/enum_names.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/results/lack_of_time.h>
#include <slalom/trajectory/trajectory.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sqlite3.h>

namespace slalom {
namespace {

std::vector<QuantityInfo> sorted_by_id(std::vector<QuantityInfo> infos) {
  std::sort(infos.begin(), infos.end(),
            [](const QuantityInfo& a, const QuantityInfo& b) { return a.id < b.id; });
  return infos;
}

/// A thin wrapper of an SQLite statement for reading millions of rows. Its connection must be
/// without SQLite's locks, so that the values of a row can be used without asking for each again.
class FastRows {
 public:
  FastRows(SQLite::Database& database, const std::string& sql) : handle_(database.getHandle()) {
    const int error = sqlite3_prepare_v2(handle_, sql.c_str(), -1, &statement_, nullptr);
    if (error != SQLITE_OK) throw SQLite::Exception(handle_, error);
    values_.resize(static_cast<std::size_t>(sqlite3_column_count(statement_)));
  }
  ~FastRows() { sqlite3_finalize(statement_); }
  FastRows(const FastRows&) = delete;
  FastRows& operator=(const FastRows&) = delete;

  bool next() {
    const int result = sqlite3_step(statement_);
    if (result != SQLITE_ROW && result != SQLITE_DONE) throw SQLite::Exception(handle_, result);
    if (result == SQLITE_DONE) return false;
    for (std::size_t i = 0; i < values_.size(); ++i)
      values_[i] = sqlite3_column_value(statement_, static_cast<int>(i));
    return true;
  }
  bool is_null(int column) const { return sqlite3_value_type(at(column)) == SQLITE_NULL; }
  bool is_text(int column) const { return sqlite3_value_type(at(column)) == SQLITE_TEXT; }
  bool is_integer(int column) const { return sqlite3_value_type(at(column)) == SQLITE_INTEGER; }
  double number(int column) const { return sqlite3_value_double(at(column)); }
  std::int64_t integer(int column) const { return sqlite3_value_int64(at(column)); }
  /// Whether the column after the first `columns` is the checksum of those from `begin` on.
  bool is_intact(int begin, int columns) {
    checksum_.clear();
    return add_to(checksum_, begin, columns).value() == integer(columns);
  }
  /// The same for a row that belongs to the row with the checksum `owner`.
  bool is_intact(int begin, int columns, std::int64_t owner) {
    checksum_.clear();
    checksum_.add(owner);
    return add_to(checksum_, begin, columns).value() == integer(columns);
  }
  RowChecksum& add_to(RowChecksum& checksum, int begin, int end) const {
    return checksum.add_values(values_.data() + begin, values_.data() + end);
  }
  const char* text(int column) const {
    const auto* bytes = sqlite3_value_text(at(column));
    return bytes == nullptr ? "" : reinterpret_cast<const char*>(bytes);
  }

 private:
  sqlite3* handle_;
  sqlite3_stmt* statement_ = nullptr;
  std::vector<sqlite3_value*> values_;  ///< of the current row
  RowChecksum checksum_;                ///< reused, for its memory

  sqlite3_value* at(int column) const { return values_[static_cast<std::size_t>(column)]; }
};

/// Looks up the index of a name: mostly that of the previous row, or the one after it.
class CachedNameIndex {
 public:
  explicit CachedNameIndex(std::vector<std::string>& names) : names_(names), index_(names) {}
  std::uint32_t index_of(const char* name) {
    if (is_name(last_, name)) return last_;
    const std::uint32_t next = last_ + 1 < names_.size() ? last_ + 1 : 0;
    last_ = is_name(next, name) ? next : index_.index_of(name);
    return last_;
  }

 private:
  std::vector<std::string>& names_;
  NameIndex index_;
  std::uint32_t last_ = 0;

  bool is_name(std::uint32_t index, const char* name) const {
    return index < names_.size() && names_[index] == name;
  }
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
    const nlohmann::json json = object_in(text, path_);
    std::vector<std::string> reasons;
    for (const QuantityInfo& info : metrics_) reasons.push_back(reason_in(json, info.id));
    return reasons;
  }
};

class ColumnReader {
 public:
  ColumnReader(const ResultFile& file, SQLite::Database& database)
      : path_(file.path()),
        database_(database),
        stored_metrics_(file.metrics()),
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

  FileRows read() {
    const ReadTransaction scope(database_);
    read_runs();
    if (timings_) read_timings();
    read_scenarios();
    return {std::move(columns_), std::move(checksums_), std::move(scenario_checksums_)};
  }

 private:
  std::string path_;
  SQLite::Database& database_;
  std::vector<QuantityInfo> stored_metrics_;  ///< in the order of the columns
  std::vector<QuantityInfo> metrics_, descriptors_;
  bool timings_ = true, details_ = false;
  ResultTable columns_;
  std::vector<std::int64_t> keys_;       ///< of the runs, referenced by the timings
  std::vector<std::int64_t> checksums_;  ///< of the runs, contained in those of the timings
  std::vector<std::optional<std::int64_t>> scenario_checksums_;  ///< none for a damaged one

  static void keep(std::vector<QuantityInfo>& infos, std::set<std::string>& requested) {
    std::vector<QuantityInfo> kept;
    for (QuantityInfo& info : infos) {
      if (requested.count(id_of_imported(info.id)) > 0) kept.push_back(std::move(info));
    }
    for (const QuantityInfo& info : kept) requested.erase(id_of_imported(info.id));
    infos = std::move(kept);
  }

  /// The column of each selected metric, which are columns of the result as well.
  std::vector<int> metric_columns() {
    std::vector<int> columns;
    for (const QuantityInfo& info : metrics_) {
      const auto stored =
          std::find_if(stored_metrics_.begin(), stored_metrics_.end(),
                       [&](const QuantityInfo& other) { return other.id == info.id; });
      columns.push_back(RunColumn::FirstMetric +
                        static_cast<int>(stored - stored_metrics_.begin()));
      columns_.metrics.emplace_back(info);
    }
    return columns;
  }

  void read_runs() {
    const std::vector<int> metric_columns = this->metric_columns();
    const int checksum = RunColumn::FirstMetric + static_cast<int>(stored_metrics_.size());
    FastRows rows(database_, select_runs(stored_metrics_));
    CachedNameIndex scenarios(columns_.scenario_hashes), methods(columns_.methods),
        outcomes(columns_.outcomes);
    Reasons reasons(metrics_, path_);
    std::int64_t count = 0;
    for (; rows.next(); ++count) {
      const std::int64_t repetition = rows.integer(RunColumn::Repetition);
      if (!rows.is_intact(RunColumn::Scenario, checksum) || !rows.is_text(RunColumn::Scenario) ||
          !rows.is_text(RunColumn::Method) || !rows.is_integer(RunColumn::Repetition) ||
          repetition < 0 || repetition > std::numeric_limits<int>::max()) {
        report_damage("run", rows);
        continue;
      }
      keys_.push_back(rows.integer(RunColumn::Run));
      checksums_.push_back(rows.integer(checksum));
      columns_.scenario.push_back(scenarios.index_of(rows.text(RunColumn::Scenario)));
      if (columns_.scenario.back() == columns_.scenario_names.size()) {
        columns_.scenario_names.emplace_back(rows.text(RunColumn::ScenarioName));
      }
      columns_.method.push_back(methods.index_of(rows.text(RunColumn::Method)));
      columns_.repetition.push_back(static_cast<std::uint32_t>(repetition));
      columns_.outcome.push_back(outcomes.index_of(rows.text(RunColumn::Outcome)));
      for (std::size_t i = 0; i < metrics_.size(); ++i) {
        if (rows.is_null(metric_columns[i])) {
          columns_.metrics[i].add_na(reasons.of(rows.text(RunColumn::Reasons), i));
        } else {
          columns_.metrics[i].add_number(rows.number(metric_columns[i]));
        }
      }
      if (std::string lack = lack_of_time_in(rows.text(RunColumn::OutcomeDetail)); !lack.empty())
        columns_.lack_of_time[columns_.scenario_hashes[columns_.scenario.back()]] = std::move(lack);
      if (!details_) continue;
      columns_.details.push_back({std::strtoull(rows.text(RunColumn::Seed), nullptr, 10),
                                  rows.text(RunColumn::OutcomeDetail),
                                  rows.text(RunColumn::TrajectoryHash), 0});
    }
    const bool imported = is_imported(columns_.manifest);
    for (const std::string& outcome : columns_.outcomes)
      if (!from_name<Outcome>(outcome) && !(imported && is_outcome_of_imported(outcome)))
        throw file_error(path_, "contains an unknown outcome '" + outcome + "'",
                         "one of " + join(names_of<Outcome>(), ", "));
    expect_names(columns_);
    expect_count_of_runs(database_, path_, count);
  }

  void report_damage(const std::string& what, FastRows& row) {
    columns_.damaged.push_back(what + " " +
                               std::string(row.text(RunColumn::Scenario)).substr(0, 8) + "/" +
                               row.text(RunColumn::Method) + "/" + row.text(RunColumn::Repetition));
  }

  void read_timings() {
    std::map<std::string, std::vector<std::pair<std::size_t, double>>> figures;
    constexpr int kWallSeconds = 1, kFigures = 2, kChecksum = 3;
    FastRows rows(database_,
                  "SELECT run, wall_seconds, figures, checksum FROM run_timings ORDER BY run");
    std::vector<bool> found(keys_.size(), false);
    std::size_t row = 0;
    bool any = false;
    while (rows.next()) {
      any = true;
      const std::int64_t run = rows.integer(0);
      while (row < keys_.size() && keys_[row] < run) ++row;
      if (row == keys_.size()) break;
      if (keys_[row] != run || !rows.is_intact(1, kChecksum, checksums_[row])) continue;
      found[row] = true;
      if (details_) columns_.details[row].wall_seconds = rows.number(kWallSeconds);
      const nlohmann::json json = object_in(rows.text(kFigures), path_);
      for (const auto& [id, value] : json.items()) {
        if (value.is_number()) figures[id].emplace_back(row, value.get<double>());
      }
    }
    for (std::size_t i = 0; any && i < found.size(); ++i) {  // a bundle has none
      if (!found[i]) columns_.damaged.push_back("wall-clock figures of run " + run_id(columns_, i));
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

  /// Scenarios and descriptors are read in the order of the hashes, so that each scenario is
  /// compared with its checksum.
  void read_scenarios() {
    std::map<std::string, std::size_t> indexes;
    for (std::size_t i = 0; i < columns_.scenario_hashes.size(); ++i) {
      indexes[columns_.scenario_hashes[i]] = i;
    }
    for (const QuantityInfo& info : descriptors_) columns_.descriptors.emplace_back(info);
    FastRows scenarios(database_, "SELECT hash, name, checksum FROM scenarios ORDER BY hash");
    FastRows values(database_,
                    "SELECT id, version, value, standard_error, reason, hash FROM descriptors "
                    "ORDER BY hash, id");
    std::vector<std::size_t> order(indexes.size(), kMissing);  // rows in the order of the hashes
    scenario_checksums_.resize(indexes.size());
    std::size_t rank = 0;
    for (bool more = values.next(); scenarios.next(); ++rank) {
      const std::string hash = scenarios.text(0);
      RowChecksum checksum;
      scenarios.add_to(checksum, 0, 2);
      std::map<std::string, VersionedValue> descriptors;
      for (; more && values.text(kHash) <= hash; more = values.next()) {
        if (values.text(kHash) != hash) continue;
        values.add_to(checksum, 0, kHash);
        descriptors[values.text(0)] = {static_cast<int>(values.integer(1)), value_of(values)};
      }
      const bool intact = checksum.value() == scenarios.integer(2);
      if (!intact) columns_.damaged.push_back("scenario " + hash);
      add_descriptors(intact ? &descriptors : nullptr);
      const auto [found, is_new] = indexes.try_emplace(hash, order.size());
      if (is_new) {
        columns_.scenario_hashes.push_back(hash);
        columns_.scenario_names.emplace_back(scenarios.text(1));
        order.push_back(rank);
        scenario_checksums_.emplace_back();
      } else {
        order[found->second] = rank;
      }
      if (intact) scenario_checksums_[found->second] = checksum.value();
    }
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (order[i] != kMissing) continue;
      columns_.damaged.push_back("scenario " + columns_.scenario_hashes[i]);
      add_descriptors(nullptr);
      order[i] = rank++;
    }
    for (ValueColumn& column : columns_.descriptors) column.reorder(order);
  }

  static constexpr int kHash = 5;  ///< column of descriptors
  static constexpr std::size_t kMissing = std::numeric_limits<std::size_t>::max();

  static Value value_of(FastRows& row) {
    if (row.is_null(2)) return Value::na(row.text(4));
    return row.is_null(3) ? Value::of(row.number(2)) : Value::of(row.number(2), row.number(3));
  }

  /// Adds a row to the columns of the descriptors; null if it is damaged.
  void add_descriptors(const std::map<std::string, VersionedValue>* descriptors) {
    for (std::size_t i = 0; i < descriptors_.size(); ++i) {
      ValueColumn& column = columns_.descriptors[i];
      if (descriptors == nullptr) {
        column.add_na("damaged");
        continue;
      }
      const auto found = descriptors->find(descriptors_[i].id);
      column.add(found == descriptors->end()
                     ? Value::na(kNotRecorded)
                     : value_of_version(found->second, descriptors_[i].version));
    }
  }
};

}  // namespace

FileRows read_file_rows(const std::string& path, const RowsToRead& wanted) {
  const ResultFile file = ResultFile::open(path);
  return reading(path, [&] {
    // SQLite would take a lock for every value; one thread uses the connection.
    const auto database = open_reader(path, SQLite::OPEN_NOMUTEX);
    ColumnReader reader(file, *database);
    if (wanted.ids) reader.select(*wanted.ids);
    if (wanted.details) reader.read_details();
    return reader.read();
  });
}

}  // namespace slalom
