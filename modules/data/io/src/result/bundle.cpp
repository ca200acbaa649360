// SPDX-License-Identifier: BSD-3-Clause
#include "compression.h"
#include "database.h"
#include "result_schema.h"
#include "sibling_temp_file.h"

#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/read_file.h>
#include <slalom/io/bundle.h>
#include <slalom/io/result_file.h>
#include <slalom/trajectory/trajectory.h>

#include <algorithm>
#include <map>
#include <set>

namespace slalom {
namespace {

constexpr const char* kCreateFiles =
    "CREATE TABLE method_files (key TEXT PRIMARY KEY, content BLOB NOT NULL)";
constexpr int kLevel = 19;  // of zstd: the smallest that it makes without much memory

/// Scenario hash and method.
using RunsToReplay = std::set<std::pair<std::string, std::string>>;

/// Failures of each method in scenarios that most of the other methods solve, each with the run of
/// one that does.
RunsToReplay runs_to_replay(const ResultFile& results, std::size_t failures) {
  std::map<std::string, std::set<std::string>> failed, solved;  // methods by scenario
  results.for_each_key([&](const std::string& hash, const std::string& method, int repetition,
                           const std::string& outcome) {
    if (repetition == 0)
      (outcome == to_string(Outcome::Success) ? solved : failed)[hash].insert(method);
  });
  std::vector<std::pair<std::string, std::string>> order;  // name, hash
  for (const auto& [hash, name] : results.read_scenario_names())
    if (failed.count(hash) > 0) order.emplace_back(name, hash);
  std::sort(order.begin(), order.end());
  std::stable_sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
    return solved[a.second].size() > solved[b.second].size();
  });
  std::map<std::string, std::size_t> chosen;  // by method
  RunsToReplay runs;
  for (const auto& [name, hash] : order)
    for (const std::string& method : failed[hash]) {
      if (chosen[method]++ >= failures) continue;
      runs.emplace(hash, method);
      if (!solved[hash].empty()) runs.emplace(hash, *solved[hash].begin());
    }
  return runs;
}

/// The scenarios of the file by name.
std::vector<std::pair<std::string, std::string>> scenarios_by_name(const ResultFile& results) {
  std::vector<std::pair<std::string, std::string>> order;
  for (const auto& [hash, name] : results.read_scenario_names()) order.emplace_back(name, hash);
  std::sort(order.begin(), order.end());
  return order;
}

void copy_results(const ResultFile& results, const RunsToReplay& to_replay,
                  const std::string& path) {
  std::set<std::string> scenarios;
  for (const auto& [hash, method] : to_replay) scenarios.insert(hash);
  ResultFile copy =
      ResultFile::create(path, results.read_manifest(), results.descriptors(), results.metrics());
  for (const auto& [name, hash] : scenarios_by_name(results)) {
    References references = results.read_references(hash);
    if (scenarios.count(hash) == 0) remove_paths(references);
    copy.add_scenario(results.read_record(hash), results.read_scenario(hash), references);
  }
  results.for_each_run([&](const RunRecord& run) {
    const bool kept = run.repetition == 0 && to_replay.count({run.scenario_hash, run.method}) > 0;
    copy.add_run(run, {}, kept ? results.read_trajectory(run) : PackedTrajectory());
  });
  copy.commit();
}

/// Removes the rows of wall-clock figures, adds the files, and packs the pages.
void finish(const std::string& path, const std::vector<BundledFile>& files) {
  SQLite::Database database(path, SQLite::OPEN_READWRITE);
  database.exec("DELETE FROM run_timings; DELETE FROM reference_timings");
  if (!files.empty()) database.exec(kCreateFiles);
  for (const BundledFile& file : files) {
    SQLite::Statement row(database, insert_sql("method_files", "key, content"));
    row.bind(1, file.key);
    row.bind(2, file.content.data(), static_cast<int>(file.content.size()));
    row.exec();
  }
  database.exec("VACUUM");
}

}  // namespace

void write_bundle(const std::string& results, const std::string& path,
                  const BundleOptions& options) {
  const SiblingTempFile draft(path);
  const ResultFile file = ResultFile::open(results);
  copy_results(file, runs_to_replay(file, options.failures), draft.name());
  writing(path, [&] { finish(draft.name(), options.files); });
  write_file_atomically(path, compress(read_file(draft.name()), kLevel));
}

void refuse_bundle(const std::string& path, const std::string& expected) {
  if (is_bundle(path)) throw usage_error(path, "is a bundle", expected);
}

std::vector<BundledFile> read_bundled_files(const std::string& path) {
  Manifest manifest = ResultFile::open(path).read_manifest();
  return reading(path, [&] {
    const auto database = open_reader(path);
    std::vector<BundledFile> files;
    if (!has_table(*database, "method_files")) return files;
    SQLite::Statement rows(*database, "SELECT key, content FROM method_files ORDER BY key");
    while (rows.executeStep()) {
      files.push_back({rows.getColumn(0).getString(), rows.getColumn(1).getString()});
      const BundledFile& file = files.back();
      if (Hasher().add(file.content).hex() != manifest[file.key + "_hash"])
        throw file_error(path + ": " + file.key, "is not the file whose hash the manifest names",
                         "the file with which the runs were executed");
    }
    return files;
  });
}

}  // namespace slalom
