// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/spreadsheet/workbook.h>

#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <error_text.h>
#include <filesystem>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace slalom {
namespace {

DataTable table_of(const std::string& name, const std::vector<Field>& fields) {
  std::vector<std::string> columns;
  for (std::size_t i = 0; i < fields.size(); ++i) columns.push_back("c" + std::to_string(i));
  return {name, name, columns, 1,
          [fields](std::size_t, std::size_t column) { return fields[column]; }};
}

/// Reads parts of the workbook with `unzip`, as an independent reader of the format.
class Workbook : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }

  std::string part(const std::string& name) const {
    FILE* pipe = popen(("unzip -p '" + path_ + "' '" + name + "'").c_str(), "r");
    std::string text;
    char buffer[4096];
    for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) text.append(buffer, n);
    EXPECT_EQ(pclose(pipe), 0) << name;
    return text;
  }

  const std::string path_ =
      testing::TempDir() + "slalom_workbook_" + std::to_string(getpid()) + ".xlsx";
};

TEST_F(Workbook, WritesNumbersAsNumbersAndTextsAsTexts) {
  write_workbook({table_of("runs", {0.25, std::int64_t{7}, std::string("=1+1"), Field{}})}, path_);
  const std::string sheet = part("xl/worksheets/sheet1.xml");
  EXPECT_NE(sheet.find("<v>0.25</v>"), std::string::npos) << sheet;
  EXPECT_NE(sheet.find("<v>7</v>"), std::string::npos) << sheet;
  EXPECT_EQ(sheet.find("<f>"), std::string::npos) << "text written as formula";
  EXPECT_NE(sheet.find("=1+1"), std::string::npos) << sheet;
  EXPECT_EQ(sheet.find("r=\"D2\""), std::string::npos) << "empty field written";
  EXPECT_NE(sheet.find("<autoFilter"), std::string::npos);
  EXPECT_NE(sheet.find("state=\"frozen\""), std::string::npos);
}

TEST_F(Workbook, WritesLargeSeedsAsTexts) {
  const std::int64_t seed = (std::int64_t{1} << 53) + 1;
  write_workbook({table_of("runs", {seed})}, path_);
  EXPECT_NE(part("xl/worksheets/sheet1.xml").find("9007199254740993"), std::string::npos);
}

TEST_F(Workbook, KeepsSeedsThatOnlyUnsignedNumbersHold) {
  ResultTable results;
  results.scenario_hashes = results.scenario_names = results.methods = results.outcomes = {"a"};
  results.scenario = results.method = results.outcome = {0, 0};
  results.repetition = {0, 1};
  results.details.resize(2);
  results.details[0].seed = 18446744073709551557U;  // 2^64 - 59
  results.details[1].seed = 7;
  write_workbook({runs_table(results)}, path_);
  const std::string sheet = part("xl/worksheets/sheet1.xml");
  EXPECT_NE(sheet.find(">18446744073709551557<"), std::string::npos) << sheet;
  EXPECT_NE(sheet.find("<v>7</v>"), std::string::npos) << sheet;
}

TEST_F(Workbook, NamesSheetsValidlyAndUniquely) {
  const std::string name = "a_very_long_method_name_by_bottleneck_width";
  write_workbook({table_of(name, {1.0}), table_of(name, {2.0}), table_of("a/b:c", {3.0}),
                  table_of("RUNS", {4.0}), table_of("runs", {5.0})},
                 path_);
  const std::string book = part("xl/workbook.xml");
  EXPECT_NE(book.find("\"" + name.substr(0, 31) + "\""), std::string::npos) << book;
  EXPECT_NE(book.find("\"" + name.substr(0, 29) + "_2\""), std::string::npos) << book;
  EXPECT_NE(book.find("\"a_b_c\""), std::string::npos) << book;
  EXPECT_NE(book.find("\"runs_2\""), std::string::npos) << book;
  EXPECT_NE(part("xl/worksheets/sheet5.xml").find("<v>5</v>"), std::string::npos);
}

TEST_F(Workbook, RejectsTooManyRows) {
  DataTable large = table_of("runs", {1.0});
  large.rows = 1048576;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "table 'runs'", {"1048576 rows", "1048575"},
                           [&] { write_workbook({large}, path_); }));
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(Workbook, AFullDiskIsAnErrorWithoutLinesOfTheLibrary) {
  // Too small for any workbook.
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{1000, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  testing::internal::CaptureStderr();
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string text =
      error_text(ErrorKind::Job, [&] { write_workbook({table_of("runs", {1.0})}, path_); });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(mentions(text, {path_, "cannot be written"}));
}

TEST_F(Workbook, LeavesAnExistingFileUnchangedOnErrors) {
  const std::string nowhere = testing::TempDir() + "slalom_no_such_folder/book.xlsx";
  EXPECT_THROW(write_workbook({table_of("runs", {1.0})}, nowhere), Error);
  std::ofstream(path_) << "before";
  DataTable large = table_of("runs", {1.0});
  large.rows = 2000000;
  EXPECT_THROW(write_workbook({large}, path_), Error);
  EXPECT_EQ(std::filesystem::file_size(path_), 6u);
}

}  // namespace
}  // namespace slalom
