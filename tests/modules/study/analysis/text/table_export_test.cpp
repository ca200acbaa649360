// SPDX-License-Identifier: BSD-3-Clause
#include "result_fixture.h"

#include <slalom/analysis/table_export.h>
#include <slalom/core/text.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace slalom {
namespace {

std::vector<CrossTable> tables(const std::string& method) {
  ResultFixture fixture;
  const std::string hash = fixture.add_scenario(Value::of(0.05));
  fixture.add_run(hash, method, 0.5, 0);
  fixture.add_run(hash, method, -1, 1);
  return build_cross_tables(fixture.table, parse_bin_specs("density:0,0.1"),
                            {"optimality", "path_length"}, {});
}

TEST(TableExport, WritesOneCsvLinePerCell) {
  // Gaffke's interval of a single value: the weight of the bound is uniform, 0.5 -+ 0.4875.
  const std::string csv = render_csv(tables("nd"));
  const std::size_t begin = csv.find("0.5,,") + 5, end = csv.find(",0.95", begin);
  double low = 0, high = 0;
  const std::string ends = csv.substr(begin, end - begin);
  ASSERT_TRUE(parse_number(ends.substr(0, ends.find(',')), low));
  ASSERT_TRUE(parse_number(ends.substr(ends.find(',') + 1), high));
  EXPECT_NEAR(low, 0.0125, 1e-3);
  EXPECT_NEAR(high, 0.9875, 1e-3);
  EXPECT_EQ(csv.substr(0, begin) + "LOW,HIGH" + csv.substr(end),
            "method,row_descriptor,bin_low,bin_high,metric,version,runs,n,na,mean,deviation,"
            "low,high,confidence,na_reasons\n"
            "nd,density,0,0.1,optimality,2,2,1,1,0.5,,LOW,HIGH,0.95,collision=1\n"
            "nd,density,0,0.1,path_length,1,2,2,0,10,0,,,0.95,\n");
}

TEST(TableExport, QuotesSpecialCharactersInCsv) {
  EXPECT_EQ(csv_field("plain"), "plain");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("say \"x\"\n"), "\"say \"\"x\"\"\n\"");
  // Separators of spreadsheets in other locales.
  EXPECT_EQ(csv_field("x;=1+1;-2;y"), "\"x;'=1+1;-2;y\"") << "also split at semicolons";
  EXPECT_EQ(csv_field("x\t=1"), "\"x\t'=1\"");
  // Texts that a spreadsheet would evaluate; numbers are not.
  for (const char* text : {"=1+1", "+x", "-x", "@SUM(A1)", "-"})
    EXPECT_EQ(csv_field(text), std::string(text) == "-" ? "-" : std::string("'") + text) << text;
  EXPECT_EQ(csv_field("\t=1"), "\"\t'=1\"");
  EXPECT_EQ(csv_field("=HYPERLINK(\"x\",1)"), "\"'=HYPERLINK(\"\"x\"\",1)\"");
  for (const char* number : {"-0.5", "+1e-3", "-12"}) EXPECT_EQ(csv_field(number), number);
  EXPECT_NE(render_csv(tables("a,b")).find("\"a,b\",density"), std::string::npos);
}

TEST(TableExport, JsonContainsTheRuns) {
  const auto json = nlohmann::json::parse(render_json(tables("nd")));
  const auto& row = json.at(0).at("rows").at(0);
  EXPECT_EQ(row.at("runs").size(), 2u);
  EXPECT_EQ(row.at("cells").at(0).at("n"), 1);  // values: the other run has none
  EXPECT_EQ(row.at("cells").at(0).at("na").at("collision"), 1);
  EXPECT_TRUE(row.at("cells").at(0).at("interval").is_array());
  EXPECT_EQ(row.at("cells").at(1).at("mean"), 10);
  EXPECT_TRUE(row.at("cells").at(1).at("interval").is_null());
  EXPECT_EQ(row.at("cells").at(1).at("interval_na"), "no bounds");
}

TEST(TableExport, JsonAcceptsNamesThatAreNotUtf8) {
  EXPECT_TRUE(nlohmann::json::accept(render_json(tables("n\xff"))));
}

}  // namespace
}  // namespace slalom
