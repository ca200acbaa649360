// SPDX-License-Identifier: BSD-3-Clause
#include "checked_row.h"
#include "compression.h"
#include "result_file_impl.h"
#include "result_schema.h"
#include "value_columns.h"

#include <slalom/core/error.h>
#include <slalom/core/expect_text.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/io/imported_table.h>
#include <slalom/io/scenario_list.h>
#include <slalom/references/reference_codec.h>

#include <filesystem>
#include <limits>

namespace slalom {
namespace {

constexpr const char* kIntact = "an unmodified file";

Error damaged(const OpenResultFile& file, const std::string& what) {
  return file_error(file.path + ": " + what, "is damaged (does not match its checksum)", kIntact);
}

/// Whether the last column is the checksum of those from `begin` on. Rows that belong to a run
/// begin with the checksum of that run.
bool is_intact(SQLite::Statement& row, int begin = 0) {
  const int last = row.getColumnCount() - 1;
  return RowChecksum().add_columns(row, begin, last).value() == row.getColumn(last).getInt64();
}

/// Reads the only row, if there is one. Throws Error (File) unless it is intact.
bool read_intact(SQLite::Statement& row, const OpenResultFile& file, const std::string& what) {
  if (!row.executeStep()) return false;
  if (!is_intact(row)) throw damaged(file, what);
  return true;
}

void expect_intact_header(const OpenResultFile& file) {
  SQLite::Statement row = file.select("checksum FROM header");
  if (row.executeStep() && row.getColumn(0).getInt64() == header_checksum(*file.database)) return;
  throw file_error(file.path, "is damaged (its manifest does not match its checksum)", kIntact);
}

void set_range(QuantityInfo& info, const std::string& kind, const std::string& range,
               const std::string& path) {
  const auto known = from_name<QuantityKind>(kind);
  const auto bounds = parse_range(range);
  if (!known || !bounds)
    throw file_error(
        path, info.id + " is a '" + printable_line(kind) + "' in '" + printable_line(range) + "'",
        "one of " + join(names_of<QuantityKind>(), ", ") + ", in a range like 0..1");
  info.kind = *known;
  info.range = *bounds;
}

std::vector<QuantityInfo> read_quantities(const OpenResultFile& file, const std::string& kind) {
  const bool ranges = states_ranges(*file.database);
  std::vector<QuantityInfo> infos;
  SQLite::Statement row = file.select(
      quantity_columns(*file.database) + " FROM quantities WHERE kind = ? ORDER BY position", kind);
  const auto text = [&](const char* column) { return row.getColumn(column).getString(); };
  while (row.executeStep()) {
    QuantityInfo info{text("id"), row.getColumn("version").getInt(), text("name"), text("unit"),
                      from_name<Direction>(text("direction")).value_or(Direction::None)};
    expect_name(info.id, "a metric");
    const auto [value_kind, range] =
        ranges ? std::pair(text("value_kind"), text("value_range")) : unstated_range(info.id);
    set_range(info, value_kind, range, file.path);
    infos.push_back(std::move(info));
  }
  return infos;
}

/// The texts of two columns.
std::map<std::string, std::string> read_texts(const OpenResultFile& file, const std::string& sql) {
  return reading(file.path, [&] {
    std::map<std::string, std::string> texts;
    SQLite::Statement rows = file.select(sql);
    while (rows.executeStep()) texts[rows.getColumn(0).getString()] = rows.getColumn(1).getString();
    return texts;
  });
}

std::map<std::string, double> numbers_in(const std::string& text, const std::string& path) {
  const nlohmann::json json = object_in(text, path);
  std::map<std::string, double> numbers;
  for (const auto& [key, value] : json.items())
    if (value.is_number()) numbers[key] = value.get<double>();
  return numbers;
}

/// Whether three values of a row, which a forger may have written, are the key of a run: SQLite
/// converts values of other types when they are read, and finds them by other keys.
bool is_key(SQLite::Statement& row, int scenario, int method, int repetition) {
  const SQLite::Column number = row.getColumn(repetition);
  return row.getColumn(scenario).isText() && row.getColumn(method).isText() && number.isInteger() &&
         number.getInt64() >= 0 && number.getInt64() <= std::numeric_limits<int>::max();
}

/// A run without its metrics, of a row that may be damaged.
RunRecord run_without_metrics(SQLite::Statement& row) {
  const auto text = [&](int column) { return row.getColumn(column).getString(); };
  RunRecord run;
  run.scenario_hash = text(RunColumn::Scenario);
  run.scenario_name = text(RunColumn::ScenarioName);
  run.method = text(RunColumn::Method);
  run.repetition = row.getColumn(RunColumn::Repetition).getInt();
  run.seed = std::strtoull(text(RunColumn::Seed).c_str(), nullptr, 10);
  run.outcome = text(RunColumn::Outcome);
  run.outcome_detail = text(RunColumn::OutcomeDetail);
  run.trajectory_hash = text(RunColumn::TrajectoryHash);
  return run;
}

void read_metrics(SQLite::Statement& row, const OpenResultFile& file, RunRecord& run) {
  const auto reasons = object_in(row.getColumn(RunColumn::Reasons).getString(), file.path);
  const auto errors = numbers_in(row.getColumn(RunColumn::StandardErrors).getString(), file.path);
  int index = RunColumn::FirstMetric;
  for (const QuantityInfo& info : file.metrics) {
    const SQLite::Column column = row.getColumn(index++);
    const auto error = errors.find(info.id);
    Value value = column.isNull()         ? Value::na(reason_in(reasons, info.id))
                  : error == errors.end() ? Value::of(column.getDouble())
                                          : Value::of(column.getDouble(), error->second);
    run.metrics[info.id] = {info.version, std::move(value)};
  }
}

/// Calls `use` with each run; for damaged ones `report`, if there is one. Returns their number.
template <typename Use, typename... Keys>
std::int64_t use_runs(const OpenResultFile& file, const DamageHandler& report, Use use,
                      const std::string& which, const Keys&... keys) {
  std::int64_t count = 0;
  for (auto row = bound(*file.database, select_runs(file.metrics, which), keys...);
       row.executeStep(); ++count) {
    RunRecord run = run_without_metrics(row);
    if (is_intact(row, RunColumn::Scenario) &&
        is_key(row, RunColumn::Scenario, RunColumn::Method, RunColumn::Repetition)) {
      expect_name(run.method, "a method");
      expect_name(run.scenario_name, "a scenario");
      read_metrics(row, file, run);
      use(std::move(run));
    } else if (report) {
      report("run " + run_id(run));
    } else {
      throw damaged(file, "run " + run_id(run));
    }
  }
  return count;
}

/// Calls `use` with the row of `table` that belongs to the run, if there is one; `columns` begin
/// with number 1.
template <typename Use>
bool use_row_of(const RunRecord& run, const OpenResultFile& file, const std::string& table,
                const std::string& columns, Use use) {
  SQLite::Statement row =
      file.select("runs.checksum, " + columns + ", " + table + ".checksum FROM " + table +
                      " JOIN runs USING (run) WHERE scenario = ? AND method = ? AND repetition = ?",
                  run.scenario_hash, run.method, run.repetition);
  const bool found = read_intact(row, file, table + " of run " + run_id(run));
  if (found) use(row);
  return found;
}

/// A blob of a scenario by its column. Throws Error (File) when it is damaged or does not exist.
std::string read_blob(const OpenResultFile& file, const std::string& column,
                      const std::string& hash, const std::string& what) {
  SQLite::Statement row = file.select(
      "hash, " + column + ", " + column + "_checksum FROM scenarios WHERE hash = ?", hash);
  if (!read_intact(row, file, what)) throw file_error(file.path, "contains no entry for " + hash);
  return row.getColumn(1).getString();
}

ReferenceTiming read_reference_timing(const OpenResultFile& file, const std::string& hash) {
  SQLite::Statement row = file.select(
      "hash, exact_seconds, planner_seconds, safest_seconds, checksum FROM reference_timings "
      "WHERE hash = ?",
      hash);
  if (!read_intact(row, file, "wall-clock figures of scenario " + hash)) return {};
  return {row.getColumn(1).getDouble(), row.getColumn(2).getDouble(), row.getColumn(3).getDouble()};
}

}  // namespace

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

bool ResultFile::exists(const std::string& path) {
  return !is_new_database(path);
}

ResultFile ResultFile::open(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw file_error(path, "is a folder", "one result file, as slalom-simulate merge makes of it");
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->database = open_database(path, kResultFile);
  reading(path, [&] {
    const ReadTransaction scope(*impl->database);
    expect_intact_header(*impl);
    impl->descriptors = read_quantities(*impl, "descriptor");
    impl->metrics = read_quantities(*impl, "metric");
  });
  impl->file = FileIdentity(path);
  return ResultFile(std::move(impl));
}

Manifest ResultFile::read_manifest() const {
  return read_texts(*impl_, "key, text FROM manifest");
}

std::map<std::string, std::string> ResultFile::read_scenario_names() const {
  return read_texts(*impl_, "hash, name FROM scenarios");
}

std::vector<std::string> ResultFile::read_methods() const {
  return reading(impl_->path, [&] {
    std::vector<std::string> methods;
    SQLite::Statement rows = impl_->select("DISTINCT method FROM runs ORDER BY method");
    while (rows.executeStep()) methods.push_back(rows.getColumn(0).getString());
    return methods;
  });
}

bool ResultFile::has_scenario(const std::string& hash) const {
  return reading(impl_->path, [&] {
    return impl_->select("1 FROM scenarios WHERE hash = ?", hash).executeStep();
  });
}

void ResultFile::for_each_key(const std::function<void(const std::string&, const std::string&, int,
                                                       const std::string&)>& use) const {
  reading(impl_->path, [&] {
    SQLite::Statement rows = impl_->select("scenario, method, repetition, outcome FROM runs");
    while (rows.executeStep()) {
      const std::string hash = rows.getColumn(0).getString(),
                        method = rows.getColumn(1).getString();
      if (!is_key(rows, 0, 1, 2))
        throw damaged(*impl_, "run " + hash.substr(0, 8) + "/" + method + "/" +
                                  rows.getColumn(2).getString());
      use(hash, method, rows.getColumn(2).getInt(), rows.getColumn(3).getString());
    }
  });
}

void ResultFile::for_each_run(const std::function<void(const RunRecord&)>& use,
                              const DamageHandler& report) const {
  reading(impl_->path, [&] {
    const ReadTransaction scope(*impl_->database);
    const std::int64_t count =
        use_runs(*impl_, report, use, "ORDER BY scenario_name, scenario, method, repetition");
    expect_count_of_runs(*impl_->database, impl_->path, count);
  });
}

std::vector<RunRecord> ResultFile::read_runs(const std::string& scenario_hash,
                                             const DamageHandler& report) const {
  return reading(impl_->path, [&] {
    std::vector<RunRecord> runs;
    use_runs(
        *impl_, report, [&](RunRecord run) { runs.push_back(std::move(run)); },
        "WHERE scenario = ? ORDER BY method, repetition", scenario_hash);
    return runs;
  });
}

std::optional<RunRecord> ResultFile::read_run(const std::string& scenario_hash,
                                              const std::string& method, int repetition) const {
  return reading(impl_->path, [&] {
    std::optional<RunRecord> found;
    use_runs(
        *impl_, {}, [&](RunRecord run) { found = std::move(run); },
        "WHERE scenario = ? AND method = ? AND repetition = ?", scenario_hash, method, repetition);
    return found;
  });
}

RunTiming ResultFile::read_timing(const RunRecord& run) const {
  return reading(impl_->path, [&] {
    RunTiming timing;
    use_row_of(run, *impl_, "run_timings", "wall_seconds, figures", [&](SQLite::Statement& row) {
      timing = {row.getColumn(1).getDouble(),
                numbers_in(row.getColumn(2).getString(), impl_->path)};
    });
    if (has_table(*impl_->database, "run_outputs"))
      use_row_of(run, *impl_, "run_outputs", "content",
                 [&](SQLite::Statement& row) { timing.output = row.getColumn(1).getString(); });
    return timing;
  });
}

ScenarioRecord ResultFile::read_record(const std::string& scenario_hash) const {
  return reading(impl_->path, [&] {
    ScenarioRecord record{scenario_hash, "", {}};
    SQLite::Statement row =
        impl_->select("hash, name, checksum FROM scenarios WHERE hash = ?", scenario_hash);
    if (!row.executeStep()) return record;
    record.name = row.getColumn(1).getString();
    RowChecksum checksum;
    checksum.add_columns(row, 0, 2);
    SQLite::Statement values = bound(*impl_->database, kSelectDescriptors, scenario_hash);
    while (values.executeStep()) {
      checksum.add_columns(values, 0, values.getColumnCount());
      record.descriptors[values.getColumn(0).getString()] = {values.getColumn(1).getInt(),
                                                             value_from_columns(values, 2)};
    }
    if (checksum.value() != row.getColumn(2).getInt64())
      throw damaged(*impl_, "scenario " + scenario_hash);
    return record;
  });
}

Scenario ResultFile::read_scenario(const std::string& hash) const {
  const std::string what = "scenario " + hash;
  return reading(impl_->path, [&] {
    const std::string content = read_blob(*impl_, "content", hash, what);
    if (content.empty()) expect_scenarios(read_manifest(), impl_->path);
    return deserialize_scenario(content, impl_->path + ": " + what);
  });
}

References ResultFile::read_references(const std::string& hash) const {
  const std::string what = "references of " + hash, where = impl_->path + ": " + what;
  return reading(impl_->path, [&] {
    PackedScenario packed;
    packed.refs = read_blob(*impl_, "refs", hash, what);
    if (packed.refs.empty()) expect_scenarios(read_manifest(), impl_->path);
    References references = packed.unpack_references(where);
    references.timing = read_reference_timing(*impl_, hash);
    return references;
  });
}

Trajectory ResultFile::read_trajectory(const RunRecord& run) const {
  const std::string where = impl_->path + ": run " + run_id(run);
  return reading(impl_->path, [&] {
    std::string content;
    const bool found =
        use_row_of(run, *impl_, "trajectories", "content",
                   [&](SQLite::Statement& row) { content = row.getColumn(1).getString(); });
    if (!found) throw file_error(where, "has no trajectory");
    Trajectory trajectory = PackedTrajectory::of_bytes(content).unpack(where);
    if (!trajectory.samples.empty() && !run.trajectory_hash.empty() &&
        trajectory.hash() != run.trajectory_hash)
      throw file_error(where, "its trajectory does not have the hash that the run states", kIntact);
    return trajectory;
  });
}

}  // namespace slalom
