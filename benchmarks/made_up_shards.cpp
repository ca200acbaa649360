// SPDX-License-Identifier: BSD-3-Clause
// Writes made-up results of ten methods with forty metrics as the shards of a campaign, to measure
// programs that read them: made_up_shards FOLDER SHARDS SCENARIOS (of each shard; 10 runs in each).
#include "checked_row.h"

#include <slalom/core/hash.h>
#include <slalom/core/random.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/io/merge_results.h>
#include <slalom/io/result_file.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace slalom {
namespace {

constexpr int kMethods = 10, kMetrics = 40;

std::vector<QuantityInfo> metric_infos() {
  std::vector<QuantityInfo> infos = {success_info(),
                                     {"optimality", 1, "Optimality", "-", Direction::Up},
                                     {"safety", 1, "Safety", "-", Direction::Up}};
  while (infos.size() < kMetrics) {
    const std::string id = "metric_" + std::to_string(infos.size());
    infos.push_back({id, 1, id, "-", Direction::None});
  }
  return infos;
}

Manifest manifest_of(const std::string& shard, int scenarios) {
  std::string ini = "[campaign]\nmethods = method0";
  for (int i = 1; i < kMethods; ++i) ini += ", method" + std::to_string(i);
  return {{"campaign", "made up"},
          {"campaign.ini", ini + "\n"},
          {kEffectiveKey, ini + "\n"},
          {"scenarios.count", std::to_string(scenarios)},
          {kShardKey, shard}};
}

/// Binds the values of a row to a statement that is used again and again.
class Row {
 public:
  Row(SQLite::Database& database, const std::string& sql) : statement_(database, sql) {}

  template <typename T>
  Row& add(const T& value) {
    checksum_.add(value);
    statement_.bind(++column_, value);
    return *this;
  }
  Row& add_na() {
    checksum_.add_null();
    ++column_;
    return *this;
  }
  void exec() {
    statement_.bind(++column_, checksum_.value());
    statement_.exec();
    statement_.reset();
    statement_.clearBindings();
    checksum_ = {};
    column_ = 0;
  }

 private:
  SQLite::Statement statement_;
  RowChecksum checksum_;
  int column_ = 0;
};

void add_scenario(SQLite::Database& database, const std::string& hash, double density) {
  SQLite::Statement value(database,
                          "INSERT INTO descriptors VALUES (?, 'density', 1, ?, NULL, NULL)");
  value.bind(1, hash);
  value.bind(2, density);
  value.exec();
  RowChecksum checksum;
  checksum.add(hash).add("scenario").add("density").add(std::int64_t{1}).add(density);
  checksum.add_null().add_null();
  SQLite::Statement row(database, "INSERT INTO scenarios VALUES (?, 'scenario', ?, 0, 0, '', '')");
  row.bind(1, hash);
  row.bind(2, checksum.value());
  row.exec();
}

/// One in ten runs fails; a third of the metrics exist only for successful runs.
void add_run(Row& row, RandomEngine& engine, const std::string& hash, int method) {
  static const std::string kNone = "{}", kCollision = [] {
    std::string reasons;
    for (int i = 3; i < kMetrics; i += 3)
      reasons += (reasons.empty() ? "{\"" : ",\"") +
                 metric_infos()[static_cast<std::size_t>(i)].id + "\":\"outcome: collision\"";
    return reasons + "}";
  }();
  const bool success = uniform_real(engine, 0, 1) < 0.9;
  row.add(hash).add(std::string("scenario")).add("method" + std::to_string(method));
  row.add(std::int64_t{0}).add(std::string("12345678901234567890"));
  row.add(std::string(success ? "success" : "collision")).add(std::string("after 12.3 s"));
  row.add(hash).add(success ? kNone : kCollision).add(kNone);
  row.add(success ? 1.0 : 0.0);
  for (int i = 1; i < kMetrics; ++i) {
    if (!success && i % 3 == 0) {
      row.add_na();
    } else {
      row.add(uniform_real(engine, 0, 1));
    }
  }
  row.exec();
}

void write_shard(const std::string& path, int index, int count, int scenarios) {
  ResultFile::create(
      path, manifest_of(std::to_string(index) + "/" + std::to_string(count), count * scenarios),
      {{"density", 1, "Density", "-", Direction::None}}, metric_infos());
  SQLite::Database database(path, SQLite::OPEN_READWRITE);
  database.exec("PRAGMA synchronous = OFF; PRAGMA journal_mode = OFF; BEGIN");
  RandomEngine engine(static_cast<std::uint64_t>(index));
  std::string places;
  for (int i = 0; i < kMetrics + 11; ++i) places += ", ?";
  Row row(database, "INSERT INTO runs VALUES (NULL" + places + ")");
  for (int i = 0; i < scenarios; ++i) {
    const std::string hash =
        Hasher()
            .add(static_cast<std::uint64_t>(index) * 100000000U + static_cast<std::uint64_t>(i))
            .hex();
    add_scenario(database, hash, uniform_real(engine, 0, 1));
    for (int method = 0; method < kMethods; ++method) add_run(row, engine, hash, method);
  }
  database.exec("COMMIT");
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "made_up_shards FOLDER SHARDS SCENARIOS\n";
    return 2;
  }
  const int shards = std::atoi(argv[2]), scenarios = std::atoi(argv[3]);
  std::filesystem::create_directories(argv[1]);
  for (int i = 1; i <= shards; ++i)
    slalom::write_shard(std::string(argv[1]) + "/" + std::to_string(i) + ".results", i, shards,
                        scenarios);
}
