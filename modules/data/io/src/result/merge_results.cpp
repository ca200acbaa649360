// SPDX-License-Identifier: BSD-3-Clause
#include "compression.h"
#include "database.h"
#include "result_schema.h"
#include "sibling_temp_file.h"
#include "unequal.h"

#include <slalom/core/text.h>
#include <slalom/io/bundle.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/io/merge_results.h>
#include <slalom/io/result_file.h>
#include <slalom/results/repeatability.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sqlite3.h>

namespace slalom {
namespace {

std::vector<std::string> columns_of(SQLite::Database& database, const std::string& table) {
  std::vector<std::string> columns;
  auto rows = bound(database, "SELECT name FROM pragma_table_info(?)", table);
  while (rows.executeStep()) columns.push_back('"' + rows.getColumn(0).getString() + '"');
  return columns;
}

std::int64_t count(SQLite::Database& database, const std::string& table) {
  return database.execAndGet("SELECT count(*) FROM " + table).getInt64();
}

bool is_shard(const std::string& path) {
  try {
    return ResultFile::open(path).read_manifest().count(kShardKey) > 0;
  } catch (const Error&) {
    return true;  // it may be one: it is not left out silently
  }
}

/// An attached file, detached at the end.
class Attached {
 public:
  Attached(SQLite::Database& database, const std::string& path) : database_(database) {
    bound(database_, "ATTACH ? AS part", path).exec();
    distrust(database_, path, "part");
  }
  ~Attached() {
    database_.tryExec("ROLLBACK");  // fails unless an error interrupted the transaction
    database_.tryExec("DETACH part");
  }
  Attached(const Attached&) = delete;
  Attached& operator=(const Attached&) = delete;

 private:
  SQLite::Database& database_;
};

}  // namespace

std::vector<std::string> campaign_files(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().extension() == ".results") files.push_back(entry->path().string());
  if (error) throw file_error(folder, "cannot be read (" + error.message() + ")", "a folder");
  std::sort(files.begin(), files.end());
  const auto wholes = std::stable_partition(files.begin(), files.end(), is_shard);
  if (wholes != files.begin()) files.erase(wholes, files.end());
  return files;
}

ResultCounts count_results(const std::string& path) {
  ResultCounts counts;
  counts.manifest = ResultFile::open(path).read_manifest();
  reading(path, [&] {
    const auto database = open_reader(path);
    SQLite::Statement rows(*database, "SELECT outcome, count(*) FROM runs GROUP BY outcome");
    while (rows.executeStep()) {
      const auto runs = static_cast<std::size_t>(rows.getColumn(1).getInt64());
      counts.outcomes[rows.getColumn(0).getString()] = runs;
      counts.runs += runs;
    }
    counts.wall_seconds =
        database->execAndGet("SELECT total(wall_seconds) FROM run_timings").getDouble();
  });
  return counts;
}

struct MergedResults::Impl {
  /// Columns to compare of a row that several files contain, and the name of the row in a message.
  struct Table {
    std::string name, keys, label;
    std::vector<std::string> compared;  ///< none: wall-clock time, that of the first file is kept
  };

  explicit Impl(const std::string& output) : path(output), draft(output) {}

  std::string path;
  SiblingTempFile draft;
  Manifest manifest;
  std::unique_ptr<SQLite::Database> database;
  std::vector<Table> tables;
  std::size_t runs = 0, duplicates = 0;

  void open() {
    database = std::make_unique<SQLite::Database>(draft.name(), SQLite::OPEN_READWRITE);
    // The draft is private, so it need not be durable before it is published.
    database->exec("PRAGMA journal_mode = OFF");
    database->exec("PRAGMA synchronous = OFF");
    database->exec("PRAGMA cache_size = -131072");  // KiB: the index of a million runs
    std::vector<std::string> of_runs = columns_of(*database, "runs");
    of_runs.erase(of_runs.begin());  // the row id
    tables = {{"scenarios", "hash", "hash", {"name", "content"}},
              {"descriptors", "hash, id", "hash || ' ' || part.descriptors.id",
               columns_of(*database, "descriptors")},
              {"reference_timings", "hash", "hash", {}},
              {"runs", "scenario, method, repetition",
               "substr(scenario, 1, 8) || '/' || method || '/' || repetition", of_runs}};
  }

  /// Copies the rows that are new; `offset` is added to row ids of runs. Returns the number of
  /// those that are not.
  std::int64_t copy(const Table& table, std::int64_t offset) {
    std::vector<std::string> names = columns_of(*database, table.name), values = names;
    if (table.name == "runs") values[0] += " + " + std::to_string(offset);
    const int inserted = database->exec(
        "INSERT INTO main." + table.name + " (" + join(names, ", ") + ") SELECT " +
        join(values, ", ") + " FROM part." + table.name + " WHERE true ON CONFLICT DO NOTHING");
    return count(*database, "part." + table.name) - inserted;
  }

  void expect_equal(const Table& table, const std::string& file) {
    std::vector<std::string> differences;
    for (const std::string& column : table.compared)
      differences.push_back("part." + table.name + "." + column + " IS NOT main." + table.name +
                            "." + column);
    if (differences.empty()) return;
    const std::string outcomes =
        table.name == "runs" ? "part.runs.outcome, main.runs.outcome" : "'', ''";
    SQLite::Statement rows(*database, "SELECT " + table.label + ", " + outcomes + " FROM part." +
                                          table.name + " JOIN main." + table.name + " USING (" +
                                          table.keys + ") WHERE " + join(differences, " OR "));
    std::optional<Error> at_time_limit;  // reported if nothing else differs
    while (rows.executeStep()) {
      const bool is_limit = ended_at_time_limit(rows.getColumn(1).getString()) ||
                            ended_at_time_limit(rows.getColumn(2).getString());
      const Error error =
          unequal(file, table.name + ": " + rows.getColumn(0).getString(), is_limit);
      if (!is_limit) throw error;
      if (!at_time_limit) at_time_limit = error;
    }
    if (at_time_limit) throw *at_time_limit;
  }

  /// The blobs and times of those runs that are new.
  void copy_by_run(const std::string& table, std::int64_t offset) {
    std::vector<std::string> names = columns_of(*database, table), values = names;
    values[0] += " + " + std::to_string(offset);
    database->exec("INSERT INTO main." + table + " (" + join(names, ", ") + ") SELECT " +
                   join(values, ", ") + " FROM part." + table + " WHERE " + values[0] +
                   " IN (SELECT run FROM main.runs)");
  }

  std::size_t add(const std::string& file) {
    const Attached attached(*database, file);
    database->exec("BEGIN");
    const std::int64_t offset =
        database->execAndGet("SELECT coalesce(max(run), 0) FROM main.runs").getInt64();
    std::int64_t known = 0;
    for (const Table& table : tables) {
      known = copy(table, offset);
      if (known > 0) expect_equal(table, file);
    }
    for (const char* table : {"trajectories", "run_timings"}) copy_by_run(table, offset);
    if (has_table(*database, "run_outputs", "part")) {
      database->exec(kCreateRunOutputs);
      copy_by_run("run_outputs", offset);
    }
    const auto added = static_cast<std::size_t>(count(*database, "part.runs"));
    database->exec("COMMIT");
    duplicates += static_cast<std::size_t>(known);
    runs += added - static_cast<std::size_t>(known);
    return added;
  }
};

MergedResults::MergedResults(const std::string& path, const std::string& first) {
  if (std::filesystem::exists(path)) ResultFile::open(path);  // throws unless it may be replaced
  impl_ = std::make_unique<Impl>(path);
  const ResultFile file = ResultFile::open(first);
  impl_->manifest = file.read_manifest();
  impl_->manifest.erase(kShardKey);
  ResultFile::create(impl_->draft.name(), impl_->manifest, file.descriptors(), file.metrics());
  writing(path, [&] { impl_->open(); });
}

MergedResults::~MergedResults() = default;

std::size_t MergedResults::add(const std::string& file) {
  refuse_bundle(file, "result files (.results), of which bundles are made");
  const Manifest manifest = ResultFile::open(file).read_manifest();
  expect_same_campaign(impl_->manifest, manifest, file, "results of the same campaign");
  add_repeated_runs(manifest, impl_->manifest);
  try {
    return impl_->add(file);
  } catch (const SQLite::Exception& e) {
    const bool is_write =
        e.getErrorCode() == SQLITE_FULL || e.getExtendedErrorCode() == SQLITE_IOERR_WRITE;
    if (is_write) throw_write_error(impl_->path, e);
    throw_read_error(file, e);
  }
}

const Manifest& MergedResults::manifest() const {
  return impl_->manifest;
}

std::size_t MergedResults::runs() const {
  return impl_->runs;
}

std::size_t MergedResults::duplicates() const {
  return impl_->duplicates;
}

void MergedResults::publish() {
  impl_->database.reset();
  if (!repeatability_of(impl_->manifest).empty()) {
    ResultFile file = ResultFile::open(impl_->draft.name());
    file.replace_manifest(impl_->manifest);
    file.commit();
  }
  impl_->draft.publish();
}

}  // namespace slalom
