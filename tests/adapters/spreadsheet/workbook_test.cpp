#include <slalom/core/error.h>
#include <slalom/spreadsheet/workbook.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace slalom {
namespace {

DataTable table_of(const std::string& name, std::vector<Field> fields) {
  std::vector<std::string> columns;
  for (std::size_t i = 0; i < fields.size(); ++i) columns.push_back("c" + std::to_string(i));
  return {name, name, columns, 1,
          [fields](std::size_t, std::size_t column) { return fields[column]; }};
}

/// What `unzip` finds in one part of the workbook: a second reader of the format.
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

TEST_F(Workbook, KeepsNumbersAsNumbersAndTextsAsTexts) {
  write_workbook({table_of("runs", {0.25, std::int64_t{7}, std::string("=1+1"), Field{}})}, path_);
  const std::string sheet = part("xl/worksheets/sheet1.xml");
  EXPECT_NE(sheet.find("<v>0.25</v>"), std::string::npos) << sheet;
  EXPECT_NE(sheet.find("<v>7</v>"), std::string::npos) << sheet;
  EXPECT_EQ(sheet.find("<f>"), std::string::npos) << "a text became a formula";
  EXPECT_NE(sheet.find("=1+1"), std::string::npos) << sheet;
  EXPECT_EQ(sheet.find("r=\"D2\""), std::string::npos) << "an empty field is not empty";
  EXPECT_NE(sheet.find("<autoFilter"), std::string::npos);
  EXPECT_NE(sheet.find("state=\"frozen\""), std::string::npos);
}

TEST_F(Workbook, KeepsSeedsThatNoDoubleHoldsAsTexts) {
  const std::int64_t seed = (std::int64_t{1} << 53) + 1;
  write_workbook({table_of("runs", {seed})}, path_);
  EXPECT_NE(part("xl/worksheets/sheet1.xml").find("9007199254740993"), std::string::npos);
}

TEST_F(Workbook, NamesSheetsAsTheFormatAsksWithoutLosingOne) {
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

TEST_F(Workbook, RefusesMoreRowsThanTheFormatHolds) {
  DataTable large = table_of("runs", {1.0});
  large.rows = 1048576;
  try {
    write_workbook({large}, path_);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.culprit(), Culprit::Usage);
    EXPECT_NE(std::string(error.what()).find("1048575"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(Workbook, LeavesWhatWasThereWhenItCannotWrite) {
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
