#include "compression.h"
#include "database.h"
#include "value_columns.h"

#include <slalom/core/error.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/references/reference_codec.h>
#include <slalom/trajectory/trajectory_codec.h>

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

using Json = nlohmann::json;

constexpr DatabaseKind kResults = {"a result file (.results)", 0x534c5253 /* "SLRS" */, 2, R"(
CREATE TABLE manifest (key TEXT PRIMARY KEY, text TEXT NOT NULL);
CREATE TABLE quantities (position INTEGER PRIMARY KEY, kind TEXT NOT NULL, id TEXT NOT NULL,
                         version INTEGER NOT NULL, name TEXT NOT NULL, unit TEXT NOT NULL,
                         direction TEXT NOT NULL, UNIQUE (kind, id));
CREATE TABLE scenarios (hash TEXT PRIMARY KEY, name TEXT NOT NULL, content BLOB NOT NULL,
                        refs BLOB NOT NULL);
CREATE TABLE descriptors (hash TEXT NOT NULL, id TEXT NOT NULL, version INTEGER NOT NULL,
                          value REAL, standard_error REAL, reason TEXT,
                          PRIMARY KEY (hash, id)) WITHOUT ROWID;
CREATE TABLE trajectories (run INTEGER PRIMARY KEY, content BLOB NOT NULL);
CREATE TABLE reference_timings (hash TEXT PRIMARY KEY, exact_seconds REAL NOT NULL,
                                planner_seconds REAL NOT NULL, safest_seconds REAL NOT NULL);
CREATE TABLE run_timings (run INTEGER PRIMARY KEY, wall_seconds REAL NOT NULL, figures TEXT NOT NULL);
)"};

/// The runs table: one row per run, one column per metric, NA reasons and standard errors as JSON.
std::string runs_schema(const std::vector<QuantityInfo>& metrics) {
  std::string sql =
      "CREATE TABLE runs (run INTEGER PRIMARY KEY, scenario TEXT NOT NULL, scenario_name TEXT NOT "
      "NULL, method TEXT NOT NULL, repetition INTEGER NOT NULL, seed TEXT NOT NULL, outcome TEXT "
      "NOT "
      "NULL, outcome_detail TEXT NOT NULL, trajectory_hash TEXT NOT NULL, reasons TEXT NOT NULL, "
      "standard_errors TEXT NOT NULL";
  for (const QuantityInfo& info : metrics) sql += ", \"m_" + info.id + "\" REAL";
  return sql + ", UNIQUE (scenario, method, repetition))";
}

constexpr int kFixedColumns = 11;

Direction direction_from_string(const std::string& text) {
  for (const Direction direction : {Direction::Up, Direction::Down})
    if (to_string(direction) == text) return direction;
  return Direction::None;
}

/// Parses a JSON column; does not trust its contents.
std::map<std::string, double> numbers_from_json(const std::string& text, const std::string& path) {
  const Json json = Json::parse(text, nullptr, false);
  std::map<std::string, double> numbers;
  if (!json.is_object()) throw file_error(path, "contains a damaged row", "a JSON object");
  for (const auto& [key, value] : json.items())
    if (value.is_number()) numbers[key] = value.get<double>();
  return numbers;
}

void check_id(const QuantityInfo& info) {
  const bool plain =
      !info.id.empty() &&
      info.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
  if (!plain)
    throw usage_error("result file", "invalid column name '" + info.id + "'", "a-z, 0-9, _");
}

}  // namespace

struct ResultFile::Impl {
  std::string path;
  std::unique_ptr<SQLite::Database> database;
  std::unique_ptr<SQLite::Transaction> transaction;  ///< open while there are uncommitted changes
  std::vector<QuantityInfo> descriptors, metrics;

  void begin() {
    if (!transaction) transaction = std::make_unique<SQLite::Transaction>(*database);
  }

  void write_manifest(const Manifest& manifest) {
    for (const auto& [key, text] : manifest) {
      SQLite::Statement row(*database, "INSERT INTO manifest VALUES (?, ?)");
      row.bind(1, key);
      row.bind(2, text);
      row.exec();
    }
  }

  void write_quantities(const std::string& kind, const std::vector<QuantityInfo>& infos) {
    for (const QuantityInfo& info : infos) {
      SQLite::Statement row(*database,
                            "INSERT INTO quantities (kind, id, version, name, unit, direction) "
                            "VALUES (?, ?, ?, ?, ?, ?)");
      row.bind(1, kind);
      row.bind(2, info.id);
      row.bind(3, info.version);
      row.bind(4, info.name);
      row.bind(5, info.unit);
      row.bind(6, to_string(info.direction));
      row.exec();
    }
  }

  std::vector<QuantityInfo> read_quantities(const std::string& kind) const {
    std::vector<QuantityInfo> infos;
    SQLite::Statement rows(*database,
                           "SELECT id, version, name, unit, direction FROM quantities "
                           "WHERE kind = ? ORDER BY position");
    rows.bind(1, kind);
    while (rows.executeStep()) {
      infos.push_back({rows.getColumn(0).getString(), rows.getColumn(1).getInt(),
                       rows.getColumn(2).getString(), rows.getColumn(3).getString(),
                       direction_from_string(rows.getColumn(4).getString())});
      check_id(infos.back());
    }
    return infos;
  }

  std::string insert_run_sql() const {
    std::string sql = "INSERT INTO runs VALUES (NULL";
    for (std::size_t i = 1; i < kFixedColumns + metrics.size(); ++i) sql += ", ?";
    return sql + ")";
  }

  void insert_run(const RunRecord& run) {
    SQLite::Statement row(*database, insert_run_sql());
    row.bind(1, run.scenario_hash);
    row.bind(2, run.scenario_name);
    row.bind(3, run.method);
    row.bind(4, run.repetition);
    row.bind(5, std::to_string(run.seed));
    row.bind(6, run.outcome);
    row.bind(7, run.outcome_detail);
    row.bind(8, run.trajectory_hash);
    Json reasons = Json::object(), errors = Json::object();
    for (std::size_t i = 0; i < metrics.size(); ++i) {
      const auto found = run.metrics.find(metrics[i].id);
      const Value value =
          found == run.metrics.end() ? Value::na(kNotComputed) : found->second.value;
      if (value.is_na()) {
        reasons[metrics[i].id] = value.reason();
      } else {
        row.bind(kFixedColumns + static_cast<int>(i), value.number());
      }
      if (value.standard_error()) errors[metrics[i].id] = *value.standard_error();
    }
    row.bind(9, reasons.dump(-1, ' ', false, Json::error_handler_t::replace));
    row.bind(10, errors.dump());
    row.exec();
  }

  void insert_timing(const std::string& hash, const ReferenceTiming& timing) {
    SQLite::Statement row(*database, "INSERT INTO reference_timings VALUES (?, ?, ?, ?)");
    row.bind(1, hash);
    row.bind(2, timing.exact);
    row.bind(3, timing.planner);
    row.bind(4, timing.safest);
    row.exec();
  }

  void insert_blob(const char* sql, std::int64_t run, const std::string& content) {
    SQLite::Statement row(*database, sql);
    row.bind(1, run);
    row.bind(2, content.data(), static_cast<int>(content.size()));
    row.exec();
  }

  Manifest read_manifest() const {
    Manifest manifest;
    SQLite::Statement rows(*database, "SELECT key, text FROM manifest");
    while (rows.executeStep())
      manifest[rows.getColumn(0).getString()] = rows.getColumn(1).getString();
    return manifest;
  }

  RunRecord run_from(SQLite::Statement& row) const {
    RunRecord run;
    run.scenario_hash = row.getColumn(1).getString();
    run.scenario_name = row.getColumn(2).getString();
    run.method = row.getColumn(3).getString();
    run.repetition = row.getColumn(4).getInt();
    run.seed = std::strtoull(row.getColumn(5).getString().c_str(), nullptr, 10);
    run.outcome = row.getColumn(6).getString();
    run.outcome_detail = row.getColumn(7).getString();
    run.trajectory_hash = row.getColumn(8).getString();
    const Json reasons = Json::parse(row.getColumn(9).getString(), nullptr, false);
    const auto errors = numbers_from_json(row.getColumn(10).getString(), path);
    if (!reasons.is_object()) throw file_error(path, "contains a damaged row", "a JSON object");
    for (std::size_t i = 0; i < metrics.size(); ++i) {
      const std::string& id = metrics[i].id;
      const SQLite::Column column = row.getColumn(kFixedColumns + static_cast<int>(i));
      const auto error = errors.find(id);
      Value value = column.isNull()         ? Value::na(reasons.value(id, kNotRecorded))
                    : error == errors.end() ? Value::of(column.getDouble())
                                            : Value::of(column.getDouble(), error->second);
      run.metrics[id] = {metrics[i].version, std::move(value)};
    }
    return run;
  }

  ReferenceTiming read_timing(const std::string& hash) const {
    SQLite::Statement row(*database, "SELECT * FROM reference_timings WHERE hash = ?");
    row.bind(1, hash);
    if (!row.executeStep()) return {};
    return {row.getColumn(1).getDouble(), row.getColumn(2).getDouble(),
            row.getColumn(3).getDouble()};
  }

  /// A blob by its keys. Throws Error (File) when it does not exist.
  std::string read_blob(const std::string& sql, const std::vector<std::string>& keys) const {
    SQLite::Statement row(*database, sql);
    for (std::size_t i = 0; i < keys.size(); ++i) row.bind(static_cast<int>(i) + 1, keys[i]);
    if (!row.executeStep()) throw file_error(path, "contains no entry for " + keys.front());
    return row.getColumn(0).getString();
  }
};

ResultFile::ResultFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ResultFile::~ResultFile() = default;
ResultFile::ResultFile(ResultFile&&) noexcept = default;
ResultFile& ResultFile::operator=(ResultFile&&) noexcept = default;

const std::string& ResultFile::path() const {
  return impl_->path;
}

const std::vector<QuantityInfo>& ResultFile::descriptors() const {
  return impl_->descriptors;
}

const std::vector<QuantityInfo>& ResultFile::metrics() const {
  return impl_->metrics;
}

ResultFile ResultFile::create(const std::string& path, const Manifest& manifest,
                              const std::vector<QuantityInfo>& descriptors,
                              const std::vector<QuantityInfo>& metrics) {
  for (const QuantityInfo& info : metrics) check_id(info);
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->descriptors = descriptors;
  impl->metrics = metrics;
  impl->database = create_database(path, kResults);
  writing(path, [&] {
    SQLite::Transaction transaction(*impl->database);
    impl->database->exec(runs_schema(metrics));
    impl->write_manifest(manifest);
    impl->write_quantities("descriptor", descriptors);
    impl->write_quantities("metric", metrics);
    transaction.commit();
  });
  return ResultFile(std::move(impl));
}

ResultFile ResultFile::open(const std::string& path) {
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->database = open_database(path, kResults);
  reading(path, [&] {
    impl->descriptors = impl->read_quantities("descriptor");
    impl->metrics = impl->read_quantities("metric");
  });
  return ResultFile(std::move(impl));
}

void ResultFile::add_scenario(const ScenarioRecord& record, const Scenario& scenario,
                              const References& references) {
  writing(impl_->path, [&] {
    impl_->begin();
    const std::string content = serialize(scenario), refs = compress(to_bytes(references));
    SQLite::Statement row(*impl_->database, "INSERT INTO scenarios VALUES (?, ?, ?, ?)");
    row.bind(1, record.hash);
    row.bind(2, record.name);
    row.bind(3, content.data(), static_cast<int>(content.size()));
    row.bind(4, refs.data(), static_cast<int>(refs.size()));
    row.exec();
    impl_->insert_timing(record.hash, references.timing);
    for (const auto& [id, versioned] : record.descriptors) {
      SQLite::Statement value(*impl_->database,
                              "INSERT INTO descriptors VALUES (?, ?, ?, ?, ?, ?)");
      value.bind(1, record.hash);
      value.bind(2, id);
      value.bind(3, versioned.version);
      bind_value(value, 4, versioned.value);
      value.exec();
    }
  });
}

void ResultFile::add_run(const RunRecord& run, const RunTiming& timing,
                         const Trajectory& trajectory) {
  writing(impl_->path, [&] {
    impl_->begin();
    impl_->insert_run(run);
    const std::int64_t id = impl_->database->getLastInsertRowid();
    impl_->insert_blob("INSERT INTO trajectories VALUES (?, ?)", id,
                       compress(to_bytes(trajectory)));
    SQLite::Statement row(*impl_->database, "INSERT INTO run_timings VALUES (?, ?, ?)");
    row.bind(1, id);
    row.bind(2, timing.wall_seconds);
    row.bind(3, Json(timing.values).dump());
    row.exec();
  });
}

void ResultFile::commit() {
  if (!impl_->transaction) return;
  writing(impl_->path, [&] { impl_->transaction->commit(); });
  impl_->transaction.reset();
}

Manifest ResultFile::read_manifest() const {
  return reading(impl_->path, [&] { return impl_->read_manifest(); });
}

std::vector<std::string> ResultFile::read_methods() const {
  return reading(impl_->path, [&] {
    std::vector<std::string> methods;
    SQLite::Statement rows(*impl_->database, "SELECT DISTINCT method FROM runs ORDER BY method");
    while (rows.executeStep()) methods.push_back(rows.getColumn(0).getString());
    return methods;
  });
}

bool ResultFile::has_scenario(const std::string& hash) const {
  return reading(impl_->path, [&] {
    SQLite::Statement row(*impl_->database, "SELECT 1 FROM scenarios WHERE hash = ?");
    row.bind(1, hash);
    return row.executeStep();
  });
}

void ResultFile::for_each_run(const std::function<void(const RunRecord&)>& use) const {
  reading(impl_->path, [&] {
    SQLite::Statement rows(*impl_->database,
                           "SELECT * FROM runs ORDER BY scenario_name, scenario, method, "
                           "repetition");
    while (rows.executeStep()) use(impl_->run_from(rows));
  });
}

std::vector<RunRecord> ResultFile::read_runs(const std::string& scenario_hash) const {
  return reading(impl_->path, [&] {
    std::vector<RunRecord> runs;
    SQLite::Statement rows(*impl_->database,
                           "SELECT * FROM runs WHERE scenario = ? ORDER BY method, repetition");
    rows.bind(1, scenario_hash);
    while (rows.executeStep()) runs.push_back(impl_->run_from(rows));
    return runs;
  });
}

std::optional<RunRecord> ResultFile::read_run(const std::string& scenario_hash,
                                              const std::string& method, int repetition) const {
  return reading(impl_->path, [&]() -> std::optional<RunRecord> {
    SQLite::Statement row(
        *impl_->database,
        "SELECT * FROM runs WHERE scenario = ? AND method = ? AND repetition = ?");
    row.bind(1, scenario_hash);
    row.bind(2, method);
    row.bind(3, repetition);
    if (!row.executeStep()) return std::nullopt;
    return impl_->run_from(row);
  });
}

RunTiming ResultFile::read_timing(const RunRecord& run) const {
  return reading(impl_->path, [&]() -> RunTiming {
    SQLite::Statement row(*impl_->database,
                          "SELECT wall_seconds, figures FROM run_timings JOIN runs USING (run) "
                          "WHERE scenario = ? AND method = ? AND repetition = ?");
    row.bind(1, run.scenario_hash);
    row.bind(2, run.method);
    row.bind(3, run.repetition);
    if (!row.executeStep()) return {};
    return {row.getColumn(0).getDouble(),
            numbers_from_json(row.getColumn(1).getString(), impl_->path)};
  });
}

ScenarioRecord ResultFile::read_record(const std::string& scenario_hash) const {
  return reading(impl_->path, [&] {
    ScenarioRecord record{scenario_hash, "", {}};
    SQLite::Statement name(*impl_->database, "SELECT name FROM scenarios WHERE hash = ?");
    name.bind(1, scenario_hash);
    if (name.executeStep()) record.name = name.getColumn(0).getString();
    SQLite::Statement values(
        *impl_->database,
        "SELECT id, version, value, standard_error, reason FROM descriptors WHERE hash = ?");
    values.bind(1, scenario_hash);
    while (values.executeStep())
      record.descriptors[values.getColumn(0).getString()] = {values.getColumn(1).getInt(),
                                                             value_from_columns(values, 2)};
    return record;
  });
}

Scenario ResultFile::read_scenario(const std::string& hash) const {
  return deserialize_scenario(
      reading(
          impl_->path,
          [&] { return impl_->read_blob("SELECT content FROM scenarios WHERE hash = ?", {hash}); }),
      impl_->path + ": scenario " + hash);
}

References ResultFile::read_references(const std::string& hash) const {
  const std::string where = impl_->path + ": references of " + hash;
  const std::string content = reading(impl_->path, [&] {
    return impl_->read_blob("SELECT refs FROM scenarios WHERE hash = ?", {hash});
  });
  References references = references_from_bytes(decompress(content, where), where);
  references.timing = reading(impl_->path, [&] { return impl_->read_timing(hash); });
  return references;
}

Trajectory ResultFile::read_trajectory(const RunRecord& run) const {
  const std::string sql =
      "SELECT content FROM trajectories JOIN runs ON runs.run = trajectories.run "
      "WHERE scenario = ? AND method = ? AND repetition = ?";
  const std::string where = impl_->path + ": run " + run_id(run);
  const std::string content = reading(impl_->path, [&] {
    return impl_->read_blob(sql, {run.scenario_hash, run.method, std::to_string(run.repetition)});
  });
  return trajectory_from_bytes(decompress(content, where), where);
}

}  // namespace slalom
