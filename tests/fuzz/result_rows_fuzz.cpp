// SPDX-License-Identifier: BSD-3-Clause
#include "checked_row.h"
#include "fuzz_target.h"

#include <slalom/core/read_file.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>

#include <set>
#include <sstream>

namespace {

using namespace slalom;

struct Cell {
  const char *table, *column;
};
constexpr Cell kCells[] = {
    {"runs", "scenario"},
    {"runs", "method"},
    {"runs", "repetition"},
    {"runs", "seed"},
    {"runs", "outcome"},
    {"runs", "outcome_detail"},
    {"runs", "reasons"},
    {"runs", "standard_errors"},
    {"runs", "m_spl"},
    {"runs", "trajectory_hash"},
    {"scenarios", "hash"},
    {"scenarios", "name"},
    {"scenarios", "content"},
    {"scenarios", "refs"},
    {"descriptors", "id"},
    {"descriptors", "version"},
    {"descriptors", "value"},
    {"descriptors", "standard_error"},
    {"trajectories", "content"},
    {"run_timings", "figures"},
    {"run_timings", "wall_seconds"},
    {"reference_timings", "exact_seconds"},
    {"manifest", "text"},
    {"quantities", "id"},
    {"quantities", "version"},
    {"quantities", "direction"},
    {"runs", "checksum"},
};

/// Two runs in one scenario.
std::string sample_file() {
  const fuzz::InputFile input("sample.results", "");
  {
    ResultFile file = ResultFile::create(
        input.path(), {{"campaign", "test"}}, {{"density", 1, "Density", "-", Direction::None}},
        {{"spl", 2, "SPL", "-", Direction::Up}, {"time", 1, "Time", "s", Direction::Down}});
    Primitives obstacles;
    obstacles.discs.push_back({{8, 5}, 0.5});
    const Scenario scenario =
        Scenario::continuous("field", {0, 0, 10, 10}, obstacles, {1, 1, 0}, {5, 5});
    References references;
    references.shortest = ShortestPath{{{1, 1}, {5, 5}}, 5.7, {5.6, 5.7}, "exact", "", 5.7, 5.8};
    file.add_scenario({scenario.hash(), "field", {{"density", {1, Value::of(0.1, 0.01)}}}},
                      scenario, references);
    for (int repetition = 0; repetition < 2; ++repetition) {
      Trajectory trajectory;
      trajectory.samples.resize(3);
      RunRecord run{scenario.hash(), "field",           "nd", repetition, 7, "success",
                    "arrived",       trajectory.hash(), {}};
      run.metrics["spl"] = {2, Value::of(0.5, 0.125)};
      run.metrics["time"] = {1, Value::na("none")};
      file.add_run(run, {1.5, {{"cycle_time_mean", 0.5}}}, trajectory);
    }
    file.commit();
  }
  return read_file(input.path());
}

/// Replaces the value of the first row of a table: as text, bytes, number, or NULL.
void replace(SQLite::Database& database, const Cell& cell, int type, const std::string& value) {
  const std::string where =
      std::string(" WHERE rowid = (SELECT min(rowid) FROM ") + cell.table + ")";
  const bool without_rowid = std::string(cell.table) == "descriptors";
  SQLite::Statement update(database, std::string("UPDATE OR IGNORE ") + cell.table + " SET " +
                                         cell.column + " = ?" + (without_rowid ? "" : where));
  double number = 0;
  std::memcpy(&number, value.data(), std::min(value.size(), sizeof number));
  if (type == 0) update.bind(1, value);
  if (type == 1) update.bind(1, value.data(), static_cast<int>(value.size()));
  if (type == 2) update.bind(1, number);
  fuzz::read_or_refuse([&] {
    try {
      update.exec();
    } catch (const SQLite::Exception&) {  // NULL where the schema does not allow it
    }
  });
}

void set_checksum(SQLite::Database& database, const std::string& table, const std::string& column,
                  std::int64_t row, std::int64_t checksum) {
  SQLite::Statement update(database, "UPDATE " + table + " SET " + column + " = ? WHERE rowid = ?");
  update.bind(1, checksum);
  update.bind(2, row);
  update.exec();
}

/// Gives the rows of runs and their trajectories and timings the checksums of what they contain.
void forge_runs(SQLite::Database& database) {
  SQLite::Statement runs(database, "SELECT * FROM runs");
  const int last = runs.getColumnCount() - 1;
  while (runs.executeStep()) {
    const std::int64_t run = runs.getColumn(0).getInt64();
    const std::int64_t checksum = RowChecksum().add_columns(runs, 1, last).value();
    set_checksum(database, "runs", "checksum", run, checksum);
    for (const char* table : {"trajectories", "run_timings"}) {
      SQLite::Statement row(database, std::string("SELECT * FROM ") + table + " WHERE run = ?");
      row.bind(1, run);
      if (!row.executeStep()) continue;
      const int end = row.getColumnCount() - 1;
      set_checksum(database, table, "checksum", run,
                   RowChecksum().add(checksum).add_columns(row, 1, end).value());
    }
  }
}

/// The same for scenarios with their descriptors, contents, and references.
void forge_scenarios(SQLite::Database& database) {
  SQLite::Statement row(database, "SELECT hash, name, content, refs, rowid FROM scenarios");
  SQLite::Statement values(database,
                           "SELECT id, version, value, standard_error, reason FROM descriptors "
                           "ORDER BY id");
  while (row.executeStep()) {
    const std::int64_t id = row.getColumn(4).getInt64();
    const std::string hash = row.getColumn(0).getString();
    RowChecksum checksum;
    checksum.add_columns(row, 0, 2);
    while (values.executeStep()) checksum.add_columns(values, 0, 5);
    set_checksum(database, "scenarios", "checksum", id, checksum.value());
    set_checksum(database, "scenarios", "content_checksum", id,
                 RowChecksum().add(hash).add_columns(row, 2, 3).value());
    set_checksum(database, "scenarios", "refs_checksum", id,
                 RowChecksum().add(hash).add_columns(row, 3, 4).value());
  }
}

/// Reads everything; returns the lines of the dump.
std::set<std::string> read_all(const std::string& path) {
  std::set<std::string> lines;
  const auto ignore = [](const std::string&) {};
  fuzz::read_or_refuse([&] { read_detailed_results(path); });
  fuzz::read_or_refuse([&] {
    const ResultFile file = ResultFile::open(path);
    file.for_each_run(
        [&](const RunRecord& run) {
          fuzz::read_or_refuse([&] { file.read_trajectory(run); });
          fuzz::read_or_refuse([&] { file.read_timing(run); });
          fuzz::read_or_refuse([&] { file.read_references(run.scenario_hash); });
          fuzz::read_or_refuse([&] { file.read_scenario(run.scenario_hash); });
        },
        ignore);
    std::stringstream text;
    dump(file, text, ignore);
    for (std::string line; std::getline(text, line);) lines.insert(line);
  });
  return lines;
}

}  // namespace

/// Result files in which one value is replaced, with or without matching checksums.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  static const std::string sample = sample_file();
  const fuzz::InputFile file("rows.results", sample);
  static const std::set<std::string> original = read_all(file.path());
  const bool forged = (data[1] & 4U) != 0;
  {
    SQLite::Database database(file.path(), SQLite::OPEN_READWRITE);
    database.exec("PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; BEGIN");
    replace(database, kCells[data[0] % std::size(kCells)], data[1] & 3U,
            fuzz::text_of(data + 2, size - 2));
    if (forged) {
      forge_runs(database);
      forge_scenarios(database);
    }
    database.exec("COMMIT");
  }
  const std::set<std::string> lines = read_all(file.path());
  if (!forged)
    for (const std::string& line : lines)
      fuzz::expect(original.count(line) == 1, "a damaged value is not read");
  return 0;
}
