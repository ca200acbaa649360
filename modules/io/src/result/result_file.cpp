// SPDX-License-Identifier: BSD-3-Clause
#include "checked_row.h"
#include "compression.h"
#include "database.h"
#include "run_outputs.h"
#include "transaction.h"
#include "value_columns.h"

#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/references/reference_codec.h>
#include <slalom/trajectory/trajectory_codec.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <sqlite3.h>

namespace slalom {
namespace {

using Json = nlohmann::json;

constexpr DatabaseKind kResults = {"a result file (.results)", 0x534c5253 /* "SLRS" */, 4, R"(
CREATE TABLE manifest (key TEXT PRIMARY KEY, text TEXT NOT NULL);
CREATE TABLE quantities (position INTEGER PRIMARY KEY, kind TEXT NOT NULL, id TEXT NOT NULL,
                         version INTEGER NOT NULL, name TEXT NOT NULL, unit TEXT NOT NULL,
                         direction TEXT NOT NULL, value_kind TEXT NOT NULL,
                         value_range TEXT NOT NULL, UNIQUE (kind, id));
CREATE TABLE header (checksum INTEGER NOT NULL);
CREATE TABLE scenarios (hash TEXT PRIMARY KEY, name TEXT NOT NULL, checksum INTEGER NOT NULL,
                        content_checksum INTEGER NOT NULL, refs_checksum INTEGER NOT NULL,
                        content BLOB NOT NULL, refs BLOB NOT NULL);
CREATE TABLE descriptors (hash TEXT NOT NULL, id TEXT NOT NULL, version INTEGER NOT NULL,
                          value REAL, standard_error REAL, reason TEXT,
                          PRIMARY KEY (hash, id)) WITHOUT ROWID;
CREATE TABLE trajectories (run INTEGER PRIMARY KEY, content BLOB NOT NULL,
                           checksum INTEGER NOT NULL);
CREATE TABLE reference_timings (hash TEXT PRIMARY KEY, exact_seconds REAL NOT NULL,
                                planner_seconds REAL NOT NULL, safest_seconds REAL NOT NULL,
                                checksum INTEGER NOT NULL);
CREATE TABLE run_timings (run INTEGER PRIMARY KEY, wall_seconds REAL NOT NULL, figures TEXT NOT NULL,
                          checksum INTEGER NOT NULL);
)",
                                   3};
constexpr int kVersionOfRanges = 4;

/// The kinds and ranges of values that files of version 3 do not state, by id. All other quantities
/// there are amounts without a range.
struct KnownRange {
  const char *kind, *range, *ids;
};
constexpr KnownRange kRangesOfVersion3[] = {
    {"rate", "0..1", "success mover_collision stood_at_contact"},
    {"count", "0..", "oscillation_count contact_mover obstacle_count"},
    {"ratio", "..", "log_dimensionless_jerk"},
    {"ratio", "..-1", "sparc"},
    {"ratio", "..1", "progress"},
    {"ratio", "0..",
     "safety path_excess time_ratio clustering traversability dynamic_density "
     "dynamic_traversability"},
    {"ratio", "0..0.5", "barn_score_v2"},
    {"ratio", "0..1",
     "optimality optisafe spl soft_spl risk_time_ratio density cspace_density clearness "
     "confinement confinement_path narrow_fraction trap_fraction goal_visibility"},
    {"ratio", "0..16", "barn_dispersion"},
    {"ratio", "1..", "arrival_ratio detour_ratio barn_tortuosity"},
    {"amount", "0..",
     "optimality_area safety_area path_length time_to_goal par2_time impact_speed "
     "min_time_to_collision final_distance closest_distance mean_speed time_stopped "
     "cumulative_heading_change angle_over_length bending_energy max_curvature path_irregularity "
     "rms_linear_acceleration rms_angular_acceleration rms_linear_jerk rms_angular_jerk "
     "command_variation_v command_variation_w frechet_to_reference hausdorff_to_reference "
     "mover_contact_speed mover_time_to_collision personal_space_time intimate_space_time "
     "frozen_time clearness_mean_distance bottleneck_width clearance_mean clearance_q05 "
     "turn_density barn_closest_distance barn_visibility barn_characteristic_dimension "
     "crossing_flow"},
    {"amount", "0..1", "occupancy_entropy"},
    {"amount", "0..1.2", "personal_space_depth"},
    {"amount", "0..12", "survivability"},
    {"amount", "0..100", "inverse_clearance"},
};

/// The runs table: one row per run, one column per metric, NA reasons and standard errors as JSON,
/// and the checksum of all of them.
std::string runs_schema(const std::vector<QuantityInfo>& metrics) {
  std::string sql =
      "CREATE TABLE runs (run INTEGER PRIMARY KEY, scenario TEXT NOT NULL, scenario_name TEXT NOT "
      "NULL, method TEXT NOT NULL, repetition INTEGER NOT NULL, seed TEXT NOT NULL, outcome TEXT "
      "NOT "
      "NULL, outcome_detail TEXT NOT NULL, trajectory_hash TEXT NOT NULL, reasons TEXT NOT NULL, "
      "standard_errors TEXT NOT NULL";
  for (const QuantityInfo& info : metrics) sql += ", \"m_" + info.id + "\" REAL";
  return sql + ", checksum INTEGER NOT NULL, UNIQUE (scenario, method, repetition))";
}

constexpr int kFixedColumns = 11;

/// Descriptors in the order in which the checksum of their scenario contains them.
constexpr const char* kDescriptorsOfScenario =
    "SELECT id, version, value, standard_error, reason FROM descriptors WHERE hash = ? ORDER BY id";
constexpr int kDescriptorColumns = 5;

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

/// Why a value is missing, by the JSON object of a row; does not trust its contents.
std::string reason_in(const Json& reasons, const std::string& id) {
  const auto found = reasons.find(id);
  const bool known = found != reasons.end() && found->is_string();
  return known ? found->get<std::string>() : kNotRecorded;
}

constexpr const char* kIntact = "an unmodified file";

void write_manifest(SQLite::Database& database, const Manifest& manifest) {
  for (const auto& [key, text] : manifest) {
    SQLite::Statement row(database, "INSERT INTO manifest VALUES (?, ?)");
    row.bind(1, key);
    row.bind(2, text);
    row.exec();
  }
}

void write_quantities(SQLite::Database& database, const std::string& kind,
                      const std::vector<QuantityInfo>& infos) {
  for (const QuantityInfo& info : infos) {
    SQLite::Statement row(database,
                          "INSERT INTO quantities (kind, id, version, name, unit, direction, "
                          "value_kind, value_range) VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    row.bind(1, kind);
    row.bind(2, info.id);
    row.bind(3, info.version);
    row.bind(4, info.name);
    row.bind(5, info.unit);
    row.bind(6, to_string(info.direction));
    row.bind(7, to_string(info.kind));
    row.bind(8, range_notation(info.range));
    row.exec();
  }
}

bool has_ranges(SQLite::Database& database) {
  return database.execAndGet("PRAGMA user_version").getInt() >= kVersionOfRanges;
}

/// Checksum of the manifest and the quantities.
std::int64_t header_checksum(SQLite::Database& database) {
  RowChecksum checksum;
  SQLite::Statement manifest(database, "SELECT key, text FROM manifest ORDER BY key");
  while (manifest.executeStep()) checksum.add_columns(manifest, 0, 2);
  SQLite::Statement quantities(database, "SELECT * FROM quantities ORDER BY position");
  const int end = has_ranges(database) ? 9 : 7;  // all but the position
  while (quantities.executeStep()) checksum.add_columns(quantities, 1, end);
  return checksum.value();
}

void write_header_checksum(SQLite::Database& database) {
  SQLite::Statement row(database, "INSERT INTO header VALUES (?)");
  row.bind(1, header_checksum(database));
  row.exec();
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
  std::unique_ptr<Transaction> transaction;  ///< open while there are uncommitted changes
  std::vector<QuantityInfo> descriptors, metrics;
  FileIdentity file;  ///< after the last commit

  /// Throws Error (Job) unless the file is as it was after the last commit.
  void expect_unchanged() const {
    std::string change = file.change(path);
    if (change.empty() && FileIdentity(path).size() != file.size())
      change = "was truncated or written by another program";
    if (!change.empty())
      throw job_error(path, change + "; " + rescue(), "a file that nobody else changes");
  }

  std::string rescue() const;

  /// Readers only delay the writer: it waits long for its lock, and keeps changes in memory while
  /// it cannot get at the file.
  void begin() {
    if (transaction) return;
    expect_unchanged();
    constexpr int kPatienceMs = 3600 * 1000;
    database->setBusyTimeout(kPatienceMs);
    database->exec("PRAGMA cache_spill = OFF");
    database->exec("PRAGMA journal_mode = DELETE");  // another one damages files on network drives
    transaction = std::make_unique<Transaction>(*database);
  }

  std::vector<QuantityInfo> read_quantities(const std::string& kind) const {
    const bool ranges = has_ranges(*database);
    std::vector<QuantityInfo> infos;
    SQLite::Statement rows(*database, "SELECT * FROM quantities WHERE kind = ? ORDER BY position");
    rows.bind(1, kind);
    while (rows.executeStep()) {
      const auto text = [&](int column) { return rows.getColumn(column).getString(); };
      QuantityInfo info{text(2), rows.getColumn(3).getInt(), text(4), text(5),
                        direction_from_string(text(6))};
      check_id(info);
      if (ranges)
        read_range(text(7), text(8), info);
      else
        for (const KnownRange& known : kRangesOfVersion3)
          if (contains(split_nonempty(known.ids, ' '), info.id))
            read_range(known.kind, known.range, info);
      infos.push_back(std::move(info));
    }
    return infos;
  }

  void read_range(const std::string& kind, const std::string& range, QuantityInfo& info) const {
    const auto known = from_name<QuantityKind>(kind);
    const auto bounds = parse_range(range);
    if (!known || !bounds)
      throw file_error(
          path, info.id + " is a '" + printable_line(kind) + "' in '" + printable_line(range) + "'",
          "one of " + join(names_of<QuantityKind>(), ", ") + ", in a range like 0..1");
    info.kind = *known;
    info.range = *bounds;
  }

  std::string insert_run_sql() const {
    std::string sql = "INSERT INTO runs VALUES (NULL";
    for (int i = 1; i <= checksum_column(); ++i) sql += ", ?";
    return sql + ")";
  }

  /// Returns the checksum of the row.
  std::int64_t insert_run(const RunRecord& run) {
    std::vector<Value> values;
    Json reasons = Json::object(), errors = Json::object();
    for (const QuantityInfo& info : metrics) {
      const auto found = run.metrics.find(info.id);
      values.push_back(found == run.metrics.end() ? Value::na(kNotComputed) : found->second.value);
      if (values.back().is_na()) reasons[info.id] = values.back().reason();
      if (values.back().standard_error()) errors[info.id] = *values.back().standard_error();
    }
    CheckedInsert row(*database, insert_run_sql());
    row.add(run.scenario_hash).add(run.scenario_name).add(run.method);
    row.add(static_cast<std::int64_t>(run.repetition)).add(std::to_string(run.seed));
    row.add(run.outcome).add(printable_line(run.outcome_detail)).add(run.trajectory_hash);
    row.add(reasons.dump(-1, ' ', false, Json::error_handler_t::replace)).add(errors.dump());
    for (const Value& value : values) value.is_na() ? row.add_null() : row.add(value.number());
    return row.exec();
  }

  void insert_timing(const std::string& hash, const ReferenceTiming& timing) {
    CheckedInsert(*database, "INSERT INTO reference_timings VALUES (?, ?, ?, ?, ?)")
        .add(hash)
        .add(timing.exact)
        .add(timing.planner)
        .add(timing.safest)
        .exec();
  }

  void insert_descriptors(const ScenarioRecord& record) {
    for (const auto& [id, versioned] : record.descriptors) {
      SQLite::Statement row(*database, "INSERT INTO descriptors VALUES (?, ?, ?, ?, ?, ?)");
      row.bind(1, record.hash);
      row.bind(2, id);
      row.bind(3, versioned.version);
      bind_value(row, 4, versioned.value);
      row.exec();
    }
  }

  void expect_intact_header() const {
    SQLite::Statement row(*database, "SELECT checksum FROM header");
    if (row.executeStep() && row.getColumn(0).getInt64() == header_checksum(*database)) return;
    throw file_error(path, "is damaged (its manifest does not match its checksum)", kIntact);
  }

  Error damaged(const std::string& what) const {
    return file_error(path + ": " + what, "is damaged (does not match its checksum)", kIntact);
  }

  /// Throws Error (File) unless the last of `columns` columns is the checksum of the key and the
  /// other columns.
  template <typename Key>
  void expect_intact(SQLite::Statement& row, const Key& key, int columns,
                     const std::string& what) const {
    const std::int64_t checksum = RowChecksum().add(key).add_columns(row, 0, columns - 1).value();
    if (checksum != row.getColumn(columns - 1).getInt64()) throw damaged(what);
  }

  int checksum_column() const { return kFixedColumns + static_cast<int>(metrics.size()); }

  bool is_intact_run(SQLite::Statement& row) const {
    return RowChecksum().add_columns(row, 1, checksum_column()).value() ==
           row.getColumn(checksum_column()).getInt64();
  }

  /// "hash8/method/repetition" of a row that may be damaged.
  static std::string id_of_row(SQLite::Statement& row) {
    RunRecord run;
    run.scenario_hash = row.getColumn(1).getString();
    run.method = row.getColumn(3).getString();
    run.repetition = row.getColumn(4).getInt();
    return run_id(run);
  }

  Manifest read_manifest() const {
    Manifest manifest;
    SQLite::Statement rows(*database, "SELECT key, text FROM manifest");
    while (rows.executeStep())
      manifest[rows.getColumn(0).getString()] = rows.getColumn(1).getString();
    return manifest;
  }

  RunRecord run_from(SQLite::Statement& row) const {
    if (!is_intact_run(row)) throw damaged("run " + id_of_row(row));
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
      Value value = column.isNull()         ? Value::na(reason_in(reasons, id))
                    : error == errors.end() ? Value::of(column.getDouble())
                                            : Value::of(column.getDouble(), error->second);
      run.metrics[id] = {metrics[i].version, std::move(value)};
    }
    return run;
  }

  template <typename Use>
  void use_run(SQLite::Statement& row, const DamageHandler& report, Use use) const {
    if (report && !is_intact_run(row))
      report("run " + id_of_row(row));
    else
      use(run_from(row));
  }

  ReferenceTiming read_timing(const std::string& hash) const {
    SQLite::Statement row(*database, "SELECT * FROM reference_timings WHERE hash = ?");
    row.bind(1, hash);
    if (!row.executeStep()) return {};
    if (RowChecksum().add_columns(row, 0, 4).value() != row.getColumn(4).getInt64())
      throw damaged("wall-clock figures of scenario " + hash);
    return {row.getColumn(1).getDouble(), row.getColumn(2).getDouble(),
            row.getColumn(3).getDouble()};
  }

  /// A blob of a scenario by its column. Throws Error (File) when it is damaged or does not exist.
  std::string read_blob(const std::string& column, const std::string& hash,
                        const std::string& what) const {
    SQLite::Statement row(
        *database, "SELECT " + column + ", " + column + "_checksum FROM scenarios WHERE hash = ?");
    row.bind(1, hash);
    if (!row.executeStep()) throw file_error(path, "contains no entry for " + hash);
    expect_intact(row, hash, 2, what);
    return row.getColumn(0).getString();
  }

  /// Calls `use` with a row of `table` that belongs to the run, if there is one. Its last column is
  /// the checksum, which begins with that of the run.
  template <typename Use>
  bool with_row_of(const RunRecord& run, const std::string& table, const std::string& columns,
                   int count, Use use) const {
    SQLite::Statement row(*database, "SELECT " + columns + ", " + table +
                                         ".checksum, runs.checksum FROM " + table +
                                         " JOIN runs USING (run) "
                                         "WHERE scenario = ? AND method = ? AND repetition = ?");
    row.bind(1, run.scenario_hash);
    row.bind(2, run.method);
    row.bind(3, run.repetition);
    if (!row.executeStep()) return false;
    expect_intact(row, static_cast<std::int64_t>(row.getColumn(count + 1).getInt64()), count + 1,
                  table + " of run " + run_id(run));
    use(row);
    return true;
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
  impl->database = create_database(path, kResults, [&](SQLite::Database& database) {
    database.exec(runs_schema(metrics));
    write_manifest(database, manifest);
    write_quantities(database, "descriptor", descriptors);
    write_quantities(database, "metric", metrics);
    write_header_checksum(database);
  });
  impl->file = FileIdentity(path);
  return ResultFile(std::move(impl));
}

bool ResultFile::exists(const std::string& path) {
  return !is_new_database(path);
}

ResultFile ResultFile::open(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw file_error(path, "is a folder", "one result file, as slalom-simulate merge makes of it");
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->database = open_database(path, kResults);
  reading(path, [&] {
    impl->expect_intact_header();
    impl->descriptors = impl->read_quantities("descriptor");
    impl->metrics = impl->read_quantities("metric");
  });
  impl->file = FileIdentity(path);
  return ResultFile(std::move(impl));
}

void ResultFile::add_scenario(const ScenarioRecord& record, const Scenario& scenario,
                              const References& references) {
  writing(impl_->path, [&] {
    impl_->begin();
    const std::string content = serialize(scenario), refs = compress(to_bytes(references));
    impl_->insert_descriptors(record);
    RowChecksum checksum;
    checksum.add(record.hash).add(record.name);
    SQLite::Statement descriptors(*impl_->database, kDescriptorsOfScenario);
    descriptors.bind(1, record.hash);
    while (descriptors.executeStep()) checksum.add_columns(descriptors, 0, kDescriptorColumns);
    SQLite::Statement row(*impl_->database, "INSERT INTO scenarios VALUES (?, ?, ?, ?, ?, ?, ?)");
    row.bind(1, record.hash);
    row.bind(2, record.name);
    row.bind(3, checksum.value());
    row.bind(4, RowChecksum().add(record.hash).add(content).value());
    row.bind(5, RowChecksum().add(record.hash).add(refs).value());
    row.bind(6, content.data(), static_cast<int>(content.size()));
    row.bind(7, refs.data(), static_cast<int>(refs.size()));
    row.exec();
    impl_->insert_timing(record.hash, references.timing);
  });
}

void ResultFile::add_run(const RunRecord& run, const RunTiming& timing,
                         const Trajectory& trajectory) {
  writing(impl_->path, [&] {
    impl_->begin();
    const std::int64_t checksum = impl_->insert_run(run);
    const std::int64_t id = impl_->database->getLastInsertRowid();
    CheckedInsert(*impl_->database, "INSERT INTO trajectories VALUES (?, ?, ?)", checksum)
        .add_key(id)
        .add_blob(compress(to_bytes(trajectory)))
        .exec();
    CheckedInsert(*impl_->database, "INSERT INTO run_timings VALUES (?, ?, ?, ?)", checksum)
        .add_key(id)
        .add(timing.wall_seconds)
        .add(Json(timing.values).dump(-1, ' ', false, Json::error_handler_t::replace))
        .exec();
    if (timing.output.empty()) return;
    impl_->database->exec(kRunOutputs);
    CheckedInsert(*impl_->database, "INSERT INTO run_outputs VALUES (?, ?, ?)", checksum)
        .add_key(id)
        .add_blob(timing.output)
        .exec();
  });
}

bool ResultFile::commit(double patience) {
  if (!impl_->transaction) return true;
  impl_->expect_unchanged();
  impl_->database->setBusyTimeout(static_cast<int>(1000 * patience));
  try {
    impl_->transaction->commit();
  } catch (const SQLite::Exception& e) {
    if (e.getErrorCode() == SQLITE_BUSY) return false;  // the transaction goes on
    throw_write_error(impl_->path, e);
  }
  impl_->transaction.reset();
  impl_->file = FileIdentity(impl_->path);
  return true;
}

std::string ResultFile::Impl::rescue() const {
  const std::string copy = path + ".rescued";
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> content(
      sqlite3_serialize(database->getHandle(), "main", &size, 0), sqlite3_free);
  try {
    if (content == nullptr) throw std::bad_alloc();
    write_file_atomically(
        copy, {reinterpret_cast<const char*>(content.get()), static_cast<std::size_t>(size)});
    std::size_t runs = 0;
    ResultFile::open(copy).for_each_run([&](const RunRecord&) { ++runs; });
    return std::to_string(runs) + (runs == 1 ? " run is" : " runs are") + " kept in " + copy;
  } catch (const std::exception& e) {
    std::error_code ignored;
    std::filesystem::remove(copy, ignored);
    return std::string("its runs cannot be kept (") + reason_of(e) + ")";
  }
}

std::string ResultFile::rescue() const {
  return impl_->rescue();
}

void ResultFile::expect_runs(std::size_t count) const {
  impl_->expect_unchanged();
  const auto stored = reading(impl_->path, [&] {
    return open_reader(impl_->path)->execAndGet("SELECT count(*) FROM runs").getInt64();
  });
  if (static_cast<std::size_t>(stored) != count)
    throw job_error(impl_->path, "contains " + std::to_string(stored) + " runs; " + rescue(),
                    std::to_string(count) + " runs");
}

Manifest ResultFile::read_manifest() const {
  return reading(impl_->path, [&] { return impl_->read_manifest(); });
}

void ResultFile::replace_manifest(const Manifest& manifest) {
  writing(impl_->path, [&] {
    impl_->begin();
    impl_->database->exec("DELETE FROM manifest; DELETE FROM header");
    write_manifest(*impl_->database, manifest);
    write_header_checksum(*impl_->database);
  });
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

std::map<std::string, std::string> ResultFile::read_scenario_names() const {
  return reading(impl_->path, [&] {
    std::map<std::string, std::string> names;
    SQLite::Statement rows(*impl_->database, "SELECT hash, name FROM scenarios");
    while (rows.executeStep()) names[rows.getColumn(0).getString()] = rows.getColumn(1).getString();
    return names;
  });
}

void ResultFile::for_each_key(const std::function<void(const std::string&, const std::string&, int,
                                                       const std::string&)>& use) const {
  reading(impl_->path, [&] {
    SQLite::Statement rows(*impl_->database,
                           "SELECT scenario, method, repetition, outcome FROM runs");
    while (rows.executeStep())
      use(rows.getColumn(0).getString(), rows.getColumn(1).getString(), rows.getColumn(2).getInt(),
          rows.getColumn(3).getString());
  });
}

void ResultFile::for_each_run(const std::function<void(const RunRecord&)>& use,
                              const DamageHandler& report) const {
  reading(impl_->path, [&] {
    const ReadTransaction scope(*impl_->database);
    SQLite::Statement rows(*impl_->database,
                           "SELECT * FROM runs ORDER BY scenario_name, scenario, method, "
                           "repetition");
    std::int64_t count = 0;
    for (; rows.executeStep(); ++count) impl_->use_run(rows, report, use);
    expect_count_of_runs(*impl_->database, impl_->path, count);
  });
}

std::vector<RunRecord> ResultFile::read_runs(const std::string& scenario_hash,
                                             const DamageHandler& report) const {
  return reading(impl_->path, [&] {
    std::vector<RunRecord> runs;
    SQLite::Statement rows(*impl_->database,
                           "SELECT * FROM runs WHERE scenario = ? ORDER BY method, repetition");
    rows.bind(1, scenario_hash);
    while (rows.executeStep())
      impl_->use_run(rows, report, [&](RunRecord run) { runs.push_back(std::move(run)); });
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
  return reading(impl_->path, [&] {
    RunTiming timing;
    impl_->with_row_of(run, "run_timings", "wall_seconds, figures", 2, [&](SQLite::Statement& row) {
      timing = {row.getColumn(0).getDouble(),
                numbers_from_json(row.getColumn(1).getString(), impl_->path)};
    });
    if (has_run_outputs(*impl_->database, "main"))
      impl_->with_row_of(run, "run_outputs", "content", 1, [&](SQLite::Statement& row) {
        timing.output = row.getColumn(0).getString();
      });
    return timing;
  });
}

ScenarioRecord ResultFile::read_record(const std::string& scenario_hash) const {
  return reading(impl_->path, [&] {
    ScenarioRecord record{scenario_hash, "", {}};
    SQLite::Statement row(*impl_->database,
                          "SELECT hash, name, checksum FROM scenarios WHERE hash = ?");
    row.bind(1, scenario_hash);
    if (!row.executeStep()) return record;
    record.name = row.getColumn(1).getString();
    RowChecksum checksum;
    checksum.add_columns(row, 0, 2);
    SQLite::Statement values(*impl_->database, kDescriptorsOfScenario);
    values.bind(1, scenario_hash);
    while (values.executeStep()) {
      checksum.add_columns(values, 0, kDescriptorColumns);
      record.descriptors[values.getColumn(0).getString()] = {values.getColumn(1).getInt(),
                                                             value_from_columns(values, 2)};
    }
    if (checksum.value() != row.getColumn(2).getInt64())
      throw impl_->damaged("scenario " + scenario_hash);
    return record;
  });
}

Scenario ResultFile::read_scenario(const std::string& hash) const {
  const std::string what = "scenario " + hash;
  return deserialize_scenario(
      reading(impl_->path, [&] { return impl_->read_blob("content", hash, what); }),
      impl_->path + ": " + what);
}

References ResultFile::read_references(const std::string& hash) const {
  const std::string what = "references of " + hash, where = impl_->path + ": " + what;
  const std::string content =
      reading(impl_->path, [&] { return impl_->read_blob("refs", hash, what); });
  References references = references_from_bytes(decompress(content, where), where);
  references.timing = reading(impl_->path, [&] { return impl_->read_timing(hash); });
  return references;
}

Trajectory ResultFile::read_trajectory(const RunRecord& run) const {
  const std::string where = impl_->path + ": run " + run_id(run);
  const std::string content = reading(impl_->path, [&] {
    std::string bytes;
    const bool found =
        impl_->with_row_of(run, "trajectories", "content", 1,
                           [&](SQLite::Statement& row) { bytes = row.getColumn(0).getString(); });
    if (!found) throw file_error(where, "has no trajectory");
    return bytes;
  });
  return trajectory_from_bytes(decompress(content, where), where);
}

}  // namespace slalom
