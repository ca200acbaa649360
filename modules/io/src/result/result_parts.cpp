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

}  // namespace

ResultParts::ResultParts(const std::string& folder, int jobs)
    : files_(shards_in(folder)), jobs_(jobs) {
  outline_.source = folder;
  for (const std::string& path : files_) {
    const ResultFile file = ResultFile::open(path);
    Manifest manifest = file.read_manifest();
    if (path == files_.front()) {
      manifest.erase(kShardKey);
      outline_.manifest = manifest;
      outline_.metrics = {file.metrics().begin(), file.metrics().end()};
      outline_.descriptors = {file.descriptors().begin(), file.descriptors().end()};
      add_success(outline_);
    }
    expect_same_campaign(outline_.manifest, manifest, path, "results of the same campaign");
  }
  check_disjoint();
}

void ResultParts::check_disjoint() {
  std::vector<std::uint64_t> all;  // half of each hash: 8 bytes per scenario
  const auto read_hashes = [&](std::size_t file) {
    std::vector<std::uint64_t> hashes;
    for_each_row(files_[file], "SELECT substr(hash, 1, 16) FROM scenarios", "",
                 [&](SQLite::Statement& row) {
                   hashes.push_back(std::strtoull(row.getColumn(0).getText(), nullptr, 16));
                 });
    return hashes;
  };
  parallel_in_order(files_.size(), jobs_, read_hashes, [&](std::vector<std::uint64_t> hashes) {
    all.insert(all.end(), hashes.begin(), hashes.end());
  });
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
