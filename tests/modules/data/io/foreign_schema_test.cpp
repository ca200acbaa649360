// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "io_sample.h"

#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/io/merge_results.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/io/result_files.h>
#include <slalom/io/scenario_list.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sys/stat.h>

namespace slalom {
namespace {

class ForeignSchema : public testing::Test {
 protected:
  ForeignSchema() {
    ResultFile::create(results_, {{"campaign", "c"}, {"campaign.effective", ""}}, {},
                       {success_info()});
    ScenarioList::create(list_);
  }

  static void execute(const std::string& path, const std::string& sql) {
    SQLite::Database(path, SQLite::OPEN_READWRITE).exec(sql);
  }

  /// Whether all readers refuse the results, naming the file and `words`.
  void expect_refused_results(const std::string& path, std::initializer_list<std::string> words) {
    const auto refused = [&](const std::function<void()>& read) {
      EXPECT_TRUE(throws_error(ErrorKind::File, path, words, read));
    };
    refused([&] { ResultFile::open(path); });
    refused([&] { read_results(path); });
    refused([&] { ResultFiles files(path); });
    refused([&] { count_results(path); });
    refused([&] { MergedResults(folder_ / "merged.results", path); });
    refused([&] { MergedResults(folder_ / "merged.results", good()).add(path); });
  }

  std::string good() const {
    const std::string path = folder_ / "good.results";
    ResultFile::create(path, {{"campaign", "c"}, {"campaign.effective", ""}}, {}, {success_info()});
    return path;
  }

  const TemporaryFolder folder_;
  const std::string results_ = folder_ / "x.results", list_ = folder_ / "x.scenarios";
};

TEST_F(ForeignSchema, TriggersAreRefused) {
  execute(results_, "CREATE TRIGGER t AFTER INSERT ON runs BEGIN DELETE FROM runs; END");
  expect_refused_results(results_, {"trigger", "'t'"});
  execute(list_, "CREATE TRIGGER t AFTER INSERT ON tags BEGIN DELETE FROM scenarios; END");
  EXPECT_TRUE(
      throws_error(ErrorKind::File, list_, {"trigger", "'t'"}, [&] { ScenarioList::open(list_); }));
}

TEST_F(ForeignSchema, ViewsInPlaceOfTablesAreRefused) {
  const std::string endless =
      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT ";
  execute(results_, "DROP TABLE manifest; CREATE VIEW manifest AS " + endless +
                        "'k' || i AS key, 'text' AS text FROM n");
  expect_refused_results(results_, {"view", "'manifest'"});
  execute(list_, "DROP TABLE notes; CREATE VIEW notes AS " + endless +
                     "'k' || i AS key, 'text' AS text FROM n");
  EXPECT_TRUE(throws_error(ErrorKind::File, list_, {"view", "'notes'"},
                           [&] { ScenarioList::open(list_); }));
}

TEST_F(ForeignSchema, ComputedColumnsAndIndexesOfExpressionsAreRefused) {
  execute(list_, "ALTER TABLE tags ADD COLUMN extra TEXT AS (hex(hash)) VIRTUAL");
  EXPECT_TRUE(throws_error(ErrorKind::File, list_, {"computed column", "'extra'"},
                           [&] { ScenarioList::open(list_); }));
  execute(results_, "CREATE INDEX slow ON runs (hex(scenario))");
  expect_refused_results(results_, {"index of an expression", "'slow'"});
}

TEST_F(ForeignSchema, VirtualTablesAreRefused) {
  execute(results_, "CREATE VIRTUAL TABLE more USING rtree(id, low, high)");
  expect_refused_results(results_, {"virtual table", "'more'"});
}

std::string big_endian(std::size_t value, int bytes) {
  std::string text;
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
    text += static_cast<char>((value >> static_cast<unsigned>(shift)) & 0xffU);
  return text;
}

/// An interior page of a table whose children are all the page `child` (file format of
/// SQLite, 1.6).
std::string page_of_equal_children(std::size_t child, std::size_t page_size) {
  constexpr std::size_t kHeader = 12, kCell = 5, kPointer = 2;
  const std::size_t cells = (page_size - kHeader) / (kCell + kPointer);
  std::string pointers, content;
  for (std::size_t i = 0; i < cells; ++i) {
    pointers += big_endian(page_size - (cells - i) * kCell, 2);
    content += big_endian(child, 4) + static_cast<char>(1);
  }
  std::string page = std::string(1, '\x05') + big_endian(0, 2) + big_endian(cells, 2) +
                     big_endian(page_size - cells * kCell, 2) + std::string(1, '\0') +
                     big_endian(child, 4) + pointers;
  page.resize(page_size - content.size(), '\0');
  return page + content;
}

TEST_F(ForeignSchema, PagesThatLeadToEachOtherAreReadForABoundedTimeOnly) {
  std::size_t root = 0, pages = 0, page_size = 0;
  {
    SQLite::Database database(results_);
    const auto number = [&](const std::string& sql) {
      return static_cast<std::size_t>(database.execAndGet(sql).getInt64());
    };
    root = number("SELECT rootpage FROM sqlite_master WHERE name = 'quantities'");
    pages = number("PRAGMA page_count");
    page_size = number("PRAGMA page_size");
  }
  std::string content = read_file(results_);
  const std::string leaf = content.substr((root - 1) * page_size, page_size);
  constexpr std::size_t kLevels = 8;  // 500^8 rows
  content.replace((root - 1) * page_size, page_size, page_of_equal_children(pages + 1, page_size));
  for (std::size_t level = 1; level < kLevels; ++level)
    content += page_of_equal_children(pages + level + 1, page_size);
  content += leaf;
  content.replace(28, 4, big_endian(pages + kLevels, 4));  // the file's size in its header
  std::ofstream(results_, std::ios::binary) << content;
  EXPECT_TRUE(throws_error(ErrorKind::File, results_, {"does not end"},
                           [&] { ResultFile::open(results_); }));
}

TEST_F(ForeignSchema, APipeAsJournalIsRefusedWithoutWaiting) {
  for (const std::string& path : {results_, list_})
    ASSERT_EQ(mkfifo((path + "-journal").c_str(), 0600), 0);
  EXPECT_TRUE(throws_error(ErrorKind::File, results_ + "-journal", {"pipe"},
                           [&] { ResultFile::open(results_); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, results_ + "-journal", {"pipe"},
                           [&] { ResultFile::exists(results_); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, list_ + "-journal", {"pipe"},
                           [&] { ScenarioList::open(list_); }));
}

}  // namespace
}  // namespace slalom
