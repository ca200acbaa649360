// SPDX-License-Identifier: BSD-3-Clause
#include "checked_row.h"
#include "result_file_impl.h"
#include "result_schema.h"
#include "value_columns.h"

#include <slalom/core/error.h>
#include <slalom/core/expect_text.h>
#include <slalom/core/printable.h>

#include <filesystem>
#include <sqlite3.h>

namespace slalom {
namespace {

using Json = nlohmann::json;

/// The text of a JSON column.
std::string json_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

template <typename... Values>
void insert(SQLite::Database& database, const std::string& table, const std::string& columns,
            const Values&... values) {
  bound(database, insert_sql(table, columns), values...).exec();
}

void insert_manifest(SQLite::Database& database, const Manifest& manifest) {
  for (const auto& [key, text] : manifest) insert(database, "manifest", "key, text", key, text);
}

void insert_header_checksum(SQLite::Database& database) {
  insert(database, "header", "checksum", header_checksum(database));
}

void insert_quantities(SQLite::Database& database, const std::string& kind,
                       const std::vector<QuantityInfo>& infos) {
  for (const QuantityInfo& info : infos)
    insert(database, "quantities",
           "kind, id, version, name, unit, direction, value_kind, value_range", kind, info.id,
           info.version, info.name, info.unit, to_string(info.direction), to_string(info.kind),
           range_notation(info.range));
}

/// Returns the checksum of the row.
std::int64_t insert_run(SQLite::Statement& insert, const RunRecord& run,
                        const std::vector<QuantityInfo>& metrics) {
  std::vector<Value> values;
  Json reasons = Json::object(), errors = Json::object();
  for (const QuantityInfo& info : metrics) {
    const auto found = run.metrics.find(info.id);
    values.push_back(found == run.metrics.end() ? Value::na(kNotComputed) : found->second.value);
    if (values.back().is_na()) reasons[info.id] = values.back().reason();
    if (values.back().standard_error()) errors[info.id] = *values.back().standard_error();
  }
  CheckedInsert row(insert);
  row.add(run.scenario_hash, run.scenario_name, run.method, std::int64_t{run.repetition},
          std::to_string(run.seed), run.outcome, printable_line(run.outcome_detail),
          run.trajectory_hash, json_text(reasons), json_text(errors));
  for (const Value& value : values) row.add(value);
  return row.exec();
}

}  // namespace

void ResultFile::Impl::expect_unchanged() const {
  std::string change = file.change(path);
  if (change.empty() && FileIdentity(path).size() != file.size())
    change = "was truncated or written by another program";
  if (!change.empty())
    throw job_error(path, change + "; " + rescue(), "a file that nobody else changes");
}

/// Readers only delay the writer: it waits long for its lock, and keeps changes in memory while it
/// cannot get at the file.
void ResultFile::Impl::begin() {
  if (transaction) return;
  expect_unchanged();
  constexpr int kPatienceMs = 3600 * 1000;
  database->setBusyTimeout(kPatienceMs);
  database->exec("PRAGMA cache_spill = OFF");
  database->exec("PRAGMA journal_mode = DELETE");  // another one damages files on network drives
  transaction = std::make_unique<Transaction>(*database);
}

SQLite::Statement& ResultFile::Impl::insert_into(const std::string& table,
                                                 const std::string& columns) {
  const auto known = inserts.find(table);
  if (known != inserts.end()) return known->second;
  return inserts.try_emplace(table, *database, insert_sql(table, columns)).first->second;
}

ResultFile ResultFile::create(const std::string& path, const Manifest& manifest,
                              const std::vector<QuantityInfo>& descriptors,
                              const std::vector<QuantityInfo>& metrics) {
  for (const QuantityInfo& info : metrics) expect_name(info.id, "a metric");
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->descriptors = descriptors;
  impl->metrics = metrics;
  impl->database = create_database(path, kResultFile, [&](SQLite::Database& database) {
    database.exec(create_runs(metrics));
    insert_manifest(database, manifest);
    insert_quantities(database, "descriptor", descriptors);
    insert_quantities(database, "metric", metrics);
    insert_header_checksum(database);
  });
  impl->file = FileIdentity(path);
  return ResultFile(std::move(impl));
}

void ResultFile::add_scenario(const ScenarioRecord& record, const PackedScenario& packed,
                              const ReferenceTiming& timing) {
  writing(impl_->path, [&] {
    impl_->begin();
    RowChecksum checksum;
    checksum.add(record.hash).add(record.name);
    SQLite::Statement& descriptor =
        impl_->insert_into("descriptors", "hash, id, version, value, standard_error, reason");
    for (const auto& [id, versioned] : record.descriptors) {
      const StatementUse row(descriptor);
      SQLite::bind(*row, record.hash, id, versioned.version);
      bind_value(*row, 4, versioned.value);
      row->exec();
      checksum.add(id).add(std::int64_t{versioned.version}).add(versioned.value);
    }
    const StatementUse row(impl_->insert_into(
        "scenarios", "hash, name, checksum, content_checksum, refs_checksum, content, refs"));
    SQLite::bind(*row, record.hash, record.name, checksum.value(),
                 RowChecksum().add(record.hash).add(packed.content).value(),
                 RowChecksum().add(record.hash).add(packed.refs).value());
    row->bindNoCopy(6, packed.content.data(), static_cast<int>(packed.content.size()));
    row->bindNoCopy(7, packed.refs.data(), static_cast<int>(packed.refs.size()));
    row->exec();
    CheckedInsert(
        impl_->insert_into("reference_timings",
                           "hash, exact_seconds, planner_seconds, safest_seconds, checksum"))
        .add(record.hash, timing.exact, timing.planner, timing.safest)
        .exec();
  });
}

std::int64_t ResultFile::Impl::add(const RunRecord& run) {
  begin();
  if (columns_of_runs.empty()) columns_of_runs = run_columns(metrics) + ", checksum";
  return insert_run(insert_into("runs", columns_of_runs), run, metrics);
}

void ResultFile::add_run(const RunRecord& run) {
  writing(impl_->path, [&] { impl_->add(run); });
}

void ResultFile::add_run(const RunRecord& run, const RunTiming& timing,
                         const PackedTrajectory& trajectory) {
  writing(impl_->path, [&] {
    const std::int64_t checksum = impl_->add(run);
    const std::int64_t id = impl_->database->getLastInsertRowid();
    CheckedInsert(impl_->insert_into("trajectories", "run, content, checksum"), id, checksum)
        .add(Blob{trajectory.bytes()})
        .exec();
    CheckedInsert(impl_->insert_into("run_timings", "run, wall_seconds, figures, checksum"), id,
                  checksum)
        .add(timing.wall_seconds, json_text(timing.values))
        .exec();
    if (timing.output.empty()) return;
    impl_->database->exec(kCreateRunOutputs);
    CheckedInsert(impl_->insert_into("run_outputs", "run, content, checksum"), id, checksum)
        .add(Blob{timing.output})
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

void ResultFile::replace_manifest(const Manifest& manifest) {
  writing(impl_->path, [&] {
    impl_->begin();
    impl_->database->exec("DELETE FROM manifest; DELETE FROM header");
    insert_manifest(*impl_->database, manifest);
    insert_header_checksum(*impl_->database);
  });
}

}  // namespace slalom
