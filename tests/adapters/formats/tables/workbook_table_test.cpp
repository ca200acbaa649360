// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "temporary_folder.h"

#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/spreadsheet/workbook.h>

#include <gtest/gtest.h>

#include <foreign_table.h>
#include <map>
#include <zip.h>

namespace slalom {
namespace {

constexpr const char* kWorkbook =
    R"(<x:workbook xmlns:x="m" xmlns:q="r"><x:sheets><x:sheet name="Notes" q:id="a"/>)"
    R"(<x:sheet name="Runs" q:id="b"/></x:sheets></x:workbook>)";
constexpr const char* kRelations =
    R"(<Relationships><Relationship Id="a" Target="worksheets/notes.xml"/>)"
    R"(<Relationship Id="b" Target="/xl/worksheets/runs.xml"/></Relationships>)";
constexpr const char* kEmpty =
    "<worksheet><sheetData><row r='1'><c r='A1'/></row></sheetData></worksheet>";

std::string sheet(const std::string& rows) {
  return "<worksheet><sheetData>" + rows + "</sheetData></worksheet>";
}

class WorkbookTable : public testing::Test {
 protected:
  /// A workbook with the sheets Notes and Runs.
  void write(const std::string& runs, const std::string& notes = kEmpty,
             const std::string& texts = "", const std::string& styles = "") {
    std::map<std::string, std::string> parts = {{"xl/workbook.xml", kWorkbook},
                                                {"xl/_rels/workbook.xml.rels", kRelations},
                                                {"xl/worksheets/notes.xml", notes},
                                                {"xl/worksheets/runs.xml", runs}};
    if (!texts.empty()) parts["xl/sharedStrings.xml"] = texts;
    if (!styles.empty()) parts["xl/styles.xml"] = styles;
    const zipFile zip = zipOpen64(path_.c_str(), APPEND_STATUS_CREATE);
    for (const auto& [name, text] : parts) {
      zipOpenNewFileInZip64(zip, name.c_str(), nullptr, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED,
                            6, 0);
      zipWriteInFileInZip(zip, text.data(), static_cast<unsigned>(text.size()));
      zipCloseFileInZip(zip);
    }
    zipClose(zip, nullptr);
  }

  std::string read(const std::string& name = "") const {
    return read_foreign_table(path_, name)->csv;
  }

  void expect_error(ErrorKind kind, const std::string& where,
                    std::initializer_list<std::string> parts, const std::string& name = "") const {
    EXPECT_TRUE(throws_error(kind, where, parts, [&] { read(name); }));
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "trials.xlsx";
};

TEST_F(WorkbookTable, HasTheFieldsOfTheOnlySheetWithCellsOnTheLinesOfTheirRows) {
  write(sheet("<row r='2'><c r='B2' t='s'><v>1</v></c><c r='C2' t='s'><v>0</v></c></row>"
              "<row r='4'><c r='B4' t='inlineStr'><is><t>nd, new</t></is></c><c "
              "r='C4'><v>1.5</v></c></row>"
              "<row r='5'><c r='B5' t='str'><f>A1</f><v>vff</v></c><c r='C5' "
              "t='e'><v>#DIV/0!</v></c></row>"
              "<row r='6'><c r='B6' t='b'><v>1</v></c><c r='D6' t='s'><v>2</v></c></row>"),
        kEmpty,
        "<sst><si><r><t>ti</t></r><r><t>me</t></r><rPh><t>x</t></rPh></si><si><t>method</t></si>"
        "<si><t xml:space='preserve'>two\nlines &amp; more</t></si></sst>");
  EXPECT_EQ(read(), "\n,method,time,\n\n,\"nd, new\",1.5,\n,vff,NA,\n,1,,two lines & more\n");
}

TEST_F(WorkbookTable, CellsThatShowTimesAreSeconds) {
  const std::string styles =
      "<styleSheet><numFmts><numFmt numFmtId='164' formatCode='[h]:mm:ss'/>"
      "<numFmt numFmtId='165' formatCode='yyyy-mm-dd hh:mm'/></numFmts>"
      "<cellXfs><xf numFmtId='0'/><xf numFmtId='164'/><xf numFmtId='45'/><xf numFmtId='165'/>"
      "</cellXfs></styleSheet>";
  const std::string row =
      "<row><c s='0'><v>0.5</v></c><c s='1'><v>0.5</v></c>"
      "<c s='2'><v>1.1574074074074E-4</v></c><c s='3'><v>0.5</v></c>"
      "<c s='1' t='str'><v>time</v></c></row>";
  write(sheet(row), kEmpty, "", styles);
  EXPECT_EQ(read(), "0.5,43200,10,0.5,time\n");
}

TEST_F(WorkbookTable, OfSeveralSheetsIsNamed) {
  const std::string cells = "<row><c><v>1</v></c><c><v>2</v></c></row>";
  write(sheet(cells + "<row><c><v>3</v></c></row>"), sheet(cells));
  EXPECT_EQ(read("Runs"), "1,2\n3,\n");
  EXPECT_EQ(read("Notes"), "1,2\n");
  expect_error(ErrorKind::File, path_, {"tables in 2 sheets", "--sheet with one of Notes, Runs"});
  expect_error(ErrorKind::Usage, "--sheet", {"'runs'", "'Runs'"}, "runs");
}

TEST_F(WorkbookTable, IsWhatSlalomWrites) {
  const DataTable table = {
      "runs", "runs", {"method", "time"}, 2, [](std::size_t row, std::size_t column) -> Field {
        if (column == 0) return std::string(row == 0 ? "=a" : "b");
        return row == 0 ? Field{0.1} : Field{};
      }};
  write_workbook({table}, path_);
  EXPECT_EQ(read(), "method,time\n'=a,0.1\nb,\n");
}

TEST_F(WorkbookTable, ThatIsDamagedIsRefusedWithItsPart) {
  write_file_atomically(path_, "PK\x03\x04 xl/");
  expect_error(ErrorKind::File, path_, {"damaged", "a workbook (.xlsx)"});
  const std::string part = path_ + ": xl/worksheets/runs.xml";
  for (const auto& [rows, problem] : std::map<std::string, std::string>{
           {"<row r='0'/>", "row '0'"},
           {"<row r='1048577'/>", "row '1048577'"},
           {"<row r='2'/><row r='2'/>", "row '2'"},
           {"<row><c r='B1'/><c r='A1'/></row>", "cell 'A1'"},
           {"<row><c r='XFE1'/></row>", "cell 'XFE1'"},
           {"<row><c r='1'/></row>", "cell '1'"},
           {"<row><c t='s'><v>0</v></c></row>", "shared text '0'"},
           {"<row><c t='s'><v>-1</v></c></row>", "shared text '-1'"}}) {
    write(sheet(rows));
    expect_error(ErrorKind::File, part + ":1", {problem});
  }
  write("<worksheet><sheetData>");
  expect_error(ErrorKind::File, part, {});
  write(kEmpty);
  expect_error(ErrorKind::File, path_, {"has no cells"});
}

TEST_F(WorkbookTable, IsReadInBoundedMemory) {
  // A field in the last column of each of 1,300 rows: 16,384 x 1,300 fields.
  std::string rows;
  for (int i = 0; i < 1300; ++i) rows += "<row><c r='XFD1'><v>1</v></c></row>";
  write(sheet(rows));
  expect_error(ErrorKind::File, path_, {"more than 20000000 fields", "CSV"});
}

TEST(JsonTable, OfRowsHasTheValuesWithinTheirObjects) {
  EXPECT_EQ(table_from_json(R"([{"planner": "a", "end": {"time": 1.5, "ok": true}, "path": [1]},
                               {"planner": "b\"NaN", "x": null, "end": {"time": NaN}}])",
                            "t")
                ->csv,
            "planner,end.time,end.ok,x\na,1.5,1,\n\"b\"\"NaN\",,,\n");
  EXPECT_EQ(table_from_json(R"({"runs": [{"a": 1}, {"a": -Infinity}]})", "t")->csv, "a\n1\n\n");
  EXPECT_EQ(table_from_json(R"({"teb": [{"a": 1}], "dwb": [{"a": 2}]})", "t")->csv,
            "method,a\nteb,1\ndwb,2\n");
}

TEST(JsonTable, OfColumnsIsThatOfTheMethodAndScenarioInItsName) {
  EXPECT_EQ(table_from_json(R"({"time": [1, NaN], "ok": [true, false]})", "t")->csv,
            "time,ok\n1,1\n,0\n");
  EXPECT_EQ(table_from_json(R"({"teb_burger--indoor": {"summary_df": {"time": [1, 2]}, "paths": {}},
                               "mpc": {"summary_df": {"time": [3], "why": ["goal_reached"]}}})",
                            "t")
                ->csv,
            "method,scenario,time,why\nteb_burger,indoor,1,\nteb_burger,indoor,2,\n"
            "mpc,,3,goal_reached\n");
  // Files of arena-evaluation have paths and zones of collisions, too, which are no tables.
  EXPECT_EQ(table_from_json(R"({"teb--office": {
              "summary_df": {"time": [1, 2], "success": [true, false]},
              "paths_travelled": {"0": [[0, 0], [1, 0], [2, 0]], "1": [[0, 0]]},
              "collision_zones": {"centroids": [[1, 1]], "counts": [7], "collisions": [[1, 1], [1, 2]]}}})",
                            "t")
                ->csv,
            "method,scenario,time,success\nteb,office,1,1\nteb,office,2,0\n");
  EXPECT_TRUE(throws_error(ErrorKind::File, "t: teb", {"'b' has 1 value and 'a' 2", "same length"},
                           [] { table_from_json(R"({"teb": {"a": [1, 2], "b": [1]}})", "t"); }));
}

TEST(JsonTable, AnObjectHasEachKeyOnce) {
  EXPECT_TRUE(throws_error(ErrorKind::File, "t", {"two values of 'success'", "each key once"}, [] {
    table_from_json(R"([{"a": {"success": 1}, "success": 1, "success": 0}])", "t");
  }));
  EXPECT_NO_THROW(table_from_json(R"([{"a": {"x": 1}, "b": {"x": 1}, "x": 2}, {"x": 3}])", "t"));
}

TEST(JsonTable, OfAnyDepthIsReadWithoutRecursionToItsEnd) {
  std::string text = R"([{"x": 1, "deep": )";
  for (int i = 0; i < 1000000; ++i) text += R"({"a":)";
  text += "1";
  EXPECT_FALSE(table_from_json(text, "t"));
  EXPECT_EQ(table_from_json(text + std::string(1000000, '}') + "}]", "t")->csv, "x\n1\n");
}

TEST(JsonTable, IsNoOtherText) {
  for (const char* text :
       {"", "3", "[1, 2]", "[{}, 3]", "{}", R"({"a": 1})", "[{]", "NaN", R"("a)", "\"\\"})
    EXPECT_FALSE(table_from_json(text, "t")) << text;
}

}  // namespace
}  // namespace slalom
