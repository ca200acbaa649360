// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/file_format.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

std::string name_of(const std::string& content) {
  const auto format = recognize_format(content);
  return format ? format->name : "";
}

TEST(FileFormat, IsRecognizedByTheFirstBytes) {
  using namespace std::string_literals;
  EXPECT_EQ(name_of("#ROSBAG V2.0\n"), "a bag of ROS 1 (.bag)");
  EXPECT_EQ(name_of("\x89MCAP0\r\n"), "a bag of ROS 2 (.mcap)");
  EXPECT_EQ(name_of("PAR1\x15"), "a Parquet file");
  EXPECT_EQ(name_of("\x89HDF\r\n\x1a\n"), "an HDF5 file");
  EXPECT_EQ(name_of("\x1f\x8b\x08"), "compressed by gzip, as rawlogs of MRPT are");
  EXPECT_EQ(name_of("\x80\x04\x95"), "a pickle of Python");
  EXPECT_EQ(name_of("\xff\xfet\0,\0"s), "a text in UTF-16");
  EXPECT_EQ(name_of("OMPL version 1.5.2\nExperiment room\n"), "a benchmark log of OMPL");
  EXPECT_EQ(name_of("PK\x03\x04[Content_Types].xml PK xl/workbook.xml"), "a workbook (.xlsx)");
  EXPECT_EQ(name_of("PK\x03\x04 arr_0.npy"), "arrays of NumPy (.npz)");
  EXPECT_EQ(name_of("PK\x03\x04"), "a zip archive");
  EXPECT_EQ(name_of(" {\n \"runs\": [] }"), "JSON");
  EXPECT_EQ(name_of("[ {\"a\": 1}]"), "JSON");
  EXPECT_EQ(name_of("<?xml version=\"1.0\"?>"), "XML or HTML");
}

TEST(FileFormat, KindsOfDatabasesAreRecognizedByTheirTables) {
  using namespace std::string_literals;
  const std::string sqlite = "SQLite format 3\0"s;
  EXPECT_EQ(name_of(sqlite + "CREATE TABLE plannerConfigs (id"), "a benchmark database of OMPL");
  EXPECT_EQ(name_of(sqlite + "CREATE TABLE topics(id CREATE TABLE messages(id"),
            "a bag of ROS 2 (.db3)");
  EXPECT_EQ(name_of(sqlite), "");
}

TEST(FileFormat, TextsOfSlalomAreNotForeign) {
  for (const char* text : {"", "t,x,y\n", "[campaign]\n", "  [robot]\n", "{x: 1}\n", "<5 m,a\n",
                           "name: room\n", "BZh,PAR\n", "PAR1,PAR2\n"})
    EXPECT_EQ(name_of(text), "") << text;
}

TEST(FileFormat, ARefusalNamesTheFormatAndTheWayIn) {
  EXPECT_TRUE(throws_error(
      ErrorKind::File, "runs.csv", {"is a Parquet file", "a table as CSV", "pandas.read_parquet"},
      [] { refuse_foreign_format("PAR1\x15", "runs.csv", "a table as CSV"); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "runs.csv", {"has an unknown format"}, [] {
    refuse_foreign_format(std::string("a,b\0c", 5), "runs.csv", "a table");
  }));
  EXPECT_NO_THROW(refuse_foreign_format("a,b\n1,2\n", "runs.csv", "a table"));
  EXPECT_NO_THROW(refuse_foreign_file("no such file", "a table"));
}

}  // namespace
}  // namespace slalom
