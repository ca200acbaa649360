// SPDX-License-Identifier: BSD-3-Clause
#include "combined_results.h"
#include "database.h"
#include "value_columns.h"

#include <slalom/core/error.h>
#include <slalom/core/parallel.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/io/merge_results.h>
#include <slalom/io/result_file.h>
#include <slalom/io/result_parts.h>

#include <algorithm>

namespace slalom {
namespace {

/// Calls `use` with each row of a query over the file.
template <typename Use>
void for_each_row(const std::string& path, const std::string& sql, const std::string& argument,
                  Use use) {
  reading(path, [&] {
    const auto database = open_reader(path);
    SQLite::Statement rows(*database, sql);
    if (!argument.empty()) rows.bind(1, argument);
    while (rows.executeStep()) use(rows);
  });
}

struct Shard {
  Manifest manifest;
  std::vector<std::uint64_t> scenarios;  ///< half of each hash: 8 bytes per scenario
};

Shard read_shard(const std::string& path) {
  Shard shard{ResultFile::open(path).read_manifest(), {}};
  for_each_row(path, "SELECT substr(hash, 1, 16) FROM scenarios", "", [&](SQLite::Statement& row) {
    shard.scenarios.push_back(std::strtoull(row.getColumn(0).getText(), nullptr, 16));
  });
  return shard;
}

}  // namespace

ResultParts::ResultParts(const std::string& folder, int jobs)
    : files_(shards_in(folder)), jobs_(jobs) {
  outline_.source = folder;
  const ResultFile first = ResultFile::open(files_.front());
  outline_.manifest = first.read_manifest();
  outline_.manifest.erase(kShardKey);
  outline_.metrics = {first.metrics().begin(), first.metrics().end()};
  outline_.descriptors = {first.descriptors().begin(), first.descriptors().end()};
  add_success(outline_);
  check_files();
}

void ResultParts::check_files() {
  std::vector<std::uint64_t> all;
  auto path = files_.begin();
  const auto add = [&](const Shard& shard) {
    expect_same_campaign(outline_.manifest, shard.manifest, *path++,
                         "results of the same campaign");
    all.insert(all.end(), shard.scenarios.begin(), shard.scenarios.end());
  };
  parallel_in_order(
      files_.size(), jobs_, [&](std::size_t file) { return read_shard(files_[file]); }, add);
  std::sort(all.begin(), all.end());
  disjoint_ = std::adjacent_find(all.begin(), all.end()) == all.end();
}

void ResultParts::read_values(const std::string& descriptor) {
  for (ValueColumn& column : outline_.descriptors) {
    if (column.info().id != descriptor || column.size() > 0) continue;
    const int version = column.info().version;
    const auto read_file = [&](std::size_t file) {
      std::vector<Value> values;
      for_each_row(files_[file],
                   "SELECT version, value, standard_error, reason FROM descriptors WHERE id = ?",
                   descriptor, [&](SQLite::Statement& row) {
                     values.push_back(value_of_version(
                         {row.getColumn(0).getInt(), value_from_columns(row, 1)}, version));
                   });
      return values;
    };
    parallel_in_order(files_.size(), jobs_, read_file, [&](const std::vector<Value>& values) {
      for (const Value& value : values) column.add(value);
    });
  }
}

void ResultParts::for_each(const std::vector<std::string>& ids,
                           const std::function<void(ResultTable&)>& use) const {
  const auto read = [&](std::size_t file) {
    return finish_table(read_file_rows(files_[file], {ids}).table);
  };
  parallel_in_order(files_.size(), jobs_, read, [&](ResultTable table) { use(table); });
}

}  // namespace slalom
